// SPDX-License-Identifier: MIT
//
// Bowyer. Computing Dirichlet tessellations. The Computer Journal 24 (1981).
// Edelsbrunner, Shah. Incremental topological flipping works for regular triangulations.
//   Algorithmica 15 (1996). We replace the whole conflict region instead of flipping through it.
// Amenta, Choi, Rote. Incremental constructions con BRIO. SoCG 2003: rounds of insertion; ours are
//   not random (see insertion_order).
// Marot, Pellerin, Remacle. One machine, one minute, three billion tetrahedra. International
//   Journal for Numerical Methods in Engineering 117 (2019): parts of a curve as territories. There
//   threads look at cells that others may be changing; here none does (see Territory).
#include "orthoball/triangulation/insertion.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "orthoball/triangulation/conflict_region.h"
#include "orthoball/triangulation/point_location.h"
#include "orthoball/triangulation/territory.h"
#include "orthoball/triangulation/territory_boxes.h"

namespace orthoball {
namespace {

template <int A, int D>
class Insertion {
 public:
  Insertion(CellStore<A>& cells, const Sites<D>& sites, std::span<const std::uint32_t> basis,
            Threads threads)
      : cells_(cells),
        sites_(sites),
        basis_(basis),
        threads_(threads),
        location_(cells, sites),
        inserted_(basis.size()) {
    add_worker();
  }

  void insert(std::span<const std::uint32_t> order) {
    while (!order.empty()) {
      const auto end = std::is_sorted_until(order.begin(), order.end());
      const auto round = order.first(static_cast<std::size_t>(end - order.begin()));
      insert_round(round);
      order = order.subspan(round.size());
    }
  }

  std::vector<std::uint32_t> hidden() {
    std::vector<std::uint32_t> all;
    for (const auto& worker : workers_) {
      all.insert(all.end(), worker->hidden.begin(), worker->hidden.end());
      worker->region.supply().close();
    }
    return all;
  }

 private:
  using Region = ConflictRegion<A, D>;
  using Outcome = typename Region::Outcome;
  using Numbers = std::span<const std::uint32_t>;

  // What a thread has for itself.
  struct Worker {
    Worker(CellStore<A>& cells, const Sites<D>& sites) : region(cells, sites) {}
    Region region;
    std::uint32_t cell = 0;  // where the next walk begins
    std::vector<std::uint32_t> hidden, postponed;
    std::vector<std::uint32_t> hints;  // see find_hints
  };

  // Territories of fewer vertices would be mostly border.
  static constexpr std::size_t kLeastVertices = 2048;
  // Sites that a thread must have to make up for its part of the postponed.
  static constexpr std::size_t kLeastShare = 512;
  static constexpr std::size_t kHintStride = 16;
  static constexpr std::uint32_t kNoHint = std::numeric_limits<std::uint32_t>::max();

  void add_worker() { workers_.push_back(std::make_unique<Worker>(cells_, sites_)); }

  void insert_round(Numbers round) {
    std::vector<std::uint32_t> left;
    if (const std::size_t count = territories_for(round); count > 1) {
      left = insert_together(round, parts_of_curve(round, count));
      round = left;
    }
    // What is near the borders, with borders in other places, as long as that makes it much less.
    for (bool is_rewarding = true; is_rewarding && territories_for(round) > 1;) {
      std::vector<std::uint32_t> rest = insert_together(round, boxes(round));
      is_rewarding = 4 * rest.size() < 3 * left.size();
      left = std::move(rest);
      round = left;
    }
    work_alone(round);
  }

  [[nodiscard]] std::size_t territories_for(Numbers sites) const {
    if (A == 1) return 1;
    return threads_.for_work(inserted_ + sites.size() / 2, kLeastVertices)
        .for_work(sites.size(), kLeastShare)
        .count();
  }

  // So many territories with equal numbers of the sites, by the numbers of the vertices.
  [[nodiscard]] std::vector<Territory<A, D>> parts_of_curve(Numbers sites,
                                                            std::size_t count) const {
    std::vector<Territory<A, D>> parts;
    std::uint32_t begin = 0;
    for (std::size_t part = 1; part <= count; ++part) {
      const std::uint32_t end =
          part == count ? cells_.infinity() : sites[part * sites.size() / count];
      parts.push_back(Territory<A, D>::of_numbers(begin, end, cells_.infinity()));
      begin = end;
    }
    return parts;
  }

  [[nodiscard]] std::vector<Territory<A, D>> boxes(Numbers sites) const {
    std::vector<Territory<A, D>> parts;
    for (const Box<D>& box : territory_boxes<D>(sites_, sites, territories_for(sites))) {
      parts.push_back(Territory<A, D>::of_box(sites_, box, cells_.infinity()));
    }
    return parts;
  }

  // Inserts what of `sites` lies within the territories. Returns what is left, ascending.
  std::vector<std::uint32_t> insert_together(Numbers sites,
                                             const std::vector<Territory<A, D>>& territories) {
    while (workers_.size() < territories.size()) add_worker();
    std::vector<std::vector<std::uint32_t>> shares(territories.size());
    const std::uint32_t start = workers_[0]->cell;
    parallel_for(threads_, shares.size(), [&](std::size_t part) {
      std::copy_if(sites.begin(), sites.end(), std::back_inserter(shares[part]),
                   [&](std::uint32_t site) { return territories[part].has(site); });
      find_hints(*workers_[part], shares[part], territories[part], start);
    });
    for (std::size_t part = 0; part < shares.size(); ++part) {
      supply(*workers_[part], shares[part].size());
    }
    parallel_for(threads_, shares.size(),
                 [&](std::size_t part) { work(*workers_[part], shares[part], territories[part]); });
    if (cells_.is_dead(cells_[start])) workers_[0]->cell = any_cell();
    std::vector<std::uint32_t> left;
    for (std::size_t part = 0; part < shares.size(); ++part) {
      std::vector<std::uint32_t>& postponed = workers_[part]->postponed;
      left.insert(left.end(), postponed.begin(), postponed.end());
      postponed.clear();
    }
    if (!std::is_sorted(left.begin(), left.end())) std::sort(left.begin(), left.end());
    inserted_ += sites.size() - left.size();
    return left;
  }

  // As many cells as so many sites will probably need.
  void supply(Worker& worker, std::size_t sites) {
    std::size_t used = cells_.size();
    for (const auto& any : workers_) used -= any->region.supply().size();
    const double wanted = 1.01 * static_cast<double>(used) / static_cast<double>(inserted_) *
                              static_cast<double>(sites) +
                          256.0;
    const double lacking = wanted - static_cast<double>(worker.region.supply().size());
    // What there is no room for is postponed to where it may grow.
    const double possible = std::min(lacking, static_cast<double>(cells_.most_more()));
    if (possible > 0.0) worker.region.supply().add(static_cast<std::uint32_t>(possible));
  }

  // For every kHintStride-th site a cell of the territory near by, kNoHint before the first that
  // has one. Their places will always have cells of the territory, or dead ones.
  void find_hints(Worker& worker, Numbers sites, const Territory<A, D>& territory,
                  std::uint32_t start) const {
    worker.hints.clear();
    std::uint32_t cell = start, hint = kNoHint;
    for (std::size_t i = 0; i < sites.size(); i += kHintStride) {
      cell = location_.locate(sites[i], cell, Territory<A, D>::whole()).cell;
      const auto& corners = cells_[cell].corners;
      const auto is_own = [&](std::uint32_t corner) { return territory.has(corner); };
      if (std::all_of(corners.begin(), corners.end(), is_own)) hint = cell;
      worker.hints.push_back(hint);
    }
  }

  // Inserts sites on one thread.
  void work_alone(Numbers sites) {
    const Territory<A, D> whole = Territory<A, D>::whole();
    Worker& worker = *workers_[0];
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (is_in_basis(sites[i])) continue;
      const std::uint32_t cell = location_.locate(sites[i], worker.cell, whole).cell;
      insert_at(worker, sites.subspan(i), cell, whole, true);
    }
    inserted_ += sites.size();
  }
  // Inserts sites in a territory. A walk that leaves it is taken up once more from the hint.
  void work(Worker& worker, Numbers sites, const Territory<A, D>& territory) const {
    bool is_lost = true;  // the last walk left the territory
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (is_in_basis(sites[i])) continue;
      for (int attempt = is_lost ? 1 : 0; attempt < 2; ++attempt) {
        is_lost = !(attempt == 0 || begin_at(worker, worker.hints[i / kHintStride]));
        if (is_lost) break;
        const auto [cell, is_found] = location_.locate(sites[i], worker.cell, territory);
        worker.cell = cell;
        is_lost = !is_found;
        if (is_found) break;
      }
      if (is_lost || !insert_at(worker, sites.subspan(i), worker.cell, territory, false)) {
        worker.postponed.push_back(sites[i]);
      }
    }
  }
  [[nodiscard]] bool begin_at(Worker& worker, std::uint32_t hint) const {
    if (hint == kNoHint || cells_.is_dead(cells_[hint])) return false;
    worker.cell = hint;
    return true;
  }

  // Inserts sites[0] and leaves the worker at a cell that is near sites[1]. False if sites[0] is
  // postponed.
  bool insert_at(Worker& worker, Numbers sites, std::uint32_t cell,
                 const Territory<A, D>& territory, bool may_grow) const {
    Region& region = worker.region;
    const Outcome outcome = region.insert(sites[0], cell, territory, may_grow, worker.hidden);
    const std::uint32_t next = sites[sites.size() > 1 ? 1 : 0];
    worker.cell = outcome == Outcome::inserted ? region.new_cell_towards(next) : cell;
    return outcome != Outcome::postponed;
  }

  // A cell that is alive. If the one where walks began is not, a worker has made others.
  [[nodiscard]] std::uint32_t any_cell() const {
    const auto is_alive = [&](const auto& worker) { return !cells_.is_dead(cells_[worker->cell]); };
    return (*std::find_if(workers_.begin(), workers_.end(), is_alive))->cell;
  }

  [[nodiscard]] bool is_in_basis(std::uint32_t site) const {
    return std::find(basis_.begin(), basis_.end(), site) != basis_.end();
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  std::span<const std::uint32_t> basis_;
  Threads threads_;
  PointLocation<A, D> location_;
  std::size_t inserted_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace

template <int A, int D>
std::vector<std::uint32_t> insert_sites(CellStore<A>& cells, const Sites<D>& sites,
                                        std::span<const std::uint32_t> order,
                                        std::span<const std::uint32_t> basis, Threads threads) {
  Insertion<A, D> insertion(cells, sites, basis, threads);
  insertion.insert(order);
  return insertion.hidden();
}

#define ORTHOBALL_INSERT(A, D)                                                           \
  template std::vector<std::uint32_t> insert_sites<A, D>(CellStore<A>&, const Sites<D>&, \
                                                         std::span<const std::uint32_t>, \
                                                         std::span<const std::uint32_t>, Threads);
ORTHOBALL_INSERT(1, 2)
ORTHOBALL_INSERT(2, 2)
ORTHOBALL_INSERT(1, 3)
ORTHOBALL_INSERT(2, 3)
ORTHOBALL_INSERT(3, 3)
#undef ORTHOBALL_INSERT

}  // namespace orthoball
