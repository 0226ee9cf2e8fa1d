// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/edit_options.h"
#include "cli/input_options.h"
#include "cli/json_text.h"
#include "cli/manifold_report.h"
#include "cli/named_outputs.h"
#include "cli/output_file.h"
#include "cli/query_memory.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/output/mesh.h"
#include "orthoball/output/planar_shape.h"
#include "orthoball/output/shape_mesh.h"
#include "orthoball/output/solid_table.h"
#include "orthoball/queries/manifold_solid.h"

namespace {

struct ShapeOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string output = "-";
  std::string format;  // empty: from the name of the output
  EditOptions edits;
  bool manifold = false;
  std::string changes;
  bool roles = false;
  bool json = false;
};

bool is_planar(const std::string& format) { return format == "geojson" || format == "svg"; }

std::string format_of(const ShapeOptions& options) {
  const std::string ending = ending_of(options.output);
  const std::string format = !options.format.empty() ? options.format
                             : ending == "json"      ? "geojson"
                                                     : ending;
  if (is_planar(format) || orthoball::mesh_format(format)) return format;
  if (options.output == "-") {
    throw UsageError(
        "shape: standard output needs --format ply, obj, off, stl, vtu, glb, geojson "
        "or svg");
  }
  throw UsageError(
      fmt::format("-o {}: the name does not tell the format; it must end in .ply, "
                  ".obj, .off, .stl, .vtu, .glb, .geojson or .svg, or --format must "
                  "be given",
                  options.output));
}

void check_dimension(const std::string& format, int dimension) {
  if (dimension == 3 && is_planar(format)) {
    throw UsageError(
        fmt::format("{} is for points in the plane; points in space go into ply, obj, "
                    "off, stl, vtu or glb",
                    format));
  }
  if (dimension == 2 && (format == "off" || format == "stl")) {
    throw UsageError(
        fmt::format("{} holds triangles only; the boundary of a plane shape goes into "
                    "geojson, svg, ply, obj, vtu or glb",
                    format));
  }
}

// What the boundary is made of.
struct Contents {
  std::size_t regular;  // triangles in space, edges in the plane
  std::size_t singular_triangles, singular_edges, singular_vertices;
};

Contents contents_of(const orthoball::ShapeMesh& mesh) {
  const auto regular = [](const std::vector<orthoball::Role>& roles) {
    return static_cast<std::size_t>(
        std::count(roles.begin(), roles.end(), orthoball::Role::regular));
  };
  const std::size_t triangles = regular(mesh.triangle_roles), edges = regular(mesh.edge_roles);
  return {mesh.dimension == 3 ? triangles : edges, mesh.triangles.size() - triangles,
          mesh.edges.size() - edges, mesh.isolated.size()};
}

// What was made to be a closed surface.
template <int D>
struct Solid {
  orthoball::ManifoldSolid<D> manifold;
  DroppedSimplices<D> dropped;
};

// What was written, for the report.
template <int D>
struct Written {
  ChosenAlpha alpha;
  orthoball::EditedShape<D> shape;
  std::optional<Solid<D>> solid;
  orthoball::ShapeMesh mesh;
};

template <int D>
void write_report(const ShapeOptions& options, const Written<D>& written,
                  const std::string& format) {
  const Contents contents = contents_of(written.mesh);
  nlohmann::ordered_json json{{"file", options.output}, {"format", format}};
  json["name"] = nullptr;
  if (!written.alpha.name.empty()) json["name"] = written.alpha.name;
  json["index"] = written.alpha.index;
  json["alpha2"] = written.alpha.alpha2;
  json["alpha"] = written.alpha.alpha;
  json["regularized"] = options.edits.regularized;
  add_json(json, written.shape, options.edits);
  json["vertices"] = written.mesh.vertex_count();
  json["regular"] = contents.regular;
  json["singular"] = {contents.singular_vertices, contents.singular_edges};
  if (D == 3) json["singular"].push_back(contents.singular_triangles);
  std::size_t missing = 0;
  if (written.solid) {
    json["manifold"] = manifold_json<D>(written.solid->manifold, written.solid->dropped, missing);
  }
  const std::string text = json_text(json) + "\n";
  write_output("-", "", [&](orthoball::ByteSink& sink) {
    sink.text(text);
    sink.flush();
  });
  warn_of_missing(options.input, missing, "null");
}

template <int D>
void say_report(const ShapeOptions& options, const Written<D>& written) {
  if (options.edits.are_given()) say(options.input, text_of(written.shape, options.edits));
  const Contents contents = contents_of(written.mesh);
  std::string text =
      orthoball::counted(contents.regular, D == 3 ? "regular triangle" : "regular edge");
  if (!options.edits.regularized && !options.manifold) {
    if (D == 3) text += ", " + orthoball::counted(contents.singular_triangles, "singular triangle");
    text += ", " + orthoball::counted(contents.singular_edges, "singular edge") + ", " +
            orthoball::counted(contents.singular_vertices, "singular vertex");
  }
  say(options.input, text_of(written.alpha) + ": " + text);
  if (!written.solid) return;
  for (const std::string& line :
       manifold_text<D>(written.solid->manifold, written.solid->dropped)) {
    say(options.input, "manifold: " + line);
  }
}

bool is_last(const Loaded& input, std::uint32_t index) {
  return std::visit([&](const auto& filtration) { return index == filtration.spectrum_size(); },
                    input.shapes.filtration());
}

// Of what the file lacks, and of an alpha far from those of the points.
void warn(const ShapeOptions& options, const Loaded& input, const ChosenAlpha& alpha,
          const orthoball::ShapeMesh& mesh, const std::string& format) {
  const Contents contents = contents_of(mesh);
  const auto mesh_format = orthoball::mesh_format(format);
  const std::size_t thin = contents.singular_edges + contents.singular_vertices;
  if (mesh_format && !orthoball::holds_edges(*mesh_format) && thin > 0) {
    say(options.input,
        fmt::format("warning: {} holds triangles only; {} and {} are left out", format,
                    orthoball::counted(contents.singular_edges, "singular edge"),
                    orthoball::counted(contents.singular_vertices, "singular vertex")));
  }
  if (mesh_format && options.roles && !orthoball::holds_roles(*mesh_format)) {
    say(options.input,
        fmt::format("warning: {} has no place for roles; they are left out", format));
  }
  if (contents.regular + contents.singular_triangles + thin == 0) {
    const bool is_alpha = !options.edits.are_given();
    say(options.input, is_alpha ? "warning: the shape has no boundary at this alpha; the file has "
                                  "none: " +
                                      scale_text(input)
                                : "warning: what is left of the shape has no boundary; the file "
                                  "has none");
  } else if (contents.regular + contents.singular_triangles + contents.singular_edges == 0) {
    say(options.input, "at this alpha the shape is points alone: " + scale_text(input));
  } else if (alpha.alpha2 > alpha_at(input, alpha.index).alpha2 && is_last(input, alpha.index)) {
    say(options.input,
        "at this alpha the shape is the convex hull of the points: " + scale_text(input));
  }
}

void check_options(const ShapeOptions& options) {
  if (options.json && options.output == "-") {
    throw UsageError("shape --json: the report goes to standard output; the shape needs -o FILE");
  }
  const OutputKind table = OutputKind::table;
  check_outputs(options.input, options.output, {{"--changes", options.changes, table}});
  check(options.alpha, false);
}

template <int D>
void write_shape(const ShapeOptions& options, const Loaded& input,
                 const orthoball::Filtration<D>& filtration, const ChosenAlpha& alpha,
                 const std::string& format) {
  auto shape = edited_shape(filtration, alpha.index, edits(options.edits));
  std::optional<Solid<D>> solid;
  if (options.manifold) {
    require_memory(options.input, manifold_memory(D, filtration.size()), "the closed surface");
    solid = {manifold_solid(shape.complex), dropped_simplices(shape.complex)};
  }
  MissingNumbers missing;
  if (!options.changes.empty()) {
    write_table(options.changes, missing,
                [&](orthoball::ByteSink& sink, orthoball::TableFormat table) {
                  write_solid_changes<D>(sink, table, shape.complex, solid->manifold);
                });
  }
  if (solid) shape.complex = complex_of(solid->manifold, shape.complex);
  const auto& points = input.shapes.points();
  auto mesh = shape_mesh(shape.complex, points);
  const Written<D> written{alpha, std::move(shape), std::move(solid), std::move(mesh)};
  write_output(options.output, "null", [&](orthoball::ByteSink& sink) {
    if (const auto mesh_format = orthoball::mesh_format(format)) {
      return write_mesh(sink, written.mesh, {*mesh_format, options.roles, alpha.alpha2});
    }
    if constexpr (D == 2) {
      const orthoball::PlanarShapeOptions planar{alpha.alpha2, options.roles};
      if (format == "geojson") write_geojson(sink, written.shape.complex, points, planar);
      if (format == "svg") write_shape_svg(sink, written.shape.complex, points, planar);
    }
  });
  options.json ? write_report(options, written, format) : say_report(options, written);
  warn(options, input, alpha, written.mesh, format);
}

void run(const ShapeOptions& options) {
  const std::string format = format_of(options);
  check_options(options);
  (void)edits(options.edits);  // refused before the work, if at all
  Progress progress(
      options.input.progress, options.input.quiet,
      {Stage::reading, Stage::triangulation, Stage::filtration, Stage::writing_shape});
  const Loaded input = load(options.input, progress);
  check_dimension(format, input.shapes.dimension());
  const auto given = chosen_alphas(options.alpha, input);
  const ChosenAlpha alpha = given.empty() ? automatic_alpha(input) : given[0];
  say_how(options.input, {alpha});

  progress.begin(Stage::writing_shape);
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        write_shape<D>(options, input, filtration, alpha, format);
      },
      input.shapes.filtration());
  progress.end();
}

}  // namespace

void add_shape_command(CLI::App& app) {
  auto options = std::make_shared<ShapeOptions>();
  CLI::App* command =
      app.add_subcommand("shape", "The boundary of the shape at one alpha as a mesh or a map.");
  add_alpha_options(*command, options->alpha, false, "auto");
  add_edit_options(*command, options->edits);
  const std::string group = "Output";
  command->add_option("-o,--output", options->output, "file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str()
      ->group(group);
  command
      ->add_option("--format", options->format,
                   "ply, obj, off, stl, vtu or glb; in the plane also geojson or svg\n"
                   "(default: by the name of -o)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"ply", "obj", "off", "stl", "vtu", "glb", "geojson", "svg"})
                  .description(""))
      ->group(group);
  auto* const manifold =
      command
          ->add_flag("--manifold", options->manifold,
                     "a closed surface to be printed: the solid part only, cells added or\n"
                     "removed where it is no manifold; see below")
          ->group("Parts");
  command
      ->add_option("--changes", options->changes,
                   "with --manifold, what was changed and left out, as CSV or JSON")
      ->type_name("FILE")
      ->needs(manifold)
      ->group(group);
  command
      ->add_flag("--roles", options->roles,
                 "mark every simplex as singular or regular: a property (ply, vtu),\n"
                 "a group (obj) or a colour (off, glb, svg); geojson always does")
      ->group(group);
  command->add_flag("--json", options->json, "a report on standard output as JSON")->group(group);
  add_input_options(*command, options->input);
  command->footer(
      "Regular triangles turn counterclockwise seen from outside. Singular triangles, edges and\n"
      "vertices, parts of the shape that bound no tetrahedron, are kept where the format can hold\n"
      "them: stl and off hold triangles only. Coordinates are those of INPUT; stl and glb round\n"
      "them to 24 bits. ply and vtu name the input row of every vertex.\n\n"
      "Regions are the components of the shape, holes the bounded components of what is around "
      "it.\n"
      "Holes are filled first, then regions left out; the report says how many.\n\n"
      "--manifold: every surface is closed, oriented and a manifold: two triangles at every edge,\n"
      "one ring of them around every vertex (in the plane: closed outlines that touch nowhere).\n"
      "Where the boundary of what is left is none, as little volume of tetrahedra as a local "
      "search\n"
      "finds is added or removed; no point is added or split, and singular simplices are left "
      "out.\n"
      "What was done is said, listed by --json, and by --changes place for place.\n\n"
      "--alpha2 auto: 0 where weights are the radii of a molecule (the dual complex of its\n"
      "atoms); without weights the first alpha2 at which the shape is one solid piece with every\n"
      "point; else the first from which on it is one piece. Which was taken is said.\n\n"
      "Examples:\n"
      "  orthoball shape bunny.off -o surface.ply\n"
      "  orthoball shape bunny.off --alpha 0.01 --manifold -o print.stl\n"
      "  orthoball shape 1ubq.pdb --alpha 1.4 -o ubiquitin.glb --roles\n"
      "  orthoball shape airports.csv --alpha2 auto -o outline.geojson\n"
      "  orthoball shape cells.csv --alpha 2 --regularized --region 1 --hole-threshold 50 -o "
      "cell.svg");
  command->callback([options] { run(*options); });
}
