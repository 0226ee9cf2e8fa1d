// SPDX-License-Identifier: MIT
#include "orthoball/output/points_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "orthoball/input/decimal.h"

namespace orthoball {
namespace {

__extension__ using Int128 = __int128;

// number * 10^-decimals, without zeros at its end.
std::string decimal_text(Int128 number, int decimals) {
  const bool is_negative = number < 0;
  if (is_negative) number = -number;
  std::string digits;  // the last first
  for (; number != 0; number /= 10)
    digits += static_cast<char>('0' + static_cast<int>(number % 10));
  const auto behind = static_cast<std::size_t>(decimals);
  if (digits.size() <= behind) digits.resize(behind + 1, '0');
  std::reverse(digits.begin(), digits.end());
  if (decimals > 0) {
    digits.insert(digits.size() - behind, 1, '.');
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
  }
  return is_negative ? "-" + digits : digits;
}

void write_weight(ByteSink& sink, const WeightedPoints& points, std::size_t row) {
  const double number = points.weights()[row];
  if (!points.decimals()) return sink.real(number + 0.0);
  Int128 exact = static_cast<Int128>(number);
  if (!points.weights_low().empty()) exact += static_cast<Int128>(points.weights_low()[row]);
  const bool is_radius = points.weight_kind() == WeightKind::radius;
  sink.text(decimal_text(exact, (is_radius ? 1 : 2) * *points.decimals()));
}

}  // namespace

void write_points_csv(ByteSink& sink, const WeightedPoints& points) {
  const auto axes = static_cast<std::size_t>(points.dimension());
  const WeightKind kind = points.weight_kind();
  sink.text(axes == 2 ? "x,y" : "x,y,z");
  sink.text(kind == WeightKind::none     ? "\n"
            : kind == WeightKind::radius ? ",radius\n"
                                         : ",weight\n");
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      if (axis > 0) sink.text(",");
      const double x = points.coordinates()[axes * row + axis];
      if (points.decimals()) {
        sink.text(decimal_text(static_cast<Int128>(x), *points.decimals()));
      } else {
        sink.real(x + 0.0);
      }
    }
    if (kind != WeightKind::none) {
      sink.text(",");
      write_weight(sink, points, row);
    }
    sink.text("\n");
  }
  sink.flush();
}

WeightedPoints as_written(const WeightedPoints& points) {
  if (points.decimals()) return points;
  const auto axes = static_cast<std::size_t>(points.dimension());
  const bool has_weights = points.weight_kind() != WeightKind::none;
  DecimalRows rows(points.dimension(), points.weight_kind());
  rows.reserve(points.size());
  const auto number = [](double x) { return parse_decimal(shortest_text(x + 0.0)).number; };
  std::array<DecimalNumber, 3> coordinates;
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      coordinates[axis] = number(points.coordinates()[axes * row + axis]);
    }
    rows.add(std::span(coordinates).first(axes),
             has_weights ? number(points.weights()[row]) : DecimalNumber{});
    if (!rows.is_fixed()) return points;
  }
  return std::move(rows).points();
}

}  // namespace orthoball
