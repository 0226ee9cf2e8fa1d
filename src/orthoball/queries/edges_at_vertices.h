// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// The edges at the vertices of a triangulation, by number among edges. 16 bytes an edge.
class EdgesAtVertices {
 public:
  /// An edge, and the vertex at its other end.
  struct Way {
    std::uint32_t edge, to;
  };

  /// Linear, but for sorting at each vertex.
  template <int D>
  explicit EdgesAtVertices(const Filtration<D>& filtration);

  /// [vertex], in filter order: those of a complex come first.
  [[nodiscard]] std::span<const Way> of(std::uint32_t vertex) const {
    return std::span(ways_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Way> ways_;
};

}  // namespace orthoball
