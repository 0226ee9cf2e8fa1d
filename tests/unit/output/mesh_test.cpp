// SPDX-License-Identifier: MIT
#include "orthoball/output/mesh.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "unit/output/shapes.h"
#include "unit/output/written_bytes.h"

namespace orthoball {
namespace {

struct Written {
  ShapeMesh mesh;
  std::string bytes;
};

Written mixed(MeshFormat format, bool roles) {
  const auto shapes = mixed_shapes();
  const std::uint32_t index = shapes.filtration.index(1.0);
  Written result{shape_mesh(AlphaComplex(shapes.filtration, index), shapes.points), {}};
  result.bytes = written([&](ByteSink& s) { write_mesh(s, result.mesh, {format, roles, 1.0}); });
  return result;
}

TEST(Mesh, FormatsAreToldByTheirNames) {
  EXPECT_EQ(mesh_format("glb"), MeshFormat::glb);
  EXPECT_FALSE(mesh_format("step").has_value());
  EXPECT_FALSE(holds_edges(MeshFormat::stl));
  EXPECT_TRUE(holds_edges(MeshFormat::vtu));
  EXPECT_FALSE(holds_roles(MeshFormat::stl));
  EXPECT_TRUE(holds_roles(MeshFormat::off));
}

TEST(Mesh, PlyHoldsVerticesWithRowsThenTrianglesThenEdgesWithRoles) {
  const auto [mesh, bytes] = mixed(MeshFormat::ply, true);
  const std::string end = "end_header\n";
  const std::size_t header = bytes.find(end) + end.size();
  EXPECT_EQ(bytes.substr(0, 40), "ply\nformat binary_little_endian 1.0\ncomm");
  EXPECT_NE(bytes.find("element vertex 12\n"), std::string::npos);
  EXPECT_NE(bytes.find("element face 9\n"), std::string::npos);
  EXPECT_NE(bytes.find("element edge 1\n"), std::string::npos);
  std::string_view rest = std::string_view(bytes).substr(header);
  for (std::size_t v = 0; v < 12; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(take<double>(rest), mesh.coordinates[3 * v + axis]);
    }
    EXPECT_EQ(take<std::uint32_t>(rest), mesh.rows[v].row());
  }
  for (std::size_t t = 0; t < 9; ++t) {
    EXPECT_EQ(take<std::uint8_t>(rest), 3);
    for (const std::uint32_t v : mesh.triangles[t]) EXPECT_EQ(take<std::uint32_t>(rest), v);
    EXPECT_EQ(take<std::uint8_t>(rest), t < 8 ? 2 : 1);
  }
  for (const std::uint32_t v : mesh.edges[0]) EXPECT_EQ(take<std::uint32_t>(rest), v);
  EXPECT_EQ(take<std::uint8_t>(rest), 1);
  EXPECT_TRUE(rest.empty());
}

TEST(Mesh, ObjNumbersFromOneAndGroupsByRole) {
  const std::string obj = mixed(MeshFormat::obj, true).bytes;
  std::istringstream lines(obj);
  int vertices = 0, triangles = 0, edges = 0, points = 0, largest = 0;
  std::string line, group;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "g") words >> group;
    vertices += word == "v";
    triangles += word == "f";
    edges += word == "l";
    points += word == "p";
    if (word == "l" || word == "p") {
      EXPECT_EQ(group, "singular");
    }
    for (int number = 0; (word == "f" || word == "l" || word == "p") && words >> number;) {
      EXPECT_GE(number, 1);
      largest = std::max(largest, number);
    }
  }
  EXPECT_EQ(vertices, 12);
  EXPECT_EQ(triangles, 9);
  EXPECT_EQ(edges, 1);
  EXPECT_EQ(points, 1);
  EXPECT_EQ(largest, 12);
}

TEST(Mesh, OffHasItsCountsOnOneLineAndColoursByRole) {
  const std::string off = mixed(MeshFormat::off, true).bytes;
  EXPECT_EQ(off.substr(0, 4), "OFF\n");
  EXPECT_NE(off.find("\n12 9 0\n"), std::string::npos);
  EXPECT_NE(off.find(" 86 180 233\n"), std::string::npos);
  EXPECT_NE(off.find(" 230 159 0\n"), std::string::npos);
}

TEST(Mesh, StlHasFiftyBytesATriangleAndUnitNormalsThatPointOutwards) {
  const auto [mesh, bytes] = mixed(MeshFormat::stl, false);
  ASSERT_EQ(bytes.size(), 84U + 50U * 9U);
  EXPECT_NE(bytes.substr(0, 5), "solid");
  std::string_view rest = std::string_view(bytes).substr(80);
  EXPECT_EQ(take<std::uint32_t>(rest), 9U);
  for (int t = 0; t < 8; ++t) {  // the octahedron around the origin
    float numbers[12];
    for (float& x : numbers) x = take<float>(rest);
    EXPECT_NEAR(numbers[0] * numbers[0] + numbers[1] * numbers[1] + numbers[2] * numbers[2], 1.0,
                1e-6);
    EXPECT_GT(numbers[0] * numbers[3] + numbers[1] * numbers[4] + numbers[2] * numbers[5], 0.5);
    EXPECT_EQ(take<std::uint16_t>(rest), 0);
  }
}

TEST(Mesh, VtuHoldsTrianglesLinesAndVerticesWithRowsAndRoles) {
  const auto [mesh, vtu] = mixed(MeshFormat::vtu, true);
  EXPECT_NE(vtu.find("NumberOfPoints=\"12\" NumberOfCells=\"11\""), std::string::npos);
  EXPECT_EQ(data_array(vtu, "points").size(), 12U * 24U);
  EXPECT_EQ(data_array(vtu, "connectivity").size(), 8U * (9U * 3U + 2U + 1U));
  EXPECT_EQ(data_array(vtu, "types"), std::string(9, '\5') + '\3' + '\1');
  EXPECT_EQ(data_array(vtu, "role"), std::string(8, '\2') + "\1\1\1");
  std::string rows = data_array(vtu, "row");
  std::string_view rest = rows;
  for (const SiteId row : mesh.rows) EXPECT_EQ(take<std::uint32_t>(rest), row.row());
  std::string offsets = data_array(vtu, "offsets");
  rest = std::string_view(offsets).substr(offsets.size() - 8);
  EXPECT_EQ(take<std::int64_t>(rest), 30);
}

TEST(Mesh, GlbIsConsistentWithItsOwnDescription) {
  const auto [mesh, bytes] = mixed(MeshFormat::glb, true);
  std::string_view rest = bytes;
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  rest.remove_prefix(4);
  EXPECT_EQ(take<std::uint32_t>(rest), 2U);
  EXPECT_EQ(take<std::uint32_t>(rest), bytes.size());
  const auto json_size = take<std::uint32_t>(rest);
  EXPECT_EQ(json_size % 4, 0U);
  EXPECT_EQ(rest.substr(0, 4), "JSON");
  const auto json = nlohmann::json::parse(rest.substr(4, json_size));
  rest.remove_prefix(4 + json_size);
  const auto binary_size = take<std::uint32_t>(rest);
  EXPECT_EQ(rest.substr(0, 4), std::string_view("BIN\0", 4));
  rest.remove_prefix(4);
  ASSERT_EQ(rest.size(), binary_size);
  EXPECT_EQ(json["buffers"][0]["byteLength"], binary_size);

  const auto& primitives = json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 4U);  // regular and singular triangles, edges, points
  const std::size_t counts[] = {24, 3, 2, 1};
  const int modes[] = {4, 4, 1, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(primitives[i]["mode"], modes[i]);
    const auto& accessor = json["accessors"][primitives[i]["indices"].get<std::size_t>()];
    EXPECT_EQ(accessor["count"], counts[i]);
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_EQ(view["byteLength"], 4 * counts[i]);
    std::string_view indices = rest.substr(view["byteOffset"].get<std::size_t>());
    for (std::size_t k = 0; k < counts[i]; ++k) EXPECT_LT(take<std::uint32_t>(indices), 12U);
  }
  const auto& node = json["nodes"][0];
  const auto& positions = json["accessors"][0];
  EXPECT_EQ(positions["count"], 12);
  for (std::size_t v = 0; v < 12; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = static_cast<double>(take<float>(rest));
      EXPECT_GE(x, positions["min"][axis].get<double>());
      EXPECT_LE(x, positions["max"][axis].get<double>());
      EXPECT_NEAR(x + node["translation"][axis].get<double>(), mesh.coordinates[3 * v + axis],
                  1e-5);
    }
  }
}

TEST(Mesh, EveryFormatHasAValidFormWithoutAnything) {
  const ShapeMesh nothing;
  for (const MeshFormat format : {MeshFormat::ply, MeshFormat::obj, MeshFormat::off,
                                  MeshFormat::stl, MeshFormat::vtu, MeshFormat::glb}) {
    EXPECT_FALSE(written([&](ByteSink& s) {
                   write_mesh(s, nothing, {format, true, 0.0});
                 }).empty());
  }
  const std::string glb = written([&](ByteSink& s) {
    write_mesh(s, nothing, {MeshFormat::glb, false, 0.0});
  });
  EXPECT_FALSE(nlohmann::json::parse(glb.substr(20)).contains("meshes"));
}

}  // namespace
}  // namespace orthoball
