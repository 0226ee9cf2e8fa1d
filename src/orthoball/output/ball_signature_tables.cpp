// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_signature_tables.h"

#include <cstdint>
#include <span>
#include <string_view>

#include "orthoball/output/alpha_text.h"
#include "orthoball/output/npz.h"
#include "orthoball/output/signature_columns.h"

namespace orthoball {
namespace {

// alpha2 or its signed root; the empty complex has neither.
void write_alpha(ByteSink& sink, std::uint32_t index, double number) {
  return is_of_empty_complex(index, number) ? sink.none() : sink.real(number);
}

}  // namespace

template <int D>
void write_ball_signatures_csv(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows) {
  sink.text(D == 3 ? "index,alpha2,alpha,betti_0,betti_1,betti_2,euler,volume,area\n"
                   : "index,alpha2,alpha,betti_0,betti_1,euler,volume,area\n");
  for (const BallSignatureRow<D>& row : rows) {
    const BallSignature<D>& s = row.signature;
    sink.integer(s.index);
    sink.text(",");
    write_alpha(sink, s.index, s.alpha2);
    sink.text(",");
    write_alpha(sink, s.index, row.alpha);
    for (const std::uint32_t betti : s.betti) {
      sink.text(",");
      sink.integer(betti);
    }
    sink.text(",");
    sink.integer(s.euler);
    for (const double measure : {s.volume, s.area}) {
      sink.text(",");
      sink.real(measure);
    }
    sink.text("\n");
  }
  sink.flush();
}

template <int D>
void write_ball_signatures_json(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows) {
  std::string_view before = "[\n";
  for (const BallSignatureRow<D>& row : rows) {
    const BallSignature<D>& s = row.signature;
    sink.text(before);
    before = ",\n";
    sink.text("{\"index\":");
    sink.integer(s.index);
    sink.text(",\"alpha2\":");
    write_alpha(sink, s.index, s.alpha2);
    sink.text(",\"alpha\":");
    write_alpha(sink, s.index, row.alpha);
    std::string_view comma = ",\"betti\":[";
    for (const std::uint32_t betti : s.betti) {
      sink.text(comma);
      sink.integer(betti);
      comma = ",";
    }
    sink.text("],\"euler\":");
    sink.integer(s.euler);
    sink.text(",\"volume\":");
    sink.real(s.volume);
    sink.text(",\"area\":");
    sink.real(s.area);
    sink.text("}");
  }
  sink.text(rows.empty() ? "[\n]\n" : "\n]\n");
  sink.flush();
}

template <int D>
void write_ball_signatures_npz(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows) {
  NpzWriter archive(sink);
  add_first_columns<D>(archive, rows);
  archive.add_column<double>("volume", rows, [](const auto& row) { return row.signature.volume; });
  archive.add_column<double>("area", rows, [](const auto& row) { return row.signature.area; });
  archive.finish();
}

template void write_ball_signatures_csv<2>(ByteSink&, const std::vector<BallSignatureRow<2>>&);
template void write_ball_signatures_csv<3>(ByteSink&, const std::vector<BallSignatureRow<3>>&);
template void write_ball_signatures_json<2>(ByteSink&, const std::vector<BallSignatureRow<2>>&);
template void write_ball_signatures_json<3>(ByteSink&, const std::vector<BallSignatureRow<3>>&);
template void write_ball_signatures_npz<2>(ByteSink&, const std::vector<BallSignatureRow<2>>&);
template void write_ball_signatures_npz<3>(ByteSink&, const std::vector<BallSignatureRow<3>>&);

}  // namespace orthoball
