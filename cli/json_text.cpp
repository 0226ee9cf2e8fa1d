// SPDX-License-Identifier: MIT
#include "cli/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "orthoball/output/byte_sink.h"

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json) {
  std::vector<std::string> parts;
  switch (json.type()) {
    case Json::value_t::object:
      for (const auto& [key, value] : json.items()) {
        parts.push_back(json_text(Json(key)) + ":" + json_text(value));
      }
      return fmt::format("{{{}}}", fmt::join(parts, ","));
    case Json::value_t::array:
      for (const Json& value : json) parts.push_back(json_text(value));
      return fmt::format("[{}]", fmt::join(parts, ","));
    case Json::value_t::number_float: {
      const auto number = json.get<double>();
      return std::isfinite(number) ? orthoball::shortest_text(number) : "null";
    }
    default:
      return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}
