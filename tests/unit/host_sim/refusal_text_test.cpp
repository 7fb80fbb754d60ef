// The command's line about what a renderer refused names the matter, whatever it was.
#include <gtest/gtest.h>

#include <set>

#include "render/refusal_text.hpp"

namespace spanline::sim {
namespace {

TEST(RefusalText, NamesTheShaderThePoolAndTheNumber) {
  EXPECT_EQ(refusal_text(MissingShader::relief), "the renderer refused: it has no shader for relief");
  EXPECT_EQ(refusal_text({Fault::too_many_lights, Pool::none, 6}),
            "the renderer refused: 6 lights of a kind, and a frame takes 4");
  EXPECT_EQ(refusal_text({Fault::bad_configuration, Pool::awake, 700}),
            "the renderer refused: pool awake has at most 700 entries");
  EXPECT_EQ(refusal_text(Fault::bad_focal), "the renderer refused: focal length out of range");
}

TEST(RefusalText, EveryFaultAndEveryShaderHasALineOfItsOwn) {
  std::set<std::string> lines;
  constexpr int faults = static_cast<int>(Fault::bad_order), shaders = static_cast<int>(MissingShader::mixture);
  for (int i = 1; i <= faults; ++i) lines.insert(refusal_text(static_cast<Fault>(i)));
  for (int i = 1; i <= shaders; ++i) lines.insert(refusal_text(static_cast<MissingShader>(i)));
  EXPECT_EQ(lines.size(), static_cast<std::size_t>(faults + shaders));
  for (const std::string& line : lines) EXPECT_EQ(line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace spanline::sim
