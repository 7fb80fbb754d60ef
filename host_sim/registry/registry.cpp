#include "registry/registry.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/failure.hpp"
#include "panels/panel_registry.hpp"

namespace spanline::sim {
namespace {

constexpr std::array<ShadingEntry, 4> shading_table{{
    {"flat", "one brightness a polygon", false, true, false},
    {"gouraud", "brightness interpolated between the vertices", true, true, false},
    {"texture", "textures under brightness interpolated between the vertices", true, true, true},
    {"unlit", "colours and textures as they are, without light", true, false, false},
}};

struct BoardEntry {
  const char* name;
  const char* description;
};

constexpr std::array<BoardEntry, 8> board_table{{
    {"lm3s6965evb", "Cortex-M3, 64 KB of RAM, SSD0323 display on SPI (QEMU)"},
    {"mps2-an385", "Cortex-M3, 4 MB of RAM (QEMU)"},
    {"mps2-an386", "Cortex-M4, 4 MB of RAM (QEMU)"},
    {"mps2-an500", "Cortex-M7, 4 MB of RAM (QEMU)"},
    {"microbit", "Cortex-M0, 16 KB of RAM (QEMU)"},
    {"stm32vldiscovery", "Cortex-M3, 8 KB of RAM (QEMU)"},
    {"pico", "Cortex-M0+, 264 KB of RAM, ST7789 or ILI9341 on SPI (Raspberry Pi Pico; rp2040js)"},
    {"virt-rv32", "RV32IMC, RISC-V virt machine (QEMU)"},
}};

/// Names that have no shading yet.
constexpr std::array<std::string_view, 0> later_shading{};

template <class Table, class Later>
const auto& find(const char* option, const Table& table, const Later& later, const std::string& name) {
  const auto entry = std::find_if(table.begin(), table.end(), [&](const auto& e) { return name == e.name; });
  if (entry != table.end()) return *entry;
  if (std::find(later.begin(), later.end(), name) != later.end()) throw NotAvailable(std::string(option) + " " + name);
  std::string choice;
  for (const auto& e : table) choice += (choice.empty() ? "" : ", ") + std::string(e.name);
  throw UsageError(std::string(option) + ": '" + name + "' is unknown; there is " + choice);
}

}  // namespace

std::span<const AlgorithmEntry> visibility_algorithms() { return algorithm_registry; }
std::span<const ShadingEntry> shadings() { return shading_table; }

const AlgorithmEntry& find_visibility(const std::string& name) {
  return find("--visibility", algorithm_registry, algorithms_to_come, name);
}

const ShadingEntry& find_shading(const std::string& name) {
  return find("--shade", shading_table, later_shading, name);
}

std::vector<ListEntry> list_entries() {
  // Kinds without classes say so by a dash, so that no column is empty.
  std::vector<ListEntry> entries;
  for (const AlgorithmEntry& e : algorithm_registry)
    entries.push_back({"visibility", e.name, to_string(e.exactness), e.description});
  for (const ShadingEntry& e : shading_table) entries.push_back({"shading", e.name, "-", e.description});
  for (const PanelInfo& e : panels())
    entries.push_back({"panel", std::string(e.name), std::string(e.panel_class), std::string(e.description)});
  for (const BoardEntry& e : board_table) entries.push_back({"board", e.name, "-", e.description});
  return entries;
}

}  // namespace spanline::sim
