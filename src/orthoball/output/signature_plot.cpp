// SPDX-License-Identifier: MIT
#include "orthoball/output/signature_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "orthoball/filtration/alpha.h"
#include "orthoball/output/plot_panel.h"
#include "orthoball/output/plot_text.h"
#include "orthoball/topology/betti.h"

namespace orthoball {
namespace {

constexpr double kWidth = 960.0, kPanelWidth = 390.0, kPanelHeight = 150.0;
constexpr double kLeft = 62.0, kTop = 98.0, kBetweenColumns = 76.0, kBetweenRows = 50.0;
constexpr double kShare = 0.8;            // of the top simplices, for the automatic range
constexpr double kReach = 12.0;           // the largest multiple of what they span that is shown
constexpr double kLetterWidth = 7.0;      // of a mark's letter; pixels
constexpr double kBoldness = 1.1;         // bold letters are so much wider
constexpr double kLeastLength = 0x1p-40;  // of an axis, by the size of its ends: ticks must differ
// An axis begins nearer to 0 than this and ends within twice that, so that its length is a double.
constexpr double kFarthest = std::numeric_limits<double>::max() / 4.0;

const std::array<std::string, 3> kBettiTitles{"Components, betti 0", "Tunnels, betti 1",
                                              "Voids, betti 2"};
const std::array<std::string, 2> kPlaneBettiTitles{"Components, betti 0", "Holes, betti 1"};
constexpr std::array<std::string_view, 3> kBettiColours{"#0072b2", "#d55e00", "#009e73"};

// The index by which a share of the simplices of the highest dimension has entered.
template <int D>
std::uint32_t index_of_share(const Filtration<D>& filtration) {
  const int top = std::max(filtration.triangulation().affine_dimension(), 0);
  std::vector<std::uint32_t> enters;
  const std::uint32_t first = filtration.table().first(top);
  for (std::uint32_t i = 0; i < filtration.count(top); ++i) {
    enters.push_back(filtration.enters(SimplexId(first + i)));
  }
  if (enters.empty()) return 0;
  const auto nth = static_cast<std::ptrdiff_t>(kShare * static_cast<double>(enters.size() - 1));
  std::nth_element(enters.begin(), enters.begin() + nth, enters.end());
  return enters[static_cast<std::size_t>(nth)];
}

// The last index at which the shape is anything but one component without tunnels and voids, or 1.
template <int D>
std::uint32_t last_change_of_topology(const Filtration<D>& filtration) {
  BettiScan<D> scan(filtration);
  std::uint32_t last = 1;
  BettiNumbers<D> trivial{};
  trivial[0] = 1;
  while (scan.next()) {
    if (scan.betti() != trivial) last = scan.index();
  }
  return std::min(last + 1, filtration.spectrum_size());
}

std::string axis_title(const PlotOptions& options) {
  const std::string unit = options.unit.empty() ? "input unit" : options.unit;
  switch (options.axis) {
    case PlotAxis::alpha:
      return "alpha (" + unit + ")";
    case PlotAxis::alpha2:
      return "alpha2 (" + unit + "²)";
    case PlotAxis::index:
      break;
  }
  return "index of the spectrum";
}

void write_text(ByteSink& sink, double x, double y, const std::string& attributes,
                const std::string& text) {
  sink.text(fmt::format("<text x=\"{:.6g}\" y=\"{:.6g}\" {}>{}</text>\n", x, y, attributes,
                        xml_text(text)));
}

// A position in the words of the legend: an index is exact.
std::string position_text(PlotAxis axis, double position) {
  if (axis == PlotAxis::index) return fmt::format("{:.0f}", position);
  return std::isfinite(position) ? fmt::format("{:.4g}", position) : "beyond double range";
}

// The letters of marks that lie close together, at the first of them.
struct MarkLabel {
  double x;
  std::string letters;
};

}  // namespace

template <int D>
double SignaturePlot<D>::position(std::uint32_t index, double alpha2) const {
  switch (options_.axis) {
    case PlotAxis::alpha:
      return alpha_from_alpha2(alpha2);
    case PlotAxis::alpha2:
      return alpha2;
    case PlotAxis::index:
      break;
  }
  return index;
}

template <int D>
SignaturePlot<D>::SignaturePlot(const Filtration<D>& filtration, PlotOptions options)
    : options_(std::move(options)), from_(0.0), to_(1.0), last_(0.0) {
  std::sort(options_.marks.begin(), options_.marks.end(),
            [](const PlotMark& a, const PlotMark& b) { return a.index < b.index; });
  const std::uint32_t size = filtration.spectrum_size();
  if (size > 0) last_ = position(size, filtration.alpha2(size));
  if (options_.range) {
    from_ = options_.range->first;
    to_ = options_.range->second;
  } else if (size > 0) {
    const auto position_of = [&](std::uint32_t index) {
      return position(index, filtration.alpha2(index));
    };
    std::uint32_t first = 1;
    while (first < size && !std::isfinite(position_of(first))) ++first;
    from_ = position_of(first);
    const double reach = kReach * (position_of(index_of_share(filtration)) - from_);
    const double settled = position_of(last_change_of_topology(filtration)) - from_;
    to_ = std::min(from_ + 1.25 * (reach > 0.0 ? std::min(settled, reach) : settled), last_);
  }
  from_ = std::isfinite(from_) ? std::clamp(from_, -kFarthest, kFarthest) : 0.0;
  const double least = kLeastLength * std::max(std::abs(from_), std::abs(to_));
  if (!(std::isfinite(to_) && to_ - from_ > least)) to_ = from_ + std::max(1.0, std::abs(from_));
  to_ = std::min(to_, 2.0 * kFarthest);
  curves_.assign(static_cast<std::size_t>(D) + (D == 3 ? 5 : 4), StepCurve(kPanelWidth));
}

template <int D>
void SignaturePlot<D>::add(const Signature<D>& signature) {
  const double x =
      (position(signature.index, signature.alpha2) - from_) / (to_ - from_) * kPanelWidth;
  std::size_t curve = 0;
  for (const std::uint32_t betti : signature.betti) curves_[curve++].add(x, betti);
  for (const double measure :
       {signature.volume, signature.area, signature.area_regular, signature.area_singular}) {
    curves_[curve++].add(x, measure);
  }
  if (D == 3) curves_[curve].add(x, signature.length);
}

template <int D>
void SignaturePlot<D>::write(ByteSink& sink) const {
  const auto unit = [&](const std::string& power) {
    return options_.unit.empty() ? "" : options_.unit + power;
  };
  std::vector<PlotPanel> left, right;
  for (std::size_t k = 0; k < D; ++k) {
    left.push_back({D == 3 ? kBettiTitles[k] : kPlaneBettiTitles[k],
                    "",
                    true,
                    {{&curves_[k], std::string(kBettiColours[k]), ""}}});
  }
  right.push_back({D == 3 ? "Volume" : "Area",
                   unit(D == 3 ? "³" : "²"),
                   false,
                   {{&curves_[D], "#0072b2", ""}}});
  right.push_back({D == 3 ? "Surface area" : "Perimeter",
                   unit(D == 3 ? "²" : ""),
                   false,
                   {{&curves_[D + 1], "#30363c", "two-sided"},
                    {&curves_[D + 2], "#0072b2", "regular"},
                    {&curves_[D + 3], "#d55e00", "singular"}}});
  if (D == 3) {
    right.push_back({"Length", unit(""), false, {{&curves_.back(), "#009e73", ""}}});
  }

  const double rows = static_cast<double>(left.size());
  const double bottom = kTop + rows * kPanelHeight + (rows - 1) * kBetweenRows;
  std::vector<std::string> explanations;
  std::vector<MarkLabel> labels;
  std::vector<double> lines;
  for (const PlotMark& mark : options_.marks) {
    const double at = position(mark.index, mark.alpha2);
    const auto explain = [&](std::string_view sign) {
      explanations.push_back(
          fmt::format("{} {} ({})", sign, mark.name, position_text(options_.axis, at)));
    };
    if (!(at >= from_ && at <= to_) || lines.size() == 26) {
      explain(at < from_ ? "\u2190" : "\u2192");  // arrows to where it lies
      continue;
    }
    const double x = (at - from_) / (to_ - from_) * kPanelWidth;
    const std::string letter(1, static_cast<char>('A' + lines.size()));
    explain(letter);
    lines.push_back(x);
    if (labels.empty() ||
        x - labels.back().x >
            kLetterWidth * (static_cast<double>(labels.back().letters.size()) + 1)) {
      labels.push_back({x, ""});
    }
    labels.back().letters += letter;
  }
  const std::size_t explanation_rows = (explanations.size() + 3) / 4;
  const double height = bottom + 66 + 17 * static_cast<double>(explanation_rows);

  sink.text(fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
      "font-size=\"10.5\" fill=\"#1d2329\">\n"
      "<title>Signatures of {2}</title>\n<desc>{3}</desc>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kWidth, height, xml_text(options_.title), xml_text(options_.subtitle)));
  const double right_edge = kLeft + 2 * kPanelWidth + kBetweenColumns;
  double room = right_edge - kLeft;
  write_text(sink, kLeft, 32, "font-size=\"17\" font-weight=\"600\"",
             shortened(options_.title, room, 17 * kBoldness));
  if (last_ > to_) {
    const double behind = options_.axis == PlotAxis::index ? std::floor(to_) + 1 : to_;
    std::string rest = "not shown: " + position_text(options_.axis, behind);
    rest += std::isfinite(last_) ? " to " + position_text(options_.axis, last_) : " and beyond";
    write_text(sink, right_edge, 50, "text-anchor=\"end\" font-size=\"11\" fill=\"#5b6570\"", rest);
    room -= text_width(rest, 11) + 20;
  }
  write_text(sink, kLeft, 50, "font-size=\"11.5\" fill=\"#5b6570\"",
             shortened(options_.subtitle, room, 11.5));
  for (const auto& [panels, x] :
       {std::pair(&left, kLeft), std::pair(&right, kLeft + kPanelWidth + kBetweenColumns)}) {
    for (std::size_t row = 0; row < panels->size(); ++row) {
      const double top = kTop + static_cast<double>(row) * (kPanelHeight + kBetweenRows);
      for (const double line : lines) {
        sink.text(
            fmt::format("<path d=\"M{:.6g} {:.6g}v{}\" stroke=\"#b4bcc4\" "
                        "stroke-dasharray=\"3 3\"/>\n",
                        x + line, top, kPanelHeight));
      }
      for (std::size_t i = 0; i < labels.size() && row == 0; ++i) {
        write_text(sink, x + labels[i].x - 3, top - 3, "font-size=\"9\" fill=\"#5b6570\"",
                   labels[i].letters);
      }
      sink.text("<g fill=\"none\">\n");
      write_panel(sink, (*panels)[row],
                  {x, top, kPanelWidth, kPanelHeight, from_, to_, row + 1 == panels->size(),
                   options_.axis == PlotAxis::index});
      sink.text("</g>\n");
    }
    write_text(sink, x + kPanelWidth / 2, bottom + 36, "text-anchor=\"middle\" font-size=\"11.5\"",
               axis_title(options_));
  }
  for (std::size_t i = 0; i < explanations.size(); ++i) {
    const std::size_t row = i / 4, column = i % 4;
    write_text(sink, kLeft + 215 * static_cast<double>(column),
               bottom + 62 + 17 * static_cast<double>(row), "fill=\"#5b6570\"", explanations[i]);
  }
  sink.text("</svg>\n");
  sink.flush();
}

template class SignaturePlot<2>;
template class SignaturePlot<3>;

}  // namespace orthoball
