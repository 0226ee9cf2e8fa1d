// SPDX-License-Identifier: MIT
#include "orthoball/output/region_tables.h"

#include <cstdint>

#include "orthoball/output/row_names.h"

namespace orthoball {
namespace {

void write_lining(TableWriter& table, std::span<const LiningBall> lining, bool has_areas,
                  const RowNames& names) {
  table.integers(lining, [](const LiningBall& ball) { return ball.row.row(); });
  if (names.has_any()) {
    table.texts(lining, [&](const LiningBall& ball) { return names.path(ball.row.row()); });
  } else {
    table.none();
  }
  if (!has_areas) return table.none();
  table.reals(lining, [](const LiningBall& ball) { return ball.area; });
}

}  // namespace

template <int D>
void write_voids(ByteSink& sink, TableFormat format, std::span<const Void<D>> voids, VoidsOf of,
                 const SiteLabels& labels) {
  const RowNames names(labels);
  std::vector<std::string> columns{"void",       "volume",     "area", "atoms",
                                   "atom_names", "atom_areas", "born", "dies"};
  for (std::size_t axis = 0; axis < D; ++axis) columns.emplace_back(1, "xyz"[axis]);
  columns.emplace_back("radius");
  TableWriter table(sink, format, columns);
  std::int64_t number = 0;
  for (const Void<D>& hole : voids) {
    table.integer(++number);
    table.real(hole.volume);
    table.real(hole.area);
    write_lining(table, hole.lining, of == VoidsOf::balls, names);
    table.real(hole.born_alpha2);
    table.real(hole.dies_alpha2);
    const bool has_ball = hole.largest_ball_radius > 0.0;
    for (const double x : hole.largest_ball_centre) has_ball ? table.real(x) : table.none();
    has_ball ? table.real(hole.largest_ball_radius) : table.none();
  }
  table.finish();
}

std::string_view pocket_kind(const Pocket& pocket) {
  return pocket.mouths.empty() ? "void" : pocket.mouths.size() == 1 ? "pocket" : "channel";
}

void write_pockets(ByteSink& sink, TableFormat format, std::span<const Pocket> pockets,
                   const SiteLabels& labels) {
  const RowNames names(labels);
  TableWriter table(sink, format,
                    {"pocket", "kind", "volume", "area", "depth", "atoms", "atom_names",
                     "atom_areas", "mouths", "mouth_areas"});
  std::int64_t number = 0;
  for (const Pocket& pocket : pockets) {
    table.integer(++number);
    table.text(pocket_kind(pocket));
    table.real(pocket.volume);
    table.real(pocket.area);
    pocket.depth ? table.real(*pocket.depth) : table.none();
    write_lining(table, pocket.lining, true, names);
    table.integer(static_cast<std::int64_t>(pocket.mouths.size()));
    table.reals(pocket.mouths, [](const Mouth& mouth) { return mouth.area; });
  }
  table.finish();
}

template void write_voids<2>(ByteSink&, TableFormat, std::span<const Void<2>>, VoidsOf,
                             const SiteLabels&);
template void write_voids<3>(ByteSink&, TableFormat, std::span<const Void<3>>, VoidsOf,
                             const SiteLabels&);

}  // namespace orthoball
