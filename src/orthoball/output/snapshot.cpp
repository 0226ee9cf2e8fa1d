// SPDX-License-Identifier: MIT
#include "orthoball/output/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/filtration/alpha.h"
#include "orthoball/output/packed_arrays.h"
#include "orthoball/output/snapshot_cycles.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/persistence.h"
#include "orthoball/version.h"

namespace orthoball {
namespace {

using Numbers = PackedArrays::Numbers;
using Reals = PackedArrays::Reals;

constexpr std::array<std::string_view, 4> kNouns{"vertices", "edges", "triangles", "tetrahedra"};

// Betti numbers and measures at every index from 1 on.
template <int D>
struct SignatureArrays {
  SignatureArrays(const Filtration<D>& filtration, Threads threads) {
    const std::size_t size = filtration.spectrum_size();
    for (auto& numbers : betti) numbers.reserve(size);
    for (auto& reals : measures) reals.reserve(size);
    scan_signatures<D>(
        filtration,
        [&](const Signature<D>& s) {
          for (std::size_t k = 0; k < D; ++k) betti[k].push_back(s.betti[k]);
          const std::array<double, 4> values{s.volume, s.area_singular, s.area_regular, s.length};
          for (std::size_t k = 0; k < measures.size(); ++k) measures[k].push_back(values[k]);
        },
        threads);
  }

  static constexpr std::array<std::string_view, 4> kMeasures{"volume", "area_singular",
                                                             "area_regular", "length"};
  std::array<Numbers, std::size_t{D}> betti;
  std::array<Reals, D == 3 ? 4 : 3> measures;
};

// The labels of one kind as numbers of the distinct ones, by first appearance.
struct Dictionary {
  explicit Dictionary(const std::vector<std::string>& labels) {
    std::map<std::string_view, std::uint32_t> known;
    for (const std::string& label : labels) {
      const auto [place, is_new] = known.try_emplace(label, words.size());
      if (is_new) words.push_back(label);
      codes.push_back(place->second);
    }
  }
  std::vector<std::string_view> words;
  Numbers codes;  // [row]
};

using Labels = std::vector<std::pair<std::string_view, Dictionary>>;

Labels coded(const SiteLabels& labels) {
  Labels all;
  const auto add = [&](std::string_view name, const std::vector<std::string>& of_row) {
    if (!of_row.empty()) all.emplace_back(name, Dictionary(of_row));
  };
  add("element", labels.element);
  add("atom", labels.atom);
  add("residue", labels.residue);
  add("residue_id", labels.residue_id);
  add("chain", labels.chain);
  return all;
}

void write_alphas(ByteSink& json, double alpha2) {
  json.text(",\"alpha2\":");
  json.real(alpha2);
  json.text(",\"alpha\":");
  json.real(alpha_from_alpha2(alpha2));
}

void write_strings(ByteSink& json, std::span<const std::string_view> words) {
  json.text("[");
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) json.text(",");
    json.json_string(words[i]);
  }
  json.text("]");
}

template <int D>
void write_notable(ByteSink& json, const Filtration<D>& filtration) {
  bool is_first = true;
  json.text(",\"notable\":[");
  for (const NotableAlpha& notable : notable_alphas(filtration)) {
    if (!notable.index) continue;
    json.text(is_first ? "{\"name\":" : ",{\"name\":");
    is_first = false;
    json.json_string(notable.name);
    json.text(",\"reason\":");
    json.json_string(notable.reason);
    json.text(",\"index\":");
    json.integer(*notable.index);
    write_alphas(json, notable.alpha2);
    json.text("}");
  }
  json.text("]");
}

void write_start(ByteSink& json, const SnapshotFacts& facts) {
  constexpr std::array<std::string_view, 3> kWeights{"none", "given", "molecule_radii"};
  const auto member = [&](std::string_view key, std::string_view value) {
    json.text(key);
    json.json_string(value);
  };
  member(",\"source\":", facts.source);
  member(",\"unit\":", facts.unit);
  member(",\"radii\":", facts.radii);
  member(",\"weights\":", kWeights[static_cast<std::size_t>(facts.weights)]);
  json.text(",\"start\":{\"index\":");
  json.integer(facts.index);
  write_alphas(json, facts.alpha2);
  member(",\"reason\":", facts.chosen_because);
  json.text("}");
}

// The members of the header.
template <int D>
std::string facts_text(const Filtration<D>& filtration, const SnapshotFacts& facts,
                       const Labels& labels, const PersistencePairs<D>& pairs,
                       const SnapshotCycles& cycles) {
  const RegularTriangulation<D>& triangulation = filtration.triangulation();
  std::ostringstream out;
  ByteSink json(out, "null");
  const auto count = [&](std::string_view key, std::size_t number) {
    json.text(key);
    json.integer(static_cast<std::int64_t>(number));
  };
  json.text("\"version\":1,\"program\":");
  json.json_string(std::string("orthoball ") + kVersion);
  write_start(json, facts);
  count(",\"dimension\":", D);
  json.text(",\"affine_dimension\":");
  json.integer(triangulation.affine_dimension());
  count(",\"sites\":", triangulation.site_count());
  count(",\"hidden\":", triangulation.hidden().size());
  count(",\"duplicates\":", triangulation.duplicates().size());
  for (int k = 0; k <= D; ++k) {
    count(",\"" + std::string(kNouns[static_cast<std::size_t>(k)]) + "\":", filtration.count(k));
  }
  count(",\"spectrum_size\":", filtration.spectrum_size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    count(",\"pairs_" + std::to_string(k) + "\":", pairs[k].size());
  }
  if (D == 3) {
    count(",\"cycles\":", cycles.pairs.size());
    count(",\"cycle_edges\":", cycles.edges.size());
  }
  write_notable(json, filtration);
  json.text(",\"dictionaries\":{");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (i > 0) json.text(",");
    json.json_string(labels[i].first);
    json.text(":");
    write_strings(json, labels[i].second.words);
  }
  json.text("}");
  json.flush();
  return out.str();
}

void add_sites(PackedArrays& arrays, const WeightedPoints& points) {
  const std::size_t dimension = static_cast<std::size_t>(points.dimension());
  arrays.add("coordinates", dimension * points.size(), PackedType::f64, [&points] {
    Reals reals;
    for (std::size_t row = 0; row < points.size(); ++row) {
      for (int axis = 0; axis < points.dimension(); ++axis) {
        reals.push_back(points.coordinate(row, axis));
      }
    }
    return reals;
  });
  if (points.weight_kind() == WeightKind::none) return;
  arrays.add("weights", points.size(), PackedType::f64, [&points] {
    Reals reals;
    for (std::size_t row = 0; row < points.size(); ++row) reals.push_back(points.weight(row));
    return reals;
  });
}

template <int D>
void add_rows(PackedArrays& arrays, const RegularTriangulation<D>& triangulation) {
  arrays.add("vertex_rows", triangulation.vertex_count(), 1, [&triangulation] {
    Numbers rows;
    for (const SiteId row : triangulation.sites().rows()) rows.push_back(row.row());
    return rows;
  });
  arrays.add("hidden", triangulation.hidden().size(), 1, [&triangulation] {
    Numbers rows;
    for (const SiteId row : triangulation.hidden()) rows.push_back(row.row());
    return rows;
  });
  arrays.add("duplicates", 2 * triangulation.duplicates().size(), 2, [&triangulation] {
    Numbers rows;
    for (const Duplicate& duplicate : triangulation.duplicates()) {
      rows.push_back(duplicate.row.row());
      rows.push_back(duplicate.representative.row());
    }
    return rows;
  });
}

// One number of every simplex of a dimension.
template <int D, class NumberOf>
Numbers of_all(const Filtration<D>& filtration, int dimension, const NumberOf& number_of) {
  const std::uint32_t first = filtration.table().first(dimension);
  Numbers numbers(filtration.count(dimension));
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = number_of(SimplexId(first + i));
  return numbers;
}

template <int D>
Numbers corners_of_all(const Filtration<D>& filtration, int dimension) {
  const std::uint32_t first = filtration.table().first(dimension);
  Numbers numbers;
  numbers.reserve((static_cast<std::size_t>(dimension) + 1) * filtration.count(dimension));
  if (dimension == D && filtration.triangulation().affine_dimension() == D) {
    for (const auto& cell : filtration.triangulation().template cells<D>()) {
      numbers.insert(numbers.end(), cell.corners.begin(), cell.corners.end());
    }
    return numbers;
  }
  for (std::uint32_t i = 0; i < filtration.count(dimension); ++i) {
    for (const VertexId v : filtration.vertices(SimplexId(first + i))) numbers.push_back(v.row());
  }
  return numbers;
}

// The cells beside facets: what facets are made of, and when they change their roles.
template <int D>
void add_facets(PackedArrays& arrays, const Filtration<D>& filtration) {
  arrays.add("facet_owners", filtration.count(D - 1), 1, [&filtration] {
    const auto owners = filtration.table().facet_owners();
    return Numbers(owners.begin(), owners.end());
  });
  arrays.add("facet_neighbours", filtration.count(D - 1), 1, [&filtration] {
    return of_all(filtration, D - 1, [&](SimplexId facet) {
      const auto cells = filtration.cells_beside(facet);
      return cells.size() < 2 ? kOutside : cells[1].row() - filtration.table().first(D);
    });
  });
}

template <int D>
void add_simplices(PackedArrays& arrays, const Filtration<D>& filtration) {
  const bool has_cells = filtration.triangulation().affine_dimension() == D;
  for (int k = 0; k <= D; ++k) {
    const std::string noun(kNouns[static_cast<std::size_t>(k)]);
    const std::size_t count = filtration.count(k), corners = static_cast<std::size_t>(k) + 1;
    if (has_cells && k == D - 1) {
      add_facets(arrays, filtration);
    } else if (k > 0) {
      arrays.add(noun, corners * count, corners,
                 [&filtration, k] { return corners_of_all(filtration, k); });
    }
    const auto add_indices = [&](const std::string& role, auto index_of) {
      arrays.add(fmt::format("{}_{}", noun, role), count, 0,
                 [&filtration, k, index_of] { return of_all(filtration, k, index_of); });
    };
    add_indices("enters", [&filtration](SimplexId s) { return filtration.enters(s); });
    if (has_cells && k >= D - 1) continue;  // the cells tell
    add_indices("regular", [&filtration](SimplexId s) { return filtration.regular(s); });
    add_indices("interior", [&filtration](SimplexId s) { return filtration.interior(s); });
  }
}

template <int D>
void add_signatures(PackedArrays& arrays, const SignatureArrays<D>& signatures) {
  for (std::size_t k = 0; k < signatures.betti.size(); ++k) {
    arrays.add("betti_" + std::to_string(k), signatures.betti[k].size(), 1,
               [&numbers = signatures.betti[k]] { return numbers; });
  }
  for (std::size_t k = 0; k < signatures.measures.size(); ++k) {
    const Reals& reals = signatures.measures[k];
    arrays.add(std::string(SignatureArrays<D>::kMeasures[k]), reals.size(),
               reals.size() > kExactMeasures ? PackedType::f32 : PackedType::f64,
               [&reals] { return reals; });
  }
}

// By the number of the simplex that closes the cycle, which packs better than the order of births.
template <int D>
PersistencePairs<D> sorted_pairs(const Filtration<D>& filtration, Threads threads) {
  PersistencePairs<D> pairs = persistence_pairs(filtration, WantedPairs::lasting, threads);
  for (auto& of_dimension : pairs) {
    std::sort(of_dimension.begin(), of_dimension.end(),
              [](const auto& a, const auto& b) { return a.birth < b.birth; });
  }
  return pairs;
}

template <int D>
void add_pairs(PackedArrays& arrays, const Filtration<D>& filtration,
               const PersistencePairs<D>& pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    arrays.add("persistence_" + std::to_string(k), 2 * pairs[k].size(), 2,
               [&filtration, &of_dimension = pairs[k], k] {
                 const int dimension = static_cast<int>(k);
                 const std::uint32_t first = filtration.table().first(dimension),
                                     first_filling = filtration.table().first(dimension + 1);
                 Numbers numbers;
                 for (const auto& [birth, death] : of_dimension) {
                   numbers.push_back(birth.row() - first);
                   numbers.push_back(death.exists() ? death.row() - first_filling : kOutside);
                 }
                 return numbers;
               });
  }
}

void add_cycles(PackedArrays& arrays, const SnapshotCycles& cycles) {
  const auto add = [&](const char* name, const std::vector<std::uint32_t>& numbers) {
    arrays.add(name, numbers.size(), 1,
               [&numbers] { return Numbers(numbers.begin(), numbers.end()); });
  };
  add("cycle_pairs", cycles.pairs);
  add("cycle_ends", cycles.ends);
  add("cycle_edges", cycles.edges);
}

void add_labels(PackedArrays& arrays, const SiteLabels& labels, const Labels& coded) {
  if (!labels.line.empty()) {
    arrays.add("line", labels.line.size(), 1,
               [&labels] { return Numbers(labels.line.begin(), labels.line.end()); });
  }
  for (const auto& [name, dictionary] : coded) {
    arrays.add(std::string(name), dictionary.codes.size(), 0,
               [&codes = dictionary.codes] { return codes; });
  }
}

}  // namespace

template <int D>
void write_snapshot(ByteSink& sink, const Filtration<D>& filtration, const WeightedPoints& points,
                    const SiteLabels& labels, const SnapshotFacts& facts, Threads threads) {
  const SignatureArrays<D> signatures(filtration, threads);
  const PersistencePairs<D> pairs = sorted_pairs(filtration, threads);
  const SnapshotCycles cycles = snapshot_cycles(filtration, pairs[1], threads);
  const Labels coded_labels = coded(labels);
  PackedArrays arrays;
  add_sites(arrays, points);
  add_rows(arrays, filtration.triangulation());
  arrays.add("spectrum", filtration.spectrum_size(), PackedType::f64, [&filtration] {
    const auto spectrum = filtration.spectrum();
    return Reals(spectrum.begin(), spectrum.end());
  });
  add_simplices(arrays, filtration);
  add_signatures(arrays, signatures);
  add_pairs(arrays, filtration, pairs);
  if (D == 3) add_cycles(arrays, cycles);
  add_labels(arrays, labels, coded_labels);
  arrays.write(sink, facts_text(filtration, facts, coded_labels, pairs, cycles));
}

template void write_snapshot<2>(ByteSink&, const Filtration<2>&, const WeightedPoints&,
                                const SiteLabels&, const SnapshotFacts&, Threads);
template void write_snapshot<3>(ByteSink&, const Filtration<3>&, const WeightedPoints&,
                                const SiteLabels&, const SnapshotFacts&, Threads);

}  // namespace orthoball
