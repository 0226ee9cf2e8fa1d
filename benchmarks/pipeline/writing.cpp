// SPDX-License-Identifier: MIT
// Megabytes a second of the writers, without a device behind them: `pipeline_writing FAMILY COUNT`
// builds the alpha shapes of COUNT points in space and writes them in every format, one line of
// JSON for each. The order by rows, which filter tables are written in, is timed by itself.
#include <fmt/format.h>

#include <iostream>
#include <ostream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/case.h"
#include "orthoball/filtration/alpha.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/output/mesh.h"
#include "orthoball/output/shape_mesh.h"
#include "orthoball/output/tables.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

// Counts what comes, and forgets it.
class Counter : public std::streambuf {
 public:
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    bytes_ += static_cast<std::size_t>(count);
    return count;
  }
  int overflow(int c) override {
    ++bytes_;
    return c;
  }

 private:
  std::size_t bytes_ = 0;
};

template <class Write>
void measure(const std::string& format, const Write& write) {
  double best = 1e300, megabytes = 0.0;
  for (int run = 0; run < 3; ++run) {
    Counter counter;
    std::ostream out(&counter);
    ByteSink sink(out, "null");
    const benchmarks::Stopwatch watch;
    write(sink);
    best = std::min(best, watch.seconds());
    megabytes = static_cast<double>(counter.bytes()) / 1e6;
  }
  std::cout << fmt::format(
                   "{{\"format\": \"{}\", \"megabytes\": {:.1f}, \"seconds\": {:.3f}, "
                   "\"megabytes_a_second\": {:.0f}}}",
                   format, megabytes, best, megabytes / best)
            << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) throw std::invalid_argument("usage: FAMILY COUNT");
  char work[] = "writing", dimension[] = "3";
  char* arguments[] = {argv[0], work, argv[1], dimension, argv[2]};
  const benchmarks::Case task = benchmarks::case_of(5, arguments);
  const Filtration<3> filtration(regular_triangulation<3>(task.points));
  const Filter<3> filter(filtration);
  const std::size_t all = filtration.size();

  measure("order by rows", [&](ByteSink&) {
    if (filter.by_rows().size() != all) throw std::logic_error("simplices were lost");
  });
  measure("filter csv", [&](ByteSink& sink) { write_filter_csv(sink, filter, all); });
  measure("filter json", [&](ByteSink& sink) { write_filter_json_lines(sink, filter, all); });
  measure("filter npz", [&](ByteSink& sink) { write_filter_npz(sink, filter, all); });

  std::vector<SignatureRow<3>> rows;
  scan_signatures<3>(filtration, [&](const Signature<3>& s) {
    if (rows.size() < 200'000) rows.push_back({s, alpha_from_alpha2(s.alpha2)});
  });
  measure("signatures csv", [&](ByteSink& sink) {
    write_signature_head_csv<3>(sink);
    for (const SignatureRow<3>& row : rows) write_signature_csv(sink, row);
    sink.flush();
  });
  measure("signatures json", [&](ByteSink& sink) {
    for (const SignatureRow<3>& row : rows) write_signature_json(sink, row);
    sink.flush();
  });
  measure("signatures npz", [&](ByteSink& sink) { write_signatures_npz(sink, rows); });

  // The fullest boundary of those tried.
  ShapeMesh mesh;
  for (std::uint32_t part = 1; part < 16; ++part) {
    const auto index =
        static_cast<std::uint32_t>(std::uint64_t{filtration.spectrum_size()} * part / 16);
    ShapeMesh other = shape_mesh(AlphaComplex(filtration, index), task.points);
    if (other.triangles.size() > mesh.triangles.size()) mesh = std::move(other);
  }
  for (const char* const name : {"ply", "obj", "off", "stl", "vtu", "glb"}) {
    measure(name, [&](ByteSink& sink) { write_mesh(sink, mesh, {*mesh_format(name), true, 1.0}); });
  }
}
