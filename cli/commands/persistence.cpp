// SPDX-License-Identifier: MIT
#include "orthoball/topology/persistence.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/query_memory.h"
#include "cli/signature_picture.h"
#include "cli/usage_error.h"
#include "orthoball/output/persistence_plot.h"
#include "orthoball/output/persistence_table.h"
#include "orthoball/output/representative_files.h"
#include "orthoball/queries/representatives.h"

namespace {

struct PersistenceOptions {
  InputOptions input;
  std::optional<unsigned> dimension;
  std::string minimum_length;
  bool all = false;
  bool indices = false;
  std::string output = "-";
  std::string format;  // csv, json, gudhi; empty: from the name of the output
  bool json = false;
  std::string plot;
  std::string plot_kind = "diagram";
  std::string plot_axis = "alpha";
  std::string representatives;         // a file, .json or .ply
  std::string representatives_alpha2;  // empty: each class at its usual index
};

std::string format_of(const PersistenceOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  return ending == "json" ? "json" : ending == "pers" ? "gudhi" : "csv";
}

// Those that were asked for.
template <int D>
orthoball::PersistencePairs<D> chosen_pairs(const PersistenceOptions& options,
                                            const orthoball::Filtration<D>& filtration) {
  using orthoball::WantedPairs;
  auto pairs = orthoball::persistence_pairs(
      filtration, options.all ? WantedPairs::all : WantedPairs::lasting, threads_of(options.input));
  for (unsigned k = 0; k < D; ++k) {
    if (options.dimension && *options.dimension != k) pairs[k].clear();
  }
  if (options.minimum_length.empty()) return pairs;
  const double least = alpha2_from_text("--minimum-length", options.minimum_length);
  return orthoball::pairs_of_length<D>(filtration, std::move(pairs), least);
}

template <int D>
void write_plot(const PersistenceOptions& options, const Loaded& input,
                const orthoball::Filtration<D>& filtration,
                const orthoball::PersistencePairs<D>& pairs) {
  const orthoball::PlotOptions of_input = plot_options(options.input, input);
  orthoball::PersistencePlotOptions plot;
  plot.title = of_input.title;
  plot.subtitle = of_input.subtitle;
  plot.unit = of_input.unit;
  plot.axis = plot_axis(options.plot_axis);
  plot.picture = options.plot_kind == "barcode" ? orthoball::PersistencePicture::barcode
                                                : orthoball::PersistencePicture::diagram;
  write_output(options.plot, "0", [&](orthoball::ByteSink& sink) {
    write_persistence_plot<D>(sink, filtration, pairs, plot);
  });
}

// What representatives take, in bytes, once they are found and once they are a mesh.
std::uint64_t bytes_of(const orthoball::Representative& one) {
  std::size_t numbers = one.rows.size() + one.cycle.size() + one.cells.size();
  for (const auto& ring : one.rings) numbers += ring.size() + 8;
  return sizeof(one) + sizeof(std::uint32_t) * numbers;
}
constexpr std::uint64_t kMeshOfFound = 4;

// Of those found so far, of which there may be many that have much; asks for memory ahead.
class Found {
 public:
  Found(const InputOptions& input, bool is_mesh) : input_(input), is_mesh_(is_mesh) {}

  void add(orthoball::Representative&& one) {
    bytes_ += bytes_of(one);
    if (bytes_ > asked_) {
      asked_ = bytes_ + kAhead;
      require_memory(input_, kAhead + (is_mesh_ ? kMeshOfFound * asked_ : 0),
                     "what makes the classes");
    }
    all_.push_back(std::move(one));
  }
  [[nodiscard]] const std::vector<orthoball::Representative>& all() const { return all_; }

 private:
  static constexpr std::uint64_t kAhead = std::uint64_t{16} << 20U;

  const InputOptions& input_;
  bool is_mesh_;
  std::uint64_t bytes_ = 0, asked_ = 0;
  std::vector<orthoball::Representative> all_;
};

// What makes the classes that are written, of those that live where they are to be shown.
template <int D>
void write_representatives(const PersistenceOptions& options, const Loaded& input,
                           const orthoball::Filtration<D>& filtration,
                           const orthoball::PersistencePairs<D>& pairs) {
  require_memory(options.input, representatives_memory(D, filtration.size()),
                 "what makes the classes");
  const bool is_mesh = ending_of(options.representatives) == "ply";
  const auto all = orthoball::persistence_pairs(filtration, orthoball::WantedPairs::all,
                                                threads_of(options.input));
  orthoball::Representatives<D> representatives(filtration, all);
  Found found(options.input, is_mesh);
  for (int k = 0; k < D; ++k) {
    for (const orthoball::PersistencePair& pair : pairs[static_cast<std::size_t>(k)]) {
      const std::uint32_t index =
          options.representatives_alpha2.empty()
              ? representatives.usual_index(k, pair)
              : filtration.index(
                    alpha2_from_text("--representatives-alpha2", options.representatives_alpha2));
      const bool is_over = pair.death.exists() && filtration.enters(pair.death) <= index;
      if (is_over || filtration.enters(pair.birth) > index) continue;
      found.add(representatives.at(k, pair, index));
    }
  }
  const std::size_t missing =
      write_output(options.representatives, "null", [&](orthoball::ByteSink& sink) {
        if (is_mesh) {
          write_representatives_ply<D>(sink, filtration, input.shapes.points(), found.all());
        } else {
          write_representatives_json<D>(sink, filtration, found.all());
        }
      });
  warn_of_missing(options.input, missing, "null");
}

void check_representatives(const PersistenceOptions& options) {
  if (options.representatives.empty()) return;
  const std::string ending = ending_of(options.representatives);
  if (ending != "json" && ending != "ply") {
    throw UsageError(fmt::format(
        "--representatives {}: they are JSON or PLY; the name must end in .json or .ply",
        options.representatives));
  }
  require_other_file(options.input, options.representatives);
  for (const std::string& other : {options.output, options.plot}) {
    if (!other.empty() && is_same_output(options.representatives, other)) {
      throw UsageError(
          "--representatives and another option name the same file; each needs one of "
          "its own");
    }
  }
  if (!options.representatives_alpha2.empty()) {
    (void)alpha2_from_text("--representatives-alpha2", options.representatives_alpha2);
  }
}

void run(const PersistenceOptions& options) {
  require_other_file(options.input, options.output);
  check_representatives(options);
  check_plot("--plot", options.plot, options.output, options.input);
  if (!options.minimum_length.empty() &&
      !(alpha2_from_text("--minimum-length", options.minimum_length) >= 0.0)) {
    throw UsageError("--minimum-length: a length of lives is 0 or more");
  }
  const std::string format = format_of(options);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::pairing});
  const Loaded input = load(options.input, progress);
  progress.begin(Stage::pairing);
  std::size_t missing = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        if (options.dimension && *options.dimension >= D) {
          throw UsageError(fmt::format(
              "--homology-dimension {}: these points have classes of the dimensions 0 to {}",
              *options.dimension, D - 1));
        }
        require_memory(options.input, orthoball::persistence_memory(filtration.size(), options.all),
                       "the pairs");
        const auto pairs = chosen_pairs(options, filtration);
        if (!options.plot.empty()) write_plot(options, input, filtration, pairs);
        if (!options.representatives.empty()) {
          write_representatives<D>(options, input, filtration, pairs);
        }
        const auto values = options.indices ? orthoball::PersistenceValues::index
                                            : orthoball::PersistenceValues::alpha2;
        missing = write_output(options.output, format == "json" ? "null" : "",
                               [&](orthoball::ByteSink& sink) {
                                 if (format == "csv")
                                   write_persistence_csv<D>(sink, filtration, pairs, values);
                                 if (format == "json")
                                   write_persistence_json<D>(sink, filtration, pairs, values);
                                 if (format == "gudhi")
                                   write_persistence_gudhi<D>(sink, filtration, pairs, values);
                               });
      },
      input.shapes.filtration());
  progress.end();
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

void add_output_options(CLI::App& command, PersistenceOptions& options) {
  const std::string group = "Output";
  add_data_options(command, {options.output, options.format, options.json},
                   {"file, or - for standard output",
                    "csv, json or gudhi (lines \"2 dimension birth death\")\n"
                    "(default: by the name of -o, .pers for gudhi, else csv)",
                    {"csv", "json", "gudhi"}});
  auto* const plot = add_plot_option(command, options.plot, "them");
  command.add_option("--plot-kind", options.plot_kind, "diagram or barcode")
      ->type_name("NAME")
      ->check(CLI::IsMember({"diagram", "barcode"}).description(""))
      ->capture_default_str()
      ->needs(plot)
      ->group(group);
  add_plot_axis_option(command, options.plot_axis, plot);
}

void add_representative_options(CLI::App& command, PersistenceOptions& options) {
  const std::string group = "Representatives";
  auto* const representatives =
      command
          .add_option("--representatives", options.representatives,
                      "also write what makes each class, as .json or .ply")
          ->type_name("FILE")
          ->group(group);
  command
      .add_option("--representatives-alpha2", options.representatives_alpha2,
                  "of the classes that live there, as they are there [length^2]\n"
                  "(default: all; components at their end, tunnels half way in alpha2,\n"
                  "voids at their birth)")
      ->type_name("X")
      ->needs(representatives)
      ->group(group);
}

}  // namespace

void add_persistence_command(CLI::App& app) {
  auto options = std::make_shared<PersistenceOptions>();
  CLI::App* command = app.add_subcommand(
      "persistence", "Births and deaths of components, tunnels and voids, with a diagram.");
  const std::string group = "Pairs";
  command->add_option("--homology-dimension", options->dimension, "classes of this dimension only")
      ->type_name("K")
      ->check(whole_number(0, 2))
      ->group(group);
  command
      ->add_option("--minimum-length", options->minimum_length,
                   "only what lives so long: death less birth [length^2]")
      ->type_name("X")
      ->group(group);
  command
      ->add_flag("--all", options->all,
                 "also pairs whose birth and death are one index: all simplices are listed")
      ->group(group);
  command
      ->add_flag("--indices", options->indices,
                 "births and deaths as indices of the spectrum instead of alpha2")
      ->group(group);
  add_output_options(*command, *options);
  add_representative_options(*command, *options);
  add_input_options(*command, options->input);
  command->footer(
      "Columns: dimension (0 components, 1 tunnels, in the plane holes, 2 voids); birth and death\n"
      "[length^2], alpha2 at which a class is there and is no more, death empty for never (null,\n"
      "inf in gudhi); birth_simplex and death_simplex, the rows of the simplices that close its\n"
      "first cycle and fill its last. Over Z/2, exact: equal values are one index of the "
      "spectrum.\n"
      "Representatives: of a component its sites; of a void (in the plane: hole) its cells, what\n"
      "encloses them, volume and area; of a tunnel a short cycle that belongs to it, and the\n"
      "triangle that fills it.\n"
      "By dimension, then by birth. At every alpha2 as many classes live as the Betti numbers "
      "say.\n\n"
      "Examples:\n"
      "  orthoball persistence linked_tori.csv --minimum-length 0.1\n"
      "  orthoball persistence points.csv -o pairs.csv --plot diagram.svg\n"
      "  orthoball persistence 1ubq.pdb --homology-dimension 2 --plot bars.svg --plot-kind "
      "barcode\n"
      "  orthoball persistence points.csv -o diagram.pers\n"
      "  orthoball persistence 1grm.pdb --minimum-length 3 --representatives classes.ply");
  command->callback([options] { run(*options); });
}
