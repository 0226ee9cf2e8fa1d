// SPDX-License-Identifier: MIT
//
// Edelsbrunner. Weighted alpha shapes. Technical report UIUCDCS-R-92-1760 (1992): its figures of
// disks, their decomposition and their dual complex, here of any data.
#include "orthoball/output/union_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/plot_text.h"
#include "orthoball/queries/planar_union.h"
#include "orthoball/topology/betti.h"

namespace orthoball {
namespace {

using Point = std::array<double, 2>;

constexpr double kPadding = 10.0, kGap = 28.0, kMargin = 24.0, kCaption = 30.0, kHead = 58.0;
constexpr double kTallest = 2.0;  // times the width of a panel

struct Colours {
  std::string_view paper, ink, muted;
  std::string_view disk, circle, outline;  // fill of the union, single circles, its boundary
  std::string_view triangle, edge, inner;  // of the complex; inner: interior edges
  std::string_view singular, site;
};
constexpr Colours kColour{"#ffffff", "#1c2733", "#5b6570", "#dcebf7", "#8fb3d3", "#1f5a94",
                          "#9cc3e4", "#1f5a94", "#5f95c4", "#d55e00", "#1c2733"};
constexpr Colours kPrint{"#ffffff", "#000000", "#444444", "#eeeeee", "#999999", "#000000",
                         "#bdbdbd", "#000000", "#777777", "#000000", "#000000"};

std::string pixel(double x) { return fmt::format("{}", std::round(100 * x) / 100 + 0.0); }

// Where the plane lies in a panel.
class Window {
 public:
  Window(const WeightedPoints& points, const PlanarUnion& drawn, double width) {
    std::array<double, 2> low, high{};
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-low[0]);
    const auto take = [&](const Point& x, double radius) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], x[axis] / 2 - radius / 2);
        high[axis] = std::max(high[axis], x[axis] / 2 + radius / 2);
      }
    };
    for (std::size_t row = 0; row < points.size(); ++row) {
      take({points.coordinate(row, 0), points.coordinate(row, 1)}, 0.0);
    }
    for (const DiskPart& part : drawn.parts) take(part.centre, part.radius);
    if (points.size() == 0) take({}, 0.0);
    std::array<double, 2> extent{};
    for (std::size_t axis = 0; axis < 2; ++axis) extent[axis] = high[axis] - low[axis];
    if (!(std::isfinite(extent[0]) && std::isfinite(extent[1]))) {
      throw InputError(InputError::Reason::not_finite, InputError::kNoRow,
                       "the disks are larger than a double can say");
    }
    const double inside = width - 2 * kPadding;
    const auto fits = [&](double size, double length) {
      return length > 0.0 ? size / length : 0.0;
    };
    scale_ = fits(inside, extent[0]);
    if (extent[1] * scale_ > kTallest * inside || scale_ == 0.0) {
      scale_ = fits(kTallest * inside, extent[1]);
    }
    if (scale_ == 0.0) scale_ = 1.0;
    left_ = low[0] - ((inside / scale_) - extent[0]) / 2;
    top_ = high[1];
    height_ = std::max(extent[1] * scale_, inside / 4);
    top_ += (height_ / scale_ - extent[1]) / 2;
  }

  // Of the panel.
  [[nodiscard]] double height() const { return height_ + 2 * kPadding; }
  [[nodiscard]] std::string position(const Point& x) const {
    return pixel((x[0] / 2 - left_) * scale_ + kPadding) + " " +
           pixel((top_ - x[1] / 2) * scale_ + kPadding);
  }
  [[nodiscard]] std::string length(double length) const { return pixel(length / 2 * scale_); }

 private:
  double left_ = 0.0, top_ = 0.0, scale_ = 1.0, height_ = 0.0;  // of halved coordinates
};

class Figure {
 public:
  Figure(ByteSink& sink, const Filtration<2>& filtration, const WeightedPoints& points,
         const UnionFigureOptions& options)
      : sink_(sink),
        filtration_(filtration),
        points_(points),
        options_(options),
        colours_(options.style == FigureStyle::print ? kPrint : kColour),
        drawn_(planar_union(filtration, options.index, options.alpha2)),
        window_(points, drawn_, options.panel_width) {}

  void write() {
    const auto count = static_cast<double>(std::max<std::size_t>(options_.panels.size(), 1));
    const double margin = options_.legend ? kMargin : 0.0;
    const double width = count * options_.panel_width + (count - 1) * kGap + 2 * margin;
    const double head = options_.legend ? kHead : 0.0;
    const double below = options_.legend ? kCaption + (shows_complex() ? kCaption : 0.0) : 0.0;
    const double height = margin + head + window_.height() + below + margin;
    sink_.text(fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n<title>Union of "
        "disks at {2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n",
        pixel(width), pixel(height), alpha_text(options_.alpha2, options_.index), colours_.paper));
    if (options_.legend) write_head(width - 2 * margin);
    for (std::size_t i = 0; i < options_.panels.size(); ++i) {
      const double left = margin + static_cast<double>(i) * (options_.panel_width + kGap);
      sink_.text(
          fmt::format("<g transform=\"translate({} {})\" fill=\"none\" stroke-linecap=\"round\" "
                      "stroke-linejoin=\"round\">\n",
                      pixel(left), pixel(margin + head)));
      write_panel(options_.panels[i]);
      sink_.text("</g>\n");
      if (options_.legend) {
        write_caption(i, left + options_.panel_width / 2,
                      margin + head + window_.height() + kCaption - 10);
      }
    }
    if (options_.legend && shows_complex()) {
      write_legend(width / 2, margin + head + window_.height() + 2 * kCaption - 6);
    }
    sink_.text("</svg>\n");
    sink_.flush();
  }

 private:
  [[nodiscard]] bool shows_complex() const {
    return std::count(options_.panels.begin(), options_.panels.end(), FigurePanel::complex) > 0;
  }
  void write_text(double x, double y, const std::string& attributes, const std::string& text) {
    sink_.text(fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", pixel(x), pixel(y), attributes,
                           xml_text(text)));
  }
  void write_head(double width);
  void write_caption(std::size_t number, double middle, double y);
  void write_legend(double middle, double y);
  void write_panel(FigurePanel panel);
  void write_union(bool is_faint);
  void write_complex();
  void begin_path(std::string_view name, const std::string& attributes) {
    sink_.text(fmt::format("<path class=\"{}\" {} d=\"", name, attributes));
  }
  void end_path() { sink_.text("\"/>\n"); }
  void move_to(const Point& x) { sink_.text("M" + window_.position(x)); }
  void line_to(const Point& x) { sink_.text("L" + window_.position(x)); }
  void follow(const DiskPart& part, const DiskPiece& piece);
  void circle(const Point& centre, double radius);
  [[nodiscard]] Point site(VertexId vertex) const {
    const std::size_t row = filtration_.triangulation().sites().row(vertex.row()).row();
    return {points_.coordinate(row, 0), points_.coordinate(row, 1)};
  }

  ByteSink& sink_;
  const Filtration<2>& filtration_;
  const WeightedPoints& points_;
  const UnionFigureOptions& options_;
  const Colours& colours_;
  PlanarUnion drawn_;
  Window window_;
};

void Figure::write_head(double width) {
  const UnionOfBalls measured =
      union_of_balls(filtration_, options_.index, options_.alpha2, UnionOptions{});
  const auto betti = betti_numbers(filtration_, options_.index);
  const std::string unit = options_.unit.empty() ? "" : "\u2009" + options_.unit;
  const std::size_t hidden = filtration_.triangulation().hidden().size();
  const std::string disks = counted(drawn_.parts.size(), "disk") +
                            (hidden > 0 ? fmt::format(" and {} hidden", hidden) : "");
  const auto number = [](double x) { return fmt::format("{:.6g}", x); };
  const std::string text = fmt::format(
      "{}: {}, area {}{}, perimeter {}{}, {}, {}", alpha_text(options_.alpha2, options_.index),
      disks, number(measured.volume), unit.empty() ? "" : unit + "²", number(measured.area), unit,
      counted(betti[0], "component"), counted(betti[1], "hole"));
  const std::string title = options_.title.empty() ? "Union of disks" : options_.title;
  write_text(kMargin, kMargin + 14,
             fmt::format("font-size=\"16\" font-weight=\"600\" fill=\"{}\"", colours_.ink),
             shortened(title, width, 17));
  write_text(kMargin, kMargin + 36, fmt::format("font-size=\"12\" fill=\"{}\"", colours_.muted),
             shortened(text, width, 12));
}

void Figure::write_caption(std::size_t number, double middle, double y) {
  constexpr std::array<std::string_view, 3> kCaptions{
      "the disks and their union", "the parts: disks cut by their power cells", "the dual complex"};
  const auto letter = static_cast<char>('a' + static_cast<int>(number));
  const auto panel = static_cast<std::size_t>(options_.panels[number]);
  const std::string prefix = options_.panels.size() > 1 ? fmt::format("({}) ", letter) : "";
  write_text(middle, y,
             fmt::format("font-size=\"13\" text-anchor=\"middle\" fill=\"{}\"", colours_.ink),
             prefix + std::string(kCaptions[panel]));
}

void Figure::write_legend(double middle, double y) {
  struct Entry {
    std::string_view text, mark;
  };
  const bool is_print = options_.style == FigureStyle::print;
  const std::string triangle =
      fmt::format("<rect width=\"16\" height=\"10\" y=\"-9\" fill=\"{}\"/>", colours_.triangle);
  const std::string regular =
      fmt::format("<path d=\"M0 -4H16\" stroke=\"{}\" stroke-width=\"2\"/>", colours_.edge);
  const std::string inner =
      fmt::format("<path d=\"M0 -4H16\" stroke=\"{}\" stroke-width=\"0.8\"/>", colours_.inner);
  const std::string singular =
      fmt::format("<path d=\"M0 -4H16\" stroke=\"{}\" stroke-width=\"2\"{}/>", colours_.singular,
                  is_print ? " stroke-dasharray=\"5 4\"" : "");
  const std::string vertex =
      fmt::format("<circle cx=\"8\" cy=\"-4\" r=\"3.5\" fill=\"{}\"/>", colours_.singular);
  const std::array<Entry, 5> entries{{{"triangle", triangle},
                                      {"interior edge", inner},
                                      {"regular edge", regular},
                                      {"singular edge", singular},
                                      {"singular vertex", vertex}}};
  constexpr double kMark = 22.0, kBetween = 22.0, kFont = 12.0;
  double width = -kBetween;
  for (const Entry& entry : entries) width += kMark + text_width(entry.text, kFont) + kBetween;
  double x = middle - width / 2;
  for (const Entry& entry : entries) {
    sink_.text(
        fmt::format("<g transform=\"translate({} {})\">{}</g>\n", pixel(x), pixel(y), entry.mark));
    write_text(x + kMark, y, fmt::format("font-size=\"{}\" fill=\"{}\"", kFont, colours_.muted),
               std::string(entry.text));
    x += kMark + text_width(entry.text, kFont) + kBetween;
  }
}

// A piece from where the path is. SVG tells an arc by its ends and radius; near a whole turn these
// say little, so it goes in halves.
void Figure::follow(const DiskPart& part, const DiskPiece& piece) {
  if (!piece.is_arc()) return line_to(piece.to);
  const std::string radius = window_.length(part.radius);
  const auto arc_to = [&](const Point& to) {
    sink_.text("A" + radius + " " + radius + " 0 0 0 " + window_.position(to));
  };
  const double x = piece.from[0] - part.centre[0], y = piece.from[1] - part.centre[1];
  const int steps = piece.turn > std::numbers::pi / 2
                        ? static_cast<int>(std::ceil(piece.turn / (std::numbers::pi / 2)))
                        : 1;
  for (int i = 1; i < steps; ++i) {
    const double c = std::cos(piece.turn * i / steps), s = std::sin(piece.turn * i / steps);
    arc_to({part.centre[0] + c * x - s * y, part.centre[1] + s * x + c * y});
  }
  arc_to(piece.to);
}

void Figure::circle(const Point& centre, double radius) {
  const DiskPart part{{}, centre, radius, {}};
  const Point start{centre[0] + radius, centre[1]};
  move_to(start);
  follow(part, {start, start, 2 * std::numbers::pi, {}});
  sink_.text("Z");
}

// The union filled, and its outline.
void Figure::write_union(bool is_faint) {
  begin_path("union", is_faint
                          ? fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"0.8\"",
                                        colours_.disk, colours_.circle)
                          : fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", colours_.outline));
  for (const auto& curve : drawn_.outline) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const DiskPart& part = drawn_.parts[curve[i].part];
      const DiskPiece& piece = part.boundary[curve[i].piece];
      if (i == 0) move_to(piece.from);
      follow(part, piece);
    }
    sink_.text("Z");
  }
  end_path();
}

void Figure::write_panel(FigurePanel panel) {
  if (panel == FigurePanel::disks) {
    begin_path("disks", fmt::format("fill=\"{}\" stroke=\"none\"", colours_.disk));
    for (const DiskPart& part : drawn_.parts) circle(part.centre, part.radius);
    end_path();
    begin_path("circles", fmt::format("stroke=\"{}\" stroke-width=\"0.8\"", colours_.circle));
    for (const DiskPart& part : drawn_.parts) circle(part.centre, part.radius);
    end_path();
    write_union(false);
  }
  if (panel == FigurePanel::cells) {
    begin_path("parts", fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"0.8\"", colours_.disk,
                                    colours_.circle));
    for (const DiskPart& part : drawn_.parts) {
      move_to(part.boundary.front().from);
      for (const DiskPiece& piece : part.boundary) follow(part, piece);
      sink_.text("Z");
    }
    end_path();
    write_union(false);
  }
  if (panel == FigurePanel::complex) {
    write_union(true);
    write_complex();
    return;
  }
  begin_path("sites", fmt::format("stroke=\"{}\" stroke-width=\"2.4\"", colours_.site));
  for (const DiskPart& part : drawn_.parts) {
    move_to(part.centre);
    sink_.text("h0");
  }
  end_path();
}

void Figure::write_complex() {
  const auto simplices = [&](int dimension, Role role, const auto& visit) {
    const std::uint32_t first = filtration_.table().first(dimension);
    for (std::uint32_t i = 0; i < filtration_.count(dimension); ++i) {
      const SimplexId simplex(first + i);
      if (filtration_.role(simplex, options_.index) == role) visit(filtration_.vertices(simplex));
    }
  };
  const auto draw_edges = [&](std::string_view name, Role role, const std::string& attributes) {
    begin_path(name, attributes);
    simplices(1, role, [&](const auto& ends) {
      move_to(site(ends[0]));
      line_to(site(ends[1]));
    });
    end_path();
  };
  begin_path("triangles", fmt::format("fill=\"{}\" stroke=\"none\"", colours_.triangle));
  simplices(2, Role::interior, [&](const auto& corners) {
    move_to(site(corners[0]));
    line_to(site(corners[1]));
    line_to(site(corners[2]));
    sink_.text("Z");
  });
  end_path();
  draw_edges("interior edges", Role::interior,
             fmt::format("stroke=\"{}\" stroke-width=\"0.8\"", colours_.inner));
  draw_edges("regular edges", Role::regular,
             fmt::format("stroke=\"{}\" stroke-width=\"2\"", colours_.edge));
  draw_edges("singular edges", Role::singular,
             fmt::format("stroke=\"{}\" stroke-width=\"2\"{}", colours_.singular,
                         options_.style == FigureStyle::print ? " stroke-dasharray=\"5 4\"" : ""));
  begin_path("singular vertices",
             fmt::format("stroke=\"{}\" stroke-width=\"7\"", colours_.singular));
  simplices(0, Role::singular, [&](const auto& vertex) {
    move_to(site(vertex[0]));
    sink_.text("h0");
  });
  end_path();
}

}  // namespace

void write_union_figure(ByteSink& sink, const Filtration<2>& filtration,
                        const WeightedPoints& points, const UnionFigureOptions& options) {
  Figure(sink, filtration, points, options).write();
}

}  // namespace orthoball
