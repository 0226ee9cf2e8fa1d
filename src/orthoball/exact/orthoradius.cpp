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
// that differ are in the order of the exact values. Between equal ones what rounding took decides
// where its bounds do not touch (label_remainder), and OrthoradiusPivot everywhere.
#include "orthoball/exact/orthoradius.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "orthoball/exact/error_free.h"
#include "orthoball/exact/floating_point.h"
#include "orthoball/exact/integer_simplex.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/orthocentre_signs.h"
#include "orthoball/exact/rounded_quotient.h"

namespace orthoball {
namespace {

// --- labels ------------------------------------------------------------------------------------

// 10^(2 decimals) is the sum of two doubles up to 22 decimals.
constexpr int kMostPairDecimals = 22;

// Nothing where labels cannot be certified in pairs of doubles.
template <int D>
std::optional<LabelUnit> label_unit(const Sites<D>& sites) {
  if (sites.decimals() > kMostPairDecimals || std::abs(sites.scale_exponent()) > 400) return {};
  double root = 1.0;  // 10^decimals is a double up to 22
  for (int i = 0; i < sites.decimals(); ++i) root *= 10.0;
  const Exactly divisor = two_product(root, root);
  return LabelUnit{{divisor.high, divisor.low},
                   std::ldexp(1.0, -2 * sites.scale_exponent()),
                   sites.weight_error() == 0.0 ? 0.0 : 1.0};
}

// The corners of a few simplices; their weights as they are where a double cannot hold them.
template <int D, std::size_t Corners>
void load(const Sites<D>& sites, std::span<const CornerSites<Corners>> simplices,
          CornerBlock<D, Corners>& block) {
  load_corners(sites, simplices, block);
  if (sites.weight_error() == 0.0) return;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    for (std::size_t corner = 0; corner < Corners; ++corner) {
      const ExactSite<D> exact = sites.exact(simplices[i][corner]);
      const int shift =
          exact.weight_exponent + 2 * (sites.scale_exponent() - sites.exact_scale_exponent());
      block.weight[corner][i] = std::ldexp(exact.weight_high, shift);
      block.weight_low[corner][i] = std::ldexp(exact.weight_low, shift);
    }
  }
}

template <int D, std::size_t Corners>
CornerBlock<D, Corners> block_of_one(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  CornerBlock<D, Corners> block;
  for (auto& weight_low : block.weight_low) weight_low[0] = 0.0;
  load<D, Corners>(sites, {&simplex, 1}, block);
  return block;
}

template <class Int>
Int power_of_ten(int exponent) {
  Int result(1);
  for (int i = 0; i < exponent; ++i) result *= Int(10);
  return result;
}

// The label of a vertex is its weight turned round; one that needs no rounding is taken as it is.
template <int D>
double vertex_label(const Sites<D>& sites, const CornerSites<1>& vertex) {
  const double weight = sites[vertex[0]].weight;
  if (sites.weight_error() == 0.0) {
    if (weight == 0.0) return 0.0;
    const double label = -std::ldexp(weight, -2 * sites.scale_exponent());
    if (sites.decimals() == 0 && std::abs(label) > 0x1p-1000 && std::isfinite(label)) return label;
  }
  return orthoradius_stages::exact_label<D, 1>(sites, vertex);
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
  std::array<std::array<double, std::size_t{D}>, Corners> x;
  std::array<double, Corners> weights;
  for (std::size_t corner = 0; corner < Corners; ++corner) {
    const Site<D>& site = sites[simplex[corner]];
    std::copy_n(site.x, D, x[corner].begin());
    weights[corner] = site.weight;
  }
  const OrthocentreSigns signs = orthocentre_signs<D, Corners>(x, weights, sign_tolerance(sites));
  if (!(signs.certainty > 0.0)) return std::nullopt;
  return static_cast<unsigned>(signs.beyond);
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
  const auto unit = label_unit(sites);
  const double label =
      unit ? certified_label_of_one(block_of_one<D>(sites, simplex), *unit) : std::nan("");
  return std::isnan(label) ? std::nullopt : std::optional(label);
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
  if constexpr (Corners == 1) {
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      labels[i] = vertex_label(sites, simplices[i]);
    }
  } else {
    const auto unit = label_unit(sites);
    constexpr std::size_t kBlock = CornerBlock<D, Corners>::kSize;
    CornerBlock<D, Corners> block{};
    std::array<double, kBlock> found;
    found.fill(std::nan(""));
    for (std::size_t first = 0; first < simplices.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, simplices.size() - first);
      if (unit) {
        load(sites, simplices.subspan(first, size), block);
        certified_labels(block, *unit, std::span(found));
      }
      for (std::size_t i = 0; i < size; ++i) {
        const auto& simplex = simplices[first + i];
        double label = found[i];
        if (std::isnan(label) && unit)
          label = certified_label_of_one(block_of_one<D>(sites, simplex), *unit);
        if (std::isnan(label)) label = orthoradius_stages::exact_label<D, Corners>(sites, simplex);
        labels[first + i] = label;
      }
    }
  }
}

template <int D>
Bounds label_remainder(const Sites<D>& sites, std::span<const std::uint32_t> simplex,
                       double label) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto unit = label_unit(sites);
  if (!unit) return {-kInfinity, kInfinity};
  return with_corners<D>(simplex.size(), [&]<std::size_t Corners>() -> Bounds {
    if constexpr (Corners == 1) {
      return {-kInfinity, kInfinity};
    } else {
      CornerSites<Corners> corners;
      std::copy(simplex.begin(), simplex.end(), corners.begin());
      return label_remainder_of_one(block_of_one<D>(sites, corners), *unit, label);
    }
  });
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
template double orthoradius_stages::exact_label<2, 1>(const Sites<2>&, const CornerSites<1>&);
template double orthoradius_stages::exact_label<3, 1>(const Sites<3>&, const CornerSites<1>&);
template Bounds label_remainder<2>(const Sites<2>&, std::span<const std::uint32_t>, double);
template Bounds label_remainder<3>(const Sites<3>&, std::span<const std::uint32_t>, double);
template class OrthoradiusPivot<2>;
template class OrthoradiusPivot<3>;

}  // namespace orthoball
