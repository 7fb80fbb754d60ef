#include "cost_model.hpp"

#include <array>
#include <bit>
#include <iterator>

namespace spanline::cycles {
namespace {

/// What the manuals' tables distinguish.
enum class Class : std::uint8_t {
  plain,
  load,
  load_pc,
  load_double,
  store,
  store_double,
  load_multiple,
  pop,
  store_multiple,
  push,
  load_multiple_wide,
  store_multiple_wide,
  branch_conditional,
  branch,
  branch_link,
  branch_exchange,
  write_pc,
  table_branch,
  multiply_add,
  multiply_long,
  multiply_add_long,
  divide,
  system,
};

/// Instructions by encoding (Armv7-M Architecture Reference Manual, A5.2 and A5.3): the first rule that fits counts.
struct Rule {
  std::uint16_t first_mask, first;
  std::uint16_t second_mask, second;
  Class what;
};

constexpr Rule short_rules[] = {
    {0xfe00, 0xde00, 0, 0, Class::plain},               // UDF, SVC
    {0xf000, 0xd000, 0, 0, Class::branch_conditional},  // B<c>
    {0xf800, 0xe000, 0, 0, Class::branch},              // B
    {0xf500, 0xb100, 0, 0, Class::branch_conditional},  // CBZ, CBNZ
    {0xff00, 0x4700, 0, 0, Class::branch_exchange},     // BX, BLX
    {0xff87, 0x4687, 0, 0, Class::write_pc},            // MOV pc
    {0xff87, 0x4487, 0, 0, Class::write_pc},            // ADD pc
    {0xfe00, 0xbc00, 0, 0, Class::pop},
    {0xfe00, 0xb400, 0, 0, Class::push},
    {0xf800, 0xc800, 0, 0, Class::load_multiple},
    {0xf800, 0xc000, 0, 0, Class::store_multiple},
    {0xf800, 0x4800, 0, 0, Class::load},   // LDR literal
    {0xfe00, 0x5600, 0, 0, Class::load},   // LDRSB register
    {0xf800, 0x5800, 0, 0, Class::load},   // LDR, LDRH, LDRB, LDRSH register: 58 to 5f
    {0xf000, 0x5000, 0, 0, Class::store},  // STR, STRH, STRB register
    {0xe800, 0x6800, 0, 0, Class::load},   // LDR, LDRB immediate
    {0xe800, 0x6000, 0, 0, Class::store},
    {0xf800, 0x8800, 0, 0, Class::load},  // LDRH immediate
    {0xf800, 0x8000, 0, 0, Class::store},
    {0xf800, 0x9800, 0, 0, Class::load},  // LDR from the stack
    {0xf800, 0x9000, 0, 0, Class::store},
};

constexpr Rule wide_rules[] = {
    {0xf800, 0xf000, 0xd000, 0xd000, Class::branch_link},         // BL
    {0xf800, 0xf000, 0xd000, 0x9000, Class::branch},              // B.W
    {0xfb80, 0xf380, 0xd000, 0x8000, Class::system},              // MSR, MRS, hints, barriers
    {0xf800, 0xf000, 0xd000, 0x8000, Class::branch_conditional},  // B<c>.W
    {0xfe50, 0xe810, 0, 0, Class::load_multiple_wide},
    {0xfe50, 0xe800, 0, 0, Class::store_multiple_wide},
    {0xfff0, 0xe8d0, 0xffe0, 0xf000, Class::table_branch},  // TBB, TBH
    {0xfe50, 0xe850, 0, 0, Class::load_double},             // LDRD
    {0xfe50, 0xe840, 0, 0, Class::store_double},            // STRD
    {0xff70, 0xf850, 0xf000, 0xf000, Class::load_pc},       // LDR pc
    {0xfe10, 0xf810, 0, 0, Class::load},
    {0xfe10, 0xf800, 0, 0, Class::store},
    {0xffd0, 0xfb90, 0x00f0, 0x00f0, Class::divide},   // SDIV, UDIV
    {0xffc0, 0xfb80, 0, 0, Class::multiply_long},      // SMULL, UMULL
    {0xff80, 0xfb80, 0, 0, Class::multiply_add_long},  // SMLAL, UMLAL and their kin
    {0xff80, 0xfb00, 0xf000, 0xf000, Class::plain},    // MUL
    {0xff80, 0xfb00, 0, 0, Class::multiply_add},       // MLA, MLS
};

/// Cycles a class. `refill` is the manuals' P, 1 to 3 by the target's alignment and width: 2 taken. A list of N
/// registers costs N on top.
struct Costs {
  std::uint8_t load, store, list, refill, branch, branch_link, branch_exchange, pop_pc, multiply_add, multiply_long,
      multiply_add_long, divide, system;
};

/// M0+: a load or store takes 2, LDM, STM, PUSH and POP 1 + N, a branch 2 if taken, BL 3, BX and BLX 2, MRS, MSR and
/// barriers 3. "POP <loreglist>, PC" takes 3 + N; N is read as the number of low registers, as rp2040js reads it: one
/// for the instruction, one a word, one to refill the pipeline. The long products do not exist there.
constexpr Costs m0plus_costs{.load = 2,
                             .store = 2,
                             .list = 1,
                             .refill = 1,
                             .branch = 2,
                             .branch_link = 3,
                             .branch_exchange = 2,
                             .pop_pc = 1,
                             .multiply_add = 1,
                             .multiply_long = 1,
                             .multiply_add_long = 1,
                             .divide = 1,
                             .system = 3};

/// M3: a load takes 2, a store 1 as the buffer takes it (3.3.2), lists 1 + N, branches 1 + P, MLA and MLS 2, SMULL and
/// UMULL 3 to 5, SMLAL and UMLAL 4 to 7, divisions 2 to 12: 7 taken, their middle.
constexpr Costs m3_costs{.load = 2,
                         .store = 1,
                         .list = 1,
                         .refill = 2,
                         .branch = 3,
                         .branch_link = 3,
                         .branch_exchange = 3,
                         .pop_pc = 2,
                         .multiply_add = 2,
                         .multiply_long = 4,
                         .multiply_add_long = 5,
                         .divide = 7,
                         .system = 2};

/// M4: as M3, with every product in one cycle.
constexpr Costs m4_costs{.load = 2,
                         .store = 1,
                         .list = 1,
                         .refill = 2,
                         .branch = 3,
                         .branch_link = 3,
                         .branch_exchange = 3,
                         .pop_pc = 2,
                         .multiply_add = 1,
                         .multiply_long = 1,
                         .multiply_add_long = 1,
                         .divide = 7,
                         .system = 2};

constexpr const Costs& costs_of(Core core) {
  switch (core) {
    case Core::m3:
      return m3_costs;
    case Core::m4:
      return m4_costs;
    case Core::m0plus:
      break;
  }
  return m0plus_costs;
}

Class class_of(std::uint16_t first, std::uint16_t second) {
  const auto search = [&](const auto& rules) {
    for (const Rule& rule : rules) {
      if ((first & rule.first_mask) == rule.first && (second & rule.second_mask) == rule.second) return rule.what;
    }
    return Class::plain;
  };
  return is_wide(first) ? search(wide_rules) : search(short_rules);
}

constexpr std::uint8_t byte(unsigned value) { return static_cast<std::uint8_t>(value); }

InstructionCost load_list(const Costs& costs, unsigned registers, bool with_pc) {
  const unsigned cycles = costs.list + registers + (with_pc ? costs.pop_pc : 0U);
  return {.cycles = byte(cycles), .kind = with_pc ? Kind::branch : Kind::load, .loads = byte(registers)};
}

InstructionCost store_list(const Costs& costs, unsigned registers) {
  return {.cycles = byte(costs.list + registers), .kind = Kind::store, .stores = byte(registers)};
}

InstructionCost branch(unsigned cycles) { return {.cycles = byte(cycles), .kind = Kind::branch}; }
InstructionCost plain(unsigned cycles) { return {.cycles = byte(cycles)}; }

constexpr unsigned bits(unsigned list) { return static_cast<unsigned>(std::popcount(list)); }

}  // namespace

std::optional<Core> core_named(std::string_view name) {
  constexpr std::array names{"m0plus", "m3", "m4"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) return static_cast<Core>(i);
  }
  return std::nullopt;
}

InstructionCost instruction_cost(Core core, std::uint16_t first, std::uint16_t second) {
  const Costs& costs = costs_of(core);
  constexpr unsigned extra_register = 0x100, low_list = 0xff, pc_bit = 0x8000;
  switch (class_of(first, second)) {
    case Class::plain:
      break;
    case Class::load:
      return {.cycles = costs.load, .kind = Kind::load, .loads = 1};
    case Class::load_pc:
      return {.cycles = byte(costs.load + costs.refill), .kind = Kind::branch, .loads = 1};
    case Class::load_double:
      return {.cycles = byte(costs.list + 2U), .kind = Kind::load, .loads = 2};
    case Class::store:
      return {.cycles = costs.store, .kind = Kind::store, .stores = 1};
    case Class::store_double:
      return {.cycles = byte(costs.list + 2U), .kind = Kind::store, .stores = 2};
    case Class::load_multiple:
      return load_list(costs, bits(first & low_list), false);
    case Class::pop:
      return load_list(costs, bits(first & (low_list | extra_register)), (first & extra_register) != 0);
    case Class::store_multiple:
      return store_list(costs, bits(first & low_list));
    case Class::push:
      return store_list(costs, bits(first & (low_list | extra_register)));
    case Class::load_multiple_wide:
      return load_list(costs, bits(second), (second & pc_bit) != 0);
    case Class::store_multiple_wide:
      return store_list(costs, bits(second));
    case Class::branch_conditional:
      return {.cycles = 1, .cycles_if_taken = costs.refill, .kind = Kind::branch, .conditional = true};
    case Class::branch:
    case Class::write_pc:
      return branch(costs.branch);
    case Class::branch_link:
      return branch(costs.branch_link);
    case Class::branch_exchange:
      return branch(costs.branch_exchange);
    case Class::table_branch:
      return {.cycles = byte(costs.load + costs.refill), .kind = Kind::branch, .loads = 1};
    case Class::multiply_add:
      return plain(costs.multiply_add);
    case Class::multiply_long:
      return plain(costs.multiply_long);
    case Class::multiply_add_long:
      return plain(costs.multiply_add_long);
    case Class::divide:
      return plain(costs.divide);
    case Class::system:
      return plain(costs.system);
  }
  return plain(1);
}

unsigned overlap(Core core, const InstructionCost& before, const InstructionCost& instruction) {
  const auto single_load = [](const InstructionCost& cost) { return cost.kind == Kind::load && cost.loads == 1; };
  return core != Core::m0plus && single_load(before) && single_load(instruction) ? 1 : 0;
}

}  // namespace spanline::cycles
