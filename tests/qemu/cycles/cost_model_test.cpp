// Costs of encoded instructions against the tables of the technical reference manuals.
#include "cost_model.hpp"

#include <gtest/gtest.h>

namespace spanline::cycles {
namespace {

struct Case {
  const char* text;
  std::uint16_t first, second;
  unsigned m0plus, m3, m4;  ///< cycles, not taken; 0 where the core lacks it
  Kind kind;
};

constexpr Case cases[] = {
    {"adds r0, r1, r2", 0x1888, 0, 1, 1, 1, Kind::other},
    {"muls r0, r1", 0x4348, 0, 1, 1, 1, Kind::other},
    {"nop", 0xbf00, 0, 1, 1, 1, Kind::other},
    {"ldr r0, [r1, #4]", 0x6848, 0, 2, 2, 2, Kind::load},
    {"ldrb r0, [r1]", 0x7808, 0, 2, 2, 2, Kind::load},
    {"ldrh r0, [r1]", 0x8808, 0, 2, 2, 2, Kind::load},
    {"ldrsb r0, [r1, r2]", 0x5688, 0, 2, 2, 2, Kind::load},
    {"ldrsh r0, [r1, r2]", 0x5e88, 0, 2, 2, 2, Kind::load},
    {"ldr r0, [pc, #8]", 0x4802, 0, 2, 2, 2, Kind::load},
    {"ldr r0, [sp, #8]", 0x9802, 0, 2, 2, 2, Kind::load},
    {"str r0, [r1, #4]", 0x6048, 0, 2, 1, 1, Kind::store},
    {"strb r0, [r1]", 0x7008, 0, 2, 1, 1, Kind::store},
    {"strh r0, [r1]", 0x8008, 0, 2, 1, 1, Kind::store},
    {"strb r0, [r1, r2]", 0x5488, 0, 2, 1, 1, Kind::store},
    {"str r0, [sp, #8]", 0x9002, 0, 2, 1, 1, Kind::store},
    {"ldmia r0!, {r1-r4}", 0xc81e, 0, 5, 5, 5, Kind::load},
    {"stmia r0!, {r1-r4}", 0xc01e, 0, 5, 5, 5, Kind::store},
    {"push {r4-r7, lr}", 0xb5f0, 0, 6, 6, 6, Kind::store},
    {"pop {r4-r7}", 0xbcf0, 0, 5, 5, 5, Kind::load},
    {"pop {r4-r7, pc}", 0xbdf0, 0, 7, 8, 8, Kind::branch},
    {"b .", 0xe7fe, 0, 2, 3, 3, Kind::branch},
    {"bne .", 0xd1fe, 0, 1, 1, 1, Kind::branch},
    {"bx lr", 0x4770, 0, 2, 3, 3, Kind::branch},
    {"blx r3", 0x4798, 0, 2, 3, 3, Kind::branch},
    {"mov pc, r0", 0x4687, 0, 2, 3, 3, Kind::branch},
    {"add pc, r0", 0x4487, 0, 2, 3, 3, Kind::branch},
    {"svc 0", 0xdf00, 0, 1, 1, 1, Kind::other},
    {"bl .", 0xf7ff, 0xfffe, 3, 3, 3, Kind::branch},
    {"mrs r0, msp", 0xf3ef, 0x8008, 3, 2, 2, Kind::other},
    {"dsb", 0xf3bf, 0x8f4f, 3, 2, 2, Kind::other},
    {"cbz r0, .+8", 0xb110, 0, 0, 1, 1, Kind::branch},
    {"b.w .", 0xf7ff, 0xbffe, 0, 3, 3, Kind::branch},
    {"bne.w .", 0xf47f, 0xaffe, 0, 1, 1, Kind::branch},
    {"ldmia.w sp!, {r4-r11, pc}", 0xe8bd, 0x8ff0, 0, 12, 12, Kind::branch},
    {"stmdb sp!, {r4-r11, lr}", 0xe92d, 0x4ff0, 0, 10, 10, Kind::store},
    {"ldrd r0, r1, [r2]", 0xe9d2, 0x0100, 0, 3, 3, Kind::load},
    {"strd r0, r1, [r2]", 0xe9c2, 0x0100, 0, 3, 3, Kind::store},
    {"tbb [pc, r0]", 0xe8df, 0xf000, 0, 4, 4, Kind::branch},
    {"ldr.w pc, [r0, r1]", 0xf850, 0xf001, 0, 4, 4, Kind::branch},
    {"ldrsh.w r0, [r1, #2]", 0xf9b1, 0x0002, 0, 2, 2, Kind::load},
    {"strh.w r0, [r1, r2]", 0xf821, 0x0002, 0, 1, 1, Kind::store},
    {"mul r0, r1, r2", 0xfb01, 0xf002, 0, 1, 1, Kind::other},
    {"mla r0, r1, r2, r3", 0xfb01, 0x3002, 0, 2, 1, Kind::other},
    {"smull r0, r1, r2, r3", 0xfb82, 0x0103, 0, 4, 1, Kind::other},
    {"umlal r0, r1, r2, r3", 0xfbe2, 0x0103, 0, 5, 1, Kind::other},
    {"sdiv r0, r1, r2", 0xfb91, 0xf0f2, 0, 7, 7, Kind::other},
    {"add.w r0, r1, #4096", 0xf501, 0x5080, 0, 1, 1, Kind::other},
    {"ubfx r0, r1, #4, #8", 0xf3c1, 0x1007, 0, 1, 1, Kind::other},
};

TEST(CycleModel, CostsAreThoseOfTheManuals) {
  for (const Case& c : cases) {
    for (const auto& [core, want] : {std::pair{Core::m0plus, c.m0plus}, {Core::m3, c.m3}, {Core::m4, c.m4}}) {
      if (want == 0) continue;
      const InstructionCost cost = instruction_cost(core, c.first, c.second);
      EXPECT_EQ(cost.cycles, want) << c.text;
      EXPECT_EQ(cost.kind, c.kind) << c.text;
    }
  }
}

TEST(CycleModel, OnlyConditionalBranchesCostMoreWhenTaken) {
  for (const Case& c : cases) {
    const InstructionCost cost = instruction_cost(Core::m4, c.first, c.second);
    const bool conditional = std::string_view(c.text).starts_with("bne") || std::string_view(c.text).starts_with("cbz");
    EXPECT_EQ(cost.conditional, conditional) << c.text;
    EXPECT_EQ(cost.cycles_if_taken, conditional ? 2 : 0) << c.text;
  }
  EXPECT_EQ(instruction_cost(Core::m0plus, 0xd1fe, 0).cycles_if_taken, 1);
}

TEST(CycleModel, CountsWhatListsMove) {
  EXPECT_EQ(instruction_cost(Core::m0plus, 0xb5f0, 0).stores, 5);
  EXPECT_EQ(instruction_cost(Core::m0plus, 0xbdf0, 0).loads, 5);
  EXPECT_EQ(instruction_cost(Core::m4, 0xe8bd, 0x8ff0).loads, 9);
  EXPECT_EQ(instruction_cost(Core::m4, 0xe9c2, 0x0100).stores, 2);
}

TEST(CycleModel, NeighbouringLoadsOverlapOnTheLargerCores) {
  const InstructionCost load = instruction_cost(Core::m4, 0x6848, 0), store = instruction_cost(Core::m4, 0x6048, 0),
                        list = instruction_cost(Core::m4, 0xc81e, 0);
  EXPECT_EQ(overlap(Core::m4, load, load), 1U);
  EXPECT_EQ(overlap(Core::m3, load, load), 1U);
  EXPECT_EQ(overlap(Core::m0plus, load, load), 0U);
  EXPECT_EQ(overlap(Core::m4, store, load), 0U);
  EXPECT_EQ(overlap(Core::m4, list, load), 0U);
}

TEST(CycleModel, KnowsItsCoresByName) {
  EXPECT_EQ(core_named("m0plus"), Core::m0plus);
  EXPECT_EQ(core_named("m3"), Core::m3);
  EXPECT_EQ(core_named("m4"), Core::m4);
  EXPECT_EQ(core_named("m7"), std::nullopt);
}

}  // namespace
}  // namespace spanline::cycles
