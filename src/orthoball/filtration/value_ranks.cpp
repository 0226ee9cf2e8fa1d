// SPDX-License-Identifier: MIT
//
// Every simplex that is not attached gets its squared orthoradius as a correctly rounded label and
// is sorted by it. Labels that differ are in exact order; runs of equal labels are split into
// classes of exactly equal values, by integers where certified bounds do not separate them. A class
// is one entry of the spectrum.
//
// Labels are dealt to buckets as they come, in a list for each dimension and part of the simplices.
// Groups of buckets are then sorted and cut into classes, each on its own. Where no weights differ,
// vertices need no labels: they are the first class.
#include "orthoball/filtration/value_ranks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <span>
#include <utility>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/class_writer.h"
#include "orthoball/filtration/crowded_bucket.h"
#include "orthoball/filtration/label_buckets.h"
#include "orthoball/filtration/simplex_labels.h"
#include "orthoball/filtration/simplex_reader.h"

namespace orthoball {
namespace {

template <int D, int A>
class Ranking {
 public:
  Ranking(const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
          std::span<const std::uint64_t> is_attached, std::span<SimplexId> order, Threads threads)
      : sites_(triangulation.sites()),
        table_(table),
        is_attached_(is_attached),
        order_(order),
        threads_(threads.for_work(table.size(), kLeastPart)),
        reader_{{}, table} {
    if constexpr (A >= 1) reader_.cells = triangulation.template cells<A>();
  }

  ValueRanks ranks() {
    result_.spectrum.resize(order_.size());
    starts_.resize(order_.size() / 64 + 1, 0);
    if (sites_.is_unweighted()) rank_vertices();
    const BucketRule rule(table_.size(), sample_of_labels());
    const std::size_t list_count = kLists * std::min<std::size_t>(threads_.count(), kMostParts);
    LabelPool pool(order_.size(), rule.bucket_count(), list_count);
    std::vector<LabelList> lists(list_count, LabelList(rule, pool));
    deal_labels(lists);
    std::vector<Group> groups = groups_of(lists, rule.bucket_count());
    parallel_for(threads_, groups.size(), [&](std::size_t i) {
      if (!groups[i].is_crowded) rank(lists, rule, groups[i]);
    });
    rank_crowded(lists, groups);
    close_gaps(groups);
    result_.starts = RankedBits(std::move(starts_));
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kLists = std::size_t{A} + 1;  // of each part: one a dimension
  // More parts would leave more of the last chunks of their lists empty than fill the others.
  static constexpr std::size_t kMostParts = 12;
  static constexpr std::size_t kLeastPart = std::size_t{1} << 16U;
  static constexpr std::size_t kCrowd = std::size_t{1} << 17U;  // numbers of a bucket
  using Rows = std::span<std::uint32_t>;
  using ConstRows = std::span<const std::uint32_t>;

  // Buckets that are ranked one after the other.
  struct Group {
    std::size_t first_bucket;
    std::size_t end_bucket;
    std::size_t begin;        // of its simplices in the order, and of its part of the spectrum
    std::size_t classes = 0;  // in that part, and then nothing up to the next
    bool is_crowded = false;  // one bucket, or a part of it, that many threads rank
  };
  [[nodiscard]] ClassWriter writer_of(const Group& group) {
    return {order_.subspan(group.begin), std::span(result_.spectrum).subspan(group.begin), starts_,
            group.begin};
  }

  void rank_vertices();
  [[nodiscard]] std::vector<double> sample_of_labels() const;
  void deal_labels(std::vector<LabelList>& lists) const;
  [[nodiscard]] std::vector<Group> groups_of(const std::vector<LabelList>& lists,
                                             std::size_t buckets) const;
  void rank(const std::vector<LabelList>& lists, const BucketRule& rule, Group& group);
  void rank_crowded(const std::vector<LabelList>& lists, std::vector<Group>& groups);
  void rank_one_key(ClassWriter& classes, Rows simplices, double label) const;
  void rank_runs(ClassWriter& classes, std::span<const std::uint64_t> keys, Rows simplices) const;
  void rank_run(ClassWriter& classes, Rows simplices, double label) const;
  [[nodiscard]] bool is_one_class(std::uint32_t first, ConstRows others) const;
  void rank_exactly(ClassWriter& classes, Rows simplices, double label) const;
  void close_gaps(const std::vector<Group>& groups);
  [[nodiscard]] FewOf<std::uint32_t, D> corners(std::uint32_t simplex) const;

  [[nodiscard]] std::uint32_t first(int dimension) const { return table_.first(dimension); }
  [[nodiscard]] std::uint32_t count(int dimension) const {
    return static_cast<std::uint32_t>(table_.count(dimension));
  }

  const Sites<D>& sites_;
  const SimplexTable<D>& table_;
  std::span<const std::uint64_t> is_attached_;
  std::span<SimplexId> order_;
  Threads threads_;
  SimplexReader<D, A> reader_;
  ValueRanks result_;
  std::vector<std::uint64_t> starts_;  // bits, see ValueRanks
};

// --- labels ------------------------------------------------------------------------------------

// The parts of each dimension fill lists that follow each other.
template <int D, int A>
void Ranking<D, A>::deal_labels(std::vector<LabelList>& lists) const {
  const std::size_t parts = lists.size() / kLists;
  parallel_for(threads_, lists.size(), [&](std::size_t task) {
    const std::size_t i = lists.size() - 1 - task;  // cells take the longest
    const auto deal = [&]<int K>() {
      if (i / parts != K || (K == 0 && sites_.is_unweighted())) return;
      const std::size_t part = i % parts;
      const std::uint64_t size = count(K);
      LabelList& list = lists[i];
      for_each_label<K>(sites_, reader_, is_attached_,
                        static_cast<std::uint32_t>(size * part / parts),
                        static_cast<std::uint32_t>(size * (part + 1) / parts),
                        [&](std::uint32_t simplex, double label) { list.add(label, simplex); });
    };
    deal.template operator()<0>();
    if constexpr (A >= 1) deal.template operator()<1>();
    if constexpr (A >= 2) deal.template operator()<2>();
    if constexpr (A >= 3) deal.template operator()<3>();
  });
}

// Of some cells far apart and one face of each dimension of each.
template <int D, int A>
std::vector<double> Ranking<D, A>::sample_of_labels() const {
  constexpr std::uint32_t kMostCells = 2048;
  constexpr std::uint32_t kLeastStep = 8;
  const std::uint32_t step = std::max(count(A) / kMostCells + 1, kLeastStep);
  std::vector<double> result;
  const auto add_faces = [&]<std::size_t Corners>() {
    std::vector<CornerSites<Corners>> faces;
    for (std::uint32_t cell = 0; cell < count(A); cell += step) {
      const auto all = reader_.template corners<A>(cell);
      std::copy_n(all.begin(), Corners, faces.emplace_back().begin());
    }
    result.resize(result.size() + faces.size());
    squared_orthoradii<D, Corners>(sites_, faces, std::span(result).last(faces.size()));
  };
  add_faces.template operator()<std::size_t{A} + 1>();
  if constexpr (A >= 2) add_faces.template operator()<2>();
  if constexpr (A >= 3) add_faces.template operator()<3>();
  return result;
}

template <int D, int A>
FewOf<std::uint32_t, D> Ranking<D, A>::corners(std::uint32_t simplex) const {
  FewOf<std::uint32_t, D> result;
  const int dimension = table_.dimension(SimplexId(simplex));
  const std::uint32_t number = simplex - first(dimension);
  const auto take = [&](const auto& sites) {
    for (const std::uint32_t site : sites) result.push_back(site);
  };
  if (dimension == 0) take(reader_.template corners<0>(number));
  if constexpr (A >= 1) {
    if (dimension == 1) take(reader_.template corners<1>(number));
  }
  if constexpr (A >= 2) {
    if (dimension == 2) take(reader_.template corners<2>(number));
  }
  if constexpr (A >= 3) {
    if (dimension == 3) take(reader_.template corners<3>(number));
  }
  return result;
}

// --- classes -----------------------------------------------------------------------------------

// All have the value of their weights, and all others have greater ones.
template <int D, int A>
void Ranking<D, A>::rank_vertices() {
  if (count(0) == 0) return;
  std::vector<std::uint32_t> vertices(count(0));
  std::iota(vertices.begin(), vertices.end(), 0U);
  double label = 0.0;
  const CornerSites<1> vertex{0};
  squared_orthoradii<D, 1>(sites_, {&vertex, 1}, {&label, 1});
  writer_of(Group{}).add(vertices, label);
}

// Where each bucket's simplices begin follows from how many are in those before.
template <int D, int A>
std::vector<typename Ranking<D, A>::Group> Ranking<D, A>::groups_of(
    const std::vector<LabelList>& lists, std::size_t buckets) const {
  constexpr std::size_t kBuckets = 8;
  std::vector<Group> groups;
  std::size_t begin = sites_.is_unweighted() ? count(0) : 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    std::size_t size = 0;
    for (const LabelList& list : lists) size += list.size(bucket);
    const bool is_crowded = size > kCrowd;
    if (groups.empty() || is_crowded || groups.back().is_crowded ||
        bucket - groups.back().first_bucket == kBuckets) {
      groups.push_back({bucket, bucket, begin, 0, is_crowded});
    }
    groups.back().end_bucket = bucket + 1;
    begin += size;
  }
  return groups;
}

template <int D, int A>
void Ranking<D, A>::rank(const std::vector<LabelList>& lists, const BucketRule& rule,
                         Group& group) {
  BucketSorter sorter(rule);
  ClassWriter classes = writer_of(group);
  for (std::size_t bucket = group.first_bucket; bucket < group.end_bucket; ++bucket) {
    sorter.sort(lists, bucket);
    rank_runs(classes, sorter.keys(), sorter.rows());
  }
  group.classes = classes.classes();
}

// Of sorted keys.
template <int D, int A>
inline void Ranking<D, A>::rank_runs(ClassWriter& classes, std::span<const std::uint64_t> keys,
                                     Rows simplices) const {
  for (std::size_t begin = 0; begin < keys.size();) {
    std::size_t end = begin + 1;
    // -0 stands for negative values too small for a double, less than what 0 stands for.
    while (end < keys.size() && keys[end] == keys[begin]) ++end;
    rank_run(classes, simplices.subspan(begin, end - begin), number_of_key(keys[begin]));
    begin = end;
  }
}

// One crowded bucket after the other, by all threads; each part of it becomes a group.
template <int D, int A>
void Ranking<D, A>::rank_crowded(const std::vector<LabelList>& lists, std::vector<Group>& groups) {
  std::vector<Group> all;
  for (const Group& group : groups) {
    if (!group.is_crowded) {
      all.push_back(group);
      continue;
    }
    CrowdedBucket bucket(lists, group.first_bucket, threads_);
    const std::size_t first = all.size();
    for (const CrowdedBucket::Part& part : bucket.parts()) {
      all.push_back({group.first_bucket, group.end_bucket, group.begin + part.begin, 0, true});
    }
    const auto rank_part = [&](std::size_t i, const auto& rank) {
      ClassWriter classes = writer_of(all[first + i]);
      rank(classes, bucket.parts()[i]);
      all[first + i].classes = classes.classes();
    };
    parallel_for(threads_, bucket.parts().size(), [&](std::size_t i) {
      if (bucket.parts()[i].one_key) return;
      rank_part(i, [&](ClassWriter& classes, const CrowdedBucket::Part& part) {
        KeySorter().sort(bucket.keys(part), bucket.rows(part));
        rank_runs(classes, bucket.keys(part), bucket.rows(part));
      });
    });
    for (std::size_t i = 0; i < bucket.parts().size(); ++i) {
      if (!bucket.parts()[i].one_key) continue;
      rank_part(i, [&](ClassWriter& classes, const CrowdedBucket::Part& part) {
        rank_one_key(classes, bucket.rows(part), number_of_key(*part.one_key));
      });
    }
  }
  groups = std::move(all);
}

// Ranks simplices with one label. Most runs of more than one are one class, which takes one pass.
// Others are cut wherever the bounds of what rounding took from the labels leave a gap: so of many
// values that share a label, as of cells that nearly share a sphere, few are compared in integers.
template <int D, int A>
inline void Ranking<D, A>::rank_run(ClassWriter& classes, Rows simplices, double label) const {
  if (simplices.size() == 1 || is_one_class(simplices[0], simplices.subspan(1))) {
    return classes.add(simplices, label);
  }
  struct Bounded {
    Bounds remainder;
    std::uint32_t simplex;
  };
  std::vector<Bounded> bounded;
  bounded.reserve(simplices.size());
  for (const std::uint32_t simplex : simplices) {
    const auto mine = corners(simplex);
    bounded.push_back({label_remainder<D>(sites_, {mine.begin(), mine.size()}, label), simplex});
  }
  std::sort(bounded.begin(), bounded.end(), [](const Bounded& a, const Bounded& b) {
    return a.remainder.least < b.remainder.least;
  });
  for (std::size_t i = 0; i < bounded.size(); ++i) simplices[i] = bounded[i].simplex;
  for (std::size_t begin = 0; begin < bounded.size();) {
    double most = bounded[begin].remainder.most;
    std::size_t end = begin + 1;
    for (; end < bounded.size() && bounded[end].remainder.least <= most; ++end) {
      most = std::max(most, bounded[end].remainder.most);
    }
    rank_exactly(classes, simplices.subspan(begin, end - begin), label);
    begin = end;
  }
}

// The same by all threads where that is one class.
template <int D, int A>
void Ranking<D, A>::rank_one_key(ClassWriter& classes, Rows simplices, double label) const {
  constexpr std::size_t kPart = std::size_t{1} << 14U;
  const std::size_t parts = simplices.size() / kPart + 1;
  std::atomic<bool> is_one = true;
  parallel_parts(threads_, simplices.size(), parts,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   if (begin == end || !is_one.load(std::memory_order_relaxed)) return;
                   if (is_one_class(simplices[0], simplices.subspan(begin, end - begin))) return;
                   is_one.store(false, std::memory_order_relaxed);
                 });
  if (!is_one.load(std::memory_order_relaxed)) return rank_run(classes, simplices, label);
  classes.add_last(simplices, label, threads_);
}

template <int D, int A>
bool Ranking<D, A>::is_one_class(std::uint32_t first, ConstRows others) const {
  const auto of_first = corners(first);
  const OrthoradiusPivot<D> pivot(sites_, {of_first.begin(), of_first.size()});
  return std::all_of(others.begin(), others.end(), [&](std::uint32_t simplex) {
    const auto mine = corners(simplex);
    return pivot.compare({mine.begin(), mine.size()}) == Sign::zero;
  });
}

// Quicksort in three parts by the exact comparison with one pivot.
template <int D, int A>
void Ranking<D, A>::rank_exactly(ClassWriter& classes, Rows simplices, double label) const {
  while (simplices.size() > 1) {
    const auto pivot_corners = corners(simplices[simplices.size() / 2]);
    const OrthoradiusPivot<D> pivot(sites_, {pivot_corners.begin(), pivot_corners.size()});
    std::size_t equal = 0;                   // [0, equal): less
    std::size_t next = 0;                    // [equal, next): equal
    std::size_t greater = simplices.size();  // [greater, size): greater
    while (next < greater) {
      const auto mine = corners(simplices[next]);
      const Sign sign = pivot.compare({mine.begin(), mine.size()});
      if (sign == Sign::negative) {
        std::swap(simplices[equal++], simplices[next++]);
      } else if (sign == Sign::positive) {
        std::swap(simplices[next], simplices[--greater]);
      } else {
        ++next;
      }
    }
    rank_exactly(classes, simplices.first(equal), label);
    classes.add(simplices.subspan(equal, greater - equal), label);
    simplices = simplices.subspan(greater);
  }
  if (!simplices.empty()) classes.add(simplices, label);
}

// Every group wrote its part of the spectrum as if all its values were distinct.
template <int D, int A>
void Ranking<D, A>::close_gaps(const std::vector<Group>& groups) {
  double* const spectrum = result_.spectrum.data();
  std::size_t size = sites_.is_unweighted() && count(0) > 0 ? 1 : 0;
  for (const Group& group : groups) {
    if (size != group.begin) {
      std::copy_n(spectrum + group.begin, group.classes, spectrum + size);
    }
    size += group.classes;
  }
  result_.spectrum.resize(size);
}

}  // namespace

template <int D>
ValueRanks value_ranks(const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
                       std::span<const std::uint64_t> is_attached, std::span<SimplexId> order,
                       Threads threads) {
  ValueRanks result{{}, RankedBits(std::vector<std::uint64_t>(1, 0))};  // without sites
  with_affine_dimension(triangulation, [&]<int A>() {
    result = Ranking<D, A>(triangulation, table, is_attached, order, threads).ranks();
  });
  return result;
}

// To simplices far from each other.
void deal_ranks(std::span<const SimplexId> order, const RankedBits& starts,
                std::span<std::uint32_t> ranks, Threads threads) {
  constexpr std::size_t kPart = std::size_t{1} << 16U;
  constexpr std::size_t kAhead = 24;
  parallel_parts(threads, order.size(), order.size() / kPart + 1,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   std::uint32_t rank = starts.rank(static_cast<std::uint32_t>(begin));
                   for (std::size_t i = begin; i < end; ++i) {
                     const std::size_t ahead = std::min(i + kAhead, order.size() - 1);
                     __builtin_prefetch(&ranks[order[ahead].row()], 1);
                     rank += starts.contains(static_cast<std::uint32_t>(i)) ? 1U : 0U;
                     ranks[order[i].row()] = rank;
                   }
                 });
}

template ValueRanks value_ranks<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                   std::span<const std::uint64_t>, std::span<SimplexId>, Threads);
template ValueRanks value_ranks<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                   std::span<const std::uint64_t>, std::span<SimplexId>, Threads);

}  // namespace orthoball
