// SPDX-License-Identifier: MIT
#pragma once

// Everything that a program which uses the library needs, in flow order.
#include "orthoball/version.h"
// no layer
#include "orthoball/error.h"
#include "orthoball/ids.h"
#include "orthoball/large_blocks.h"
#include "orthoball/memory_budget.h"
#include "orthoball/parallel.h"
// points, input
#include "orthoball/input/probe_radius.h"
#include "orthoball/input/read.h"
#include "orthoball/points/density_weights.h"
#include "orthoball/points/position_tree.h"
#include "orthoball/points/probe.h"
#include "orthoball/points/weighted_points.h"
// triangulation
#include "orthoball/triangulation/build.h"
#include "orthoball/triangulation/regular_triangulation.h"
#include "orthoball/triangulation/triangle_edge.h"
#include "orthoball/triangulation/verify.h"
// filtration
#include "orthoball/filtration/alpha.h"
#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/simplex_table.h"
// topology, measures
#include "orthoball/measures/ball_overlaps.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/topology/betti.h"
#include "orthoball/topology/persistence.h"
// signatures
#include "orthoball/signatures/ball_signature.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"
// queries
#include "orthoball/queries/containment.h"
#include "orthoball/queries/nearest.h"
#include "orthoball/queries/planar_union.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/power_cells.h"
#include "orthoball/queries/regions.h"
#include "orthoball/queries/voids.h"
// output
#include "orthoball/output/ball_tables.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/encoded_output.h"
#include "orthoball/output/mesh.h"
#include "orthoball/output/molecule.h"
#include "orthoball/output/persistence_plot.h"
#include "orthoball/output/persistence_table.h"
#include "orthoball/output/planar_shape.h"
#include "orthoball/output/power_cell_files.h"
#include "orthoball/output/region_mesh.h"
#include "orthoball/output/region_tables.h"
#include "orthoball/output/row_names.h"
#include "orthoball/output/shape_mesh.h"
#include "orthoball/output/signature_plot.h"
#include "orthoball/output/snapshot.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/output/tables.h"
#include "orthoball/output/union_figure.h"
// all of them, the dimension chosen at run time
#include "orthoball/alpha_shapes.h"
