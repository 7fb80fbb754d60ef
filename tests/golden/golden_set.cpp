#include "golden_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "image/png.hpp"

namespace spanline::test {
namespace {

std::filesystem::path png_path(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + ".png");
}

void write_png(const std::filesystem::path& path, const sim::Picture& picture) {
  std::filesystem::create_directories(path.parent_path());
  const std::vector<std::byte> bytes = sim::encode_png(picture);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

std::uint8_t amplified(std::uint8_t a, std::uint8_t b) {
  return static_cast<std::uint8_t>(std::min(255, std::abs(a - b) * 8));
}

}  // namespace

GoldenSet::GoldenSet(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::ifstream file(folder_ / "crcs.txt");
  std::string name;
  Crcs crcs;
  while (file >> name >> std::hex >> crcs.colours >> crcs.depths) crcs_[name] = crcs;
}

const GoldenSet::Crcs* GoldenSet::find(const std::string& name) const {
  const auto at = crcs_.find(name);
  return at == crcs_.end() ? nullptr : &at->second;
}

sim::Picture GoldenSet::picture(const std::string& name) const {
  std::ifstream file(png_path(folder_ / "pictures", name), std::ios::binary);
  if (!file) return {};
  const std::vector<char> chars{std::istreambuf_iterator<char>(file), {}};
  return sim::decode_png(std::as_bytes(std::span(chars)));
}

void GoldenSet::set(const std::string& name, Crcs crcs, const sim::Picture& picture) {
  crcs_[name] = crcs;
  write_png(png_path(folder_ / "pictures", name), picture);
}

std::set<std::string> GoldenSet::names() const {
  std::set<std::string> all;
  for (const auto& [name, crcs] : crcs_) all.insert(name);
  const std::filesystem::path pictures = folder_ / "pictures";
  if (std::filesystem::is_directory(pictures))
    for (const auto& file : std::filesystem::directory_iterator(pictures)) all.insert(file.path().stem().string());
  return all;
}

void GoldenSet::remove(const std::string& name) {
  crcs_.erase(name);
  std::filesystem::remove(png_path(folder_ / "pictures", name));
}

void GoldenSet::save() const {
  std::ofstream file(folder_ / "crcs.txt");
  for (const auto& [name, crcs] : crcs_) file << name << ' ' << std::hex << crcs.colours << ' ' << crcs.depths << '\n';
  if (!file) throw std::runtime_error("cannot write the table of CRCs");
}

void write_difference(const std::filesystem::path& folder, const std::string& name, const sim::Picture& got,
                      const sim::Picture& want) {
  write_png(png_path(folder, name + "-got"), got);
  if (want.pixels.size() != got.pixels.size()) return;
  write_png(png_path(folder, name + "-want"), want);
  sim::Picture difference(got.width, got.height);
  for (std::size_t i = 0; i < got.pixels.size(); ++i) {
    const Rgb888 &a = got.pixels[i], &b = want.pixels[i];
    difference.pixels[i] = {amplified(a.red, b.red), amplified(a.green, b.green), amplified(a.blue, b.blue)};
  }
  write_png(png_path(folder, name + "-difference"), difference);
}

}  // namespace spanline::test
