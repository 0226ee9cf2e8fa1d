// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <string_view>

#include "orthoball/output/npz.h"
#include "orthoball/output/tables.h"

namespace orthoball {
namespace {

template <int D>
std::vector<SimplexId> first_in_filter(const Filtration<D>& filtration, std::size_t count) {
  std::vector<SimplexId> simplices = filtration.filter_by_rows();
  simplices.resize(count);
  return simplices;
}

template <int D>
void write_rows(ByteSink& sink, const Filtration<D>& filtration, SimplexId simplex,
                std::string_view between) {
  bool is_first = true;
  for (const SiteId row : filtration.rows(simplex)) {
    if (!is_first) sink.text(between);
    is_first = false;
    sink.integer(row.row());
  }
}

}  // namespace

template <int D>
void write_filter_csv(ByteSink& sink, const Filtration<D>& filtration, std::size_t count) {
  sink.text("position,dimension,vertices,alpha2,enters,regular,interior\n");
  std::int64_t position = 0;
  for (const SimplexId simplex : first_in_filter(filtration, count)) {
    sink.integer(++position);
    sink.text(",");
    sink.integer(filtration.dimension(simplex));
    sink.text(",");
    write_rows(sink, filtration, simplex, " ");
    sink.text(",");
    sink.real(filtration.alpha2(filtration.enters(simplex)));
    for (const std::uint32_t index :
         {filtration.enters(simplex), filtration.regular(simplex), filtration.interior(simplex)}) {
      sink.text(",");
      if (index != filtration.never()) sink.integer(index);
    }
    sink.text("\n");
  }
  sink.flush();
}

template <int D>
void write_filter_json_lines(ByteSink& sink, const Filtration<D>& filtration, std::size_t count) {
  std::int64_t position = 0;
  for (const SimplexId simplex : first_in_filter(filtration, count)) {
    sink.text("{\"position\":");
    sink.integer(++position);
    sink.text(",\"dimension\":");
    sink.integer(filtration.dimension(simplex));
    sink.text(",\"vertices\":[");
    write_rows(sink, filtration, simplex, ",");
    sink.text("],\"alpha2\":");
    sink.real(filtration.alpha2(filtration.enters(simplex)));
    const auto write_index = [&](std::string_view key, std::uint32_t index) {
      sink.text(key);
      if (index == filtration.never()) return sink.text("null");
      sink.integer(index);
    };
    write_index(",\"enters\":", filtration.enters(simplex));
    write_index(",\"regular\":", filtration.regular(simplex));
    write_index(",\"interior\":", filtration.interior(simplex));
    sink.text("}\n");
  }
  sink.flush();
}

template <int D>
void write_filter_npz(ByteSink& sink, const Filtration<D>& filtration, std::size_t count) {
  const std::vector<SimplexId> simplices = first_in_filter(filtration, count);
  NpzWriter archive(sink);
  // One array at a time: together they would be as large as the filtration.
  const auto add = [&](std::string_view name, auto type, const auto& value_of) {
    std::vector<decltype(type)> values;
    values.reserve(count);
    for (const SimplexId simplex : simplices) values.push_back(value_of(simplex));
    archive.add<decltype(type)>(name, std::array{count}, values);
  };
  const auto index_or_0 = [&](std::uint32_t index) {
    return index == filtration.never() ? 0U : index;
  };
  add("dimension", std::uint8_t{},
      [&](SimplexId s) { return static_cast<std::uint8_t>(filtration.dimension(s)); });
  {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(count * (D + 1));
    for (const SimplexId simplex : simplices) {
      for (const SiteId row : filtration.rows(simplex)) vertices.push_back(row.row());
      vertices.resize((vertices.size() + D) / (D + 1) * (D + 1),
                      std::numeric_limits<std::uint32_t>::max());
    }
    archive.add<std::uint32_t>("vertices", std::array{count, std::size_t{D + 1}}, vertices);
  }
  add("alpha2", double{}, [&](SimplexId s) { return filtration.alpha2(filtration.enters(s)); });
  add("enters", std::uint32_t{}, [&](SimplexId s) { return filtration.enters(s); });
  add("regular", std::uint32_t{}, [&](SimplexId s) { return index_or_0(filtration.regular(s)); });
  add("interior", std::uint32_t{}, [&](SimplexId s) { return index_or_0(filtration.interior(s)); });
  archive.add<double>("spectrum", std::array{filtration.spectrum().size()}, filtration.spectrum());
  archive.finish();
}

template void write_filter_csv<2>(ByteSink&, const Filtration<2>&, std::size_t);
template void write_filter_csv<3>(ByteSink&, const Filtration<3>&, std::size_t);
template void write_filter_json_lines<2>(ByteSink&, const Filtration<2>&, std::size_t);
template void write_filter_json_lines<3>(ByteSink&, const Filtration<3>&, std::size_t);
template void write_filter_npz<2>(ByteSink&, const Filtration<2>&, std::size_t);
template void write_filter_npz<3>(ByteSink&, const Filtration<3>&, std::size_t);

}  // namespace orthoball
