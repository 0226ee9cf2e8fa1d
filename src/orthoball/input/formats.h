// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/input/read.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// One function a format, all alike: they take the bytes of a whole input and give its sites, or
/// throw ParseError that names the line. `read` fills in `file` and `format` and judges emptiness.
/// Each is defined in the file of its name.
[[nodiscard]] Reading read_table(const Source& source, const ReadOptions& options);
/// Does a line before the first point say `#fix: W.A`, as in the point files of the 1995 programs?
[[nodiscard]] bool is_alpha_1995(std::string_view text);
[[nodiscard]] Reading read_alpha_1995(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_off(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_obj(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_ply(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_npy(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_las(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_geojson(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_pdb(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_cif(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_pqr(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_xyz(const Source& source, const ReadOptions& options);
[[nodiscard]] Reading read_xyzr(const Source& source, const ReadOptions& options);

}  // namespace orthoball
