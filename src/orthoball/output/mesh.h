// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "orthoball/output/byte_sink.h"
#include "orthoball/output/shape_mesh.h"

namespace orthoball {

/// File formats of a boundary. docs/guide/formats.md says what each holds.
enum class MeshFormat {
  ply,  ///< binary, lowest byte first: triangles, edges, the input row of every vertex
  obj,  ///< text: triangles `f`, edges `l`, vertices `p`
  off,  ///< text: triangles only
  stl,  ///< binary: triangles only, coordinates rounded to 24 bits
  vtu,  ///< XML for VTK and ParaView: triangles, lines and vertices, rows, roles
  glb,  ///< binary glTF 2.0: triangles, lines and points, coordinates rounded to 24 bits
};

/// What is written, and how.
struct MeshOptions {
  MeshFormat format = MeshFormat::ply;
  bool roles = false;   ///< mark every simplex with its role: a number, group or colour
  double alpha2 = 0.0;  ///< the number written beside the index; length^2
};

/// The format of a file name's ending or of `--format`: "ply", ... Empty for others.
[[nodiscard]] std::optional<MeshFormat> mesh_format(std::string_view ending);

/// Whether a format has a place for edges and single vertices.
[[nodiscard]] bool holds_edges(MeshFormat format);

/// Whether a format has a place for the roles of simplices.
[[nodiscard]] bool holds_roles(MeshFormat format);

/// Writes a boundary. What the format cannot hold is left out, see `holds_edges`.
/// @throws OutputError; LimitError for a GLB of 4 GiB or more, an STL of 2^32 triangles or more.
void write_mesh(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options);

}  // namespace orthoball
