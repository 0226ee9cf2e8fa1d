// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/output_file.h"
#include "cli/usage_error.h"
#include "orthoball/error.h"
#include "orthoball/large_blocks.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/version.h"

namespace {

constexpr int kDone = 0, kBadData = 1, kWrongUsage = 2, kCouldNot = 3;

int failed(int status, const std::string& message) {
  fmt::print(stderr, "orthoball: {}\n", message);
  return status;
}

// Options as "--name TYPE", without what CLI11 adds of their checks.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = option->get_type_name();
    if (!text.empty()) text.insert(0, 1, ' ');
    return text;
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::string value = option->get_default_str();
    return option->get_description() + (value.empty() ? "" : " (default: " + value + ")");
  }
};

// --help and --version are no errors, and their text is data like any other.
int answer(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) {
    std::string command;
    for (const CLI::App* sub : app.get_subcommands()) command = " " + sub->get_name();
    const std::vector<std::string> unknown = app.remaining();
    if (command.empty() && !unknown.empty()) {
      return failed(kWrongUsage,
                    fmt::format("there is no command or option \"{}\"; see orthoball --help",
                                unknown.front()));
    }
    if (command.empty()) return failed(kWrongUsage, "a command is needed; see orthoball --help");
    return failed(kWrongUsage, std::string(error.what()) + "; see orthoball" + command + " --help");
  }
  std::ostringstream text;
  app.exit(error, text);
  write_output("-", "", [&](orthoball::ByteSink& sink) {
    sink.text(text.str());
    sink.flush();
  });
  return kDone;
}

// An empty value, mostly of a shell variable that is not set, is not the same as none.
void refuse_empty_values(CLI::App& command) {
  const CLI::Validator not_empty(
      [](const std::string& value) -> std::string {
        return value.empty() ? "the value is empty; give one, or leave the option out" : "";
      },
      "");
  for (CLI::Option* option : command.get_options()) {
    const bool is_flag = option->get_expected_max() == 0;
    if (!is_flag) option->transform(not_empty);  // before the option's own checks
  }
}

void add_commands(CLI::App& app) {
  app.name("orthoball");
  app.set_version_flag("--version", std::string("orthoball ") + orthoball::kVersion,
                       "print the version and exit");
  app.require_subcommand(1);
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(28);
  app.set_help_flag("-h,--help", "print this and exit");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND INPUT");
  app.get_formatter()->label("Subcommands", "Commands");
  for (const auto add :
       {add_summary_command, add_signatures_command, add_shape_command, add_locate_command,
        add_filter_command, add_measure_command, add_pockets_command, add_persistence_command,
        add_alpha_command, add_figure_command, add_enforce_command, add_view_command}) {
    add(app);
  }
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_values(*command);
  app.footer(
      "Everything is computed exactly; printed numbers are rounded once. Lengths are in the unit\n"
      "of the input (ångström for molecules), alpha2 and areas in its square.\n"
      "Exit status: 0 done, 1 bad data, 2 wrong usage, 3 could not (memory, limit, output).\n\n"
      "Examples:\n"
      "  orthoball summary 1crn.cif\n"
      "  orthoball signatures 1ubq.pdb -o table.csv --plot signatures.svg\n"
      "  orthoball shape bunny.off --alpha2 auto -o surface.ply\n"
      "  orthoball locate bunny.off probes.csv --alpha2 auto\n"
      "  orthoball measure 1ubq.pdb --probe 1.4 --per-residue residues.csv\n"
      "  orthoball pockets 1fmo.pdb --probe 1.4\n"
      "  orthoball figure trees.csv --columns x,y --radius-column crown -o trees.svg\n"

      "  orthoball view 1ubq.pdb");
}

int run(int argc, char** argv) {
  CLI::App app("Every alpha shape of weighted points in the plane and in space, exactly.");
  add_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  // A closed pipe and a file over the limit are errors of writing: status 3.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::ios::sync_with_stdio(false);
  try {
    const orthoball::LargeBlockReuse reuse;  // from one stage to the next
    return run(argc, argv);
  } catch (const UsageError& error) {
    return failed(kWrongUsage, error.what());
  } catch (const orthoball::ParseError& error) {
    return failed(kBadData, error.what());
  } catch (const orthoball::InputError& error) {
    const bool is_option = error.reason() == orthoball::InputError::Reason::wrong_argument;
    return failed(is_option ? kWrongUsage : kBadData, error.what());
  } catch (const orthoball::LimitError& error) {
    return failed(kCouldNot, error.what());
  } catch (const ReaderGone&) {
    return kCouldNot;
  } catch (const orthoball::OutputError& error) {
    return failed(kCouldNot, error.what());
  } catch (const std::bad_alloc&) {
    return failed(kCouldNot, "out of memory");
  } catch (const std::length_error&) {
    return failed(kCouldNot, "out of memory: an array would be too large");
  }
}
