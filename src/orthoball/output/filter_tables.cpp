// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "orthoball/output/filter_lines.h"
#include "orthoball/output/npz.h"
#include "orthoball/output/tables.h"

namespace orthoball {
namespace {

template <int D>
std::vector<SimplexId> first_by_rows(const Filter<D>& filter, std::size_t count) {
  std::vector<SimplexId> simplices = filter.by_rows();
  simplices.resize(count);
  return simplices;
}

template <int D>
std::span<const std::uint32_t> rows_of(const FilterLine<D>& line) {
  return std::span(line.rows).first(line.dimension + 1);
}

// The text of alpha2 at the index of each line: those that enter together share it.
template <int D>
class Alpha2Column {
 public:
  explicit Alpha2Column(const Filtration<D>& filtration) : filtration_(filtration) {}

  void write(ByteSink& sink, std::uint32_t index) {
    if (index == index_) return sink.text(text_);
    const double alpha2 = filtration_.alpha2(index);
    if (!std::isfinite(alpha2)) return sink.real(alpha2);
    index_ = index;
    text_ = shortest_text(alpha2);
    sink.text(text_);
  }

 private:
  const Filtration<D>& filtration_;
  std::uint32_t index_ = 0;  // none
  std::string text_;
};

}  // namespace

template <int D>
void write_filter_csv(ByteSink& sink, const Filter<D>& filter, std::size_t count) {
  const Filtration<D>& filtration = filter.filtration();
  sink.text("position,dimension,vertices,alpha2,enters,regular,interior\n");
  std::int64_t position = 0;
  Alpha2Column<D> alpha2(filtration);
  const auto write = [&](const FilterLine<D>& line) {
    sink.integer(++position);
    sink.text(",");
    sink.integer(line.dimension);
    std::string_view before = ",";
    for (const std::uint32_t row : rows_of(line)) {
      sink.text(before);
      sink.integer(row);
      before = " ";
    }
    sink.text(",");
    alpha2.write(sink, line.enters);
    for (const std::uint32_t index : {line.enters, line.regular, line.interior}) {
      sink.text(",");
      if (index != filtration.never()) sink.integer(index);
    }
    sink.text("\n");
  };
  for_filter_lines(filtration, first_by_rows(filter, count), [&](const auto& lines) {
    for (const FilterLine<D>& line : lines) write(line);
  });
  sink.flush();
}

template <int D>
void write_filter_json_lines(ByteSink& sink, const Filter<D>& filter, std::size_t count) {
  const Filtration<D>& filtration = filter.filtration();
  std::int64_t position = 0;
  Alpha2Column<D> alpha2(filtration);
  const auto write_index = [&](std::string_view key, std::uint32_t index) {
    sink.text(key);
    if (index == filtration.never()) return sink.text("null");
    sink.integer(index);
  };
  const auto write = [&](const FilterLine<D>& line) {
    sink.text("{\"position\":");
    sink.integer(++position);
    sink.text(",\"dimension\":");
    sink.integer(line.dimension);
    std::string_view before = ",\"vertices\":[";
    for (const std::uint32_t row : rows_of(line)) {
      sink.text(before);
      sink.integer(row);
      before = ",";
    }
    sink.text("],\"alpha2\":");
    alpha2.write(sink, line.enters);
    write_index(",\"enters\":", line.enters);
    write_index(",\"regular\":", line.regular);
    write_index(",\"interior\":", line.interior);
    sink.text("}\n");
  };
  for_filter_lines(filtration, first_by_rows(filter, count), [&](const auto& lines) {
    for (const FilterLine<D>& line : lines) write(line);
  });
  sink.flush();
}

template <int D>
void write_filter_npz(ByteSink& sink, const Filter<D>& filter, std::size_t count) {
  const Filtration<D>& filtration = filter.filtration();
  const std::vector<SimplexId> simplices = first_by_rows(filter, count);
  NpzWriter archive(sink);
  // Only those arrays at once that are found together: all would be as large as the filtration.
  {
    std::vector<std::uint8_t> dimensions;
    dimensions.reserve(count);
    for (const SimplexId simplex : simplices) {
      dimensions.push_back(static_cast<std::uint8_t>(filtration.dimension(simplex)));
    }
    archive.add<std::uint8_t>("dimension", std::array{count}, dimensions);
  }
  std::vector<std::uint32_t> enters, regular, interior;
  {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(count * (D + 1));
    for (auto* const indices : {&enters, &regular, &interior}) indices->reserve(count);
    const auto index_or_0 = [&](std::uint32_t index) {
      return index == filtration.never() ? 0U : index;
    };
    for_filter_lines(filtration, simplices, [&](const auto& lines) {
      for (const FilterLine<D>& line : lines) {
        for (std::uint32_t i = 0; i <= D; ++i) {
          vertices.push_back(i <= line.dimension ? line.rows[i]
                                                 : std::numeric_limits<std::uint32_t>::max());
        }
        enters.push_back(line.enters);
        regular.push_back(index_or_0(line.regular));
        interior.push_back(index_or_0(line.interior));
      }
    });
    archive.add<std::uint32_t>("vertices", std::array{count, std::size_t{D + 1}}, vertices);
  }
  {
    std::vector<double> alpha2;
    alpha2.reserve(count);
    for (const std::uint32_t index : enters) alpha2.push_back(filtration.alpha2(index));
    archive.add<double>("alpha2", std::array{count}, alpha2);
  }
  archive.add<std::uint32_t>("enters", std::array{count}, enters);
  archive.add<std::uint32_t>("regular", std::array{count}, regular);
  archive.add<std::uint32_t>("interior", std::array{count}, interior);
  archive.add<double>("spectrum", std::array{filtration.spectrum().size()}, filtration.spectrum());
  archive.finish();
}

template void write_filter_csv<2>(ByteSink&, const Filter<2>&, std::size_t);
template void write_filter_csv<3>(ByteSink&, const Filter<3>&, std::size_t);
template void write_filter_json_lines<2>(ByteSink&, const Filter<2>&, std::size_t);
template void write_filter_json_lines<3>(ByteSink&, const Filter<3>&, std::size_t);
template void write_filter_npz<2>(ByteSink&, const Filter<2>&, std::size_t);
template void write_filter_npz<3>(ByteSink&, const Filter<3>&, std::size_t);

}  // namespace orthoball
