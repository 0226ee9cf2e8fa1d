// SPDX-License-Identifier: MIT
//
// With the normals n_i of the facets, each taken in the order of the corners, the exterior angle at
// an edge is atan2(6 V len, +-(n_i . n_j)), as in contributions.cpp. Both arguments are of degree 4
// in lengths; they are formed as integers, rounded, and brought to one power of two.
#include "orthoball/measures/thin_cell.h"

#include <algorithm>
#include <cmath>

#include "orthoball/exact/local_frame.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/rounded_quotient.h"
#include "orthoball/measures/angle.h"

namespace orthoball {
namespace {

// A number that a double may not hold: mantissa * 2^exponent.
struct Rounded {
  double mantissa;
  int exponent;
};

template <class Int>
Rounded rounded(const Int& value) {
  const int exponent = value.bit_length();
  return {rounded_quotient(value, Int(1), -exponent), exponent};
}

Rounded square_root(const Rounded& square) {
  const int odd = square.exponent & 1;
  return {std::sqrt(std::ldexp(square.mantissa, odd)), (square.exponent - odd) / 2};
}

double angle(const Rounded& cosine, const Rounded& sine) {
  // A zero counts as small: its exponent is 0, that of other products may be larger only.
  const int largest = std::max(cosine.exponent, sine.exponent);
  return angle_from_x_axis(std::ldexp(cosine.mantissa, cosine.exponent - largest),
                           std::ldexp(sine.mantissa, sine.exponent - largest));
}

template <class Int>
ThinCell measured(const std::array<ExactSite<3>, 4>& sites, const LocalFrame& frame, int exponent) {
  using Vector = std::array<Int, 3>;
  std::array<Vector, 4> from_first;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto site = integer_site<Int, 3>(sites[i], sites[0], frame);
    for (std::size_t axis = 0; axis < 3; ++axis) from_first[i][axis] = site.x[axis];
  }
  const auto edge = [&](std::size_t from, std::size_t to) {
    Vector vector;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vector[axis] = from_first[to][axis] - from_first[from][axis];
    }
    return vector;
  };
  // [i]: of the facet without corner i; n_0 and n_2 point outward where n_1 and n_3 point inward.
  const std::array<Vector, 4> normals{
      cross_product(edge(1, 2), edge(1, 3)), cross_product(edge(0, 2), edge(0, 3)),
      cross_product(edge(0, 1), edge(0, 3)), cross_product(edge(0, 1), edge(0, 2))};
  Rounded volume = rounded(dot_product(edge(0, 1), normals[1]));
  volume.mantissa = std::abs(volume.mantissa);

  ThinCell cell{std::ldexp(volume.mantissa, volume.exponent + 3 * (frame.unit - exponent)), 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const std::size_t k = i > 0 ? 0 : (j > 1 ? 1 : 2);  // the edge that leaves out i and j
      const std::size_t l = 6 - i - j - k;
      const Vector along = edge(k, l);
      const Rounded length = square_root(rounded(dot_product(along, along)));
      const Rounded sine{volume.mantissa * length.mantissa, volume.exponent + length.exponent};
      Rounded cosine = rounded(dot_product(normals[i], normals[j]));
      if ((i + j) % 2 != 0) cosine.mantissa = -cosine.mantissa;
      cell.length += std::ldexp(length.mantissa * angle(cosine, sine),
                                length.exponent + frame.unit - exponent);
    }
  }
  return cell;
}

}  // namespace

ThinCell thin_cell(const Sites<3>& sites, const std::array<std::uint32_t, 4>& corners,
                   int exponent) {
  std::array<ExactSite<3>, 4> exact{};  // without weights
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactSite<3> site = sites.exact(corners[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) exact[i].x[axis] = site.x[axis];
  }
  const LocalFrame frame = local_frame<3>(exact);
  // Edges are below 2^(bits + 1), normals below 2^(2 bits + 3), their inner products below
  // 2^(4 bits + 8); rounded_quotient wants two more.
  return with_width(4 * frame.bits + 10,
                    [&]<class Int>() { return measured<Int>(exact, frame, exponent); });
}

}  // namespace orthoball
