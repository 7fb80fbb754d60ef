// Traits of a renderer: options in any order, each with its default.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <type_traits>

namespace spanline::test {
namespace {

using Shaders = ShaderList<FlatShader<Rgb565>>;
template <class... Options>
using With = RendererTraits<Rgb565, Shaders, Options...>;

TEST(Traits, OptionsStandInAnyOrder) {
  EXPECT_TRUE((std::is_same_v<With<Depth24<>, Spanning>, With<Spanning, Depth24<>>>));
  EXPECT_TRUE((std::is_same_v<With<Counted, Depth24<>, Deferred<8>>, With<Deferred<8>, Counted, Depth24<>>>));
  EXPECT_TRUE((std::is_same_v<FlatTraits<Rgb565, Depth24<>, Spanning>, With<Depth24<>, Spanning>>));
}

TEST(Traits, WhatIsNotNamedHasItsDefault) {
  EXPECT_TRUE((std::is_same_v<With<>, With<ZBuffer, Depth16<>>>)) << "one type, or programs would link it twice";
  EXPECT_TRUE((std::is_same_v<With<>::Depth, Depth16<>>));
  EXPECT_TRUE((std::is_same_v<With<>::Visibility, ZBuffer>));
  EXPECT_FALSE(With<>::statistics);
  EXPECT_TRUE((std::is_same_v<With<Spanning>::Depth, Depth16<>>));
  EXPECT_TRUE((std::is_same_v<With<Depth24<>>::Visibility, ZBuffer>));
}

TEST(Traits, EachOptionIsTakenForWhatItIs) {
  using All = With<Counted, BoundedZBuffer, Depth24<DepthSense::larger_is_nearer>>;
  EXPECT_TRUE((std::is_same_v<All::Depth, Depth24<DepthSense::larger_is_nearer>>));
  EXPECT_TRUE((std::is_same_v<All::Visibility, BoundedZBuffer>));
  EXPECT_TRUE(All::statistics);
  EXPECT_TRUE(DepthOption<Depth16<>> && !DepthOption<Spanning> && !DepthOption<Counted> && !DepthOption<int>);
  EXPECT_TRUE(VisibilityOption<Deferred<>> && !VisibilityOption<Depth16<>> && !VisibilityOption<Counted>);
  EXPECT_TRUE((std::is_same_v<IdTraits<Counted>::Format, PolygonIds> && IdTraits<Counted>::statistics));
}

}  // namespace
}  // namespace spanline::test
