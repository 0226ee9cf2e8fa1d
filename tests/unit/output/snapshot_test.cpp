// SPDX-License-Identifier: MIT
#include "orthoball/output/snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>

#include "generators/point_families.h"
#include "orthoball/queries/representatives.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/persistence.h"
#include "unit/output/shapes.h"
#include "unit/output/snapshot_reader.h"

namespace orthoball {
namespace {

const SnapshotFacts kFacts{.source = "a \"name\".csv", .unit = "Å", .radii = "none"};

template <int D>
std::string snapshot(const Shapes<D>& shapes, const SiteLabels& labels = {}) {
  return written([&](ByteSink& sink) {
    write_snapshot(sink, shapes.filtration, shapes.points, labels, kFacts);
  });
}

SiteLabels some_labels(std::size_t rows) {
  SiteLabels labels;
  for (std::size_t row = 0; row < rows; ++row) {
    labels.line.push_back(static_cast<std::uint32_t>(10 * row + 3));
    labels.element.emplace_back(row % 3 == 0 ? "C" : "N");
    labels.atom.emplace_back("CA");
    labels.residue.emplace_back(row < 4 ? "ALA" : "GLY");
    labels.residue_id.push_back(std::to_string(row / 2));
    labels.chain.emplace_back("A");
  }
  return labels;
}

// Rows of the tables of the description whose first cell is a name in backticks.
std::vector<std::vector<std::string>> described(const std::string& heading) {
  std::ifstream file(ORTHOBALL_SOURCE_DIR "/docs/file_formats/snapshot.md");
  std::vector<std::vector<std::string>> rows;
  bool is_there = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) is_there = line == "## " + heading;
    if (!is_there || line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 2; at < line.size();) {
      const std::size_t end = line.find(" |", at);
      cells.push_back(line.substr(at, end - at));
      at = end + 3;
    }
    cells[0] = cells[0].substr(1, cells[0].size() - 2);
    rows.push_back(cells);
  }
  return rows;
}

bool holds_where(const std::string& where, const nlohmann::json& header) {
  const int dimension = header["dimension"], span = header["affine_dimension"];
  const std::map<std::string, bool> conditions{
      {"always", true},
      {"weights != none", header["weights"] != "none"},
      {"D = 3", dimension == 3},
      {"A = D", span == dimension},
      {"A != D", span != dimension},
      {"D = 3 and A != D", dimension == 3 && span != 3},
      {"D != 2 or A != D", dimension != 2 || span != 2},
      {"D != 3 or A != D", dimension != 3 || span != 3},
      {"text formats", header["dictionaries"].contains("atom")},
      {"molecules", header["dictionaries"].contains("atom")}};
  return conditions.at(where);
}

std::size_t length_of(const std::string& text, const nlohmann::json& header) {
  std::size_t product = 1;
  std::string rest = text;
  while (!rest.empty()) {
    const std::string factor = rest.substr(0, rest.find(" * "));
    rest = factor.size() == rest.size() ? "" : rest.substr(factor.size() + 3);
    if (factor == "D") {
      product *= header["dimension"].get<std::size_t>();
    } else if (factor == "s") {
      product *= header["spectrum_size"].get<std::size_t>();
    } else if (factor == "facets") {
      product *= header[header["dimension"] == 3 ? "triangles" : "edges"].get<std::size_t>();
    } else if (std::isdigit(factor[0]) != 0) {
      product *= std::stoul(factor);
    } else {
      product *= header.at(factor).get<std::size_t>();
    }
  }
  return product;
}

void expect_as_described(const std::string& bytes) {
  const PackedReader read(bytes);
  std::set<std::string> expected;
  for (const auto& cells : described("The arrays")) {
    if (!holds_where(cells[3], read.header())) continue;
    expected.insert(cells[0]);
    ASSERT_TRUE(read.has(cells[0])) << cells[0];
    const auto& array = read.array(cells[0]);
    EXPECT_NE(cells[1].find(array["type"]), std::string::npos) << cells[0];
    EXPECT_EQ(array["length"], length_of(cells[2], read.header())) << cells[0];
  }
  EXPECT_GT(expected.size(), 10U);
  for (const auto& array : read.header()["arrays"]) {
    EXPECT_EQ(expected.count(array["name"]), 1U) << array["name"] << " is not described";
  }
  std::set<std::string> members;
  for (const auto& cells : described("The header")) {
    const std::set<std::string> of_space{"tetrahedra", "pairs_2", "cycles", "cycle_edges"};
    const bool is_of_space = of_space.count(cells[0]) > 0;
    if (is_of_space && read.header()["dimension"] == 2) continue;
    members.insert(cells[0]);
    EXPECT_TRUE(read.header().contains(cells[0])) << cells[0];
  }
  for (const auto& member : read.header().items()) {
    EXPECT_EQ(members.count(member.key()), 1U) << member.key() << " is not described";
  }
}

Shapes<2> planar() {
  return checkered(4, [](int x, int y) { return x == 1 && y == 2; });
}

Shapes<3> flat() { return Shapes<3>({0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 5, 5, 1}); }

TEST(Snapshot, HoldsWhatItsDescriptionSays) {
  expect_as_described(snapshot(mixed_shapes()));
  expect_as_described(snapshot(planar()));
  expect_as_described(snapshot(flat()));
  expect_as_described(snapshot(Shapes<3>({})));
  expect_as_described(snapshot(Shapes<2>({1, 2, 1, 2, 1, 2})));
  const auto shapes = mixed_shapes();
  expect_as_described(snapshot(shapes, some_labels(shapes.points.size())));
}

// The corners and the three indices of every simplex, as a reader of the file finds them.
template <int D>
void expect_simplices(const Shapes<D>& shapes) {
  const Filtration<D>& filtration = shapes.filtration;
  const PackedReader read(snapshot(shapes));
  const std::array<std::string, 4> nouns{"vertices", "edges", "triangles", "tetrahedra"};
  const bool has_cells = filtration.triangulation().affine_dimension() == D;
  for (int k = 0; k <= D; ++k) {
    const std::string& noun = nouns[static_cast<std::size_t>(k)];
    const std::size_t corners = static_cast<std::size_t>(k + 1);
    const auto enters = read.numbers(noun + "_enters");
    for (std::uint32_t i = 0; i < enters.size(); ++i) {
      const SimplexId simplex(filtration.table().first(k) + i);
      EXPECT_EQ(enters[i], filtration.enters(simplex));
      std::set<std::uint32_t> found, true_ones;
      for (const VertexId v : filtration.vertices(simplex)) true_ones.insert(v.row());
      std::uint32_t regular = enters[i], interior = enters[i];
      if (has_cells && k == D - 1) {
        const auto cells = read.numbers(nouns[std::size_t{D}]);
        const auto cells_enter = read.numbers(nouns[std::size_t{D}] + "_enters");
        const std::uint32_t owner = read.numbers("facet_owners")[i];
        const std::uint32_t neighbour = read.numbers("facet_neighbours")[i];
        for (std::uint32_t c = 0; c <= D; ++c) {
          if (c != owner % 4) found.insert(cells[owner / 4 * (D + 1) + c]);
        }
        const std::uint32_t other = neighbour == 0xFFFFFFFFU
                                        ? read.header()["spectrum_size"].get<std::uint32_t>() + 1
                                        : cells_enter[neighbour];
        regular = std::min(cells_enter[owner / 4], other);
        interior = std::max(cells_enter[owner / 4], other);
      } else {
        for (std::size_t c = 0; k > 0 && c < corners; ++c) {
          found.insert(read.numbers(noun)[corners * i + c]);
        }
        if (k == 0) found.insert(i);
        if (!has_cells || k < D) {
          regular = read.numbers(noun + "_regular")[i];
          interior = read.numbers(noun + "_interior")[i];
        }
      }
      EXPECT_EQ(found, true_ones);
      EXPECT_EQ(regular, filtration.regular(simplex));
      EXPECT_EQ(interior, filtration.interior(simplex));
    }
  }
}

TEST(Snapshot, KeepsEverySimplexWithItsThreeIndices) {
  expect_simplices(mixed_shapes());
  expect_simplices(planar());
  expect_simplices(flat());
}

TEST(Snapshot, KeepsSitesSpectrumAndSignatures) {
  const auto shapes = mixed_shapes();
  const PackedReader read(snapshot(shapes));
  const auto coordinates = read.reals("coordinates");
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    EXPECT_EQ(coordinates[i], shapes.points.coordinate(i / 3, static_cast<int>(i % 3)));
  }
  const auto rows = read.numbers("vertex_rows");
  for (std::size_t v = 0; v < rows.size(); ++v) {
    EXPECT_EQ(rows[v], shapes.filtration.triangulation().sites().row(v).row());
  }
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 1; i <= shapes.filtration.spectrum_size(); ++i) indices.push_back(i);
  const auto signatures = orthoball::signatures<3>(shapes.filtration, indices);
  ASSERT_EQ(signatures.size(), read.reals("spectrum").size());
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    EXPECT_EQ(read.reals("spectrum")[i], signatures[i].alpha2);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(read.numbers("betti_" + std::to_string(k))[i], signatures[i].betti[k]);
    }
    EXPECT_EQ(read.reals("volume")[i], signatures[i].volume);
    EXPECT_EQ(read.reals("area_singular")[i], signatures[i].area_singular);
    EXPECT_EQ(read.reals("area_regular")[i], signatures[i].area_regular);
    EXPECT_EQ(read.reals("length")[i], signatures[i].length);
  }
}

// The simplices that begin and end each class, as a reader of the file finds them.
template <int D>
void expect_pairs(const Shapes<D>& shapes) {
  const PackedReader read(snapshot(shapes));
  const auto expected = persistence_pairs(shapes.filtration);
  for (std::size_t k = 0; k < D; ++k) {
    const auto& table = shapes.filtration.table();
    const std::uint32_t first = table.first(static_cast<int>(k)),
                        first_filling = table.first(static_cast<int>(k) + 1);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found, true_ones;
    const auto numbers = read.numbers("persistence_" + std::to_string(k));
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      found.emplace(numbers[i], numbers[i + 1]);
      EXPECT_TRUE(i == 0 || numbers[i - 2] < numbers[i]);
    }
    for (const auto& [birth, death] : expected[k]) {
      true_ones.emplace(birth.row() - first,
                        death.exists() ? death.row() - first_filling : 0xFFFFFFFFU);
    }
    EXPECT_EQ(found, true_ones);
    EXPECT_EQ(read.header()["pairs_" + std::to_string(k)], expected[k].size());
  }
}

TEST(Snapshot, KeepsPersistencePairs) {
  expect_pairs(mixed_shapes());
  expect_pairs(planar());
  expect_pairs(flat());
  expect_pairs(Shapes<3>({}));
}

TEST(Snapshot, KeepsCyclesOfTunnels) {
  const auto points = generators::points_of(generators::PointFamily::uniform, 3, 120, 1);
  std::vector<double> coordinates;
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(points.coordinate(row, axis));
  }
  const Shapes<3> shapes(coordinates);
  const PackedReader read(snapshot(shapes));
  const auto pairs = read.numbers("persistence_1"), of = read.numbers("cycle_pairs"),
             ends = read.numbers("cycle_ends"), edges = read.numbers("cycle_edges");
  ASSERT_EQ(of.size(), 100U);
  ASSERT_EQ(read.header()["cycles"], of.size());
  ASSERT_EQ(read.header()["cycle_edges"], edges.size());
  const auto all = persistence_pairs(shapes.filtration, WantedPairs::all);
  Representatives<3> representatives(shapes.filtration, all);
  const auto& table = shapes.filtration.table();
  const auto life = [&](std::uint32_t pair) {
    const auto alpha2 = [&](std::uint32_t simplex) {
      return shapes.filtration.alpha2(shapes.filtration.enters(SimplexId(simplex)));
    };
    return alpha2(table.first(2) + pairs[2 * pair + 1]) - alpha2(table.first(1) + pairs[2 * pair]);
  };
  double shortest = life(of[0]);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const PersistencePair pair{SimplexId(table.first(1) + pairs[2 * of[i]]),
                               SimplexId(table.first(2) + pairs[2 * of[i] + 1])};
    const auto one = representatives.at(1, pair, representatives.usual_index(1, pair));
    std::vector<SimplexId> kept;
    for (std::uint32_t at = i == 0 ? 0 : ends[i - 1]; at < ends[i]; ++at) {
      kept.emplace_back(table.first(1) + edges[at]);
    }
    EXPECT_EQ(kept, one.cycle);
    shortest = std::min(shortest, life(of[i]));
  }
  for (std::uint32_t pair = 0; pair < pairs.size() / 2; ++pair) {
    const bool is_kept = std::find(of.begin(), of.end(), pair) != of.end();
    EXPECT_TRUE(is_kept || life(pair) <= shortest);
  }
  EXPECT_TRUE(PackedReader(snapshot(flat())).numbers("cycle_pairs").empty());
}

TEST(Snapshot, NamesWordsOfLabelsInTheOrderOfTheirRows) {
  const auto shapes = mixed_shapes();
  const PackedReader read(snapshot(shapes, some_labels(shapes.points.size())));
  const auto& dictionaries = read.header()["dictionaries"];
  EXPECT_EQ(dictionaries["element"], (nlohmann::json{"C", "N"}));
  EXPECT_EQ(dictionaries["residue"], (nlohmann::json{"ALA", "GLY"}));
  EXPECT_EQ(read.numbers("element")[3], 0U);
  EXPECT_EQ(read.numbers("element")[4], 1U);
  EXPECT_EQ(read.numbers("residue_id")[5], 2U);
  EXPECT_EQ(read.numbers("line")[2], 23U);
  EXPECT_EQ(read.header()["source"], kFacts.source);
}

}  // namespace
}  // namespace orthoball
