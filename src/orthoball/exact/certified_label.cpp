// SPDX-License-Identifier: MIT
//
// Labels in pairs of doubles, with a forward error bound (docs/derivations/orthoradius.md).
//
// Everything about one simplex is one expression without branches or loops, so that a loop over a
// block of simplices becomes vector instructions: two simplices at a time on any x86-64, four or
// eight where it has AVX2 or AVX-512 and fused multiply-adds, which then replace the splitting of
// factors. Both are
// error-free products and a certified rounding is the correct one, so machines cannot differ.
#include "orthoball/exact/certified_label.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/magnitudes.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/processor.h"
#include "orthoball/exact/unrolled.h"

namespace orthoball {
namespace {

// Of one operation on DoubleDouble.
constexpr double kPairRounding = 8 * kRounding * kRounding;
// The longest paths to a component of x and of y (orthocentre_formulas.h) have at most 10 and 6
// operations on pairs; one square is a product and two sums. docs/derivations/orthoradius.md.
constexpr double kXError = 10 * kPairRounding;
constexpr double kYError = 6 * kPairRounding;
constexpr double kSquareError = 4 * kPairRounding;

template <class Number, std::size_t Size>
[[nodiscard, gnu::always_inline]] inline double sum_of_magnitudes(
    const std::array<Number, Size>& vector) {
  double sum = 0.0;
  unrolled<Size>([&](std::size_t i)
                     __attribute__((always_inline)) { sum += std::abs(vector[i].high); });
  return sum;
}

// A squared orthoradius in input units over LabelUnit::scale.
template <class Products>
struct BoundedValue {
  DoubleDoubleOf<Products> value;
  double error;      // |value - true value| is less
  double certainty;  // positive where that can be said
};

// Of simplex `i` of a block. Not bounded where the simplex is outside the range of the bounds, or
// Length is ExactDouble and not all differences of coordinates are doubles. Without branches.
template <class Length, class Products, int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline BoundedValue<Products> bounded_value_of(
    const CornerBlock<D, Corners>& block, std::size_t i, const LabelUnit& unit) {
  using Pair = DoubleDoubleOf<Products>;
  constexpr bool kIsExact = std::is_same_v<Length, ExactDoubleOf<Products>>;

  // Differences from the first corner.
  const Pair weight{block.weight[0][i], block.weight_low[0][i]};
  CornerDifferences<Length, Pair, D, Corners> simplex;
  std::array<std::array<double, std::size_t{D}>, Corners - 1> edges;
  std::array<double, Corners - 1> weight_differences;
  double lost = 0.0;
  unrolled<Corners - 1>([&](std::size_t corner) __attribute__((always_inline)) {
    auto& edge = simplex.edges[corner];
    unrolled<std::size_t{D}>([&](std::size_t axis) __attribute__((always_inline)) {
      const Exactly difference = two_sum(block.x[corner + 1][axis][i], -block.x[0][axis][i]);
      edges[corner][axis] = difference.high;
      if constexpr (kIsExact) {
        lost += std::abs(difference.low);
        edge[axis] = {difference.high};
      } else {
        edge[axis] = {difference.high, difference.low};
      }
    });
    const Pair apart = weight - Pair{block.weight[corner + 1][i], block.weight_low[corner + 1][i]};
    weight_differences[corner] = apart.high;
    simplex.powers[corner] = dot_product(edge, edge) + apart;
  });
  const Magnitudes<D, Corners> size(edges, weight_differences,
                                    2 * unit.weights_are_pairs * std::abs(weight.high));

  // |x|^2 and |y|^2, and how far each may be off.
  OrthocentreSquares<Pair> squares;
  const double x_off = kXError * size.x();
  const double y_off = Corners == 2 ? 0.0 : kYError * size.y();
  double x_sum = 0.0;
  double y_sum = 0.0;
  if constexpr (Corners == 2) {
    squares = orthocentre_squares(simplex);
    x_sum = std::abs(simplex.powers[0].high);
  } else {
    const auto vectors = orthocentre_vectors(simplex);
    squares = {dot_product(vectors.x, vectors.x), dot_product(vectors.y, vectors.y)};
    x_sum = sum_of_magnitudes(vectors.x);
    y_sum = sum_of_magnitudes(vectors.y);
  }
  const Pair& x = squares.x;
  const Pair& y = squares.y;
  const double x_error = 2 * x_sum * x_off + 3 * x_off * x_off + kSquareError * x.high;
  const double y_error = 2 * y_sum * y_off + 3 * y_off * y_off + kSquareError * y.high;

  // (|x|^2 - 4 |y|^2 w) / (4 |y|^2 10^(2 decimals)).
  const Pair four_y{4 * y.high, 4 * y.low};
  const Pair product = weight * four_y;
  const Pair numerator = x - product;
  const Pair denominator = four_y * Pair{unit.divisor[0], unit.divisor[1]};
  const Pair value = numerator / denominator;
  const double numerator_error = x_error + 4 * std::abs(weight.high) * y_error +
                                 3 * kPairRounding * (x.high + std::abs(product.high));
  const double error = 1.001 * (numerator_error / denominator.high +
                                std::abs(value.high) * (y_error / y.high + 4 * kPairRounding));
  const double flatness = 0x1p-20 * y.high - y_error;  // not positive where nearly flat
  const double certainty = lost > 0.0 ? -1.0 : std::min(flatness, size.margin);
  return {value, error, certainty};
}

// Labels within can be scaled without rounding.
constexpr double kLeastLabel = 0x1p-1000;
constexpr double kMostLabel = 0x1p+1000;

// The same correctly rounded in input units; NaN where every number within the error does not round
// to the same, or no error is known. One condition after the other, as vector instructions choose.
template <class Length, class Products, int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline double certified_label_of(
    const CornerBlock<D, Corners>& block, std::size_t i, const LabelUnit& unit) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto [value, error, certainty] = bounded_value_of<Length, Products>(block, i, unit);
  double label = value.high * unit.scale;
  label = certainty > 0.0 ? label : kNone;
  label = std::abs(label) > kLeastLabel ? label : kNone;
  label = std::abs(label) < kMostLabel ? label : kNone;
  label = value.high + (value.low - error) == value.high ? label : kNone;
  label = value.high + (value.low + error) == value.high ? label : kNone;
  return label;
}

// The labels of a block where all differences of coordinates are doubles, as nearly always. The
// same numbers whatever the machine: both kinds of products are exact, and so is the rounding.
template <class Products, int D, std::size_t Corners>
[[gnu::always_inline]] inline void label_block(const CornerBlock<D, Corners>& block, LabelUnit unit,
                                               double* labels) {
  // Nothing else can refer to this array, which the loop needs to know.
  std::array<double, CornerBlock<D, Corners>::kSize> found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i] = certified_label_of<ExactDoubleOf<Products>, Products>(block, i, unit);
  }
  std::copy(found.begin(), found.end(), labels);
}

template <int D, std::size_t Corners>
void label_block_anywhere(const CornerBlock<D, Corners>& block, const LabelUnit& unit,
                          double* labels) {
  label_block<SplitProducts>(block, unit, labels);
}

template <int D, std::size_t Corners>
ORTHOBALL_AVX2_FMA void label_block_in_fours(const CornerBlock<D, Corners>& block,
                                             const LabelUnit& unit, double* labels) {
  label_block<FusedProducts>(block, unit, labels);
}

template <int D, std::size_t Corners>
ORTHOBALL_AVX512 void label_block_in_eights(const CornerBlock<D, Corners>& block,
                                            const LabelUnit& unit, double* labels) {
  label_block<FusedProducts>(block, unit, labels);
}

}  // namespace

template <int D, std::size_t Corners>
void certified_labels(const CornerBlock<D, Corners>& block, const LabelUnit& unit,
                      std::span<double, CornerBlock<D, Corners>::kSize> labels) {
  if (has_avx512()) return label_block_in_eights(block, unit, labels.data());
  if (has_avx2_fma()) return label_block_in_fours(block, unit, labels.data());
  label_block_anywhere(block, unit, labels.data());
}

template <int D, std::size_t Corners>
double certified_label_of_one(const CornerBlock<D, Corners>& block, const LabelUnit& unit) {
  return certified_label_of<DoubleDoubleOf<SplitProducts>, SplitProducts>(block, 0, unit);
}

template <int D, std::size_t Corners>
Bounds label_remainder_of_one(const CornerBlock<D, Corners>& block, const LabelUnit& unit,
                              double label) {
  const auto [value, error, certainty] =
      bounded_value_of<DoubleDoubleOf<SplitProducts>, SplitProducts>(block, 0, unit);
  if (!(certainty > 0.0 && std::abs(label) > kLeastLabel && std::abs(label) < kMostLabel)) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity};
  }
  const double rest = (value.high - label / unit.scale) + value.low;
  return {rest - 2 * error, rest + 2 * error};  // twice: for the roundings here
}

#define ORTHOBALL_INSTANTIATE_LABELS(D, CORNERS)                                                 \
  template void certified_labels<D, CORNERS>(const CornerBlock<D, CORNERS>&, const LabelUnit&,   \
                                             std::span<double, CornerBlock<D, CORNERS>::kSize>); \
  template double certified_label_of_one<D, CORNERS>(const CornerBlock<D, CORNERS>&,             \
                                                     const LabelUnit&);                          \
  template Bounds label_remainder_of_one<D, CORNERS>(const CornerBlock<D, CORNERS>&,             \
                                                     const LabelUnit&, double);
ORTHOBALL_INSTANTIATE_LABELS(2, 2)
ORTHOBALL_INSTANTIATE_LABELS(2, 3)
ORTHOBALL_INSTANTIATE_LABELS(3, 2)
ORTHOBALL_INSTANTIATE_LABELS(3, 3)
ORTHOBALL_INSTANTIATE_LABELS(3, 4)
#undef ORTHOBALL_INSTANTIATE_LABELS

}  // namespace orthoball
