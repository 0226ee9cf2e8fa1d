// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/exact/sites.h"
#include "orthoball/parallel.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// Inserts sites one by one between the cells of A + 1 of them. Each is located by a walk from the
/// last cell made; if the cell found is not in conflict with it, the site is hidden, now and for
/// ever; otherwise the cells in conflict are replaced by cells at the site. Between insertions the
/// cells are the regular triangulation of the sites so far, with one vertex at infinity.
///
/// Several threads share the later rounds of the order: each has a territory, a part of the curve
/// along which sites are numbered, and inserts the sites whose conflict regions lie in it; those
/// that are left follow, with the borders elsewhere, and the last on one thread. The result is
/// unique, so it does not depend on that; the numbers of the cells do.
///
/// @param cells  with the first cells; at the end all that are not dead are the triangulation.
/// @param order  the sites in rounds, numbers ascending within each.
/// @param basis  sites of the first cells, which are left out.
/// @return the hidden sites.
/// @throws LimitError for more than 2^29 cells.
template <int A, int D>
[[nodiscard]] std::vector<std::uint32_t> insert_sites(CellStore<A>& cells, const Sites<D>& sites,
                                                      std::span<const std::uint32_t> order,
                                                      std::span<const std::uint32_t> basis,
                                                      Threads threads);

extern template std::vector<std::uint32_t> insert_sites<1, 2>(CellStore<1>&, const Sites<2>&,
                                                              std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>,
                                                              Threads);
extern template std::vector<std::uint32_t> insert_sites<2, 2>(CellStore<2>&, const Sites<2>&,
                                                              std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>,
                                                              Threads);
extern template std::vector<std::uint32_t> insert_sites<1, 3>(CellStore<1>&, const Sites<3>&,
                                                              std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>,
                                                              Threads);
extern template std::vector<std::uint32_t> insert_sites<2, 3>(CellStore<2>&, const Sites<3>&,
                                                              std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>,
                                                              Threads);
extern template std::vector<std::uint32_t> insert_sites<3, 3>(CellStore<3>&, const Sites<3>&,
                                                              std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>,
                                                              Threads);

}  // namespace orthoball
