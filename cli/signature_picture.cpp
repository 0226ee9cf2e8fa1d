// SPDX-License-Identifier: MIT
#include "cli/signature_picture.h"

#include <fmt/format.h>

#include <utility>

#include "cli/output_file.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"

std::string name_of(const InputOptions& options) {
  if (options.path == "-") return "standard input";
  return options.path.substr(options.path.find_last_of('/') + 1);
}

void require_svg(const std::string& option, const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending.empty() || ending == "svg") return;
  throw UsageError(fmt::format("{} {}: a picture is SVG; the name must end in .svg", option, path));
}

void check_plot(const std::string& option, const std::string& path, const std::string& output,
                const InputOptions& input) {
  if (path.empty()) return;
  if (is_same_output(path, output)) {
    throw UsageError(option + " and -o name the same file; each needs one of its own");
  }
  require_other_file(input, path);
  require_svg(option, path);
}

orthoball::PlotAxis plot_axis(const std::string& name) {
  return name == "alpha2"  ? orthoball::PlotAxis::alpha2
         : name == "index" ? orthoball::PlotAxis::index
                           : orthoball::PlotAxis::alpha;
}

orthoball::PlotOptions plot_options(const InputOptions& options, const Loaded& input) {
  const orthoball::WeightedPoints& points = input.shapes.points();
  orthoball::PlotOptions plot;
  plot.title = name_of(options);
  plot.subtitle = fmt::format(
      "{}, weights: {}", orthoball::counted(points.size(), "site"),
      points.weight_kind() == orthoball::WeightKind::none ? "none" : input.reading.radii);
  plot.unit = input.unit();
  return plot;
}

template <int D>
void write_signature_picture(const std::string& path, const InputOptions& options,
                             const orthoball::Filtration<D>& filtration,
                             orthoball::PlotOptions plot) {
  require_memory(options, orthoball::signature_memory(filtration.size()), "the signatures");
  for (const auto& notable : orthoball::notable_alphas(filtration)) {
    if (notable.index) plot.marks.push_back({notable.name, *notable.index, notable.alpha2});
  }
  orthoball::SignaturePlot<D> picture(filtration, std::move(plot));
  orthoball::scan_signatures<D>(
      filtration, [&](const orthoball::Signature<D>& s) { picture.add(s); }, threads_of(options));
  write_output(path, "0", [&](orthoball::ByteSink& sink) { picture.write(sink); });
}

template void write_signature_picture<2>(const std::string&, const InputOptions&,
                                         const orthoball::Filtration<2>&, orthoball::PlotOptions);
template void write_signature_picture<3>(const std::string&, const InputOptions&,
                                         const orthoball::Filtration<3>&, orthoball::PlotOptions);
