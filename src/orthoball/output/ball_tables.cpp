// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_tables.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/measures/compensated_sum.h"

namespace orthoball {
namespace {

// "ALA 12", as far as it is known.
std::string residue_of(const SiteLabels& labels, std::size_t row) {
  std::string text(label_of(labels.residue, row));
  const std::string_view number = label_of(labels.residue_id, row);
  if (!text.empty() && !number.empty()) text += ' ';
  return text.append(number);
}

void write_text(ByteSink& sink, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return sink.text(text);
  sink.text("\"");
  for (const char& c : text)
    sink.text(c == '"' ? std::string_view("\"\"") : std::string_view(&c, 1));
  sink.text("\"");
}

void write_texts(ByteSink& sink, std::initializer_list<std::string_view> texts) {
  for (const std::string_view text : texts) {
    sink.text(",");
    write_text(sink, text);
  }
}

void write_reals(ByteSink& sink, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    sink.text(",");
    sink.real(number + 0.0);  // no -0
  }
}

// Who is of which residue; these in the order of their first rows.
struct Residues {
  std::vector<std::pair<std::string, std::string>> names;  // chain and residue
  std::vector<std::size_t> of_row;
};

Residues residues_of(const SiteLabels& labels, std::size_t rows) {
  Residues residues;
  std::map<std::pair<std::string, std::string>, std::size_t> number_of;
  for (std::size_t row = 0; row < rows; ++row) {
    std::pair name(std::string(label_of(labels.chain, row)), residue_of(labels, row));
    const auto [at, is_new] = number_of.try_emplace(name, residues.names.size());
    if (is_new) residues.names.push_back(std::move(name));
    residues.of_row.push_back(at->second);
  }
  return residues;
}

void write_row(ByteSink& sink, std::size_t row) { sink.integer(static_cast<std::int64_t>(row)); }

}  // namespace

void write_balls_csv(ByteSink& sink, const UnionOfBalls& balls, const WeightedPoints& points,
                     const SiteLabels& labels) {
  sink.text("row,chain,residue,atom,element,radius,area,volume\n");
  for (std::size_t row = 0; row < balls.areas.size(); ++row) {
    write_row(sink, row);
    write_texts(sink, {label_of(labels.chain, row), residue_of(labels, row),
                       label_of(labels.atom, row), label_of(labels.element, row)});
    if (const auto radius = ball_radius(points, row, balls.alpha2)) {
      write_reals(sink, {*radius});
    } else {
      sink.text(",");
    }
    write_reals(sink, {balls.areas[row], balls.volumes[row]});
    sink.text("\n");
  }
  sink.flush();
}

void write_residues_csv(ByteSink& sink, const UnionOfBalls& balls, const SiteLabels& labels) {
  struct Sums {
    std::size_t atoms = 0;
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
  sink.text("chain,residue,atoms,area,volume\n");
  for (std::size_t i = 0; i < sums.size(); ++i) {
    write_text(sink, residues.names[i].first);
    write_texts(sink, {residues.names[i].second});
    sink.text(",");
    write_row(sink, sums[i].atoms);
    write_reals(sink, {sums[i].area.value().high, sums[i].volume.value().high});
    sink.text("\n");
  }
  sink.flush();
}

void write_residue_contacts_csv(ByteSink& sink, std::span<const Contact> contacts, std::size_t rows,
                                const SiteLabels& labels) {
  struct Sums {
    std::size_t pairs = 0;
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
  sink.text("chain_1,residue_1,chain_2,residue_2,pairs,area\n");
  for (const auto& [pair, of_pair] : sums) {
    const auto& [chain_1, residue_1] = residues.names[pair.first];
    const auto& [chain_2, residue_2] = residues.names[pair.second];
    write_text(sink, chain_1);
    write_texts(sink, {residue_1, chain_2, residue_2});
    sink.text(",");
    write_row(sink, of_pair.pairs);
    write_reals(sink, {of_pair.area.value().high});
    sink.text("\n");
  }
  sink.flush();
}

void write_contacts_csv(ByteSink& sink, std::span<const Contact> contacts) {
  sink.text("row_1,row_2,area,exposed\n");
  for (const Contact& contact : contacts) {
    write_row(sink, contact.rows[0].row());
    sink.text(",");
    write_row(sink, contact.rows[1].row());
    write_reals(sink, {contact.area, contact.exposed});
    sink.text("\n");
  }
  sink.flush();
}

void write_derivatives_csv(ByteSink& sink, const UnionOfBalls& balls, int dimension) {
  const std::string_view axes = std::string_view("xyz").substr(0, dimension == 2 ? 2 : 3);
  const UnionDerivatives& derivatives = balls.derivatives;
  sink.text("row,area_by_radius,volume_by_radius");
  for (const std::string_view measure : {",volume_by_", ",area_by_"}) {
    for (const char& axis : axes) {
      sink.text(measure);
      sink.text({&axis, 1});
    }
  }
  sink.text("\n");
  for (std::size_t row = 0; row < derivatives.area_by_radius.size(); ++row) {
    write_row(sink, row);
    write_reals(sink, {derivatives.area_by_radius[row], balls.areas[row]});
    for (const auto* const by_centre :
         {&derivatives.volume_by_centre, &derivatives.area_by_centre}) {
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        write_reals(sink, {(*by_centre)[axes.size() * row + axis]});
      }
    }
    sink.text("\n");
  }
  sink.flush();
}

}  // namespace orthoball
