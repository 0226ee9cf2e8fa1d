// SPDX-License-Identifier: MIT
#include "orthoball/output/persistence_table.h"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace orthoball {
namespace {

// One pair after the other: visit(dimension, pair).
template <int D, class Visit>
void for_each_pair(const PersistencePairs<D>& pairs, const Visit& visit) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    for (const PersistencePair& pair : pairs[k]) visit(k, pair);
  }
}

template <int D>
class Writer {
 public:
  Writer(ByteSink& sink, const Filtration<D>& filtration, PersistenceValues values)
      : sink_(sink), filtration_(filtration), values_(values) {}

  void value(SimplexId simplex) {
    const std::uint32_t index = filtration_.enters(simplex);
    values_ == PersistenceValues::index ? sink_.integer(index)
                                        : sink_.real(filtration_.alpha2(index));
  }
  /// Never empty: for a reader that tells columns by blanks.
  void value_or_infinity(SimplexId simplex) {
    const double alpha2 = filtration_.alpha2(filtration_.enters(simplex));
    if (values_ == PersistenceValues::index || std::isfinite(alpha2)) return value(simplex);
    sink_.text(alpha2 < 0.0 ? "-inf" : "inf");
  }
  void rows(SimplexId simplex, std::string_view between) {
    FewOf<SiteId, D> rows;
    for (const SiteId row : filtration_.rows(simplex)) rows.insert(row);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0) sink_.text(between);
      sink_.integer(rows[i].row());
    }
  }

 private:
  ByteSink& sink_;
  const Filtration<D>& filtration_;
  PersistenceValues values_;
};

}  // namespace

template <int D>
void write_persistence_csv(ByteSink& sink, const Filtration<D>& filtration,
                           const PersistencePairs<D>& pairs, PersistenceValues values) {
  Writer<D> writer(sink, filtration, values);
  sink.text("dimension,birth,death,birth_simplex,death_simplex\n");
  for_each_pair<D>(pairs, [&](std::size_t dimension, const PersistencePair& pair) {
    sink.integer(static_cast<std::int64_t>(dimension));
    sink.text(",");
    writer.value(pair.birth);
    sink.text(",");
    if (pair.death.exists()) writer.value(pair.death);
    sink.text(",");
    writer.rows(pair.birth, " ");
    sink.text(",");
    if (pair.death.exists()) writer.rows(pair.death, " ");
    sink.text("\n");
  });
  sink.flush();
}

template <int D>
void write_persistence_json(ByteSink& sink, const Filtration<D>& filtration,
                            const PersistencePairs<D>& pairs, PersistenceValues values) {
  Writer<D> writer(sink, filtration, values);
  std::string_view before = "[\n";
  for_each_pair<D>(pairs, [&](std::size_t dimension, const PersistencePair& pair) {
    sink.text(before);
    before = ",\n";
    sink.text("{\"dimension\":");
    sink.integer(static_cast<std::int64_t>(dimension));
    sink.text(",\"birth\":");
    writer.value(pair.birth);
    sink.text(",\"death\":");
    pair.death.exists() ? writer.value(pair.death) : sink.text("null");
    sink.text(",\"birth_simplex\":[");
    writer.rows(pair.birth, ",");
    sink.text("],\"death_simplex\":");
    if (pair.death.exists()) {
      sink.text("[");
      writer.rows(pair.death, ",");
      sink.text("]}");
    } else {
      sink.text("null}");
    }
  });
  sink.text(before == "[\n" ? "[]\n" : "\n]\n");
  sink.flush();
}

template <int D>
void write_persistence_gudhi(ByteSink& sink, const Filtration<D>& filtration,
                             const PersistencePairs<D>& pairs, PersistenceValues values) {
  Writer<D> writer(sink, filtration, values);
  for_each_pair<D>(pairs, [&](std::size_t dimension, const PersistencePair& pair) {
    sink.text("2 ");
    sink.integer(static_cast<std::int64_t>(dimension));
    sink.text(" ");
    writer.value_or_infinity(pair.birth);
    sink.text(" ");
    pair.death.exists() ? writer.value_or_infinity(pair.death) : sink.text("inf");
    sink.text("\n");
  });
  sink.flush();
}

template void write_persistence_csv<2>(ByteSink&, const Filtration<2>&, const PersistencePairs<2>&,
                                       PersistenceValues);
template void write_persistence_csv<3>(ByteSink&, const Filtration<3>&, const PersistencePairs<3>&,
                                       PersistenceValues);
template void write_persistence_json<2>(ByteSink&, const Filtration<2>&, const PersistencePairs<2>&,
                                        PersistenceValues);
template void write_persistence_json<3>(ByteSink&, const Filtration<3>&, const PersistencePairs<3>&,
                                        PersistenceValues);
template void write_persistence_gudhi<2>(ByteSink&, const Filtration<2>&,
                                         const PersistencePairs<2>&, PersistenceValues);
template void write_persistence_gudhi<3>(ByteSink&, const Filtration<3>&,
                                         const PersistencePairs<3>&, PersistenceValues);

}  // namespace orthoball
