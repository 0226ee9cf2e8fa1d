// SPDX-License-Identifier: MIT
//
// PDB columns as in version 3.30 of the format (wwPDB); hybrid-36 as published by the Computational
// Crystallography Initiative. An atom's name begins in column 14, in 13 if its element has two
// letters or the name four.
#include "orthoball/output/molecule.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

// A number of a width as decimals, then A000.. to ZZZZ, then a000.. to zzzz; empty beyond.
std::string hybrid_36(std::int64_t number, std::size_t width) {
  std::string decimal = fmt::format("{:>{}}", number, width);
  if (decimal.size() == width) return decimal;
  std::int64_t tens = 1, power = 1;  // 10^width, 36^(width - 1)
  for (std::size_t i = 0; i < width; ++i) tens *= 10;
  for (std::size_t i = 1; i < width; ++i) power *= 36;
  std::int64_t rest = number - tens;
  if (number < 0 || rest >= 52 * power) return {};
  const bool is_lower = rest >= 26 * power;
  if (is_lower) rest -= 26 * power;
  rest += 10 * power;
  std::string text(width, '0');
  for (auto at = text.rbegin(); at != text.rend(); ++at, rest /= 36) {
    const char digit = static_cast<char>(rest % 36);
    *at = static_cast<char>(digit < 10 ? '0' + digit : (is_lower ? 'a' : 'A') + digit - 10);
  }
  return text;
}

constexpr std::size_t kMostAtoms = 87440031;

// Eight columns with three decimals; empty where they are too few.
std::string coordinate_text(double x) {
  if (!(std::abs(x) < 1e5)) return {};
  std::string text = fmt::format("{:8.3f}", x);
  if (text == "  -0.000") text = "   0.000";
  return text.size() == 8 ? text : std::string();
}

// The labels of a row in the columns of a record.
class PdbNames {
 public:
  PdbNames(const SiteLabels& labels, std::size_t row)
      : element_(element_of(label_of(labels.element, row))),
        atom_(padded_atom(label_of(labels.atom, row))),
        residue_(fitting(label_of(labels.residue, row), 3)),
        chain_(fitting(label_of(labels.chain, row), 2)) {
    if (label_of(labels.residue, row).empty()) residue_ = "UNK";
    set_number(label_of(labels.residue_id, row));
  }

  // Columns 13 to 30.
  [[nodiscard]] std::string columns() const {
    return fmt::format("{:<4} {:>3}{:>2}{:>4}{}   ", atom_, residue_, chain_, number_, insertion_);
  }
  [[nodiscard]] const std::string& element() const { return element_; }
  [[nodiscard]] std::size_t cut_count() const { return cut_count_; }

 private:
  static std::string element_of(std::string_view element) {
    std::string text(element.substr(0, 2));
    std::transform(text.begin(), text.end(), text.begin(), upper);
    return text.empty() ? "X" : text;
  }

  std::string fitting(std::string_view text, std::size_t width) {
    if (text.size() > width) ++cut_count_;
    return std::string(text.substr(0, width));
  }

  std::string padded_atom(std::string_view name) {
    const std::string text = name.empty() ? element_ : fitting(name, 4);
    const bool starts_with_element = element_.size() == 2 && text.size() >= 2 &&
                                     upper(text[0]) == element_[0] && upper(text[1]) == element_[1];
    return text.size() == 4 || starts_with_element ? text : " " + text;
  }

  // "12A" is residue 12 with insertion code A.
  void set_number(std::string_view text) {
    if (text.empty()) text = "1";
    const bool has_insertion =
        text.size() > 1 && !is_digit(text.back()) && is_digit(text[text.size() - 2]);
    const std::string_view digits = has_insertion ? text.substr(0, text.size() - 1) : text;
    const std::string_view figures = digits.substr(digits[0] == '-' ? 1 : 0);
    const bool is_decimal = !figures.empty() && figures.size() < 10 &&
                            std::all_of(figures.begin(), figures.end(), is_digit);
    if (is_decimal) number_ = hybrid_36(std::stoll(std::string(digits)), 4);
    if (number_.empty()) number_ = fitting(has_insertion && is_decimal ? digits : text, 4);
    if (has_insertion && is_decimal) insertion_ = text.back();
  }

  std::size_t cut_count_ = 0;
  std::string element_, atom_, residue_, chain_, number_;
  char insertion_ = ' ';
};

// Six columns with two decimals: the nearest that fits.
std::string value_text(double value, PdbLosses& losses) {
  constexpr double kLeast = -99.99, kMost = 999.99;
  std::string text =
      std::isfinite(value) && std::abs(value) < 1e5 ? fmt::format("{:6.2f}", value) : std::string();
  if (text == " -0.00") text = "  0.00";
  if (text.size() == 6) return text;
  ++losses.values;
  return std::isnan(value) ? "  0.00" : fmt::format("{:6.2f}", value < 0.0 ? kLeast : kMost);
}

// The names of atoms of one residue, in the order of their rows.
struct ResidueAtoms {
  std::string_view chain, residue_id;
  std::vector<std::string_view> names;
};

std::vector<ResidueAtoms> residues_of(const ShownPart& part, const SiteLabels& labels) {
  std::vector<ResidueAtoms> residues;
  for (const SiteId site : part.atoms) {
    const std::size_t row = site.row();
    const std::string_view name = label_of(labels.atom, row);
    const std::string_view chain = label_of(labels.chain, row),
                           residue_id = label_of(labels.residue_id, row);
    if (name.empty() || residue_id.empty()) continue;
    if (residues.empty() || residues.back().chain != chain ||
        residues.back().residue_id != residue_id) {
      residues.push_back({chain, residue_id, {}});
    }
    auto& names = residues.back().names;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return residues;
}

using Colour = std::array<int, 3>;  // red, green, blue to 255

// Colours that all can tell apart (Okabe and Ito), again and again.
const Colour& colour_of(std::size_t part) {
  static constexpr std::array<Colour, 7> kColours{{{230, 159, 0},
                                                   {86, 180, 233},
                                                   {0, 158, 115},
                                                   {240, 228, 66},
                                                   {0, 114, 178},
                                                   {213, 94, 0},
                                                   {204, 121, 167}}};
  return kColours[part % kColours.size()];
}

void write_text(ByteSink& sink, const std::string& text) { sink.text(text); }

// Without line breaks, for comments.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

// A text in double quotes, as Python and ChimeraX read it.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + '"';
}

// Python between `python` and `python end`; one line of it a part.
void write_pymol(ByteSink& sink, const ViewerScene& scene, const SiteLabels& labels) {
  write_text(sink, fmt::format("# {}\n", one_line(scene.title)));
  sink.text(
      "python\n"
      "import os\n"
      "from pymol.cgo import COLOR, SPHERE\n");
  write_text(sink, fmt::format("cmd.load(os.path.join(os.path.dirname(__script__), {}), "
                               "\"molecule\")\n",
                               quoted(scene.file)));
  sink.text(
      "cmd.hide(\"everything\", \"molecule\")\n"
      "cmd.show(\"cartoon\", \"molecule\")\n"
      "cmd.show(\"sticks\", \"molecule and not polymer\")\n"
      "cmd.color(\"gray80\", \"molecule\")\n"
      "found = {}\n"
      "cmd.iterate(\"molecule\", \"found.setdefault((chain, resi, name), []).append(index)\",\n"
      "            space={\"found\": found})\n"
      "def show_part(name, colour, balls, residues):\n"
      "    shapes = [COLOR, *colour]\n"
      "    for ball in balls:\n"
      "        shapes += [SPHERE, *ball]\n"
      "    cmd.load_cgo(shapes, name, zoom=0)\n");
  write_text(sink, fmt::format("    cmd.group(\"{}\", name)\n", scene.group));
  sink.text(
      "    atoms = [i for chain, residue, names in residues for atom in names.split()\n"
      "             for i in found.get((chain, residue, atom), [])]\n"
      "    cmd.select_list(name + \"_atoms\", \"molecule\", atoms, mode=\"index\")\n");
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const ShownPart& part = scene.parts[i];
    std::vector<std::string> balls, residues;
    for (const InscribedBall<3>& ball : part.balls) {
      balls.push_back(fmt::format("({:.3f}, {:.3f}, {:.3f}, {:.3f})", ball.centre[0],
                                  ball.centre[1], ball.centre[2], ball.radius));
    }
    for (const ResidueAtoms& residue : residues_of(part, labels)) {
      residues.push_back(fmt::format("({}, {}, {})", quoted(residue.chain),
                                     quoted(residue.residue_id),
                                     quoted(fmt::format("{}", fmt::join(residue.names, " ")))));
    }
    const Colour& colour = colour_of(i);
    write_text(sink,
               fmt::format("# {}\nshow_part(\"{}\", ({:.3f}, {:.3f}, {:.3f}), [{}], [{}])\n",
                           one_line(part.title), part.name, colour[0] / 255.0, colour[1] / 255.0,
                           colour[2] / 255.0, fmt::join(balls, ", "), fmt::join(residues, ", ")));
  }
  sink.text("cmd.deselect()\ncmd.zoom()\npython end\n");
}

void write_chimerax(ByteSink& sink, const ViewerScene& scene, const SiteLabels& labels) {
  write_text(sink, fmt::format("# {}\n", one_line(scene.title)));
  write_text(sink, fmt::format("open {} id 1\n", quoted(scene.file)));
  sink.text("color #1 lightgray\n");
  std::size_t model = 1;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const ShownPart& part = scene.parts[i];
    write_text(sink, fmt::format("\n# {}\n", one_line(part.title)));
    if (!part.balls.empty()) ++model;
    const Colour& colour = colour_of(i);
    for (const InscribedBall<3>& ball : part.balls) {
      write_text(sink, fmt::format("marker #{} position {:.3f},{:.3f},{:.3f} radius {:.3f} "
                                   "color #{:02x}{:02x}{:02x}\n",
                                   model, ball.centre[0], ball.centre[1], ball.centre[2],
                                   ball.radius, colour[0], colour[1], colour[2]));
    }
    if (!part.balls.empty()) {
      write_text(sink, fmt::format("rename #{} {}\n", model, quoted(part.name)));
    }
    std::vector<std::string> specs;
    for (const ResidueAtoms& residue : residues_of(part, labels)) {
      specs.push_back(fmt::format("#1{}{}:{}@{}", residue.chain.empty() ? "" : "/", residue.chain,
                                  residue.residue_id, fmt::join(residue.names, ",")));
    }
    if (specs.empty()) continue;
    write_text(sink, fmt::format("name frozen {}_atoms {}\n", part.name, fmt::join(specs, " | ")));
  }
  sink.text("\nview\n");
}

}  // namespace

void require_pdb_points(const WeightedPoints& points) {
  if (points.size() > kMostAtoms) throw LimitError("a PDB file holds at most 87,440,031 atoms");
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (int axis = 0; axis < points.dimension(); ++axis) {
      const double x = points.coordinate(row, axis);
      if (!coordinate_text(x).empty()) continue;
      throw LimitError(
          fmt::format("row {}: {} is {}; a PDB file holds coordinates from -999.999 to "
                      "9999.999",
                      row, "xyz"[axis], x));
    }
  }
}

PdbLosses write_pdb(ByteSink& sink, const WeightedPoints& points, const SiteLabels& labels,
                    std::span<const double> values) {
  require_pdb_points(points);
  PdbLosses losses;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const PdbNames names(labels, row);
    losses.labels += names.cut_count();
    const auto x = [&](int axis) {
      return coordinate_text(axis < points.dimension() ? points.coordinate(row, axis) : 0.0);
    };
    write_text(sink,
               fmt::format("ATOM  {} {}{}{}{}  1.00{}          {:>2}  \n",
                           hybrid_36(static_cast<std::int64_t>(row) + 1, 5), names.columns(), x(0),
                           x(1), x(2), value_text(values[row], losses), names.element()));
  }
  write_text(sink, fmt::format("{:<80}\n", "END"));
  sink.flush();
  return losses;
}

std::optional<Viewer> viewer_of(std::string_view ending) {
  if (ending == "pml") return Viewer::pymol;
  if (ending == "cxc") return Viewer::chimerax;
  return {};
}

void write_viewer_script(ByteSink& sink, Viewer viewer, const ViewerScene& scene,
                         const SiteLabels& labels) {
  viewer == Viewer::pymol ? write_pymol(sink, scene, labels) : write_chimerax(sink, scene, labels);
  sink.flush();
}

}  // namespace orthoball
