// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball::matchers {

/// The folder `shared` beside the project.
[[nodiscard]] std::filesystem::path shared_folder();

/// The files of expected results in it, ascending; one empty path where there are none, for which
/// a test is to be skipped.
[[nodiscard]] std::vector<std::filesystem::path> reference_files();

/// What a test of such a file is called.
[[nodiscard]] std::string reference_name(const std::filesystem::path& file);

/// What a file holds.
[[nodiscard]] nlohmann::json reference_results(const std::filesystem::path& file);

/// The points that expected results are of.
/// @throws ParseError, std::runtime_error where they cannot be read as the results say.
[[nodiscard]] WeightedPoints reference_points(const nlohmann::json& results);

}  // namespace orthoball::matchers
