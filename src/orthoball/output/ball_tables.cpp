// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_tables.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/measures/compensated_sum.h"
#include "orthoball/output/row_names.h"

namespace orthoball {
namespace {

// Who is of which residue; these in the order of their first rows.
struct Residues {
  std::vector<std::pair<std::string, std::string>> names;  // chain and residue
  std::vector<std::size_t> of_row;
};

Residues residues_of(const SiteLabels& labels, std::size_t rows) {
  const RowNames names(labels);
  Residues residues;
  std::map<std::pair<std::string, std::string>, std::size_t> number_of;
  for (std::size_t row = 0; row < rows; ++row) {
    std::pair name(std::string(names.chain(row)), names.residue(row));
    const auto [at, is_new] = number_of.try_emplace(name, residues.names.size());
    if (is_new) residues.names.push_back(std::move(name));
    residues.of_row.push_back(at->second);
  }
  return residues;
}

void write_residue(TableWriter& table, const std::pair<std::string, std::string>& name) {
  table.text(name.first);
  table.text(name.second);
}

void append(std::vector<std::string>& columns, const std::vector<std::string>& more) {
  columns.insert(columns.end(), more.begin(), more.end());
}

}  // namespace

void write_balls(ByteSink& sink, TableFormat format, const UnionOfBalls& balls,
                 const WeightedPoints& points, const SiteLabels& labels) {
  const RowNames names(labels);
  std::vector<std::string> columns = RowNames::columns();
  append(columns, {"element", "radius", "area", "volume"});
  TableWriter table(sink, format, columns);
  for (std::size_t row = 0; row < balls.areas.size(); ++row) {
    names.write(table, row);
    table.text(names.element(row));
    const auto radius = ball_radius(points, row, balls.alpha2);
    radius ? table.real(*radius) : table.none();
    table.real(balls.areas[row]);
    table.real(balls.volumes[row]);
  }
  table.finish();
}

void write_residues(ByteSink& sink, TableFormat format, const UnionOfBalls& balls,
                    const SiteLabels& labels) {
  struct Sums {
    std::int64_t atoms = 0;
    CompensatedSum area{}, volume{};
  };
  const Residues residues = residues_of(labels, balls.areas.size());
  std::vector<Sums> sums(residues.names.size());
  for (std::size_t row = 0; row < balls.areas.size(); ++row) {
    Sums& of_residue = sums[residues.of_row[row]];
    ++of_residue.atoms;
    of_residue.area.add(balls.areas[row]);
    of_residue.volume.add(balls.volumes[row]);
  }
  TableWriter table(sink, format, {"chain", "residue", "atoms", "area", "volume"});
  for (std::size_t i = 0; i < sums.size(); ++i) {
    write_residue(table, residues.names[i]);
    table.integer(sums[i].atoms);
    table.real(sums[i].area.value().high);
    table.real(sums[i].volume.value().high);
  }
  table.finish();
}

void write_contacts(ByteSink& sink, TableFormat format, std::span<const Contact> contacts,
                    const SiteLabels& labels) {
  const RowNames names(labels);
  std::vector<std::string> columns = RowNames::columns("_1");
  append(columns, RowNames::columns("_2"));
  append(columns, {"area", "exposed_length"});
  TableWriter table(sink, format, columns);
  for (const Contact& contact : contacts) {
    for (const SiteId row : contact.rows) names.write(table, row.row());
    table.real(contact.area);
    table.real(contact.exposed_length);
  }
  table.finish();
}

void write_residue_contacts(ByteSink& sink, TableFormat format, std::span<const Contact> contacts,
                            std::size_t rows, const SiteLabels& labels) {
  struct Sums {
    std::int64_t pairs = 0;
    CompensatedSum area{};
  };
  const Residues residues = residues_of(labels, rows);
  std::map<std::pair<std::size_t, std::size_t>, Sums> sums;
  for (const Contact& contact : contacts) {
    const std::size_t one = residues.of_row[contact.rows[0].row()];
    const std::size_t other = residues.of_row[contact.rows[1].row()];
    if (one == other) continue;
    Sums& of_pair = sums[std::minmax(one, other)];
    ++of_pair.pairs;
    of_pair.area.add(contact.area);
  }
  TableWriter table(sink, format,
                    {"chain_1", "residue_1", "chain_2", "residue_2", "pairs", "area"});
  for (const auto& [pair, of_pair] : sums) {
    write_residue(table, residues.names[pair.first]);
    write_residue(table, residues.names[pair.second]);
    table.integer(of_pair.pairs);
    table.real(of_pair.area.value().high);
  }
  table.finish();
}

void write_derivatives(ByteSink& sink, TableFormat format, const UnionOfBalls& balls, int dimension,
                       const SiteLabels& labels) {
  const std::string_view axes = std::string_view("xyz").substr(0, dimension == 2 ? 2 : 3);
  const UnionDerivatives& derivatives = balls.derivatives;
  const RowNames names(labels);
  std::vector<std::string> columns = RowNames::columns();
  append(columns, {"area_by_radius", "volume_by_radius"});
  for (const char* const measure : {"volume_by_", "area_by_"}) {
    for (const char axis : axes) columns.push_back(std::string(measure) + axis);
  }
  TableWriter table(sink, format, columns);
  for (std::size_t row = 0; row < derivatives.area_by_radius.size(); ++row) {
    names.write(table, row);
    table.real(derivatives.area_by_radius[row]);
    table.real(balls.areas[row]);
    for (const auto* const by_centre :
         {&derivatives.volume_by_centre, &derivatives.area_by_centre}) {
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        table.real((*by_centre)[axes.size() * row + axis]);
      }
    }
  }
  table.finish();
}

}  // namespace orthoball
