// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/query_memory.h"
#include "cli/usage_error.h"
#include "cli/viewer_page.h"
#include "orthoball/error.h"
#include "orthoball/output/page.h"
#include "orthoball/output/snapshot.h"
#include "orthoball/output/snapshot_cycles.h"

extern char** environ;

namespace {

constexpr std::string_view kGenerator = "<meta name=\"generator\" content=\"orthoball";

struct ViewOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string output;  // empty: by the name of the input
  bool no_open = false;
};

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// Whether a file can be replaced without asking: it is a page that this program has written.
bool is_page(const std::string& path) {
  std::string begin(2000, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find(kGenerator) != std::string::npos;
}

// NAME.html in the current folder for FOLDER/NAME.pdb.gz.
std::string output_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  if (options.input.path == "-") {
    throw UsageError("view -: standard input has no name for the page; -o FILE gives one");
  }
  std::filesystem::path name = file_name(options.input.path);
  if (ending_of(name.string()) == "gz") name.replace_extension();
  std::string output = name.replace_extension(".html").string();
  if (std::filesystem::exists(output) && !is_page(output)) {
    throw UsageError(output + ": is not a page of orthoball and will not be replaced; -o FILE " +
                     "names another file, or this one if it is meant");
  }
  return output;
}

orthoball::SnapshotFacts facts_of(const ViewOptions& options, const Loaded& input) {
  const auto given = chosen_alphas(options.alpha, input);
  const ChosenAlpha start = given.empty() ? automatic_alpha(input) : given[0];
  if (!given.empty()) say_how(options.input, given);
  const bool has_weights = input.shapes.points().weight_kind() != orthoball::WeightKind::none;
  return {.source = options.input.path == "-" ? "standard input" : file_name(options.input.path),
          .unit = input.unit(),
          .radii = input.reading.radii,
          .weights = !has_weights                ? orthoball::WeightMeaning::none
                     : input.reading.is_molecule ? orthoball::WeightMeaning::molecule_radii
                                                 : orthoball::WeightMeaning::given,
          .index = start.index,
          .alpha2 = start.alpha2,
          .chosen_because = start.reason};
}

// Shows a file as the desktop does. Nothing is said where that fails: its path is.
void open_page(const std::string& path) {
  const auto is_set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
#ifdef __APPLE__
  std::string program = "open";
#else
  std::string program = "xdg-open";
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) return;
#endif
  std::string name = std::filesystem::absolute(path).string();
  const std::array<char*, 3> arguments{program.data(), name.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // On its own, so that it does not end with the terminal, and with the usual effect of signals.
  posix_spawnattr_t alone;
  posix_spawnattr_init(&alone);
  posix_spawnattr_setflags(&alone, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);
  sigset_t ours;
  sigemptyset(&ours);
  sigaddset(&ours, SIGPIPE);
  sigaddset(&ours, SIGXFSZ);
  posix_spawnattr_setsigdefault(&alone, &ours);
  pid_t child = 0;
  posix_spawnp(&child, program.c_str(), &quiet, &alone, arguments.data(), environ);
  posix_spawnattr_destroy(&alone);
  posix_spawn_file_actions_destroy(&quiet);
}

void run(const ViewOptions& options) {
  if (viewer_page().empty()) {
    throw orthoball::LimitError(
        "view: this orthoball was built without the viewer; a build finds Node 20 after "
        "./bootstrap viewer");
  }
  const std::string output = output_of(options);
  require_other_file(options.input, output);
  check(options.alpha, false);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::writing_page});
  const Loaded input = load(options.input, progress);
  const orthoball::SnapshotFacts facts = facts_of(options, input);
  progress.begin(Stage::writing_page);
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        const std::size_t size = filtration.size();
        const bool has_cycles = D == 3 && size <= orthoball::kMostSimplicesForCycles;
        require_memory(options.input,
                       orthoball::signature_memory(size) +
                           (has_cycles ? representatives_memory(D, size)
                                       : orthoball::persistence_memory(size, false)) +
                           std::uint64_t{48} * filtration.spectrum_size(),
                       "the page");
      },
      input.shapes.filtration());
  write_output(output, "", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&](const auto& filtration) {
          write_page(sink, viewer_page(), filtration, input.shapes.points(), input.reading.labels,
                     facts, threads_of(options.input));
        },
        input.shapes.filtration());
  });
  progress.end();
  if (output == "-") return;
  write_output("-", "", [&](orthoball::ByteSink& sink) {
    sink.text(output + "\n");
    sink.flush();
  });
  if (!options.no_open && isatty(STDOUT_FILENO) == 1) open_page(output);
}

}  // namespace

void add_view_command(CLI::App& app) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
      app.add_subcommand("view", "Every shape in one HTML file, to be looked at in a browser.");
  add_alpha_options(*command, options->alpha, false, "auto; the page shows it first");
  const std::string group = "Output";
  command
      ->add_option("-o,--output", options->output,
                   "file, or - for standard output\n(default: the name of INPUT with .html, here)")
      ->type_name("FILE")
      ->group(group);
  command
      ->add_flag("--no-open", options->no_open,
                 "do not open the page; only done from a terminal with a display")
      ->group(group);
  add_input_options(*command, options->input);
  command->footer(
      "The page holds the viewer and the data: it needs no server, no network and no Orthoball, "
      "and\n"
      "can be mailed and kept. Its path is printed. In it the signatures are the slider; arrow "
      "keys\n"
      "go from one event to the next.\n\n"
      "--alpha2 auto: as in shape.\n\n"
      "Examples:\n"
      "  orthoball view 1ubq.pdb\n"
      "  orthoball view bunny.off --alpha 0.004 -o bunny.html");
  command->callback([options] { run(*options); });
}
