// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_tables.h"

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

using Labels = std::vector<std::string>;  // [row], or empty

std::string_view label_of(const Labels& labels, std::size_t row) {
  return row < labels.size() ? std::string_view(labels[row]) : std::string_view();
}

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
  struct Residue {
    std::string chain, name;
    std::size_t atoms = 0;
    CompensatedSum area{}, volume{};
  };
  std::vector<Residue> residues;
  std::map<std::pair<std::string, std::string>, std::size_t> number_of;
  for (std::size_t row = 0; row < balls.areas.size(); ++row) {
    std::string chain(label_of(labels.chain, row)), name = residue_of(labels, row);
    const auto [at, is_new] = number_of.try_emplace({chain, name}, residues.size());
    if (is_new) residues.push_back({std::move(chain), std::move(name)});
    Residue& residue = residues[at->second];
    ++residue.atoms;
    residue.area.add(balls.areas[row]);
    residue.volume.add(balls.volumes[row]);
  }
  sink.text("chain,residue,atoms,area,volume\n");
  for (const Residue& residue : residues) {
    write_text(sink, residue.chain);
    write_texts(sink, {residue.name});
    sink.text(",");
    write_row(sink, residue.atoms);
    write_reals(sink, {residue.area.value().high, residue.volume.value().high});
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
