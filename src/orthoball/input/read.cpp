// SPDX-License-Identifier: MIT
#include "orthoball/input/read.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/source.h"

namespace orthoball {
namespace {

using Reader = Reading (*)(const Source&, const ReadOptions&);

struct Format {
  std::string_view name;
  std::string_view endings;  // of file names, each with a blank before and after it
  Reader reader;
  bool is_text;
  bool is_molecule;  // has atoms to choose from, and no columns
};

constexpr std::array kFormats = {
    Format{"table", " csv tsv tab txt dat asc pts pwn xyzn xyzrgb ", read_table, true, false},
    Format{"alpha_1995", " alf ", read_alpha_1995, true, false},
    Format{"off", " off coff noff ", read_off, true, false},
    Format{"obj", " obj ", read_obj, true, false},
    Format{"ply", " ply ", read_ply, false, false},
    Format{"npy", " npy ", read_npy, false, false},
    Format{"las", " las ", read_las, false, false},
    Format{"geojson", " geojson json ", read_geojson, true, false},
    Format{"pdb", " pdb ent ", read_pdb, true, true},
    Format{"cif", " cif mmcif mcif ", read_cif, true, true},
    Format{"pqr", " pqr ", read_pqr, true, true},
    Format{"xyz", " xyz extxyz ", read_xyz, true, true},
    Format{"xyzr", " xyzr crd ", read_xyzr, true, false},
};

struct Refusal {
  std::string_view endings;
  std::string_view what;
};

constexpr std::array kRefused = {
    Refusal{" laz ", "LAZ (compressed LAS) is not read; convert it to LAS with laszip or laspy"},
    Refusal{" sdf sd mol mol2 ",
            "SDF, MOL and MOL2 are not read; convert them to PDB or XYZ with Open Babel (obabel)"},
    Refusal{" lammps lmp data lammpstrj dump ",
            "LAMMPS files are not read; write the atoms as extended XYZ with ASE or OVITO"},
    Refusal{" bz2 ", "bzip2 is not read; run bunzip2 first"},
    Refusal{" zst ", "zstd is not read; run unzstd first"},
    Refusal{" xz ", "xz is not read; run unxz first"},
    Refusal{" zip 7z tar tgz ", "archives are not read; unpack them first"},
    Refusal{" npz ", "NPZ archives are not read; save one array with numpy.save"},
    Refusal{
        " gro g96 xtc dcd trr ",
        "GROMACS and trajectory files are not read; convert them to PDB with gmx or MDAnalysis"},
    Refusal{" bcif mmtf ", "binary molecules are not read; get the mmCIF file"},
    Refusal{" pcd e57 ", "PCD and E57 are not read; convert them to PLY with CloudCompare or PDAL"},
    Refusal{" stl vtk vtu vtp glb gltf ",
            "meshes of this kind are not read; convert them to PLY, OBJ or OFF with meshio"},
    Refusal{" shp gpkg kml ", "convert it to GeoJSON with ogr2ogr"},
    Refusal{" xlsx xls ods ", "spreadsheets are not read; save the sheet as CSV"},
};

bool has_ending(std::string_view endings, const std::string& ending) {
  return !ending.empty() && endings.find(" " + ending + " ") != std::string_view::npos;
}

[[noreturn]] void refuse_options(const std::string& message) {
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow, message);
}

std::string format_names() {
  std::string names;
  for (const Format& format : kFormats) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

// The lower-case ending of a file name, .gz put aside; empty if there is none.
std::string ending_of(std::string path) {
  std::transform(path.begin(), path.end(), path.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (path.size() > 3 && path.substr(path.size() - 3) == ".gz") path.resize(path.size() - 3);
  const std::size_t point = path.rfind('.');
  const std::size_t slash = path.rfind('/');
  if (point == std::string::npos || (slash != std::string::npos && slash > point)) return {};
  return path.substr(point + 1);
}

const Format& format_named(const std::string& name) {
  for (const Format& format : kFormats) {
    if (format.name == name) return format;
  }
  refuse_options(quoted(name) + " is no input format; the formats are " + format_names());
}

// Null where the name tells none.
const Format* format_of_name(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const Format& format : kFormats) {
    if (has_ending(format.endings, ending)) return &format;
  }
  for (const Refusal& refusal : kRefused) {
    if (!has_ending(refusal.endings, ending)) continue;
    throw ParseError(path, 0,
                     std::string(refusal.what) +
                         " (or name the format with --input-format if the "
                         "file name misleads)");
  }
  return nullptr;
}

[[noreturn]] void refuse_name(const std::string& path) {
  const std::string ending = ending_of(path);
  throw ParseError(path, 0,
                   (ending.empty() ? "a file name without an ending"
                                   : "an unknown file name ending, " + quoted(ending)) +
                       "; name the format with --input-format: " + format_names());
}

// The format that the bytes show, where the name of the file stands for several or for none.
const Format& format_of_content(const Format* by_name, const Source& source) {
  const std::string_view text = source.bytes;
  if (by_name == nullptr) {
    if (!is_alpha_1995(text)) refuse_name(source.name);
    return format_named("alpha_1995");
  }
  const Format& format = *by_name;
  if (format.name == "xyz") {
    Lines lines(text);
    std::string_view first;
    if (lines.next(first)) first = trimmed(first);
    if (!first.empty() && (first[0] == '-' || first[0] == '+')) first.remove_prefix(1);
    const bool is_count =
        !first.empty() && first.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_count) return is_alpha_1995(text) ? format_named("alpha_1995") : format_named("table");
  }
  if (format.name == "table" && is_alpha_1995(text)) return format_named("alpha_1995");
  return format;
}

void check_options(const ReadOptions& options) {
  if (options.dimension && *options.dimension != 2 && *options.dimension != 3) {
    refuse_options("dimension is " + std::to_string(*options.dimension) + "; it must be 2 or 3");
  }
  if (!options.radius_column.empty() && !options.weight_column.empty()) {
    refuse_options("a radius column and a weight column; only one of them can be used");
  }
  if (options.columns.empty()) return;
  const std::size_t columns = options.columns.size();
  if (columns != 2 && columns != 3) {
    refuse_options(counted(columns, "coordinate column") + "; there must be 2 or 3");
  }
  if (options.dimension && columns != static_cast<std::size_t>(*options.dimension)) {
    refuse_options(counted(columns, "coordinate column") + " for dimension " +
                   std::to_string(*options.dimension) + "; they must be as many");
  }
}

}  // namespace

Reading read(const std::string& path, const ReadOptions& options) {
  check_options(options);
  if (path == "-" && options.format.empty()) {
    refuse_options("standard input has no name to tell its format; name it with --input-format: " +
                   format_names());
  }
  const Format* format =
      options.format.empty() ? format_of_name(path) : &format_named(options.format);
  const Source source = read_source(path, options.limited, options.memory);
  if (options.format.empty()) format = &format_of_content(format, source);
  if (format->is_text) require_text(source);
  const bool has_columns =
      !options.columns.empty() || !options.radius_column.empty() || !options.weight_column.empty();
  if (format->is_molecule && has_columns) {
    refuse_options("columns cannot be chosen in the format " + std::string(format->name) +
                   "; they are for tables");
  }
  const bool has_atoms = !options.radii.empty() || options.default_radius.has_value() ||
                         !(options.molecule == MoleculeOptions{});
  if (!format->is_molecule && has_atoms) {
    refuse_options("atoms and their radii cannot be chosen in the format " +
                   std::string(format->name) + "; they are for molecules");
  }
  // About as much again for the numbers; atoms keep their names, too.
  const std::uint64_t each = format->is_molecule ? 8 : 1;
  options.memory.require(each * source.bytes.size(), path + ": the points in it");
  ReadOptions wanted = options;
  if (options.only_points && format->is_molecule) wanted.radii = "none";
  Reading reading = format->reader(source, wanted);
  reading.file = path;
  reading.format = format->name;
  if (reading.points.size() == 0 && !options.allow_empty) {
    throw ParseError(path, 0,
                     "no point or atom found as " + reading.format +
                         "; it may be the wrong file or format (--allow-empty accepts it)");
  }
  return reading;
}

const std::vector<std::string>& input_formats() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(kFormats.size());
    for (const Format& format : kFormats) all.emplace_back(format.name);
    return all;
  }();
  return names;
}

}  // namespace orthoball
