// SPDX-License-Identifier: MIT
// Compares the library with the reference results beside the project, where they are: each input is
// computed, written as a candidate in the keys of the expected file, and judged by its compare.py.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "matchers/reference_inputs.h"
#include "oracles/sha256.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

std::string joined(const std::vector<std::uint32_t>& rows) {
  std::string text;
  for (const std::uint32_t row : rows) text += (text.empty() ? "" : " ") + std::to_string(row);
  return text;
}

std::string twelve_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

template <int D>
std::vector<std::uint32_t> rows_of(const Filtration<D>& filtration, SimplexId simplex) {
  std::vector<std::uint32_t> rows;
  for (const SiteId row : filtration.rows(simplex)) rows.push_back(row.row());
  return rows;
}

template <int D>
json digests(const Filtration<D>& filtration) {
  std::string top_cells, order, values, spectrum;

  std::vector<std::pair<std::vector<std::uint32_t>, double>> simplices;
  for (std::uint32_t row = 0; row < filtration.size(); ++row) {
    const SimplexId simplex(row);
    simplices.emplace_back(rows_of(filtration, simplex),
                           filtration.alpha2(filtration.enters(simplex)));
  }
  std::sort(simplices.begin(), simplices.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.size(), a.first) < std::pair(b.first.size(), b.first);
  });
  const auto top = static_cast<std::size_t>(filtration.triangulation().affine_dimension() + 1);
  for (const auto& [rows, alpha2] : simplices) {
    values += joined(rows) + ' ' + twelve_digits(alpha2) + '\n';
    if (rows.size() == top) top_cells += joined(rows) + '\n';
  }

  std::uint32_t index = 1;
  for (const SimplexId simplex : Filter<D>(filtration).by_rows()) {
    if (filtration.enters(simplex) != index) order += "|\n";
    index = filtration.enters(simplex);
    order += std::to_string(filtration.dimension(simplex)) + ' ' +
             joined(rows_of(filtration, simplex)) + '\n';
  }
  std::string last;
  for (const double alpha2 : filtration.spectrum()) {
    const std::string text = twelve_digits(alpha2);
    if (text != last) spectrum += text + '\n';
    last = text;
  }
  return {{"top_cells", oracles::sha256(top_cells)},
          {"filtration_order", oracles::sha256(order)},
          {"simplex_values_12g", oracles::sha256(values)},
          {"spectrum_12g", oracles::sha256(spectrum)}};
}

// Four or three numbers, one for each dimension, as the expected files have them.
template <class Array>
std::vector<std::uint32_t> padded(const Array& array, std::size_t size) {
  std::vector<std::uint32_t> values(array.begin(), array.end());
  values.resize(size, 0);
  return values;
}

template <int D>
json at_thresholds(const Filtration<D>& filtration, const std::vector<double>& thresholds) {
  std::vector<std::uint32_t> indices;
  for (const double alpha2 : thresholds) indices.push_back(filtration.index(alpha2));
  const auto signature = signatures(filtration, std::span<const std::uint32_t>(indices));
  json rows = json::array();
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    rows.push_back({{"alpha2", thresholds[i]},
                    {"betti", padded(signature[i].betti, 3)},
                    {"singular", signature[i].singular},
                    {"regular", signature[i].regular},
                    {"interior", signature[i].interior},
                    {"volume", signature[i].volume},
                    {"boundary_regular", signature[i].area_regular},
                    {"boundary_singular", signature[i].area_singular}});
  }
  return rows;
}

template <int D>
json candidate(const Filtration<D>& filtration, const std::vector<double>& thresholds) {
  const RegularTriangulation<D>& triangulation = filtration.triangulation();
  json result{{"affine_dim", triangulation.affine_dimension()},
              {"distinct_sites", triangulation.distinct_site_count()},
              {"vertices_in_triangulation", triangulation.vertex_count()},
              {"hidden_distinct", triangulation.hidden().size()},
              {"spectrum_size", filtration.spectrum_size()},
              {"sha256", digests(filtration)},
              {"at", at_thresholds(filtration, thresholds)}};
  std::vector<std::uint32_t> counts(4), attached(4);
  std::vector<double> sums(static_cast<std::size_t>(triangulation.affine_dimension() + 1));
  for (std::uint32_t row = 0; row < filtration.size(); ++row) {
    const SimplexId simplex(row);
    const auto dimension = static_cast<std::size_t>(filtration.dimension(simplex));
    ++counts[dimension];
    if (filtration.is_attached(simplex)) ++attached[dimension];
    sums[dimension] += filtration.alpha2(filtration.enters(simplex));
  }
  result["simplices"] = counts;
  result["attached"] = attached;
  result["alpha2_sum_by_dim"] = sums;
  if (filtration.spectrum_size() == 0) return result;
  result["alpha2_min"] = filtration.spectrum().front();
  result["alpha2_max"] = filtration.spectrum().back();
  const std::uint32_t last = filtration.spectrum_size();
  result["hull_volume"] = signatures(filtration, std::span(&last, 1)).front().volume;
  return result;
}

std::string text_of(const Path& path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

class Reference : public ::testing::TestWithParam<Path> {};

TEST_P(Reference, AgreesInEveryKey) {
  if (GetParam().empty()) GTEST_SKIP() << "no ../shared/reference beside the project";
  const json expected = matchers::reference_results(GetParam());
  std::vector<double> thresholds;
  for (const json& row : expected["at"]) thresholds.push_back(row["alpha2"]);

  const WeightedPoints points = matchers::reference_points(expected);
  json result = points.dimension() == 2
                    ? candidate(Filtration<2>(regular_triangulation<2>(points)), thresholds)
                    : candidate(Filtration<3>(regular_triangulation<3>(points)), thresholds);

  // The reference has no number where its own squares overflow (areas of 1e298): nothing to
  // compare.
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    for (const char* const key : {"volume", "boundary_regular", "boundary_singular"}) {
      if (expected["at"][i][key].is_null()) result["at"][i][key] = nullptr;
    }
  }

  const Path folder =
      std::filesystem::temp_directory_path() /
      ("orthoball_reference_" + std::to_string(getpid()) + "_" + GetParam().filename().string());
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "candidate.json") << result.dump();
  const Path report = folder / "report.txt";
  const std::string command =
      "python3 '" + (matchers::shared_folder() / "reference/compare.py").string() +
      "' --all --ties '" + GetParam().string() + "' '" + (folder / "candidate.json").string() +
      "' > '" + report.string() + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(report);
  std::filesystem::remove_all(folder);
}

template <int D>
void expect_unions(const Filtration<D>& filtration, const json& expected) {
  for (const json& row : expected) {
    const double alpha2 = row["alpha2"];
    const UnionOfBalls found = union_of_balls(filtration, filtration.index(alpha2), alpha2, {});
    for (const auto& [key, value] :
         {std::pair(std::string("volume"), found.volume), {"area", found.area}}) {
      const double sliced = row[key], spread = row.value(key + "_spread", 0.0);
      const bool is_near = std::abs(value - sliced) <= std::max(2e-4 * sliced, 20 * spread);
      if (!row.contains("qmc_" + key)) {
        EXPECT_TRUE(is_near) << key << " at " << alpha2 << ": " << value << ' ' << sliced;
        continue;
      }
      const double sampled = row["qmc_" + key], deviation = row["qmc_" + key + "_stderr"];
      EXPECT_NEAR(value, sampled, (is_near ? 6 : 5) * deviation + 1e-9 * sampled)
          << key << " at " << alpha2 << (is_near ? "" : ", and not as sliced");
    }
  }
}

// The references' volumes and areas are sums over slices along three axes: good to 1e-5 or 1e-4 of
// themselves where these agree, but not for lattices, whose axes are alike. There samples decide,
// good to a few of their standard deviations.
TEST_P(Reference, AgreesInUnionsOfBalls) {
  if (GetParam().empty()) GTEST_SKIP() << "no ../shared/reference beside the project";
  const json expected = matchers::reference_results(GetParam());
  if (!expected.contains("union_of_balls")) return;
  const WeightedPoints points = matchers::reference_points(expected);
  if (points.dimension() == 2) {
    expect_unions(Filtration<2>(regular_triangulation<2>(points)), expected["union_of_balls"]);
  } else {
    expect_unions(Filtration<3>(regular_triangulation<3>(points)), expected["union_of_balls"]);
  }
}

std::string test_name(const ::testing::TestParamInfo<Path>& info) {
  return matchers::reference_name(info.param);
}

INSTANTIATE_TEST_SUITE_P(Files, Reference, ::testing::ValuesIn(matchers::reference_files()),
                         test_name);

}  // namespace
}  // namespace orthoball
