// SPDX-License-Identifier: MIT
#include "cli/manifold_report.h"

#include <fmt/format.h>

#include <vector>

#include "cli/report.h"
#include "orthoball/counted.h"

namespace {

using Json = nlohmann::ordered_json;

// How many cells were added, and how many removed.
struct CellCounts {
  std::size_t added = 0, removed = 0;
};

template <int D>
CellCounts cell_counts(const orthoball::ManifoldSolid<D>& solid) {
  CellCounts counts;
  for (const auto& change : solid.changes) {
    (change.is_added ? counts.added : counts.removed) += change.cells.size();
  }
  return counts;
}

template <int D>
std::string changes_text(const orthoball::ManifoldSolid<D>& solid) {
  if (solid.offending.empty()) return "nothing had to be changed";
  const auto cells = [](std::size_t count) {
    return orthoball::counted(count, D == 3 ? "tetrahedron" : "triangle");
  };
  const std::string measure = D == 3 ? "volume" : "area";
  const CellCounts counts = cell_counts(solid);
  std::vector<std::string> words;
  if (counts.added > 0) {
    words.push_back(
        fmt::format("{} added, {} {}", cells(counts.added), measure, number_text(solid.added)));
  }
  if (counts.removed > 0) {
    words.push_back(fmt::format("{} removed, {} {}", cells(counts.removed), measure,
                                number_text(solid.removed)));
  }
  std::string text = fmt::format("{}; in {}, where it was no manifold in {}", joined(words),
                                 orthoball::counted(solid.changes.size(), "place"),
                                 orthoball::counted(solid.offending.size(), "vertex"));
  if (D == 3) text += " and " + orthoball::counted(solid.offending_edges, "edge");
  // Of what there was. Where that is much, walls are as thin as one cell.
  constexpr double kMuch = 0.1;
  const double share = (solid.added + solid.removed) / (solid.volume - solid.added + solid.removed);
  if (share > kMuch) {
    text += fmt::format(" ({:.0f} % of the shape; a larger alpha may need less)", 100 * share);
  }
  return text;
}

template <int D>
std::string dropped_text(const DroppedSimplices<D>& dropped) {
  constexpr std::array<const char*, 3> kNouns{"vertex", "edge", "triangle"};
  std::vector<std::string> words;
  for (std::size_t d = D; d-- > 0;) {
    if (dropped[d] == 0) continue;
    words.push_back(orthoball::counted(dropped[d], std::string("singular ") + kNouns[d]));
  }
  return words.empty() ? "" : "; left out: " + joined(words);
}

}  // namespace

template <int D>
DroppedSimplices<D> dropped_simplices(const orthoball::AlphaComplex<D>& shape) {
  DroppedSimplices<D> dropped{};
  for (int d = 0; d < D; ++d) {
    dropped[static_cast<std::size_t>(d)] = shape.simplices(d, orthoball::Role::singular).size();
  }
  return dropped;
}

template <int D>
Json manifold_json(const orthoball::ManifoldSolid<D>& solid, const DroppedSimplices<D>& dropped,
                   std::size_t& missing) {
  const CellCounts counts = cell_counts(solid);
  Json json;
  json["cells"] = solid.cell_count;
  json["volume"] = finite(solid.volume, missing);
  json["area"] = finite(solid.area, missing);
  json["surfaces"] = solid.surface_count;
  json["euler"] = solid.euler;
  json["offending_vertices"] = Json::array();
  for (const orthoball::SiteId row : solid.offending) {
    json["offending_vertices"].push_back(row.row());
  }
  json["offending_edges"] = D == 3 ? Json(solid.offending_edges) : Json();
  json["added_cells"] = counts.added;
  json["added_volume"] = finite(solid.added, missing);
  json["removed_cells"] = counts.removed;
  json["removed_volume"] = finite(solid.removed, missing);
  json["changes"] = Json::array();
  for (const auto& change : solid.changes) {
    Json entry{{"change", change.is_added ? "added" : "removed"}, {"cells", change.cells.size()}};
    entry["volume"] = finite(change.volume, missing);
    entry["centre"] = Json::array();
    for (const double x : change.centre) entry["centre"].push_back(finite(x + 0.0, missing));
    entry["rows"] = Json::array();
    for (const orthoball::SiteId row : change.rows) entry["rows"].push_back(row.row());
    json["changes"].push_back(std::move(entry));
  }
  json["dropped"] = dropped;
  return json;
}

template <int D>
std::array<std::string, 2> manifold_text(const orthoball::ManifoldSolid<D>& solid,
                                         const DroppedSimplices<D>& dropped) {
  if (solid.cell_count == 0) {
    return {fmt::format("no solid: the shape has no {} at this alpha",
                        D == 3 ? "tetrahedra" : "triangles"),
            "nothing to close" + dropped_text<D>(dropped)};
  }
  const std::string surfaces =
      orthoball::counted(solid.surface_count, D == 3 ? "closed surface" : "closed outline");
  const std::string euler = D == 3 ? fmt::format(", Euler number {}", solid.euler) : "";
  return {fmt::format("{}{}, {} {}, {} {}", surfaces, euler, D == 3 ? "volume" : "area",
                      number_text(solid.volume), D == 3 ? "area" : "perimeter",
                      number_text(solid.area)),
          changes_text(solid) + dropped_text<D>(dropped)};
}

template DroppedSimplices<2> dropped_simplices(const orthoball::AlphaComplex<2>&);
template DroppedSimplices<3> dropped_simplices(const orthoball::AlphaComplex<3>&);
template Json manifold_json<2>(const orthoball::ManifoldSolid<2>&, const DroppedSimplices<2>&,
                               std::size_t&);
template Json manifold_json<3>(const orthoball::ManifoldSolid<3>&, const DroppedSimplices<3>&,
                               std::size_t&);
template std::array<std::string, 2> manifold_text<2>(const orthoball::ManifoldSolid<2>&,
                                                     const DroppedSimplices<2>&);
template std::array<std::string, 2> manifold_text<3>(const orthoball::ManifoldSolid<3>&,
                                                     const DroppedSimplices<3>&);
