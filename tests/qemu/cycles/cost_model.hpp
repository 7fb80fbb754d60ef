#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace spanline::cycles {

/// A core whose cycles are modelled, from the instruction timings of its technical reference manual (TRM):
/// - Cortex-M0+: Arm DDI 0484C, 3.3, table 3-1, with the single-cycle multiplier (as on the RP2040);
/// - Cortex-M3: Arm DDI 0337I, 3.3.1, table 3-1, and 3.3.2 "Load/store timings";
/// - Cortex-M4: Arm DDI 0439B, 3.3.1, table 3-1, and 3.3.2 "Load/store timings".
///
/// Not modelled: wait states of flash and buses, the refill's dependence on the target's alignment, divisions and long
/// products that end early, folded IT, stalls of a full store buffer, entry to and return from exceptions. Instructions
/// whose IT condition fails cost what they would cost otherwise.
enum class Core : std::uint8_t { m0plus, m3, m4 };

/// The core of that name as the benchmark tables spell it.
[[nodiscard]] std::optional<Core> core_named(std::string_view name);

enum class Kind : std::uint8_t { other, load, store, branch };

/// What an instruction costs.
struct InstructionCost {
  std::uint8_t cycles = 1;
  std::uint8_t cycles_if_taken = 0;  ///< on top, where a conditional branch is taken
  Kind kind = Kind::other;
  std::uint8_t loads = 0;   ///< words, halfwords or bytes read
  std::uint8_t stores = 0;  ///< and written
  bool conditional = false;
};

/// The cost of a Thumb instruction by its one or two halfwords; `second` is 0 for a short one.
[[nodiscard]] InstructionCost instruction_cost(Core core, std::uint16_t first, std::uint16_t second);

/// Whether a halfword begins an instruction of two.
[[nodiscard]] constexpr bool is_wide(std::uint16_t first) { return first >= 0xe800; }

/// Cycles that the instruction saves by following `before`: on M3 and M4 a load behind a load overlaps its address
/// phase with the other's data phase (3.3.2).
[[nodiscard]] unsigned overlap(Core core, const InstructionCost& before, const InstructionCost& instruction);

}  // namespace spanline::cycles
