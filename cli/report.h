// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "cli/input_options.h"

// What reports of a whole input share: text for people, one JSON object for programs.

/// A line of the text: a label, then what it is about.
[[nodiscard]] std::string report_line(const std::string& label, const std::string& text);

/// The shortest text that reads back to the same double, or that it is beyond the double range.
[[nodiscard]] std::string number_text(double number);

/// The words with commas between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// "1 component, 0 tunnels, 1 void".
[[nodiscard]] std::string betti_text(std::span<const std::uint32_t> betti);

/// A number that JSON can hold; null, counted in `missing`, beyond the range of doubles.
[[nodiscard]] nlohmann::ordered_json finite(double number, std::size_t& missing);

/// The lines that say what was read, and how.
[[nodiscard]] std::string input_text(const Loaded& input);

/// The key `input`: the file, and how it was read.
[[nodiscard]] nlohmann::ordered_json input_json(const Loaded& input);

/// The object with one key a line; of an array of objects one object.
[[nodiscard]] std::string json_report_text(const nlohmann::ordered_json& json);
