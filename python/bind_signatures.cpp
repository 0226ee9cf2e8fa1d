// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/filtration/alpha.h"
#include "orthoball/output/ball_signature_tables.h"
#include "orthoball/output/signature_table.h"
#include "orthoball/signatures/ball_signature.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/plot_axis.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::Signature;

namespace {

// The columns of many signatures.
struct Columns {
  explicit Columns(std::size_t size) {
    for (auto* const column :
         {&alpha2, &alpha, &volume, &area_singular, &area_regular, &area, &length}) {
      column->reserve(size);
    }
  }
  template <int D>
  void add(const Signature<D>& s) {
    index.push_back(s.index);
    alpha2.push_back(s.alpha2);
    alpha.push_back(orthoball::alpha_from_alpha2(s.alpha2));
    betti.insert(betti.end(), s.betti.begin(), s.betti.end());
    euler.push_back(s.euler);
    exterior.insert(exterior.end(), s.exterior.begin(), s.exterior.end());
    singular.insert(singular.end(), s.singular.begin(), s.singular.end());
    regular.insert(regular.end(), s.regular.begin(), s.regular.end());
    interior.insert(interior.end(), s.interior.begin(), s.interior.end());
    volume.push_back(s.volume);
    area_singular.push_back(s.area_singular);
    area_regular.push_back(s.area_regular);
    area.push_back(s.area);
    length.push_back(s.length);
  }

  std::vector<std::uint32_t> index, betti, exterior, singular, regular, interior;
  std::vector<std::int64_t> euler;
  std::vector<double> alpha2, alpha, volume, area_singular, area_regular, area, length;
};

nb::dict as_dict(Columns columns, int dimension) {
  const std::size_t size = columns.index.size();
  const auto d = static_cast<std::size_t>(dimension);
  nb::dict result;
  const auto add = [&](const char* name, auto& column, std::size_t width) {
    using T = typename std::remove_reference_t<decltype(column)>::value_type;
    result[name] =
        width == 1 ? owned<T>(std::move(column)) : owned<T>(std::move(column), {size, width});
  };
  add("index", columns.index, 1);
  add("alpha2", columns.alpha2, 1);
  add("alpha", columns.alpha, 1);
  add("betti", columns.betti, d);
  add("euler", columns.euler, 1);
  add("exterior", columns.exterior, d + 1);
  add("singular", columns.singular, d + 1);
  add("regular", columns.regular, d + 1);
  add("interior", columns.interior, d + 1);
  add("volume", columns.volume, 1);
  add("area_singular", columns.area_singular, 1);
  add("area_regular", columns.area_regular, 1);
  add("area", columns.area, 1);
  if (dimension == 3) add("length", columns.length, 1);
  return result;
}

nb::dict signatures(const AlphaShapes& shapes,
                    const std::optional<Given<std::uint32_t, 1>>& indices,
                    std::optional<unsigned> threads) {
  Columns columns = without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    if (indices) {
      Columns some(indices->size());
      const std::span wanted(indices->data(), indices->size());
      for (const auto& s : orthoball::signatures<D>(filtration, wanted, threads_of(threads))) {
        some.add(s);
      }
      return some;
    }
    Columns all(filtration.spectrum_size());
    orthoball::scan_signatures<D>(
        filtration, [&](const Signature<D>& s) { all.add(s); }, threads_of(threads));
    return all;
  });
  return as_dict(std::move(columns), shapes.dimension());
}

// The unions at some alpha2, each with the index of its dual complex.
std::vector<orthoball::BallAlpha> ball_alphas(const Given<std::uint32_t, 1>& indices,
                                              const Given<double, 1>& alpha2) {
  if (indices.size() != alpha2.size()) refuse("there must be as many indices as alpha2");
  std::vector<orthoball::BallAlpha> wanted;
  for (std::size_t i = 0; i < alpha2.size(); ++i) {
    wanted.push_back({indices.data()[i], alpha2.data()[i]});
  }
  return wanted;
}

nb::dict ball_signatures(const AlphaShapes& shapes, const Given<std::uint32_t, 1>& indices,
                         const Given<double, 1>& alpha2_of, std::optional<unsigned> threads) {
  const auto wanted = ball_alphas(indices, alpha2_of);
  std::vector<std::uint32_t> index, betti;
  std::vector<double> alpha2s, alphas, volume, area;
  std::vector<std::int64_t> euler;
  without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    for (const auto& s : orthoball::ball_signatures<D>(filtration, wanted, threads_of(threads))) {
      index.push_back(s.index);
      alpha2s.push_back(s.alpha2);
      alphas.push_back(orthoball::alpha_from_alpha2(s.alpha2));
      betti.insert(betti.end(), s.betti.begin(), s.betti.end());
      euler.push_back(s.euler);
      volume.push_back(s.volume);
      area.push_back(s.area);
    }
  });
  const std::size_t size = index.size();
  nb::dict result;
  result["index"] = owned<std::uint32_t>(std::move(index));
  result["alpha2"] = owned<double>(std::move(alpha2s));
  result["alpha"] = owned<double>(std::move(alphas));
  result["betti"] =
      owned<std::uint32_t>(std::move(betti), {size, static_cast<std::size_t>(shapes.dimension())});
  result["euler"] = owned<std::int64_t>(std::move(euler));
  result["volume"] = owned<double>(std::move(volume));
  result["area"] = owned<double>(std::move(area));
  return result;
}

void check_table_format(const std::string& format) {
  if (format == "csv" || format == "json" || format == "npz") return;
  refuse_format(format, "csv, json and npz");
}

nb::bytes signature_file(const AlphaShapes& shapes,
                         const std::optional<Given<std::uint32_t, 1>>& indices,
                         const std::string& format, std::optional<unsigned> threads) {
  using orthoball::SignatureFormat;
  check_table_format(format);
  const auto wanted_format = format == "csv"    ? SignatureFormat::csv
                             : format == "json" ? SignatureFormat::json
                                                : SignatureFormat::npz;
  return written(format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&]<int D>(const Filtration<D>& filtration) {
          orthoball::SignatureTable<D> table(sink, wanted_format);
          const auto add = [&](const Signature<D>& s) {
            table.add({s, orthoball::alpha_from_alpha2(s.alpha2)});
          };
          if (indices) {
            const std::span wanted(indices->data(), indices->size());
            for (const auto& s : orthoball::signatures<D>(filtration, wanted, threads_of(threads)))
              add(s);
          } else {
            orthoball::scan_signatures<D>(filtration, add, threads_of(threads));
          }
          table.finish();
        },
        shapes.filtration());
  });
}

nb::bytes ball_signature_file(const AlphaShapes& shapes, const Given<std::uint32_t, 1>& indices,
                              const Given<double, 1>& alpha2, const std::string& format,
                              std::optional<unsigned> threads) {
  check_table_format(format);
  const auto wanted = ball_alphas(indices, alpha2);
  return written(format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&]<int D>(const Filtration<D>& filtration) {
          std::vector<orthoball::BallSignatureRow<D>> rows;
          for (const auto& s :
               orthoball::ball_signatures<D>(filtration, wanted, threads_of(threads))) {
            rows.push_back({s, orthoball::alpha_from_alpha2(s.alpha2)});
          }
          if (format == "csv") write_ball_signatures_csv<D>(sink, rows);
          if (format == "json") write_ball_signatures_json<D>(sink, rows);
          if (format == "npz") write_ball_signatures_npz<D>(sink, rows);
        },
        shapes.filtration());
  });
}

nb::bytes signature_figure(const AlphaShapes& shapes, const std::string& axis,
                           std::optional<std::pair<double, double>> range, const std::string& title,
                           const std::string& subtitle, const std::string& unit,
                           std::optional<unsigned> threads) {
  if (range && !(range->first < range->second)) {
    refuse("the range is two numbers, the first less than the second");
  }
  const orthoball::PlotOptions options{.title = title,
                                       .subtitle = subtitle,
                                       .unit = unit,
                                       .axis = plot_axis(axis),
                                       .range = range,
                                       .marks = {}};
  return written("0", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&]<int D>(const Filtration<D>& filtration) {
          orthoball::PlotOptions marked = options;
          for (const auto& notable : orthoball::notable_alphas(filtration)) {
            if (!notable.index) continue;
            marked.marks.push_back({notable.name, *notable.index, notable.alpha2});
          }
          orthoball::SignaturePlot<D> plot(filtration, std::move(marked));
          orthoball::scan_signatures<D>(
              filtration, [&](const Signature<D>& s) { plot.add(s); }, threads_of(threads));
          plot.write(sink);
        },
        shapes.filtration());
  });
}

nb::tuple as_tuple(const orthoball::NotableAlpha& notable) {
  return nb::make_tuple(notable.name, notable.reason, notable.index, notable.alpha2, notable.alpha);
}

nb::list notable_alphas(const AlphaShapes& shapes) {
  nb::list result;
  const auto notables =
      without_gil(shapes, [](const auto& f) { return orthoball::notable_alphas(f); });
  for (const auto& notable : notables) result.append(as_tuple(notable));
  return result;
}

nb::tuple automatic_alpha(const AlphaShapes& shapes, bool is_molecule) {
  const orthoball::WeightMeaning meaning = meaning_of_weights(shapes, is_molecule);
  return as_tuple(without_gil(shapes, [&](const auto& f) {
    return orthoball::automatic_alpha(f, orthoball::notable_alphas(f), meaning);
  }));
}

}  // namespace

void bind_signatures(nb::module_& module) {
  module.def("signatures", &signatures, nb::arg("shapes"), nb::arg("indices").none(),
             nb::arg("threads").none(),
             "Columns of the signatures at some indices, or at all from 1 on.");
  module.def("ball_signatures", &ball_signatures, nb::arg("shapes"), nb::arg("indices"),
             nb::arg("alpha2"), nb::arg("threads").none(),
             "Columns of the unions of balls at some alpha2.");
  module.def("signature_file", &signature_file, nb::arg("shapes"), nb::arg("indices").none(),
             nb::arg("format"), nb::arg("threads").none(),
             "Signatures as a table: csv, json or npz.");
  module.def("ball_signature_file", &ball_signature_file, nb::arg("shapes"), nb::arg("indices"),
             nb::arg("alpha2"), nb::arg("format"), nb::arg("threads").none(),
             "Unions of balls as a table: csv, json or npz.");
  module.def("signature_figure", &signature_figure, nb::arg("shapes"), nb::arg("axis"),
             nb::arg("range").none(), nb::arg("title"), nb::arg("subtitle"), nb::arg("unit"),
             nb::arg("threads").none(), "Signatures as SVG.");
  module.def("notable_alphas", &notable_alphas, nb::arg("shapes"),
             "A tuple (name, reason, index or None, alpha2, alpha) for each.");
  module.def("automatic_alpha", &automatic_alpha, nb::arg("shapes"), nb::arg("is_molecule"),
             "The same of the one that is taken where none is named.");
}
