// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "orthoball/output/alpha_text.h"
#include "orthoball/output/npz.h"
#include "orthoball/output/signature_columns.h"
#include "orthoball/output/tables.h"

namespace orthoball {
namespace {

// The measures in the order of the columns; `length` is the last and none in the plane.
constexpr std::array<std::string_view, 5> kMeasures{"volume", "area_singular", "area_regular",
                                                    "area", "length"};

template <int D>
std::array<double, 5> measures(const Signature<D>& s) {
  return {s.volume, s.area_singular, s.area_regular, s.area, s.length};
}

template <int D>
constexpr std::size_t kMeasureCount = D == 3 ? 5 : 4;

constexpr std::array<std::string_view, 4> kRoles{"exterior", "singular", "regular", "interior"};

template <int D>
std::array<std::span<const std::uint32_t>, 4> counts(const Signature<D>& s) {
  return {s.exterior, s.singular, s.regular, s.interior};
}

// alpha2 or its signed root; the empty complex has neither.
void write_alpha(ByteSink& sink, std::uint32_t index, double number) {
  return is_of_empty_complex(index, number) ? sink.none() : sink.real(number);
}

void write_json_array(ByteSink& sink, std::span<const std::uint32_t> numbers) {
  std::string_view before = "[";
  for (const std::uint32_t n : numbers) {
    sink.text(before);
    sink.integer(n);
    before = ",";
  }
  sink.text("]");
}

}  // namespace

template <int D>
void write_signature_head_csv(ByteSink& sink) {
  sink.text("index,alpha2,alpha");
  const auto head = [&](std::string_view name, int count) {
    for (int k = 0; k < count; ++k) {
      sink.text(",");
      sink.text(name);
      sink.text("_");
      sink.integer(k);
    }
  };
  head("betti", D);
  sink.text(",euler");
  for (const std::string_view role : kRoles) head(role, D + 1);
  for (std::size_t i = 0; i < kMeasures.size(); ++i) {
    sink.text(",");
    sink.text(kMeasures[i]);
  }
  sink.text("\n");
}

template <int D>
void write_signature_csv(ByteSink& sink, const SignatureRow<D>& row) {
  const Signature<D>& s = row.signature;
  sink.integer(s.index);
  sink.text(",");
  write_alpha(sink, s.index, s.alpha2);
  sink.text(",");
  write_alpha(sink, s.index, row.alpha);
  const auto integers = [&](std::span<const std::uint32_t> numbers) {
    for (const std::uint32_t n : numbers) {
      sink.text(",");
      sink.integer(n);
    }
  };
  integers(s.betti);
  sink.text(",");
  sink.integer(s.euler);
  for (const auto& by_dimension : counts(s)) integers(by_dimension);
  for (std::size_t i = 0; i < kMeasures.size(); ++i) {
    sink.text(",");
    if (i < kMeasureCount<D>) sink.real(measures(s)[i]);
  }
  sink.text("\n");
}

template <int D>
void write_signature_json(ByteSink& sink, const SignatureRow<D>& row) {
  const Signature<D>& s = row.signature;
  sink.text("{\"index\":");
  sink.integer(s.index);
  sink.text(",\"alpha2\":");
  write_alpha(sink, s.index, s.alpha2);
  sink.text(",\"alpha\":");
  write_alpha(sink, s.index, row.alpha);
  sink.text(",\"betti\":");
  write_json_array(sink, s.betti);
  sink.text(",\"euler\":");
  sink.integer(s.euler);
  for (std::size_t role = 0; role < kRoles.size(); ++role) {
    sink.text(",\"");
    sink.text(kRoles[role]);
    sink.text("\":");
    write_json_array(sink, counts(s)[role]);
  }
  for (std::size_t i = 0; i < kMeasures.size(); ++i) {
    sink.text(",\"");
    sink.text(kMeasures[i]);
    sink.text("\":");
    if (i < kMeasureCount<D>) {
      sink.real(measures(s)[i]);
    } else {
      sink.text("null");
    }
  }
  sink.text("}");
}

template <int D>
void write_signatures_npz(ByteSink& sink, const std::vector<SignatureRow<D>>& rows) {
  NpzWriter archive(sink);
  add_first_columns<D>(archive, rows);
  for (std::size_t role = 0; role < kRoles.size(); ++role) {
    archive.add_columns(kRoles[role], D + 1, rows,
                        [&](const auto& row) { return counts(row.signature)[role]; });
  }
  for (std::size_t i = 0; i < kMeasureCount<D>; ++i) {
    archive.add_column<double>(kMeasures[i], rows,
                               [&](const auto& row) { return measures(row.signature)[i]; });
  }
  archive.finish();
}

template void write_signature_head_csv<2>(ByteSink&);
template void write_signature_head_csv<3>(ByteSink&);
template void write_signature_csv<2>(ByteSink&, const SignatureRow<2>&);
template void write_signature_csv<3>(ByteSink&, const SignatureRow<3>&);
template void write_signature_json<2>(ByteSink&, const SignatureRow<2>&);
template void write_signature_json<3>(ByteSink&, const SignatureRow<3>&);
template void write_signatures_npz<2>(ByteSink&, const std::vector<SignatureRow<2>>&);
template void write_signatures_npz<3>(ByteSink&, const std::vector<SignatureRow<3>>&);

}  // namespace orthoball
