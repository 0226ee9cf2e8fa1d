// SPDX-License-Identifier: MIT
#include "orthoball/output/plot_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "orthoball/output/plot_text.h"

namespace orthoball {
namespace {

constexpr double kMostOnLinearScale = 50.0;  // counts above are shown logarithmically
constexpr double kTitleHeight = 16.0;        // of the title above the frame
constexpr double kFontSize = 10.5;           // of numbers
constexpr std::string_view kMuted = "#5b6570", kGrid = "#e3e7eb", kAxis = "#8a949e";

std::string pixel(double x) { return fmt::format("{}", std::round(100 * x) / 100 + 0.0); }

double tick_step(double low, double high, int wanted) {
  const double rough = (high - low) / std::max(wanted, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  if (rough < 1.5 * power) return power;
  if (rough < 3.5 * power) return 2.0 * power;
  return rough < 7.5 * power ? 5.0 * power : 10.0 * power;
}

// Maps values to heights in a panel and knows the ticks. Counts that are many are mapped by the
// logarithm of 1 + 2 count, so that 0 has a place, and room for its number below that of 1; large
// and small measures by a power of ten.
class ValueAxis {
 public:
  explicit ValueAxis(const PlotPanel& panel) {
    for (const PlotCurve& curve : panel.curves) {
      low_ = std::min(low_, curve.curve->low());
      high_ = std::max(high_, curve.curve->high());
    }
    if (!std::isfinite(low_)) low_ = 0.0;
    if (!std::isfinite(high_)) high_ = std::max(1.0, low_);
    if (low_ == high_) high_ = low_ + 1.0;
    is_logarithmic_ = panel.is_count && high_ > kMostOnLinearScale;
    if (is_logarithmic_) {
      for (double tick = 1.0; tick <= high_; tick *= 10.0) ticks_.push_back(tick);
      ticks_.insert(ticks_.begin(), 0.0);
      top_ = 1.06 * logarithm(high_);
      return;
    }
    const int exponent = static_cast<int>(std::floor(std::log10(std::max(high_, -low_))));
    if (!panel.is_count && (exponent >= 6 || exponent <= -4)) exponent_ = exponent;
    high_ += 0.06 * (high_ - low_);
    if (low_ < 0.0) low_ -= 0.06 * (high_ - low_);
    const double unit = std::pow(10.0, exponent_);
    step_ = tick_step(low_ / unit, high_ / unit, 4) * unit;
    if (panel.is_count) step_ = std::max(step_, 1.0);
    for (double k = std::ceil(low_ / step_); k * step_ <= high_; ++k) ticks_.push_back(k * step_);
  }

  // 0 at the bottom of the panel, 1 at its top.
  [[nodiscard]] double height(double value) const {
    const double clamped = std::clamp(value, low_, high_);
    return is_logarithmic_ ? logarithm(clamped) / top_ : (clamped - low_) / (high_ - low_);
  }
  [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }
  [[nodiscard]] std::string text(double tick) const {
    const double unit = std::pow(10.0, exponent_);
    return tick_text(tick / unit, is_logarithmic_ ? 1.0 : step_ / unit);
  }
  // "10^6 " as people write it, for the unit of the axis; empty for 10^0.
  [[nodiscard]] std::string factor() const {
    if (exponent_ == 0) return {};
    return fmt::format(
        "10<tspan dy=\"-4\" font-size=\"8\">{}</tspan><tspan dy=\"4\">\u2009</tspan>", exponent_);
  }
  [[nodiscard]] bool is_logarithmic() const { return is_logarithmic_; }

 private:
  static double logarithm(double count) { return std::log1p(2.0 * count); }

  double low_ = 0.0, high_ = 0.0, step_ = 1.0;
  double top_ = 1.0;  // logarithm at the top of the panel
  int exponent_ = 0;
  bool is_logarithmic_ = false;
  std::vector<double> ticks_;
};

void write_line(ByteSink& sink, double x1, double y1, double x2, double y2,
                std::string_view colour) {
  sink.text(fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"{}\"/>\n", pixel(x1), pixel(y1),
                        pixel(x2), pixel(y2), colour));
}

void write_label(ByteSink& sink, double x, double y, std::string_view anchor,
                 const std::string& text) {
  sink.text(fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                        pixel(x), pixel(y), anchor, kMuted, text));
}

double step_of(const std::vector<double>& ticks) {
  return ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
}

bool is_whole(double x) { return std::floor(x) == x; }

// As many ticks of the horizontal axis as have room for their numbers.
std::vector<double> ticks_with_room(const PlotFrame& frame) {
  constexpr int kMost = 7;
  constexpr double kBetweenNumbers = 9.0;
  std::vector<double> ticks;
  for (int wanted = kMost; wanted > 0; --wanted) {
    ticks = tick_values(frame.from, frame.to, wanted);
    const double step = step_of(ticks);
    double widest = 0.0;
    for (const double tick : ticks) {
      widest = std::max(widest, text_width(tick_text(tick, step), kFontSize));
    }
    const double room = step / (frame.to - frame.from) * frame.width - kBetweenNumbers;
    if (widest <= room && (step >= 1.0 || !frame.is_whole)) break;
  }
  if (frame.is_whole && !std::all_of(ticks.begin(), ticks.end(), is_whole)) {
    // Even one tick wanted is too many: the axis is shorter than 2.
    ticks.clear();
    for (double k = std::ceil(frame.from); k <= frame.to; ++k) ticks.push_back(k);
  }
  return ticks;
}

void write_axes(ByteSink& sink, const PlotFrame& frame, const ValueAxis& axis) {
  const double bottom = frame.top + frame.height, right = frame.left + frame.width;
  for (const double tick : axis.ticks()) {
    const double y = bottom - axis.height(tick) * frame.height;
    write_line(sink, frame.left, y, right, y, kGrid);
    write_label(sink, frame.left - 7, y + 3.5, "end", axis.text(tick));
  }
  const std::vector<double> ticks = ticks_with_room(frame);
  const double step = step_of(ticks);
  for (const double tick : ticks) {
    const double x = frame.left + (tick - frame.from) / (frame.to - frame.from) * frame.width;
    write_line(sink, x, frame.top, x, bottom, kGrid);
    write_line(sink, x, bottom, x, bottom + 4, kAxis);
    if (frame.has_numbers) write_label(sink, x, bottom + 17, "middle", tick_text(tick, step));
  }
  write_line(sink, frame.left, bottom, right, bottom, kAxis);
}

void write_curve(ByteSink& sink, const PlotCurve& curve, const PlotFrame& frame,
                 const ValueAxis& axis) {
  const auto y = [&](double value) {
    return pixel(frame.top + (1.0 - axis.height(value)) * frame.height);
  };
  sink.text(
      fmt::format("<path class=\"curve\" stroke=\"{}\" stroke-width=\"1.6\" "
                  "stroke-linejoin=\"round\" d=\"M{} {}",
                  curve.colour, pixel(frame.left), y(curve.curve->initial())));
  for (const StepColumn& column : curve.curve->columns()) {
    sink.text(fmt::format("H{}", pixel(frame.left + column.x)));
    if (column.low != column.last) sink.text(fmt::format("V{}", y(column.low)));
    if (column.high != column.last) sink.text(fmt::format("V{}", y(column.high)));
    sink.text(fmt::format("V{}", y(column.last)));
  }
  sink.text(fmt::format("H{}\"/>\n", pixel(frame.left + frame.width)));
}

void write_legend(ByteSink& sink, const PlotPanel& panel, const PlotFrame& frame) {
  double x = frame.left + frame.width;
  for (auto curve = panel.curves.rbegin(); curve != panel.curves.rend(); ++curve) {
    if (curve->name.empty()) continue;
    write_label(sink, x, frame.top - kTitleHeight, "end", curve->name);
    x -= 6.0 * static_cast<double>(curve->name.size()) + 8;
    sink.text(fmt::format("<path d=\"M{} {}h14\" stroke=\"{}\" stroke-width=\"2.2\"/>\n",
                          pixel(x - 12), pixel(frame.top - kTitleHeight - 3.5), curve->colour));
    x -= 26;
  }
}

}  // namespace

std::vector<double> tick_values(double low, double high, int wanted) {
  if (!(low < high)) return {};
  const double step = tick_step(low, high, wanted);
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    ticks.push_back(k * step + 0.0);
  }
  return ticks;
}

std::string tick_text(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const std::size_t point = std::min(text.find('.'), text.size());
  for (std::size_t i = point; i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return value < 0.0 ? fmt::format("\u2212{}", text) : text;
}

void write_panel(ByteSink& sink, const PlotPanel& panel, const PlotFrame& frame) {
  const ValueAxis axis(panel);
  write_axes(sink, frame, axis);
  for (const PlotCurve& curve : panel.curves) write_curve(sink, curve, frame, axis);
  const std::string note = axis.factor() + panel.unit;
  sink.text(fmt::format(
      R"(<text x="{}" y="{}" font-size="12.5" fill="#1d2329"><tspan font-weight="600">{}</tspan>)"
      R"(<tspan dx="7" fill="{}" font-size="11">{}{}</tspan></text>)",
      pixel(frame.left), pixel(frame.top - kTitleHeight), xml_text(panel.title), kMuted, note,
      axis.is_logarithmic() ? "log scale" : ""));
  sink.text("\n");
  write_legend(sink, panel, frame);
}

}  // namespace orthoball
