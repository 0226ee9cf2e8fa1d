// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/step_curve.h"
#include "orthoball/signatures/signature.h"

namespace orthoball {

/// What runs along the horizontal axis of a plot.
enum class PlotAxis { alpha, alpha2, index };

/// A value of the parameter worth a vertical line.
struct PlotMark {
  std::string name;
  std::uint32_t index;
  double alpha2;
};

/// How a plot is labelled and what part of it is shown.
struct PlotOptions {
  std::string title;                ///< the file; shortened where it is too long
  std::string subtitle;             ///< what was read; shortened as well
  std::string unit;                 ///< of lengths, "Å"; empty where it is not known
  PlotAxis axis = PlotAxis::alpha;  ///< what runs from left to right
  /// Ends of the axis, in its own unit. Empty: from the first entry of the spectrum to a quarter
  /// past the last change of the topology, unless that is twelve times as far as the entry by which
  /// four fifths of the top simplices have entered: then to a quarter past that.
  std::optional<std::pair<double, double>> range;
  std::vector<PlotMark> marks;  ///< those in the range are drawn, the others listed below
};

/// Signatures as functions of alpha in one SVG: a panel for each Betti number, for volume, area by
/// role and (in space) length. Takes one signature after the other and keeps what can be seen.
template <int D>
class SignaturePlot {
 public:
  SignaturePlot(const Filtration<D>& filtration, PlotOptions options);

  /// The signature of the next index; indices must ascend.
  void add(const Signature<D>& signature);
  /// @throws OutputError
  void write(ByteSink& sink) const;

 private:
  [[nodiscard]] double position(std::uint32_t index, double alpha2) const;

  PlotOptions options_;
  double from_, to_;
  double last_;                    // position of the last entry of the spectrum
  std::vector<StepCurve> curves_;  // betti, volume, area, area_regular, area_singular, length
};

extern template class SignaturePlot<2>;  // defined in signature_plot.cpp
extern template class SignaturePlot<3>;

}  // namespace orthoball
