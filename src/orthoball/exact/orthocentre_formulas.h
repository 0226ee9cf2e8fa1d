// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "orthoball/exact/unrolled.h"

namespace orthoball {

/// A simplex of `Corners` weighted points p_0, p_1, ... as the orthocentre's formulas take it.
///
/// `Length` is the number type of coordinates, `Number` that of everything made of them: equal for
/// doubles and integers.
template <class Length, class Number, int D, std::size_t Corners>
struct CornerDifferences {
  std::array<std::array<Length, std::size_t{D}>, Corners - 1> edges;  ///< [i]: p_(i+1) - p_0
  std::array<Number, Corners - 1> powers;  ///< [i]: |edge i|^2 + w_0 - w_(i+1)
};

/// The centre c of a simplex's orthoball, from its first corner p_0, as two short vectors:
/// |c - p_0|^2 = |x|^2 / (4 |y|^2), so rho2 = |x|^2 / (4 |y|^2) - w_0.
///
/// With edges u, v, w and powers a, b, c, from 2 (c - p_0) . u = a and so on:
///   triangle     x = a v - b u              y = u x v
///   tetrahedron  x = a v x w + b w x u + c u x v, which is 2 y (c - p_0);  y = u . v x w
/// For an edge the two would be a and u.
template <class Number, int D, std::size_t Corners>
struct OrthocentreVectors {
  std::array<Number, std::size_t{D}> x;                  ///< [axis]
  std::array<Number, Corners == 3 && D == 3 ? 3 : 1> y;  ///< [axis], or the one number it is
};

/// u x v, as exact as the arithmetic of `Length`.
template <class Length>
[[nodiscard, gnu::always_inline]] inline auto cross_product(const std::array<Length, 3>& u,
                                                            const std::array<Length, 3>& v) {
  return std::array{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]};
}

/// a . b, as exact as the arithmetic of its numbers.
template <class A, class B, std::size_t Size>
[[nodiscard, gnu::always_inline]] inline auto dot_product(const std::array<A, Size>& a,
                                                          const std::array<B, Size>& b) {
  auto sum = a[0] * b[0];
  unrolled<Size - 1>([&](std::size_t i)
                         __attribute__((always_inline)) { sum = sum + a[i + 1] * b[i + 1]; });
  return sum;
}

/// The vectors of a triangle or tetrahedron, as exact as the arithmetic of `Number`.
template <class Number, class Length, int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline OrthocentreVectors<Number, D, Corners> orthocentre_vectors(
    const CornerDifferences<Length, Number, D, Corners>& simplex) {
  OrthocentreVectors<Number, D, Corners> result;
  const auto& edges = simplex.edges;
  const auto& powers = simplex.powers;
  if constexpr (Corners == 3) {
    unrolled<std::size_t{D}>([&](std::size_t axis) __attribute__((always_inline)) {
      result.x[axis] = powers[0] * edges[1][axis] - powers[1] * edges[0][axis];
    });
    if constexpr (D == 2) {
      result.y[0] = edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0];
    } else {
      result.y = cross_product(edges[0], edges[1]);
    }
  } else if constexpr (Corners == 4) {
    const auto vw = cross_product(edges[1], edges[2]);
    const auto wu = cross_product(edges[2], edges[0]);
    const auto uv = cross_product(edges[0], edges[1]);
    unrolled<std::size_t{D}>([&](std::size_t axis) __attribute__((always_inline)) {
      result.x[axis] = powers[0] * vw[axis] + powers[1] * wu[axis] + powers[2] * uv[axis];
    });
    result.y[0] = dot_product(vw, edges[0]);
  }
  return result;
}

/// The squares |x|^2 and |y|^2 of those vectors.
template <class Number>
struct OrthocentreSquares {
  Number x;
  Number y;
};

/// The squares for any simplex but a vertex, as exact as the arithmetic of `Number`.
template <class Number, class Length, int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline OrthocentreSquares<Number> orthocentre_squares(
    const CornerDifferences<Length, Number, D, Corners>& simplex) {
  if constexpr (Corners == 2) {
    return {simplex.powers[0] * simplex.powers[0], dot_product(simplex.edges[0], simplex.edges[0])};
  } else {
    const auto vectors = orthocentre_vectors(simplex);
    return {dot_product(vectors.x, vectors.x), dot_product(vectors.y, vectors.y)};
  }
}

/// Positive multiples of the barycentric coordinates of the orthocentre, [corner].
///
/// A triangle's need no more than the products of its edges: from z . u = a / 2, z . v = b / 2,
/// times 2 |y|^2, that of the second corner is a |v|^2 - b u . v, and |y|^2 = |u|^2 |v|^2 - (u .
/// v)^2.
template <class Number, int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline std::array<Number, Corners> orthocentre_coordinates(
    const CornerDifferences<Number, Number, D, Corners>& simplex) {
  std::array<Number, Corners> result;
  const auto& edges = simplex.edges;
  const auto& powers = simplex.powers;
  if constexpr (Corners == 2) {
    result[1] = powers[0];
    result[0] = dot_product(edges[0], edges[0]);
  } else if constexpr (Corners == 3) {
    const auto uu = dot_product(edges[0], edges[0]);
    const auto vv = dot_product(edges[1], edges[1]);
    const auto uv = dot_product(edges[0], edges[1]);
    result[1] = powers[0] * vv - powers[1] * uv;
    result[2] = powers[1] * uu - powers[0] * uv;
    result[0] = uu * vv - uv * uv;
  } else {
    const auto vectors = orthocentre_vectors(simplex);
    result[1] = dot_product(vectors.x, cross_product(edges[1], edges[2]));
    result[2] = dot_product(vectors.x, cross_product(edges[2], edges[0]));
    result[3] = dot_product(vectors.x, cross_product(edges[0], edges[1]));
    result[0] = vectors.y[0] * vectors.y[0];
  }
  result[0] = result[0] + result[0];
  unrolled<Corners - 1>([&](std::size_t i) __attribute__((always_inline)) {
    result[0] = result[0] - result[i + 1];
  });
  return result;
}

}  // namespace orthoball
