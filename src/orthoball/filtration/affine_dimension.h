// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// Calls `evaluate.template operator()<A>()` with the affine dimension of a triangulation, 0..D, as
/// a constant; does nothing without sites.
template <int D, class Evaluate>
void with_affine_dimension(const RegularTriangulation<D>& triangulation, const Evaluate& evaluate) {
  switch (triangulation.affine_dimension()) {
    case 0:
      return evaluate.template operator()<0>();
    case 1:
      return evaluate.template operator()<1>();
    case 2:
      return evaluate.template operator()<2>();
    case 3:
      if constexpr (D == 3) return evaluate.template operator()<3>();
      break;
    default:
      break;
  }
}

}  // namespace orthoball
