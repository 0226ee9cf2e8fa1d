// SPDX-License-Identifier: MIT
#include "matchers/reference_inputs.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "orthoball/input/read.h"

namespace orthoball::matchers {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

// The same numbers, each taken as the double nearest to it.
WeightedPoints as_doubles(const WeightedPoints& points) {
  if (!points.decimals()) return points;
  if (*points.decimals() > 22 || points.weight_kind() == WeightKind::weight) {
    throw std::runtime_error("numbers that are not known as doubles");
  }
  const double unit = std::pow(10.0, *points.decimals());  // exact up to 22 decimals
  std::vector<double> coordinates, radii;
  for (const double x : points.coordinates()) coordinates.push_back(x / unit);
  for (const double r : points.weights()) radii.push_back(r / unit);
  return {points.dimension(), std::move(coordinates), points.weight_kind(), std::move(radii)};
}

Path points_file(const std::string& file) {
  if (file == "1aon.txt") return shared_folder() / "data/mol/1aon_groel.pdb.gz";
  if (file == "bunny.txt") return shared_folder() / "data/cloud/bunny.off";
  const Path generated = shared_folder() / "reference/generated" / file;
  return exists(generated) ? generated : shared_folder() / "data/points" / file;
}

}  // namespace

Path shared_folder() { return Path(ORTHOBALL_SOURCE_DIR) / ".." / "shared"; }

std::vector<Path> reference_files() {
  std::vector<Path> files;
  for (const char* const folder : {"generated", "real"}) {
    const Path path = shared_folder() / "reference" / folder;
    if (!is_directory(path)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) files.emplace_back();
  return files;
}

std::string reference_name(const Path& file) {
  std::string name = file.stem().string();
  if (name.empty()) return "absent";
  for (char& character : name) {
    if (std::isalnum(static_cast<unsigned char>(character)) == 0) character = '_';
  }
  return name;
}

json reference_results(const Path& file) {
  std::ifstream stream(file, std::ios::binary);
  return json::parse(stream);
}

WeightedPoints reference_points(const json& results) {
  const json& input = results["input"];
  const Path path = points_file(input["file"]);
  ReadOptions options;
  options.dimension = input["dim"].get<int>();
  options.allow_empty = true;
  if (path.extension() == ".txt" && input["weighted"]) {
    options.radius_column = std::to_string(*options.dimension + 1);
  }
  WeightedPoints points = read(path.string(), options).points;
  if (input["numbers"] == "double") return as_doubles(points);
  if (!points.decimals()) throw std::runtime_error(path.string() + ": not in decimal fixed point");
  return points;
}

}  // namespace orthoball::matchers
