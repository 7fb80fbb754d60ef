// A QEMU plugin that counts what a guest executes between markers: instructions, loads, stores, branches, and cycles by
// the model of cost_model.hpp.
//
//     qemu-system-arm … -plugin libspanline_cycles.so,core=m0plus,out=FILE[,blocks=on]
//
// Markers are instructions that do nothing and that no compiler writes: `mov r9, r9` starts an interval of counting,
// `mov r10, r10` ends it, and `mov r11, r11` reports what the intervals since the last report add up to and begins at
// zero. None of the three is counted. Each report is a line in FILE:
//
//     report <instructions> <cycles> <loads> <stores> <branches> <taken> <intervals>
//
// where `taken` are conditional branches. With blocks=on, a line for each block of code that ran comes before it:
//
//     block <address, hexadecimal> <instructions> <cycles>
#include <cstdio>
#include <cstring>
#include <deque>
#include <map>
#include <string_view>
#include <vector>

#include "cost_model.hpp"
#include "plugin_api.h"

int qemu_plugin_version = 1;

namespace spanline::cycles {
namespace {

enum class Marker : std::uint16_t { start = 0x46c9, stop = 0x46d2, report = 0x46db };

bool is_marker(std::uint16_t first) {
  return first == static_cast<std::uint16_t>(Marker::start) || first == static_cast<std::uint16_t>(Marker::stop) ||
         first == static_cast<std::uint16_t>(Marker::report);
}

struct Totals {
  std::uint64_t instructions = 0, cycles = 0, loads = 0, stores = 0, branches = 0, taken = 0;

  Totals& operator+=(const Totals& other) {
    instructions += other.instructions;
    cycles += other.cycles;
    loads += other.loads;
    stores += other.stores;
    branches += other.branches;
    taken += other.taken;
    return *this;
  }
  Totals operator-(const Totals& other) const {
    return {instructions - other.instructions, cycles - other.cycles, loads - other.loads, stores - other.stores,
            branches - other.branches,         taken - other.taken};
  }
};

/// A translated run of instructions without a branch but for the last.
struct Block {
  std::uint64_t start = 0, end = 0;
  Totals whole;
  std::uint8_t cycles_if_taken = 0;
  bool conditional = false;
  std::uint64_t executions = 0, taken_cycles = 0;  ///< while counting, since the last report
};

/// A marker in a block, and what comes before and behind it there.
struct MarkedPlace {
  Marker marker;
  Totals before, behind;
};

/// The one counter: the boards that QEMU emulates here have one core each.
struct Counter {
  Core core = Core::m0plus;
  std::FILE* out = nullptr;
  bool with_blocks = false;
  std::deque<Block> blocks;
  std::deque<MarkedPlace> places;

  Totals running;             ///< of all that began to execute, whole blocks
  Totals at_start, reported;  ///< `running` when the interval began; sum of the intervals that have ended
  unsigned intervals = 0;
  bool counting = false;
  Block* last = nullptr;

  void finish_branch(const Block& next) {
    if (last == nullptr || !last->conditional || next.start == last->end) return;
    running.cycles += last->cycles_if_taken;
    ++running.taken;
    if (counting) last->taken_cycles += last->cycles_if_taken;
  }

  void execute(Block& block) {
    finish_branch(block);
    running += block.whole;
    if (counting) ++block.executions;
    last = &block;
  }

  void pass(const MarkedPlace& place) {
    switch (place.marker) {
      case Marker::start:
        at_start = running - place.behind;
        counting = true;
        break;
      case Marker::stop:
        if (!counting) break;
        reported += running - place.behind - at_start;
        ++intervals;
        counting = false;
        break;
      case Marker::report:
        report();
        break;
    }
  }

  void report() {
    if (with_blocks) report_blocks();
    std::fprintf(out, "report %llu %llu %llu %llu %llu %llu %u\n", count(reported.instructions), count(reported.cycles),
                 count(reported.loads), count(reported.stores), count(reported.branches), count(reported.taken),
                 intervals);
    reported = {};
    intervals = 0;
  }

  /// One line an address: a block may have been translated more than once.
  void report_blocks() {
    std::map<std::uint64_t, Totals> sums;
    for (Block& block : blocks) {
      if (block.executions == 0) continue;
      Totals& sum = sums[block.start];
      sum.instructions += block.executions * block.whole.instructions;
      sum.cycles += block.executions * block.whole.cycles + block.taken_cycles;
      block.executions = block.taken_cycles = 0;
    }
    for (const auto& [address, sum] : sums) {
      std::fprintf(out, "block %llx %llu %llu\n", count(address), count(sum.instructions), count(sum.cycles));
    }
  }

  static unsigned long long count(std::uint64_t value) { return value; }
};

Counter counter;

void on_execute(unsigned, void* data) { counter.execute(*static_cast<Block*>(data)); }
void on_marker(unsigned, void* data) { counter.pass(*static_cast<MarkedPlace*>(data)); }

/// Adds up a block once, when QEMU translates it.
void on_translate(qemu_plugin_id_t, qemu_plugin_tb* translation) {
  Block& block = counter.blocks.emplace_back();
  block.start = block.end = qemu_plugin_tb_vaddr(translation);
  const std::size_t first_place = counter.places.size();
  InstructionCost before;
  for (std::size_t i = 0; i < qemu_plugin_tb_n_insns(translation); ++i) {
    qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(translation, i);
    std::uint16_t halfwords[2] = {};
    const std::size_t size = qemu_plugin_insn_size(instruction);
    std::memcpy(halfwords, qemu_plugin_insn_data(instruction), size < sizeof halfwords ? size : sizeof halfwords);
    block.end += size;
    if (is_marker(halfwords[0])) {
      MarkedPlace& place = counter.places.emplace_back(MarkedPlace{Marker{halfwords[0]}, block.whole, {}});
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_marker, QEMU_PLUGIN_CB_NO_REGS, &place);
      continue;
    }
    const InstructionCost cost = instruction_cost(counter.core, halfwords[0], halfwords[1]);
    ++block.whole.instructions;
    block.whole.cycles += cost.cycles - overlap(counter.core, before, cost);
    block.whole.loads += cost.loads;
    block.whole.stores += cost.stores;
    block.whole.branches += cost.kind == Kind::branch ? 1 : 0;
    block.conditional = cost.conditional;
    block.cycles_if_taken = cost.cycles_if_taken;
    before = cost;
  }
  for (std::size_t i = first_place; i < counter.places.size(); ++i) {
    counter.places[i].behind = block.whole - counter.places[i].before;
  }
  qemu_plugin_register_vcpu_tb_exec_cb(translation, on_execute, QEMU_PLUGIN_CB_NO_REGS, &block);
}

void on_exit(qemu_plugin_id_t, void*) { std::fclose(counter.out); }

bool take_argument(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string_view::npos) return false;
  const std::string_view name = argument.substr(0, equals), value = argument.substr(equals + 1);
  if (name == "core") {
    const auto core = core_named(value);
    counter.core = core.value_or(Core::m0plus);
    return core.has_value();
  }
  if (name == "out") {
    counter.out = std::fopen(value.data(), "w");  // an argument's end is the string's
    return counter.out != nullptr;
  }
  counter.with_blocks = value == "on";
  return name == "blocks";
}

}  // namespace
}  // namespace spanline::cycles

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t*, int count, char** arguments) {
  using namespace spanline::cycles;
  for (int i = 0; i < count; ++i) {
    if (take_argument(arguments[i])) continue;
    std::fprintf(stderr, "spanline_cycles: cannot do what '%s' asks\n", arguments[i]);
    return 1;
  }
  if (counter.out == nullptr) {
    std::fputs("spanline_cycles: out=FILE is missing\n", stderr);
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translate);
  qemu_plugin_register_atexit_cb(id, on_exit, nullptr);
  return 0;
}
