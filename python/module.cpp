// SPDX-License-Identifier: MIT
#include "python/module.h"

#include "orthoball/version.h"

NB_MODULE(_core, module) {
  module.doc() = "The compiled part of orthoball: its names are those of the package, see there.";
  module.attr("__version__") = orthoball::kVersion;
  bind_errors(module);
  bind_reading(module);
  bind_alpha_shapes(module);
  bind_weights(module);
  bind_simplices(module);
  bind_topology(module);
  bind_signatures(module);
  bind_alpha_candidates(module);
  bind_shape(module);
  bind_manifold(module);
  bind_balls(module);
  bind_ball_files(module);
  bind_free_space(module);
  bind_queries(module);
  bind_power_cells(module);
  bind_view(module);
}
