// SPDX-License-Identifier: MIT
// GUDHI's side of a comparison, see case.h: its alpha complex in space in the default form, whose
// combinatorics are exact and whose values are doubles, sorted as its filtration; and the
// persistent cohomology of that over Z/2.
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "benchmarks/case.h"

namespace {

using Gudhi::alpha_complex::complexity;
using orthoball::benchmarks::Case;
using orthoball::benchmarks::Meter;

template <bool IsWeighted>
void filter(const Case& task) {
  using Complex = Gudhi::alpha_complex::Alpha_complex_3d<complexity::SAFE, IsWeighted>;
  std::vector<typename Complex::Bare_point_3> centres;
  std::vector<double> weights;
  for (std::size_t row = 0; row < task.points.size(); ++row) {
    const double* x = task.points.coordinates().data() + 3 * row;
    centres.emplace_back(x[0], x[1], x[2]);
    weights.push_back(orthoball::benchmarks::weight(task.points, row));
  }
  using Tree = Gudhi::Simplex_tree<Gudhi::Simplex_tree_options_fast_persistence>;
  Tree tree;
  Meter meter;
  if constexpr (IsWeighted) {
    Complex(centres, weights).create_complex(tree);
  } else {
    Complex(centres).create_complex(tree);
  }
  tree.initialize_filtration();
  meter.stage("filtration");
  if (task.work == "persistence") {
    using Gudhi::persistent_cohomology::Field_Zp;
    Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Field_Zp> cohomology(tree);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology();
    meter.stage("pairs");
  }
  meter.report(task, {{"vertices", tree.num_vertices()}, {"simplices", tree.num_simplices()}});
}

}  // namespace

int main(int argc, char** argv) {
  const Case task = orthoball::benchmarks::case_of(argc, argv);
  const bool is_known = task.work == "filtration" || task.work == "persistence";
  if (!is_known || task.points.dimension() != 3) {
    throw std::invalid_argument("GUDHI is asked for filtrations and persistence in space only");
  }
  task.points.weight_kind() == orthoball::WeightKind::none ? filter<false>(task)
                                                           : filter<true>(task);
}
