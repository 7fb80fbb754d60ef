// Frames: settings that are refused, sinks that fail, shaders that are missing, buffers that take turns.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <vector>

#include "support/owned_mesh.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;
using Traits = FlatTraits<Rgb565, Depth16<>>;

Capacity small_capacity() {
  return {.width = 64,
          .height = 48,
          .band_lines = 10,
          .colour_bands = 2,
          .instances = 4,
          .vertices = 40,
          .shades = 40,
          .polygons = 40,
          .fans = 40,
          .active = 40};
}

struct Ready {
  std::vector<std::byte> memory{Renderer<Traits>::bytes_needed(small_capacity())};
  Renderer<Traits> renderer{small_capacity(), memory};
  OwnedMesh owned = tetrahedron();
  Mesh mesh = owned.view();
  Transform transform;
  FrameSettings settings;
  Ready() { transform.translation.z = -4.0_q16; }
};

TEST(Settings, PlanesAndFocalLengthOutOfRangeAreRefused) {
  Ready r;
  const auto fault = [&](auto change) {
    FrameSettings settings = r.settings;
    change(settings.camera);
    const Fault begun = r.renderer.begin(settings).fault;
    if (begun != Fault::none) {
      EXPECT_EQ(r.renderer.add(r.mesh, r.transform, {}).fault, begun);
      EXPECT_EQ(r.renderer.draw([](const auto&) { return true; }).fault, begun);
    }
    return begun;
  };
  EXPECT_EQ(fault([](Camera&) {}), Fault::none);
  EXPECT_EQ(fault([](Camera& c) { c.near_plane = c.far_plane; }), Fault::bad_planes);
  EXPECT_EQ(fault([](Camera& c) { c.near_plane = 101.0_q16; }), Fault::bad_planes);
  EXPECT_EQ(fault([](Camera& c) { c.near_plane = {}; }), Fault::bad_planes);
  EXPECT_EQ(fault([](Camera& c) { c.near_plane = -1.0_q16; }), Fault::bad_planes);
  EXPECT_EQ(fault([](Camera& c) { c.focal = {}; }), Fault::bad_focal);
  EXPECT_EQ(fault([](Camera& c) { c.focal = -5.0_q16; }), Fault::bad_focal);
  const auto ortho = [](Camera& c) {
    c.projection = Projection::orthographic;
    c.near_plane = -3.0_q16;
  };
  EXPECT_EQ(fault(ortho), Fault::none) << "an orthographic view may begin behind the eye";
}

TEST(Settings, AnOrthographicRangeMayEndAtOrBehindTheEye) {
  for (const Q16_16 far : {Q16_16{}, -1.0_q16, Q16_16::from_raw(1)}) {
    Ready r;
    r.settings.camera.projection = Projection::orthographic;
    r.settings.camera.focal = 10.0_q16;
    r.settings.camera.near_plane = -7.0_q16;
    r.settings.camera.far_plane = far;
    r.transform.translation.z = 4.0_q16;  // four units behind the eye
    ASSERT_TRUE(r.renderer.begin(r.settings).ok());
    EXPECT_TRUE(r.renderer.add(r.mesh, r.transform, {}).ok());
    std::size_t lit = 0;
    EXPECT_TRUE(r.renderer
                    .draw([&](const auto& band) {
                      for (const auto d : band.depth) lit += d != Depth16<>::clear ? 1U : 0U;
                      return true;
                    })
                    .ok());
    EXPECT_GT(lit, 100U) << far.raw();
  }
}

TEST(Sink, AFrameEndsWhereItFailsAndTheNextIsWhole) {
  Ready r;
  const auto frame = [&](int failing_band) {
    EXPECT_TRUE(r.renderer.begin(r.settings).ok());
    EXPECT_TRUE(r.renderer.add(r.mesh, r.transform, {}).ok());
    int bands = 0;
    const Status status = r.renderer.draw([&](const auto&) { return bands++ != failing_band; });
    return std::pair{status, bands};
  };
  for (int band = 0; band < 5; ++band) {
    EXPECT_EQ(frame(band), (std::pair{Status{Fault::sink_failed, Pool::none, 0}, band + 1}));
    EXPECT_EQ(frame(99), (std::pair{Status{}, 5}));
  }
}

struct Acquiring {
  std::vector<unsigned> acquired;
  std::vector<unsigned> sent;
  std::size_t give_up = 99;
  bool acquire(unsigned buffer) {
    acquired.push_back(buffer);
    return acquired.size() <= give_up;
  }
  template <class Band>
  bool operator()(const Band& band) {
    sent.push_back(band.buffer);
    return true;
  }
};

TEST(Sink, TwoBuffersTakeTurnsAndAreAcquiredFirst) {
  Ready r;
  ASSERT_TRUE(r.renderer.begin(r.settings).ok());
  Acquiring sink;
  EXPECT_TRUE(r.renderer.draw(sink).ok());
  EXPECT_EQ(sink.acquired, (std::vector<unsigned>{0, 1, 0, 1, 0}));
  EXPECT_EQ(sink.sent, sink.acquired);
}

TEST(Sink, ManyBuffersTakeTurnsAcrossFramesAndLieApart) {
  Ready r;
  Capacity capacity = small_capacity();
  capacity.colour_bands = 3;
  std::vector<std::byte> memory(Renderer<Traits>::bytes_needed(capacity));
  Renderer<Traits> renderer(capacity, memory);
  ASSERT_TRUE(renderer.status().ok());
  for (unsigned i = 1; i < 3; ++i)
    EXPECT_GE(renderer.colour_band(i).data(), renderer.colour_band(i - 1).data() + renderer.colour_band(i - 1).size());
  EXPECT_TRUE(renderer.colour_band(3).empty());
  std::vector<unsigned> used;
  for (int frame = 0; frame < 2; ++frame) {
    ASSERT_TRUE(renderer.begin(r.settings).ok());
    ASSERT_TRUE(renderer.add(r.mesh, r.transform, {}).ok());
    EXPECT_TRUE(renderer
                    .draw([&](const auto& band) {
                      EXPECT_EQ(band.pixels.data(), renderer.colour_band(band.buffer).data());
                      used.push_back(band.buffer);
                      return true;
                    })
                    .ok());
  }
  EXPECT_EQ(used, (std::vector<unsigned>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0}));  // five bands a frame
}

TEST(Sink, ABufferThatNeverComesFreeEndsTheFrame) {
  Ready r;
  ASSERT_TRUE(r.renderer.begin(r.settings).ok());
  Acquiring sink;
  sink.give_up = 2;
  EXPECT_EQ(r.renderer.draw(sink).fault, Fault::sink_failed);
  EXPECT_EQ(sink.sent.size(), 2U);
}

TEST(Sink, BandsCoverThePictureFromTopToBottom) {
  Ready r;
  ASSERT_TRUE(r.renderer.begin(r.settings).ok());
  std::int32_t next = 0;
  EXPECT_TRUE(r.renderer
                  .draw([&](const auto& band) {
                    EXPECT_EQ(band.y0, next);
                    EXPECT_EQ(band.pixels.size(), 64U * static_cast<unsigned>(band.y1 - band.y0));
                    EXPECT_EQ(band.depth.size(), band.pixels.size());
                    next = band.y1;
                    return true;
                  })
                  .ok());
  EXPECT_EQ(next, 48);
}

TEST(Frames, AnEmptyOneShowsTheBackground) {
  Ready r;
  r.settings.background = {255, 0, 255};
  ASSERT_TRUE(r.renderer.begin(r.settings).ok());
  EXPECT_TRUE(r.renderer
                  .draw([](const auto& band) {
                    for (const auto pixel : band.pixels) EXPECT_EQ(pixel, 0xf81f);
                    for (const auto depth : band.depth) EXPECT_EQ(depth, 0xffff);
                    return true;
                  })
                  .ok());
}

TEST(Frames, AMissingShaderIsAStatusAndLeavesTheInstanceOut) {
  Ready r;
  ASSERT_TRUE(r.renderer.begin(r.settings).ok());
  EXPECT_EQ(r.renderer.add(r.mesh, r.transform, {{}, ShadingMode::gouraud}), Status(MissingShader::gouraud));
  EXPECT_TRUE(r.renderer.add(r.mesh, r.transform, {{}, ShadingMode::flat}).ok());
  EXPECT_TRUE(r.renderer.draw([](const auto&) { return true; }).ok());
}

TEST(Frames, IdsCountThroughInstancesThatAreNotSeen) {
  Studio<IdTraits<>> studio(small_capacity());
  const OwnedMesh owned = tetrahedron();
  const Mesh mesh = owned.view();
  Transform behind, before;
  behind.translation.z = 40.0_q16;
  before.translation.z = -4.0_q16;
  FrameSettings settings;
  studio.begin(settings);
  studio.add(mesh, behind, {});
  studio.add(mesh, before, {});
  const auto picture = studio.draw();
  EXPECT_EQ(studio.statistics().polygons.total, 8U);
  EXPECT_EQ(studio.statistics().polygons.outside, 4U);
  ASSERT_GT(picture.drawn_count(), 0U);
  for (const std::uint32_t id : picture.pixels) EXPECT_TRUE(id == 0 || (id > 4 && id <= 8)) << id;
}

TEST(Frames, EveryStatusHasAName) {
  EXPECT_STREQ(to_string(Fault::sink_failed), "sink failed");
  EXPECT_STREQ(to_string(Pool::active), "active");
}

}  // namespace
}  // namespace spanline::test
