// Values that programs rely on without naming them: defaults, limits, and a colour's eight bits. Written out here,
// since tests that use the constants themselves would follow any change of them.
#include <gtest/gtest.h>

#include <cmath>

#include "spanline/frame/frame_settings.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/memory/pool_peaks.hpp"
#include "spanline/model/material.hpp"

namespace spanline::test {
namespace {

TEST(PublicValues, ACapacityThatSaysNothingHasRoomForAPictureAndNoPolygons) {
  constexpr Capacity c;
  EXPECT_EQ(c.width, 320);
  EXPECT_EQ(c.height, 240);
  EXPECT_EQ(c.band_lines, 16);
  EXPECT_EQ(c.colour_bands, 2);
  EXPECT_EQ(c.depth_bands, 1);
  EXPECT_EQ(c.instances, 1U);
  for (const std::uint32_t pool : {c.vertices, c.shades, c.textures, c.polygons, c.fans, c.active, c.layers})
    EXPECT_EQ(pool, 0U);
  EXPECT_TRUE(c.valid());
}

TEST(PublicValues, PeaksBeginAtNothing) { EXPECT_EQ(PoolPeaks{}.total(), 0U); }

TEST(PublicValues, AFrameThatSaysNothingIsBlackFullyLitAndWithoutEffects) {
  const FrameSettings s;
  EXPECT_EQ(s.background, (Rgb888{0, 0, 0}));
  EXPECT_EQ(s.cull, Cull::back);
  EXPECT_EQ(s.stipple_seed, 0);
  EXPECT_FALSE(s.dither);
  EXPECT_EQ(s.fog.curve, FogCurve::none);
  EXPECT_EQ(s.lighting.ambient.raw(), 1 << 16);
  EXPECT_EQ(s.camera.projection, Projection::perspective);
  EXPECT_EQ(s.camera.focal.raw(), 240 << 16);
  EXPECT_EQ(s.camera.near_plane.raw(), 6554);
  EXPECT_EQ(s.camera.far_plane.raw(), 100 << 16);
}

TEST(PublicValues, AMaterialThatSaysNothingIsWhiteAndOpaque) {
  const Material m;
  EXPECT_EQ(m.colour, (Rgb888{255, 255, 255}));
  EXPECT_EQ(m.shading, ShadingMode::flat);
  EXPECT_EQ(m.opacity, 255);
  EXPECT_EQ(m.transparency, Transparency::blend);
  EXPECT_EQ(m.specular, (Rgb888{0, 0, 0}));
  EXPECT_EQ(m.shininess, 32);
  EXPECT_EQ(m.texturing.texture, nullptr);
  EXPECT_EQ(m.relief.heights, nullptr);
  EXPECT_EQ(m.volume.source, SolidSource::none);
  EXPECT_TRUE(m.texture_matrix == TextureMatrix{});
  EXPECT_EQ(m.texture_matrix.ss.raw(), 1 << 16);
  EXPECT_EQ(m.texture_matrix.st.raw(), 0);
}

TEST(PublicValues, LimitsAreThoseOfTheDocumentation) {
  EXPECT_EQ(Mesh::max_corners, 8U);
  EXPECT_EQ(Mesh::max_vertices, 65535U);
  EXPECT_EQ(Mesh::max_polygons, 32767U);
  EXPECT_EQ(Texture::max_log2_size, 11U);
  EXPECT_EQ(Texture::max_log2_texels, 20U);
  EXPECT_EQ(Texture::max_levels, 12U);
  EXPECT_EQ(HeightMap::max_log2_size, 11U);
  EXPECT_EQ(VolumeTexture::max_log2_size, 7U);
  EXPECT_EQ(Lighting::max_lights, 4U);
}

TEST(PublicValues, AnRgb565WordIsWidenedToTheNearestEightBits) {
  for (std::uint32_t word = 0; word < 65536; ++word) {
    const Rgb888 c = widened(static_cast<std::uint16_t>(word));
    // Repeated bits are within a step of the exact value.
    ASSERT_NEAR(c.red, (word >> 11) * 255 / 31.0, 1) << word;
    ASSERT_NEAR(c.green, (word >> 5 & 63) * 255 / 63.0, 1) << word;
    ASSERT_NEAR(c.blue, (word & 31) * 255 / 31.0, 1) << word;
  }
  EXPECT_EQ(widened(0xffff), (Rgb888{255, 255, 255}));
  EXPECT_EQ(widened(0), (Rgb888{0, 0, 0}));
}

TEST(PublicValues, AFieldOfViewHasTheFocalLengthOfItsTangent) {
  for (int degrees = 1; degrees < 180; ++degrees) {
    const double exact = 240 / 2.0 / std::tan(degrees * 3.14159265358979 / 360);
    const double got = std::ldexp(Camera::focal_for(Angle::from_degrees(degrees), 240).raw(), -16);
    EXPECT_NEAR(got, exact, exact * 1e-5 + 1e-4) << degrees;
  }
  EXPECT_EQ(Camera::focal_for(Angle::from_raw(1), 240).raw(), 0x7fffffff) << "an angle of nothing";
}

}  // namespace
}  // namespace spanline::test
