// SPDX-License-Identifier: MIT
// Regular triangulation and filtration from the definitions, by trying all subsets of the sites.
//
// Lift a site p of weight w to the height |p|^2 - w above its position. A set of A + 2 sites (A is
// the dimension of what the sites span) has one affine dependence of positions; its coefficients c
// are minors of the matrix of positions, and sum c_j height_j is the lifted determinant. Divided by
// c_q it is the height of q above the plane through the other A + 1: these are no cell if it is
// negative, that is if q is in conflict with them. Lowering the weight of site j by eps_j adds
// sum c_j eps_j to the determinant: where it vanishes, the sign is that of the coefficient of the
// largest eps among those that are not 0.
//
// The value of a simplex T is the least power distance over the common face V_T of the power cells.
// It is taken at the orthocentre of some set S of sites that contains T and has no other site
// inside its orthoball, and the orthocentre of every such set lies in V_T: so it is the least
// squared orthoradius of all such S, in the triangulation or not.
#include "oracles/brute_force.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>

namespace orthoball::oracles {

namespace {

using Mask = std::uint64_t;         // a set of sites
using Set = std::vector<unsigned>;  // the same, ascending

Mask mask_of(const Set& set) {
  Mask mask = 0;
  for (const unsigned site : set) mask |= Mask{1} << site;
  return mask;
}

// Calls `visit` with every subset of `size` of the numbers below `count`.
void for_each_subset(unsigned count, std::size_t size, const std::function<void(const Set&)>& visit,
                     Set chosen = {}) {
  if (chosen.size() == size) return visit(chosen);
  chosen.push_back(0);
  const unsigned first = chosen.size() == 1 ? 0 : chosen[chosen.size() - 2] + 1;
  for (unsigned site = first; site < count; ++site) {
    chosen.back() = site;
    for_each_subset(count, size, visit, chosen);
  }
}

using Matrix = std::vector<std::vector<Integer>>;

// The distinct sites, in the order that the perturbation ranks them.
class Sites {
 public:
  explicit Sites(const WeightedPoints& points) : exact_(exact_points(points)) {
    std::map<std::pair<std::vector<Integer>, Integer>, std::uint32_t> first;
    for (std::uint32_t row = 0; row < points.size(); ++row) {
      const auto [place, is_new] =
          first.emplace(std::pair(exact_.position[row], exact_.weight[row]), row);
      if (!is_new) duplicates.emplace_back(row, place->second);
    }
    for (const auto& [site, row] : first) rows.push_back(row);
    if (rows.size() > 64) throw std::length_error("brute force takes at most 64 distinct sites");
    for (unsigned a = 0; a < size(); ++a) {
      auto& row = dots_.emplace_back(size());
      for (unsigned b = 0; b < size(); ++b) {
        for (std::size_t axis = 0; axis < position(a).size(); ++axis) {
          row[b] += position(a)[axis] * position(b)[axis];
        }
      }
    }
    find_span();
  }

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(rows.size()); }
  [[nodiscard]] const std::vector<Integer>& position(unsigned site) const {
    return exact_.position[rows[site]];
  }
  [[nodiscard]] const Integer& weight(unsigned site) const { return exact_.weight[rows[site]]; }
  [[nodiscard]] const Rational& unit() const { return exact_.unit; }

  // Squared distance from the origin less the weight.
  [[nodiscard]] Integer height(unsigned site) const { return dot(site, site) - weight(site); }
  [[nodiscard]] const Integer& dot(unsigned a, unsigned b) const { return dots_[a][b]; }

  // Signed measure of a simplex of affine_dimension + 1 sites, seen along axes that flatten
  // nothing.
  [[nodiscard]] Integer orientation(const Set& set) const { return orientation(set, axes_); }

  int affine_dimension = -1;
  std::vector<std::uint32_t> rows;  // [site]
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;

 private:
  [[nodiscard]] Integer orientation(const Set& set, const Set& axes) const {
    Matrix matrix;
    for (std::size_t i = 1; i < set.size(); ++i) {
      auto& row = matrix.emplace_back();
      for (const unsigned axis : axes) {
        row.push_back(position(set[i])[axis] - position(set[0])[axis]);
      }
    }
    return determinant(matrix);
  }

  // The most axes along which some simplex keeps its measure.
  void find_span() {
    if (rows.empty()) return;
    for (int dimension = exact_.dimension; affine_dimension < 0; --dimension) {
      const auto count = static_cast<std::size_t>(dimension);
      for_each_subset(static_cast<unsigned>(exact_.dimension), count, [&](const Set& axes) {
        for_each_subset(size(), count + 1, [&](const Set& set) {
          if (affine_dimension >= 0 || orientation(set, axes) == 0) return;
          affine_dimension = dimension;
          axes_ = axes;
        });
      });
    }
  }

  ExactPoints exact_;
  Matrix dots_;
  Set axes_;
};

// The coefficients of the affine dependence of affine_dimension + 2 sites.
class Dependences {
 public:
  explicit Dependences(const Sites& sites) : sites_(sites) {}

  [[nodiscard]] const Integer& orientation(const Set& set) {
    const auto [place, is_new] = orientations_.emplace(mask_of(set), 0);
    if (is_new) place->second = sites_.orientation(set);
    return place->second;
  }
  [[nodiscard]] std::vector<Integer> coefficients(const Set& set) {
    std::vector<Integer> coefficients;
    for (std::size_t j = 0; j < set.size(); ++j) {
      Set others = set;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(j));
      const Integer& minor = orientation(others);
      coefficients.push_back((set.size() - 1 - j) % 2 == 0 ? minor : Integer(-minor));
    }
    return coefficients;
  }

 private:
  const Sites& sites_;
  std::unordered_map<Mask, Integer> orientations_;
};

std::size_t cell_size(const Sites& sites) {
  return static_cast<std::size_t>(sites.affine_dimension + 1);
}

// All cells whose sites are in conflict with no other site. `determinant_sign` is the sign of the
// lifted determinant of a set with these coefficients.
using DeterminantSign = std::function<int(const Set&, const std::vector<Integer>&)>;
std::vector<Set> cells_without_conflict(const Sites& sites,
                                        const DeterminantSign& determinant_sign) {
  std::vector<Set> cells;
  if (sites.size() == 0) return cells;
  Dependences dependences(sites);
  std::set<Mask> in_conflict;
  for_each_subset(sites.size(), cell_size(sites) + 1, [&](const Set& set) {
    const std::vector<Integer> coefficients = dependences.coefficients(set);
    const int sign = determinant_sign(set, coefficients);
    for (std::size_t j = 0; j < set.size(); ++j) {
      if (sign * coefficients[j].sign() < 0)
        in_conflict.insert(mask_of(set) & ~(Mask{1} << set[j]));
    }
  });
  for_each_subset(sites.size(), cell_size(sites), [&](const Set& set) {
    if (dependences.orientation(set) != 0 && !in_conflict.contains(mask_of(set))) {
      cells.push_back(set);
    }
  });
  return cells;
}

std::vector<Set> perturbed_cells(const Sites& sites) {
  std::vector<Integer> heights;
  for (unsigned site = 0; site < sites.size(); ++site) heights.push_back(sites.height(site));
  return cells_without_conflict(sites,
                                [&](const Set& set, const std::vector<Integer>& coefficients) {
                                  Integer sum = 0;
                                  for (std::size_t j = 0; j < set.size(); ++j)
                                    sum += coefficients[j] * heights[set[j]];
                                  for (std::size_t j = set.size(); sum == 0 && j-- > 0;)
                                    sum = coefficients[j];
                                  return sum.sign();
                                });
}

// A set of affinely independent sites with no other site inside its orthoball.
struct Unattached {
  Mask sites;
  Integer numerator, denominator;  // squared orthoradius, units squared; denominator > 0
};

// The orthoball of affinely independent sites.
//
// Its centre is p_0 + sum mu_j (p_j - p_0) with 2 G mu = b, where G holds the inner products of the
// p_j - p_0 and b_j = |p_j - p_0|^2 - w_j + w_0; by Cramer's rule mu = numerators / (2 det G).
class Orthoball {
 public:
  Orthoball(const Sites& sites, const Set& set) : sites_(sites), set_(set) {
    Matrix gram;
    std::vector<Integer> b;
    for (std::size_t i = 1; i < set.size(); ++i) {
      auto& row = gram.emplace_back();
      for (std::size_t j = 1; j < set.size(); ++j) row.push_back(inner(set[i], set[j]));
      b.push_back(lift(set[i]));
    }
    determinant_ = determinant(gram);
    for (std::size_t j = 0; j < gram.size(); ++j) {
      Matrix replaced = gram;
      for (std::size_t i = 0; i < gram.size(); ++i) replaced[i][j] = b[i];
      numerators_.push_back(determinant(replaced));
    }
    rho2_.sites = mask_of(set);
    rho2_.denominator = 4 * determinant_;
    rho2_.numerator = -rho2_.denominator * sites.weight(set[0]);
    for (std::size_t j = 0; j < b.size(); ++j) rho2_.numerator += numerators_[j] * b[j];
  }

  [[nodiscard]] bool exists() const { return determinant_ != 0; }
  [[nodiscard]] const Unattached& rho2() const { return rho2_; }
  // Whether the power distance of q at the centre is less than rho2.
  [[nodiscard]] bool contains(unsigned q) const {
    Integer difference = determinant_ * lift(q);
    for (std::size_t j = 0; j < numerators_.size(); ++j) {
      difference -= numerators_[j] * inner(set_[j + 1], q);
    }
    return difference < 0;
  }
  [[nodiscard]] bool is_attached() const {
    for (unsigned q = 0; q < sites_.size(); ++q) {
      if ((rho2_.sites >> q & 1U) == 0 && contains(q)) return true;
    }
    return false;
  }

 private:
  // Inner product seen from p_0; squared distance from p_0 less the difference of weights.
  [[nodiscard]] Integer inner(unsigned a, unsigned b) const {
    const unsigned origin = set_[0];
    return sites_.dot(a, b) - sites_.dot(a, origin) - sites_.dot(b, origin) +
           sites_.dot(origin, origin);
  }
  [[nodiscard]] Integer lift(unsigned q) const {
    return inner(q, q) - sites_.weight(q) + sites_.weight(set_[0]);
  }

  const Sites& sites_;
  Set set_;
  Integer determinant_;
  std::vector<Integer> numerators_;
  Unattached rho2_;
};

std::vector<Unattached> unattached_sets(const Sites& sites) {
  std::vector<Unattached> sets;
  for (std::size_t size = 1; size <= cell_size(sites); ++size) {
    for_each_subset(sites.size(), size, [&](const Set& set) {
      const Orthoball orthoball(sites, set);
      if (orthoball.exists() && !orthoball.is_attached()) sets.push_back(orthoball.rho2());
    });
  }
  return sets;
}

// Planes through sites that have all sites on one side or on them, as the sets of sites on them.
std::vector<Mask> supporting_planes(const Sites& sites) {
  std::set<Mask> planes;
  if (sites.affine_dimension < 1) return {};
  for_each_subset(sites.size(), cell_size(sites) - 1, [&](const Set& facet) {
    Mask on = 0;
    bool above = false, below = false;
    for (unsigned q = 0; q < sites.size(); ++q) {
      Set set = facet;
      set.push_back(q);
      const Integer side = sites.orientation(set);
      if (side == 0) on |= Mask{1} << q;
      above = above || side > 0;
      below = below || side < 0;
    }
    if (above != below) planes.insert(on);
  });
  return {planes.begin(), planes.end()};
}

// Ranks of the boundary matrices over Z/2 of a complex that grows by one simplex at a time.
class BoundaryRanks {
 public:
  void add(const std::vector<std::uint32_t>& rows) {
    const std::size_t dimension = rows.size() - 1;
    ++count_[dimension];
    if (dimension == 0) return;
    std::set<std::vector<std::uint32_t>> column;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<std::uint32_t> face = rows;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
      column.insert(face);
    }
    // Elimination: subtract the column whose largest entry is the same until there is none such.
    auto& columns = columns_[dimension];
    while (!column.empty()) {
      const auto same = columns.find(*column.rbegin());
      if (same == columns.end()) break;
      for (const auto& face : same->second) {
        if (!column.insert(face).second) column.erase(face);
      }
    }
    if (!column.empty()) columns.emplace(*column.rbegin(), column);
  }
  [[nodiscard]] std::array<std::uint32_t, 3> betti() const {
    std::array<std::uint32_t, 3> betti{};
    for (std::size_t k = 0; k < 3; ++k) {
      betti[k] =
          static_cast<std::uint32_t>(count_[k] - columns_[k].size() - columns_[k + 1].size());
    }
    return betti;
  }

 private:
  using Face = std::vector<std::uint32_t>;
  std::array<std::size_t, 4> count_{};
  std::array<std::map<Face, std::set<Face>>, 4> columns_;
};

}  // namespace

BruteForce brute_force(const WeightedPoints& points) {
  const Sites sites(points);
  BruteForce result;
  result.affine_dimension = sites.affine_dimension;
  result.duplicates = sites.duplicates;

  // The triangulation.
  const std::vector<Set> cells = perturbed_cells(sites);
  std::set<Mask> complex;
  for (const Set& cell : cells) {
    const Mask mask = mask_of(cell);
    for (Mask face = mask; face != 0; face = (face - 1) & mask) complex.insert(face);
  }
  for (unsigned site = 0; site < sites.size(); ++site) {
    if (!complex.contains(Mask{1} << site)) result.hidden.push_back(sites.rows[site]);
  }
  std::sort(result.hidden.begin(), result.hidden.end());

  // When each simplex enters: as the rank of a value among those of all unattached sets.
  std::vector<Unattached> sets = unattached_sets(sites);
  const auto less = [](const Unattached& a, const Unattached& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  };
  std::sort(sets.begin(), sets.end(), less);
  std::set<Mask> unattached;
  for (const Unattached& set : sets) unattached.insert(set.sites);
  std::map<Mask, std::size_t> position;  // of the first set that contains the simplex
  std::set<std::size_t> group_starts;
  for (const Mask simplex : complex) {
    std::size_t first = 0;
    while ((sets[first].sites & simplex) != simplex) ++first;
    while (first > 0 && !less(sets[first - 1], sets[first])) --first;
    position.emplace(simplex, first);
    group_starts.insert(first);
  }
  std::map<std::size_t, std::uint32_t> index_of;
  for (const std::size_t start : group_starts) {
    result.spectrum.push_back(Rational(sets[start].numerator, sets[start].denominator) *
                              sites.unit() * sites.unit());
    index_of.emplace(start, static_cast<std::uint32_t>(result.spectrum.size()));
  }

  // The three indices.
  const std::vector<Mask> planes = supporting_planes(sites);
  for (const Mask simplex : complex) {
    BruteSimplex entry;
    for (unsigned site = 0; site < sites.size(); ++site) {
      if ((simplex >> site & 1U) != 0) entry.rows.push_back(sites.rows[site]);
    }
    std::sort(entry.rows.begin(), entry.rows.end());
    entry.is_attached = !unattached.contains(simplex);
    entry.enters = index_of.at(position.at(simplex));

    entry.regular = result.never();
    std::uint32_t last_cell = 0;
    for (const Mask coface : complex) {
      if ((coface & simplex) != simplex) continue;
      const std::uint32_t enters = index_of.at(position.at(coface));
      if (coface != simplex) entry.regular = std::min(entry.regular, enters);
      if (static_cast<std::size_t>(__builtin_popcountll(coface)) == cell_size(sites)) {
        last_cell = std::max(last_cell, enters);
      }
    }
    const bool spans_space = sites.affine_dimension == points.dimension();
    const bool is_on_hull = std::any_of(planes.begin(), planes.end(),
                                        [&](Mask plane) { return (plane & simplex) == simplex; });
    entry.interior = spans_space && !is_on_hull ? last_cell : result.never();
    if (spans_space && entry.dimension() == points.dimension()) entry.regular = entry.enters;
    result.simplices.push_back(entry);
  }
  std::sort(result.simplices.begin(), result.simplices.end(),
            [](const BruteSimplex& a, const BruteSimplex& b) {
              return std::tuple(a.enters, a.rows.size(), a.rows) <
                     std::tuple(b.enters, b.rows.size(), b.rows);
            });

  // Betti numbers of every prefix that is a complex of the spectrum.
  BoundaryRanks ranks;
  std::size_t added = 0;
  for (std::uint32_t index = 0; index < result.never(); ++index) {
    while (added < result.simplices.size() && result.simplices[added].enters == index) {
      ranks.add(result.simplices[added++].rows);
    }
    result.betti.push_back(ranks.betti());
  }
  return result;
}

std::vector<std::uint32_t> sites_without_power_cell(const WeightedPoints& points) {
  // Site q has none if and only if it lies in a simplex of other sites and strictly above it.
  const Sites sites(points);
  std::set<std::uint32_t> rows;
  if (sites.size() == 0) return {};
  Dependences dependences(sites);
  for_each_subset(sites.size(), cell_size(sites) + 1, [&](const Set& set) {
    const std::vector<Integer> coefficients = dependences.coefficients(set);
    Integer determinant = 0;
    for (std::size_t j = 0; j < set.size(); ++j) {
      determinant += coefficients[j] * sites.height(set[j]);
    }
    for (std::size_t q = 0; q < set.size(); ++q) {
      const int side = coefficients[q].sign();
      if (side * determinant.sign() <= 0) continue;
      bool is_inside = true;
      for (std::size_t j = 0; j < set.size(); ++j) {
        if (j != q && coefficients[j].sign() * side > 0) is_inside = false;
      }
      if (is_inside) rows.insert(sites.rows[set[q]]);
    }
  });
  return {rows.begin(), rows.end()};
}

std::vector<std::vector<std::uint32_t>> cells_by_lowered_weights(const WeightedPoints& points) {
  const Sites sites(points);
  // Heights are integers and coefficients at most `largest`: with eps of the last site 1 / ratio,
  // and each other's 1 / ratio of the next, no sum of the smaller outweighs one that is larger.
  Integer largest = 1;
  if (sites.size() > 0) {
    for_each_subset(sites.size(), cell_size(sites), [&](const Set& set) {
      largest = std::max(largest, Integer(abs(sites.orientation(set))));
    });
  }
  const Integer ratio = 8 * largest;
  std::vector<Integer> heights;  // times ratio^size
  Integer eps = 1;
  for (unsigned site = 0; site < sites.size(); ++site) {
    heights.push_back(sites.height(site) *
                          boost::multiprecision::pow(ratio, static_cast<unsigned>(sites.size())) +
                      eps);
    eps *= ratio;
  }
  std::vector<std::vector<std::uint32_t>> cells;
  const auto sign = [&](const Set& set, const std::vector<Integer>& coefficients) {
    Integer sum = 0;
    for (std::size_t j = 0; j < set.size(); ++j) sum += coefficients[j] * heights[set[j]];
    return sum.sign();
  };
  for (const Set& cell : cells_without_conflict(sites, sign)) {
    auto& rows = cells.emplace_back();
    for (const unsigned site : cell) rows.push_back(sites.rows[site]);
    std::sort(rows.begin(), rows.end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace orthoball::oracles
