// SPDX-License-Identifier: MIT
// The atoms of a benchmark as files for programs: `pipeline_balls COUNT FILE.xyzr FILE.pdb` writes
// the family `atoms` in space as lines `x y z radius` and, for programs that read no such lines, as
// a PDB file with radii in the place of occupancies.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "benchmarks/inputs.h"

int main(int argc, char** argv) {
  if (argc != 4) throw std::invalid_argument("usage: COUNT FILE.xyzr FILE.pdb");
  const auto points = orthoball::benchmarks::input("atoms", 3, std::strtoull(argv[1], nullptr, 10));
  double unit = 1.0;
  for (int i = 0; i < points.decimals().value(); ++i) unit *= 10.0;
  std::string lines, pdb;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double x = points.coordinate(row, 0), y = points.coordinate(row, 1);
    const double z = points.coordinate(row, 2), radius = points.weights()[row] / unit;
    lines += fmt::format("{:.3f} {:.3f} {:.3f} {:.2f}\n", x, y, z, radius);
    pdb += fmt::format(
        "ATOM  {:5} {:>2}   ALA A{:4}    {:8.3f}{:8.3f}{:8.3f}{:6.2f}{:6.2f}           C\n",
        row % 100'000, "C", row / 10 % 10'000, x, y, z, radius, 0.0);
  }
  std::ofstream(argv[2]) << lines;
  std::ofstream(argv[3]) << pdb;
}
