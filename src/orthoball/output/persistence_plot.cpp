// SPDX-License-Identifier: MIT
#include "orthoball/output/persistence_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "orthoball/counted.h"
#include "orthoball/filtration/alpha.h"
#include "orthoball/output/plot_panel.h"
#include "orthoball/output/plot_text.h"

namespace orthoball {
namespace {

constexpr double kWidth = 640.0, kLeft = 66.0, kTop = 74.0, kSide = 540.0, kFoot = 64.0;
constexpr std::size_t kMostBars = 60;  // of a dimension
constexpr double kBar = 4.0, kBetweenDimensions = 26.0;
constexpr std::string_view kInk = "#1d2329", kMuted = "#5b6570", kGrid = "#e3e7eb",
                           kAxis = "#8a949e";
constexpr std::array<std::string_view, 3> kColours{"#0072b2", "#d55e00", "#009e73"};

std::string pixel(double x) { return fmt::format("{}", std::round(100 * x) / 100 + 0.0); }

struct Life {
  double birth, death;  // in the unit of the axis; infinite for never
};

template <int D>
class Plot {
 public:
  Plot(ByteSink& sink, const Filtration<D>& filtration, const PersistencePairs<D>& pairs,
       const PersistencePlotOptions& options)
      : sink_(sink), options_(options) {
    const auto place = [&](SimplexId simplex) {
      const std::uint32_t index = filtration.enters(simplex);
      if (options.axis == PlotAxis::index) return static_cast<double>(index);
      const double alpha2 = filtration.alpha2(index);
      return options.axis == PlotAxis::alpha2 ? alpha2 : alpha_from_alpha2(alpha2);
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      for (const PersistencePair& pair : pairs[k]) {
        lives_[k].push_back({place(pair.birth), pair.death.exists()
                                                    ? place(pair.death)
                                                    : std::numeric_limits<double>::infinity()});
      }
    }
    find_range();
  }

  void write() {
    const bool is_diagram = options_.picture == PersistencePicture::diagram;
    const double height = kTop + (is_diagram ? kSide : height_of_bars()) + kFoot;
    sink_.text(fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"10.5\" "
        "fill=\"{2}\">\n<title>Persistence of {3}</title>\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"#fff\"/>\n",
        pixel(kWidth), pixel(height), kInk, xml_text(options_.title)));
    text(kLeft, 30, "font-size=\"17\" font-weight=\"600\"",
         shortened(options_.title, kWidth - kLeft - 30, 18));
    text(kLeft, 48, fmt::format("font-size=\"11.5\" fill=\"{}\"", kMuted),
         shortened(options_.subtitle, kWidth - kLeft - 30, 11.5));
    is_diagram ? write_diagram() : write_barcode();
    sink_.text("</svg>\n");
    sink_.flush();
  }

 private:
  void text(double x, double y, const std::string& attributes, const std::string& words) {
    sink_.text(fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", pixel(x), pixel(y), attributes,
                           xml_text(words)));
  }
  void line(double x1, double y1, double x2, double y2, std::string_view colour) {
    sink_.text(fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"{}\"/>\n", pixel(x1), pixel(y1),
                           pixel(x2), pixel(y2), colour));
  }
  void find_range();
  [[nodiscard]] double x(double place) const {
    return kLeft + (std::clamp(place, from_, to_) - from_) / (to_ - from_) * kSide;
  }
  [[nodiscard]] bool is_shown(const Life& life) const {
    return life.birth < to_ && x(life.death) - x(life.birth) >= kShortest;
  }
  [[nodiscard]] std::string name(std::size_t k) const {
    constexpr std::array<std::string_view, 3> kNames{"component", "tunnel", "void"};
    return D == 2 && k == 1 ? "hole" : std::string(kNames[k]);
  }
  void write_horizontal_axis(double bottom);
  void write_diagram();
  void write_barcode();
  [[nodiscard]] std::vector<Life> bars(std::size_t k) const;
  [[nodiscard]] double height_of_bars() const {
    double height = 0.0;
    for (std::size_t k = 0; k < D; ++k) {
      height += kBetweenDimensions + kBar * static_cast<double>(bars(k).size());
    }
    return height;
  }

  static constexpr double kShortest = 0.5;  // pixels

  ByteSink& sink_;
  const PersistencePlotOptions& options_;
  std::array<std::vector<Life>, std::size_t{D}> lives_;
  double from_ = 0.0, to_ = 1.0;
};

template <int D>
void Plot<D>::find_range() {
  constexpr double kFarthest = std::numeric_limits<double>::max() / 4.0;
  double low = std::numeric_limits<double>::infinity(), high = -low, all = -low;
  for (std::size_t k = 0; k < D; ++k) {
    for (const Life& life : lives_[k]) {
      low = std::min(low, life.birth);
      const double end = std::isfinite(life.death) ? life.death : life.birth;
      all = std::max(all, end);
      if (k > 0) high = std::max(high, end);
    }
  }
  if (!(low <= all)) return;
  if (!(low < high)) high = all;
  low = std::clamp(low, -kFarthest, kFarthest);
  high = std::clamp(high, -kFarthest, kFarthest);
  const double length = std::max(high - low, 0x1p-40 * std::max(std::abs(low), std::abs(high)));
  from_ = low;
  to_ = low + (length > 0.0 ? 1.08 * length : 1.0);
}

template <int D>
void Plot<D>::write_horizontal_axis(double bottom) {
  const auto ticks = tick_values(from_, to_, 6);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double tick : ticks) {
    line(x(tick), kTop, x(tick), bottom, kGrid);
    line(x(tick), bottom, x(tick), bottom + 4, kAxis);
    text(x(tick), bottom + 17, fmt::format("text-anchor=\"middle\" fill=\"{}\"", kMuted),
         tick_text(tick, step));
  }
  line(kLeft, bottom, kLeft + kSide, bottom, kAxis);
  const std::string unit = options_.unit.empty() ? "input unit" : options_.unit;
  const std::string what = options_.axis == PlotAxis::index    ? "index of the spectrum"
                           : options_.axis == PlotAxis::alpha2 ? "alpha2 (" + unit + "²)"
                                                               : "alpha (" + unit + ")";
  text(kLeft + kSide / 2, bottom + 36, "text-anchor=\"middle\" font-size=\"11.5\"",
       options_.picture == PersistencePicture::diagram ? "birth: " + what : what);
}

template <int D>
void Plot<D>::write_diagram() {
  const double bottom = kTop + kSide;
  write_horizontal_axis(bottom);
  const auto y = [&](double place) { return bottom - (x(place) - kLeft); };
  const auto ticks = tick_values(from_, to_, 6);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double tick : ticks) {
    line(kLeft, y(tick), kLeft + kSide, y(tick), kGrid);
    text(kLeft - 7, y(tick) + 3.5, fmt::format("text-anchor=\"end\" fill=\"{}\"", kMuted),
         tick_text(tick, step));
  }
  text(16, kTop + kSide / 2,
       fmt::format("text-anchor=\"middle\" font-size=\"11.5\" transform=\"rotate(-90 16 {})\"",
                   pixel(kTop + kSide / 2)),
       "death");
  line(kLeft, bottom, kLeft + kSide, kTop, kAxis);
  // The top, where those are that never die.
  line(kLeft, kTop, kLeft + kSide, kTop, kAxis);
  text(kLeft + kSide, kTop - 6, fmt::format("text-anchor=\"end\" fill=\"{}\"", kMuted), "never");
  // Circles, triangles and squares; those of the lower dimensions first, for they are many.
  double legend = bottom - 14.0 * D;
  for (std::size_t k = 0; k < D; ++k) {
    std::size_t hidden = 0;
    sink_.text(fmt::format("<path class=\"dimension {}\" fill=\"{}\" fill-opacity=\"0.7\" d=\"", k,
                           kColours[k]));
    const auto mark = [&](double at, double up) {
      constexpr std::array<std::string_view, 3> kMarks{
          "m-3 0a3 3 0 1 0 6 0a3 3 0 1 0 -6 0Z", "m0 -4l3.6 6.4h-7.2Z", "m-2.8 -2.8h5.6v5.6h-5.6Z"};
      sink_.text("M" + pixel(at) + " " + pixel(up));
      sink_.text(kMarks[k]);
    };
    for (const Life& life : lives_[k]) {
      is_shown(life) ? mark(x(life.birth), y(life.death)) : static_cast<void>(++hidden);
    }
    mark(kLeft + kSide - 230, legend - 3.5);
    sink_.text("\"/>\n");
    const std::string shown = counted(lives_[k].size() - hidden, name(k));
    text(kLeft + kSide - 220, legend, fmt::format("fill=\"{}\"", kMuted),
         hidden > 0 ? fmt::format("{}, {} too short to show", shown, hidden) : shown);
    legend += 14.0;
  }
}

// The longest of a dimension, longest first.
template <int D>
std::vector<Life> Plot<D>::bars(std::size_t k) const {
  std::vector<Life> bars;
  for (const Life& life : lives_[k]) {
    if (is_shown(life)) bars.push_back(life);
  }
  std::stable_sort(bars.begin(), bars.end(), [](const Life& a, const Life& b) {
    return a.death - a.birth > b.death - b.birth;
  });
  if (bars.size() > kMostBars) bars.resize(kMostBars);
  return bars;
}

template <int D>
void Plot<D>::write_barcode() {
  write_horizontal_axis(kTop + height_of_bars());
  double top = kTop;
  for (std::size_t k = 0; k < D; ++k) {
    const std::vector<Life> bars = this->bars(k);
    const std::size_t hidden = lives_[k].size() - bars.size();
    text(kLeft, top + 14, fmt::format("font-weight=\"600\" fill=\"{}\"", kColours[k]),
         counted(bars.size(), name(k)) +
             (hidden > 0 ? fmt::format(", {} shorter", hidden) : std::string()));
    top += kBetweenDimensions - 4;
    sink_.text(fmt::format("<path class=\"dimension {}\" stroke=\"{}\" stroke-width=\"2.4\" d=\"",
                           k, kColours[k]));
    for (const Life& life : bars) {
      sink_.text(fmt::format("M{} {}H{}", pixel(x(life.birth)), pixel(top + kBar / 2),
                             pixel(x(life.death) + (std::isinf(life.death) ? 8.0 : 0.0))));
      top += kBar;
    }
    sink_.text("\"/>\n");
    top += 4;
  }
}

}  // namespace

template <int D>
void write_persistence_plot(ByteSink& sink, const Filtration<D>& filtration,
                            const PersistencePairs<D>& pairs,
                            const PersistencePlotOptions& options) {
  Plot<D>(sink, filtration, pairs, options).write();
}

template void write_persistence_plot<2>(ByteSink&, const Filtration<2>&, const PersistencePairs<2>&,
                                        const PersistencePlotOptions&);
template void write_persistence_plot<3>(ByteSink&, const Filtration<3>&, const PersistencePairs<3>&,
                                        const PersistencePlotOptions&);

}  // namespace orthoball
