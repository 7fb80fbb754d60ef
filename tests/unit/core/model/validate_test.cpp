// validate() finds each fault of a mesh and says where it stands.
#include "spanline/model/validate.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/owned_mesh.hpp"

namespace spanline::test {
namespace {

/// Two quadrilaterals and a triangle with all the tables that a mesh may have.
OwnedMesh full_mesh() {
  OwnedMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({static_cast<std::int16_t>(i * 10), static_cast<std::int16_t>(i % 2), 0});
  mesh.indices = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2};
  mesh.corners = {4, 4, 3};
  mesh.polygon_normals.resize(3);
  mesh.polygon_colours.resize(3);
  mesh.vertex_normals.resize(8);
  mesh.vertex_colours.resize(8);
  mesh.texture_coordinates.resize(8);
  mesh.vertex_opacities.resize(8);
  mesh.fit_bounds();
  return mesh;
}

void expect_fault(const OwnedMesh& mesh, MeshFault fault, std::uint32_t at = 0) {
  const MeshReport report = validate(mesh.view());
  EXPECT_EQ(report.fault, fault) << to_string(report.fault);
  EXPECT_EQ(report.at, at);
  EXPECT_FALSE(report.ok());
}

TEST(Validate, AcceptsTheMeshThatTheOtherCasesSpoil) {
  EXPECT_TRUE(validate(full_mesh().view()).ok());
  EXPECT_TRUE(validate(tetrahedron().view()).ok());
}

TEST(Validate, WantsExactlyOneVertexTable) {
  OwnedMesh mesh = full_mesh();
  mesh.wide_vertices.resize(8);
  expect_fault(mesh, MeshFault::two_vertex_tables);
  mesh.vertices.clear();
  mesh.wide_vertices.clear();
  expect_fault(mesh, MeshFault::no_vertices);
}

TEST(Validate, NamesTheFirstIndexOutOfRange) {
  OwnedMesh mesh = full_mesh();
  mesh.indices[9] = 8;
  mesh.indices[10] = 65535;
  expect_fault(mesh, MeshFault::index_out_of_range, 9);
}

TEST(Validate, NamesThePolygonWithTooFewOrTooManyCorners) {
  OwnedMesh mesh = full_mesh();
  mesh.corners = {4, 2, 5};
  expect_fault(mesh, MeshFault::corner_count, 1);
  mesh.corners = {3, 3, 9};
  expect_fault(mesh, MeshFault::corner_count, 2);
  mesh.corners = {0, 8, 3};
  expect_fault(mesh, MeshFault::corner_count, 0);
}

TEST(Validate, WantsIndicesToFitTheCorners) {
  OwnedMesh mesh = full_mesh();
  mesh.corners = {4, 3, 3};
  expect_fault(mesh, MeshFault::ragged_indices, 10);
  OwnedMesh triangles = tetrahedron();
  triangles.indices.pop_back();
  expect_fault(triangles, MeshFault::ragged_indices, 11);
  triangles.indices.clear();
  expect_fault(triangles, MeshFault::no_polygons);
}

TEST(Validate, WantsNoneOrOneAttributeEach) {
  const auto spoil = [](auto table, MeshFault fault) {
    OwnedMesh mesh = full_mesh();
    (mesh.*table).pop_back();
    expect_fault(mesh, fault);
    (mesh.*table).clear();
    EXPECT_TRUE(validate(mesh.view()).ok());
    (mesh.*table).resize(20);
    expect_fault(mesh, fault);
  };
  spoil(&OwnedMesh::polygon_normals, MeshFault::polygon_normals_count);
  spoil(&OwnedMesh::vertex_normals, MeshFault::vertex_normals_count);
  spoil(&OwnedMesh::polygon_colours, MeshFault::polygon_colours_count);
  spoil(&OwnedMesh::vertex_colours, MeshFault::vertex_colours_count);
  spoil(&OwnedMesh::texture_coordinates, MeshFault::texture_coordinates_count);
  spoil(&OwnedMesh::vertex_opacities, MeshFault::vertex_opacities_count);
}

TEST(Validate, HoldsMarksOfPlanarPolygonsAgainstTheirCorners) {
  OwnedMesh mesh = full_mesh();
  for (std::size_t i = 0; i < 8; ++i)
    mesh.vertices[i] = {static_cast<std::int16_t>(i % 4 % 3 == 0 ? 0 : 90),
                        static_cast<std::int16_t>(i % 4 < 2 ? 0 : 90), 0};
  mesh.fit_bounds();
  for (std::uint8_t& corners : mesh.corners) corners |= Mesh::planar;
  EXPECT_TRUE(validate(mesh.view()).ok());
  EXPECT_EQ(mesh.view().triangle_count(), 5U);
  EXPECT_EQ(mesh.view().first_corner(2), 8U);
  mesh.texture_coordinates[5].t = 1000;
  expect_fault(mesh, MeshFault::not_linear, 1);
  mesh.vertices[5].z = 40;
  mesh.fit_bounds();
  expect_fault(mesh, MeshFault::not_planar, 1);
  mesh.corners[1] = 4;
  EXPECT_TRUE(validate(mesh.view()).ok()) << "nothing is said of a polygon without a mark";
  mesh.corners = {2 | Mesh::planar, 6, 3};
  expect_fault(mesh, MeshFault::corner_count, 0);
}

TEST(Validate, NamesTheVertexOutsideTheSphere) {
  OwnedMesh mesh = tetrahedron(100);
  mesh.bounds = {{0, 0, 0}, 174};  // the corners are 173.2 away
  EXPECT_TRUE(validate(mesh.view()).ok());
  mesh.bounds.radius = 173;
  expect_fault(mesh, MeshFault::bounds_too_small, 0);
  mesh.bounds = {{-50, 0, 0}, 174};
  expect_fault(mesh, MeshFault::bounds_too_small, 0);
  mesh.bounds = {{50, 0, 0}, 174};
  expect_fault(mesh, MeshFault::bounds_too_small, 1);
}

TEST(Validate, KeepsWideCoordinatesAndOffsetsIn2ToThe30) {
  constexpr std::int32_t limit = 1 << 30;
  OwnedMesh mesh;
  mesh.wide_vertices = {{limit, 0, 0}, {-limit, 0, 0}, {0, limit, -limit}};
  mesh.triangle(0, 1, 2);
  mesh.bounds = {{0, 0, 0}, 0x7fffffff};
  mesh.offset = {limit, -limit, limit};
  EXPECT_TRUE(validate(mesh.view()).ok()) << "the limits themselves are valid";
  for (const auto axis : {&Vertex32::x, &Vertex32::y, &Vertex32::z}) {
    OwnedMesh spoilt = mesh;
    spoilt.wide_vertices[1].*axis = limit + 1;
    expect_fault(spoilt, MeshFault::vertex_out_of_range, 1);
    spoilt.wide_vertices[1].*axis = std::numeric_limits<std::int32_t>::min();
    expect_fault(spoilt, MeshFault::vertex_out_of_range, 1);
  }
  mesh.offset.y = -limit - 1;
  expect_fault(mesh, MeshFault::vertex_out_of_range);
}

TEST(Validate, ComputesDistancesOfExtremeSpheresWithoutOverflow) {
  constexpr std::int32_t limit = 1 << 30;
  OwnedMesh mesh;
  mesh.wide_vertices = {{limit, limit, limit}, {-limit, -limit, -limit}, {0, 0, 0}};
  mesh.triangle(0, 1, 2);
  mesh.bounds = {{0, 0, 0}, 1859775394};  // ⌈2^30·√3⌉
  EXPECT_TRUE(validate(mesh.view()).ok());
  mesh.bounds.radius -= 1;
  expect_fault(mesh, MeshFault::bounds_too_small, 0);
  mesh.bounds = {{std::numeric_limits<std::int32_t>::min(), 0, 0}, 0xffffffff};
  EXPECT_TRUE(validate(mesh.view()).ok());
}

TEST(Validate, KeepsStepExponentsInTheirRange) {
  OwnedMesh mesh = tetrahedron();
  for (int exponent = -128; exponent <= 127; ++exponent) {
    mesh.step_exponent = static_cast<std::int8_t>(exponent);
    if (exponent >= -30 && exponent <= 14)
      EXPECT_TRUE(validate(mesh.view()).ok()) << exponent;
    else
      expect_fault(mesh, MeshFault::step_exponent_range);
  }
}

TEST(Validate, KeepsTextureExponentsInTheirRange) {
  OwnedMesh mesh = tetrahedron();
  for (int exponent = -128; exponent <= 127; ++exponent) {
    mesh.texture_exponent = static_cast<std::int8_t>(exponent);
    if (exponent >= -20 && exponent <= -5)
      EXPECT_TRUE(validate(mesh.view()).ok()) << exponent;
    else
      expect_fault(mesh, MeshFault::texture_exponent_range);
  }
}

TEST(Validate, TakesMeshesAtTheirLimitsAndNoLarger) {
  OwnedMesh mesh;
  mesh.vertices.resize(Mesh::max_vertices);
  mesh.bounds.radius = 1;
  mesh.indices.resize(Mesh::max_polygons * 3, 65534);
  EXPECT_TRUE(validate(mesh.view()).ok());
  mesh.indices.resize(mesh.indices.size() + 3);
  expect_fault(mesh, MeshFault::too_many_polygons, Mesh::max_polygons);
  mesh.indices.resize(3);
  mesh.vertices.resize(Mesh::max_vertices + 1);
  expect_fault(mesh, MeshFault::too_many_vertices, Mesh::max_vertices);
}

TEST(Validate, CountsTrianglesOfFans) {
  const OwnedMesh owned = full_mesh();
  const Mesh mesh = owned.view();
  EXPECT_EQ(mesh.polygon_count(), 3U);
  EXPECT_EQ(mesh.triangle_count(), 5U);
  EXPECT_EQ(mesh.vertex_count(), 8U);
}

TEST(Validate, GivesEveryFaultAnEnglishName) {
  std::set<std::string> names;
  for (int fault = 0; fault <= static_cast<int>(MeshFault::bounds_too_small); ++fault)
    names.insert(to_string(static_cast<MeshFault>(fault)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(MeshFault::bounds_too_small) + 1);
  EXPECT_FALSE(names.contains("unknown fault"));
}

TEST(PackedNormals, KeepEveryComponent) {
  for (int c = -511; c <= 511; ++c) {
    const PackedNormal n(c, -c, c / 2);
    ASSERT_TRUE(n.x() == c && n.y() == -c && n.z() == c / 2) << c;
  }
}

}  // namespace
}  // namespace spanline::test
