// SPDX-License-Identifier: MIT
//
// Squared orthoradii and the sides of the orthocentre on which "attached" rests.
//
// All formulas (orthocentre_formulas.h) work with the differences of the corners at hand and are
// evaluated in three number types: doubles and pairs of doubles, both with a forward error bound
// that follows the extent of the simplex, and integers. The bounds use the largest coordinate of
// each edge, A, B, C, and a bound on each power; every error is a small multiple of 2^-53 (2^-106)
// times a product of these. Derived in docs/derivations/orthoradius.md.
//
// The order of simplices rests on labels: rounding to nearest never reverses an order, so labels
// that differ are in the order of the exact values; OrthoradiusPivot decides between equal ones.
#include "orthoball/exact/orthoradius.h"

#include <cmath>
#include <tuple>

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/integer_simplex.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/rounded_quotient.h"

namespace orthoball {
namespace {

// Edges whose largest coordinate is in this range, with weights as Sites bounds them, let no
// product here over- or underflow harmfully.
constexpr double kShortestEdge = 0x1p-80;
constexpr double kLongestEdge = 0x1p+80;

// Largest magnitudes of what a simplex is made of.
template <std::size_t Corners>
struct Magnitudes {
  std::array<double, Corners - 1> edges;   // largest coordinate
  std::array<double, Corners - 1> powers;  // |edge|^2 + |w_0 - w_i| and more
  bool in_range = true;

  // Of a component of the vector x of orthocentre_formulas.h, and of y.
  [[nodiscard]] double x() const {
    if constexpr (Corners == 2) return powers[0];
    if constexpr (Corners == 3) return powers[0] * edges[1] + powers[1] * edges[0];
    if constexpr (Corners == 4) {
      return 2 * (powers[0] * edges[1] * edges[2] + powers[1] * edges[2] * edges[0] +
                  powers[2] * edges[0] * edges[1]);
    }
  }
  [[nodiscard]] double y() const {
    if constexpr (Corners == 2) return edges[0];
    if constexpr (Corners == 3) return 2 * edges[0] * edges[1];
    if constexpr (Corners == 4) return 6 * edges[0] * edges[1] * edges[2];
  }
};

template <int D>
double largest_coordinate(const std::array<double, std::size_t{D}>& edge) {
  double largest = std::max(std::abs(edge[0]), std::abs(edge[1]));
  if constexpr (D == 3) largest = std::max(largest, std::abs(edge[2]));
  return largest;
}

// weight_magnitude: what the error of a weights' difference is a few roundings of, if that is more
// than the difference itself.
template <int D, std::size_t Corners>
Magnitudes<Corners> magnitudes(
    const std::array<std::array<double, std::size_t{D}>, Corners - 1>& edges,
    const std::array<double, Corners - 1>& weight_differences, double weight_magnitude) {
  Magnitudes<Corners> result;
  for (std::size_t i = 0; i + 1 < Corners; ++i) {
    const double largest = largest_coordinate<D>(edges[i]);
    result.in_range &= largest > kShortestEdge && largest < kLongestEdge;
    result.edges[i] = largest;
    result.powers[i] = D * largest * largest + std::abs(weight_differences[i]) + weight_magnitude;
  }
  return result;
}

// --- attached or not ---------------------------------------------------------------------------

// Roundings on the longest path to one of orthocentre_coordinates, and a few for the bound itself.
constexpr double kCoordinateError = 40 * kRounding;

// Magnitudes of orthocentre_coordinates, one bound for all.
template <std::size_t Corners>
double coordinate_magnitude(const Magnitudes<Corners>& size) {
  if constexpr (Corners == 2) {
    return size.powers[0] + 6 * size.edges[0] * size.edges[0];
  } else {
    const double x = size.x();
    const double y = size.y();
    if constexpr (Corners == 3) return 3 * x * (size.edges[0] + size.edges[1]) + 6 * y * y;
    if constexpr (Corners == 4) {
      const double cross = size.edges[1] * size.edges[2] + size.edges[2] * size.edges[0] +
                           size.edges[0] * size.edges[1];
      return 6 * x * cross + 2 * y * y;
    }
  }
}

template <std::size_t Corners>
unsigned negative_bits(const std::array<double, Corners>& coordinates) {
  unsigned mask = 0;
  for (unsigned i = 0; i < Corners; ++i) mask |= static_cast<unsigned>(coordinates[i] < 0) << i;
  return mask;
}

// --- labels ------------------------------------------------------------------------------------

constexpr double kPairRounding = 8 * kRounding * kRounding;  // of one operation on DoubleDouble

template <int D>
DoubleDouble weight_pair(const Sites<D>& sites, std::uint32_t site) {
  if (sites.weight_error() == 0.0) return {sites[site].weight, 0.0};
  const ExactSite<D> exact = sites.exact(site);
  const int shift =
      exact.weight_exponent + 2 * (sites.scale_exponent() - sites.exact_scale_exponent());
  return {std::ldexp(exact.weight_high, shift), std::ldexp(exact.weight_low, shift)};
}

// 10^(2 decimals) as an exact pair; only up to 22 decimals.
constexpr int kMostPairDecimals = 22;
DoubleDouble power_of_hundred(int decimals) {
  double root = 1.0;  // 10^decimals is a double up to 22
  for (int i = 0; i < decimals; ++i) root *= 10.0;
  return ExactDouble{root} * ExactDouble{root};
}

// What labels of one set of sites have in common.
struct LabelUnit {
  DoubleDouble divisor;  // 10^(2 decimals)
  double scale = 1.0;    // 2^(-2 scale_exponent), which is then normal
  bool is_usable = true;
  bool is_one = true;  // divisor == 1

  template <int D>
  explicit LabelUnit(const Sites<D>& sites)
      : is_usable(sites.decimals() <= kMostPairDecimals && std::abs(sites.scale_exponent()) < 400),
        is_one(sites.decimals() == 0) {
    if (!is_usable) return;
    divisor = power_of_hundred(sites.decimals());
    scale = std::ldexp(1.0, -2 * sites.scale_exponent());
  }
};

// Whether every number within `error` of `value` rounds to value.high.
bool rounds_surely(const DoubleDouble& value, double error) {
  return value.high + (value.low - error) == value.high &&
         value.high + (value.low + error) == value.high;
}

template <class Number, std::size_t Size>
double sum_of_magnitudes(const std::array<Number, Size>& vector) {
  double sum = 0.0;
  for (const Number& component : vector) sum += std::abs(component.high);
  return sum;
}

// x^2, y^2 as pairs and how far each may be off.
struct BoundedSquares {
  OrthocentreSquares<DoubleDouble> squares;
  double x_error;
  double y_error;
};

// The longest paths to a component of x and of y have at most 9 and 5 operations on pairs.
constexpr double kXError = 10 * kPairRounding;
constexpr double kYError = 6 * kPairRounding;
constexpr double kSquareError = 4 * kPairRounding;  // a product and two sums

template <class Length, int D, std::size_t Corners>
BoundedSquares bounded_squares(const CornerDifferences<Length, DoubleDouble, D, Corners>& simplex,
                               const Magnitudes<Corners>& size) {
  BoundedSquares result;
  const double x_off = kXError * size.x();
  const double y_off = Corners == 2 ? 0.0 : kYError * size.y();
  double x_sum = 0.0;
  double y_sum = 0.0;
  if constexpr (Corners == 2) {
    result.squares = orthocentre_squares(simplex);
    x_sum = std::abs(simplex.powers[0].high);
  } else {
    const auto vectors = orthocentre_vectors(simplex);
    result.squares = {dot_product(vectors.x, vectors.x), dot_product(vectors.y, vectors.y)};
    x_sum = sum_of_magnitudes(vectors.x);
    y_sum = sum_of_magnitudes(vectors.y);
  }
  result.x_error = 2 * x_sum * x_off + 3 * x_off * x_off + kSquareError * result.squares.x.high;
  result.y_error = 2 * y_sum * y_off + 3 * y_off * y_off + kSquareError * result.squares.y.high;
  return result;
}

// |x|^2 / (4 |y|^2) - w in input units, if its rounding is certain.
template <int D>
std::optional<double> certified(const BoundedSquares& bounded, const DoubleDouble& weight,
                                const LabelUnit& unit) {
  const auto& [x, y] = bounded.squares;
  if (!(bounded.y_error < 0x1p-20 * y.high)) return std::nullopt;  // nearly flat
  const DoubleDouble four_y{4 * y.high, 4 * y.low};
  DoubleDouble numerator = x;
  double numerator_error = bounded.x_error;
  if (weight.high != 0.0) {
    const DoubleDouble product = weight * four_y;
    numerator = x - product;
    numerator_error += 4 * std::abs(weight.high) * bounded.y_error +
                       3 * kPairRounding * (x.high + std::abs(product.high));
  }
  const DoubleDouble denominator = unit.is_one ? four_y : four_y * unit.divisor;
  const DoubleDouble value = numerator / denominator;
  const double size = std::abs(value.high);
  const double error = 1.001 * (numerator_error / denominator.high +
                                size * (bounded.y_error / y.high + 4 * kPairRounding));
  if (!rounds_surely(value, error)) return std::nullopt;
  const double label = value.high * unit.scale;
  constexpr double kLeast = 0x1p-1000;  // neither this nor any number near it is subnormal
  constexpr double kLargest = 0x1p+1000;
  if (!(std::abs(label) > kLeast && std::abs(label) < kLargest)) return std::nullopt;
  return label;
}

template <int D, std::size_t Corners>
std::optional<double> certified_in(const Sites<D>& sites, const CornerSites<Corners>& simplex,
                                   const LabelUnit& unit) {
  if (!unit.is_usable) return std::nullopt;
  const DoubleDouble weight = weight_pair(sites, simplex[0]);
  CornerDifferences<DoubleDouble, DoubleDouble, D, Corners> differences;
  CornerDifferences<ExactDouble, DoubleDouble, D, Corners> exact_differences;
  std::array<std::array<double, std::size_t{D}>, Corners - 1> edges;
  std::array<double, Corners - 1> weight_differences;
  double lost = 0.0;  // 0 if all differences are doubles
  for (std::size_t i = 0; i + 1 < Corners; ++i) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Exactly difference = two_sum(sites[simplex[i + 1]].x[axis], -sites[simplex[0]].x[axis]);
      lost = std::max(lost, std::abs(difference.low));
      edges[i][axis] = difference.high;
      exact_differences.edges[i][axis] = {difference.high};
      differences.edges[i][axis] = {difference.high, difference.low};
    }
    const DoubleDouble apart = weight - weight_pair(sites, simplex[i + 1]);
    weight_differences[i] = apart.high;
    differences.powers[i] = apart;
  }
  // Differences of weights that are doubles are exact.
  const double weight_magnitude = sites.weight_error() == 0.0 ? 0.0 : 2 * std::abs(weight.high);
  const auto size = magnitudes<D, Corners>(edges, weight_differences, weight_magnitude);
  if (!size.in_range) return std::nullopt;
  for (std::size_t i = 0; i + 1 < Corners; ++i) {
    auto& power = differences.powers[i];
    const auto& edge = exact_differences.edges[i];
    const auto& pair_edge = differences.edges[i];
    power = (lost == 0.0 ? dot_product(edge, edge) : dot_product(pair_edge, pair_edge)) + power;
  }
  if (lost != 0.0) return certified<D>(bounded_squares(differences, size), weight, unit);
  exact_differences.powers = differences.powers;
  return certified<D>(bounded_squares(exact_differences, size), weight, unit);
}

template <class Int>
Int power_of_ten(int exponent) {
  Int result(1);
  for (int i = 0; i < exponent; ++i) result *= Int(10);
  return result;
}

// A weight turned round: its error has nowhere to hide.
template <int D>
double label_of(const Sites<D>& sites, const CornerSites<1>& simplex, const LabelUnit& unit) {
  const Site<D>& site = sites[simplex[0]];
  if (site.weight == 0.0 && sites.weight_error() == 0.0) return 0.0;
  if (sites.weight_error() == 0.0 && unit.is_usable && unit.is_one) {
    const double label = -site.weight * unit.scale;
    if (std::abs(label) > 0x1p-1000 && std::abs(label) < 0x1p+1000) return label;
  }
  return orthoradius_stages::exact_label<D, 1>(sites, simplex);
}

template <int D, std::size_t Corners>
double label_of(const Sites<D>& sites, const CornerSites<Corners>& simplex, const LabelUnit& unit) {
  const auto label = certified_in<D, Corners>(sites, simplex, unit);
  return label ? *label : orthoradius_stages::exact_label<D, Corners>(sites, simplex);
}

// Calls `evaluate.template operator()<Corners>()` with a simplex's number of corners.
template <int D, class Evaluate>
auto with_corners(std::size_t corners, const Evaluate& evaluate) {
  switch (corners) {
    case 1:
      return evaluate.template operator()<1>();
    case 2:
      return evaluate.template operator()<2>();
    case 4:
      if constexpr (D == 3) return evaluate.template operator()<4>();
      [[fallthrough]];
    default:
      return evaluate.template operator()<3>();
  }
}

}  // namespace

namespace orthoradius_stages {

template <int D, std::size_t Corners>
std::optional<unsigned> filtered_attached_facets(const Sites<D>& sites,
                                                 const CornerSites<Corners>& simplex) {
  CornerDifferences<double, double, D, Corners> differences;
  std::array<double, Corners - 1> weight_differences;
  const Site<D>& origin = sites[simplex[0]];
  for (std::size_t i = 0; i + 1 < Corners; ++i) {
    const Site<D>& site = sites[simplex[i + 1]];
    auto& edge = differences.edges[i];
    for (std::size_t axis = 0; axis < D; ++axis) edge[axis] = site.x[axis] - origin.x[axis];
    weight_differences[i] = origin.weight - site.weight;
    differences.powers[i] = dot_product(edge, edge) + weight_differences[i];
  }
  const auto size = magnitudes<D, Corners>(differences.edges, weight_differences,
                                           2 * sites.weight_error() / kRounding);
  if (!size.in_range) return std::nullopt;
  const auto coordinates = orthocentre_coordinates(differences);
  const double magnitude = coordinate_magnitude(size);
  // Integers this small are never rounded.
  if (sites.is_integral() && magnitude < 0x1p+53) return negative_bits(coordinates);
  const double error = kCoordinateError * magnitude;
  for (const double coordinate : coordinates) {
    if (!(std::abs(coordinate) > error)) return std::nullopt;
  }
  return negative_bits(coordinates);
}

template <int D, std::size_t Corners>
unsigned exact_attached_facets(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  const FramedSimplex<D, Corners> framed(sites, simplex.data());
  const int bits = bits_of(kOrthoradiusBits[Corners - 1].coordinate, framed.frame());
  return with_least_width(bits, [&]<class Int>() {
    const auto coordinates = orthocentre_coordinates(framed.template integers<Int>().differences);
    unsigned mask = 0;
    for (unsigned i = 0; i < Corners; ++i) {
      mask |= static_cast<unsigned>(coordinates[i].sign() == Sign::negative) << i;
    }
    return mask;
  });
}

template <int D, std::size_t Corners>
std::optional<double> certified_label(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  return certified_in<D, Corners>(sites, simplex, LabelUnit(sites));
}

template <int D, std::size_t Corners>
double exact_label(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  const FramedSimplex<D, Corners> framed(sites, simplex.data());
  const OrthoradiusBits& rule = kOrthoradiusBits[Corners - 1];
  constexpr int kBitsOfHundred = 7;
  const int numerator_bits = bits_of(rule.numerator, framed.frame());
  const int denominator_bits =
      bits_of(rule.denominator, framed.frame()) + kBitsOfHundred * sites.decimals();
  return with_least_width(std::max(numerator_bits, denominator_bits) + 2, [&]<class Int>() {
    const auto fraction = orthoradius_fraction<Int>(framed);
    return rounded_quotient(fraction.numerator,
                            fraction.denominator * power_of_ten<Int>(2 * sites.decimals()),
                            2 * (framed.frame().unit - sites.exact_scale_exponent()));
  });
}

}  // namespace orthoradius_stages

template <int D, std::size_t Corners>
unsigned attached_facets(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  if (const auto mask = orthoradius_stages::filtered_attached_facets<D, Corners>(sites, simplex)) {
    return *mask;
  }
  return orthoradius_stages::exact_attached_facets<D, Corners>(sites, simplex);
}

template <int D, std::size_t Corners>
void squared_orthoradii(const Sites<D>& sites, std::span<const CornerSites<Corners>> simplices,
                        std::span<double> labels) {
  const LabelUnit unit(sites);
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    labels[i] = label_of<D>(sites, simplices[i], unit);
  }
}

// The pivot's fraction in every width up to 16 words that holds it; wider ones are made anew.
template <int D>
struct OrthoradiusPivot<D>::Fractions {
  std::array<std::uint32_t, 4> corners{};
  std::size_t size = 0;
  LocalFrame frame;
  int numerator_bits = 0;
  int denominator_bits = 0;
  std::tuple<OrthoradiusFraction<WideInteger<1>>, OrthoradiusFraction<WideInteger<2>>,
             OrthoradiusFraction<WideInteger<4>>, OrthoradiusFraction<WideInteger<8>>,
             OrthoradiusFraction<WideInteger<16>>>
      kept;

  template <class Int>
  [[nodiscard]] OrthoradiusFraction<Int> fraction(const Sites<D>& sites) const {
    if constexpr (Int::kBits <= 16 * 64) {
      return std::get<OrthoradiusFraction<Int>>(kept);
    } else {
      return made<Int>(sites);
    }
  }
  template <class Int>
  [[nodiscard]] OrthoradiusFraction<Int> made(const Sites<D>& sites) const {
    return with_corners<D>(size, [&]<std::size_t Corners>() {
      return orthoradius_fraction<Int>(FramedSimplex<D, Corners>(sites, corners.data()));
    });
  }
  template <class Int>
  void keep(const Sites<D>& sites) {
    if (std::max(numerator_bits, denominator_bits) < Int::kBits - 1) {
      std::get<OrthoradiusFraction<Int>>(kept) = made<Int>(sites);
    }
  }
};

template <int D>
OrthoradiusPivot<D>::OrthoradiusPivot(const Sites<D>& sites, std::span<const std::uint32_t> pivot)
    : sites_(sites) {
  auto fractions = std::make_unique<Fractions>();
  std::copy(pivot.begin(), pivot.end(), fractions->corners.begin());
  fractions->size = pivot.size();
  fractions->frame = with_corners<D>(pivot.size(), [&]<std::size_t Corners>() {
    return FramedSimplex<D, Corners>(sites, pivot.data()).frame();
  });
  const OrthoradiusBits& rule = kOrthoradiusBits[pivot.size() - 1];
  fractions->numerator_bits = bits_of(rule.numerator, fractions->frame);
  fractions->denominator_bits = bits_of(rule.denominator, fractions->frame);
  fractions->template keep<WideInteger<1>>(sites);
  fractions->template keep<WideInteger<2>>(sites);
  fractions->template keep<WideInteger<4>>(sites);
  fractions->template keep<WideInteger<8>>(sites);
  fractions->template keep<WideInteger<16>>(sites);
  fractions_ = std::move(fractions);
}

template <int D>
OrthoradiusPivot<D>::~OrthoradiusPivot() = default;

template <int D>
Sign OrthoradiusPivot<D>::compare(std::span<const std::uint32_t> simplex) const {
  return with_corners<D>(simplex.size(), [&]<std::size_t Corners>() {
    const FramedSimplex<D, Corners> framed(sites_, simplex.data());
    const OrthoradiusBits& rule = kOrthoradiusBits[Corners - 1];
    // n / d 4^unit against n' / d' 4^unit': the products in the smaller unit squared.
    const int shift = 2 * (framed.frame().unit - fractions_->frame.unit);
    const int bits = std::max(
        bits_of(rule.numerator, framed.frame()) + fractions_->denominator_bits + std::max(shift, 0),
        fractions_->numerator_bits + bits_of(rule.denominator, framed.frame()) +
            std::max(-shift, 0));
    return with_least_width(bits + 1, [&]<class Int>() {
      const auto mine = orthoradius_fraction<Int>(framed);
      const auto pivot = fractions_->template fraction<Int>(sites_);
      Int left = mine.numerator * pivot.denominator;
      Int right = pivot.numerator * mine.denominator;
      if (shift > 0) left = left << shift;
      if (shift < 0) right = right << -shift;
      const auto order = left <=> right;
      return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
    });
  });
}

#define ORTHOBALL_INSTANTIATE_ORTHORADIUS(D, CORNERS)                                          \
  template unsigned attached_facets<D, CORNERS>(const Sites<D>&, const CornerSites<CORNERS>&); \
  template void squared_orthoradii<D, CORNERS>(                                                \
      const Sites<D>&, std::span<const CornerSites<CORNERS>>, std::span<double>);              \
  template std::optional<unsigned> orthoradius_stages::filtered_attached_facets<D, CORNERS>(   \
      const Sites<D>&, const CornerSites<CORNERS>&);                                           \
  template unsigned orthoradius_stages::exact_attached_facets<D, CORNERS>(                     \
      const Sites<D>&, const CornerSites<CORNERS>&);                                           \
  template std::optional<double> orthoradius_stages::certified_label<D, CORNERS>(              \
      const Sites<D>&, const CornerSites<CORNERS>&);                                           \
  template double orthoradius_stages::exact_label<D, CORNERS>(const Sites<D>&,                 \
                                                              const CornerSites<CORNERS>&);

ORTHOBALL_INSTANTIATE_ORTHORADIUS(2, 2)
ORTHOBALL_INSTANTIATE_ORTHORADIUS(2, 3)
ORTHOBALL_INSTANTIATE_ORTHORADIUS(3, 2)
ORTHOBALL_INSTANTIATE_ORTHORADIUS(3, 3)
ORTHOBALL_INSTANTIATE_ORTHORADIUS(3, 4)
#undef ORTHOBALL_INSTANTIATE_ORTHORADIUS
template void squared_orthoradii<2, 1>(const Sites<2>&, std::span<const CornerSites<1>>,
                                       std::span<double>);
template void squared_orthoradii<3, 1>(const Sites<3>&, std::span<const CornerSites<1>>,
                                       std::span<double>);
template class OrthoradiusPivot<2>;
template class OrthoradiusPivot<3>;

}  // namespace orthoball
