// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/output/mesh.h"

namespace orthoball {

// The mesh formats that have a file of their own; called by `write_mesh`, which flushes the sink.

/// VTK's unstructured grid, arrays as base64.
void write_vtu(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options);

/// Binary glTF 2.0: one node whose translation is the middle of the box (a double), positions
/// relative to it as 32-bit floats.
/// @throws LimitError where the file would reach 4 GiB.
void write_glb(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options);

}  // namespace orthoball
