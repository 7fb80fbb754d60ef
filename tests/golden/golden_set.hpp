#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "image/picture.hpp"

namespace spanline::test {

/// The table of golden CRCs, a line each: scene, bits of depth, CRC of the colours, CRC of the depths. And the
/// pictures, `pictures/SCENE-BITS.png`.
class GoldenSet {
 public:
  struct Crcs {
    std::uint32_t colours = 0, depths = 0;
    friend bool operator==(const Crcs&, const Crcs&) = default;
  };

  /// Reads the table of a folder; an absent one is empty.
  explicit GoldenSet(std::filesystem::path folder);

  /// What the table says of `SCENE-BITS`; null if it does not know it.
  [[nodiscard]] const Crcs* find(const std::string& name) const;
  /// The picture; empty if there is none.
  [[nodiscard]] sim::Picture picture(const std::string& name) const;

  /// Everything that the table or the folder of pictures names.
  [[nodiscard]] std::set<std::string> names() const;

  void set(const std::string& name, Crcs crcs, const sim::Picture& picture);
  /// Forgets a scene that is no longer drawn, with its picture.
  void remove(const std::string& name);
  /// Writes the table.
  void save() const;

 private:
  std::filesystem::path folder_;
  std::map<std::string, Crcs> crcs_;
};

/// Writes got, want and their difference, amplified eight times, into a folder.
void write_difference(const std::filesystem::path& folder, const std::string& name, const sim::Picture& got,
                      const sim::Picture& want);

}  // namespace spanline::test
