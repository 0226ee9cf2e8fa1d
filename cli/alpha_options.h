// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/input_options.h"
#include "orthoball/signatures/notable_alphas.h"

/// The four forms of the parameter as typed; at most one of them is not empty.
struct AlphaOptions {
  std::string alpha2, alpha, inverse_alpha, index;

  [[nodiscard]] bool is_given() const {
    return !alpha2.empty() || !alpha.empty() || !inverse_alpha.empty() || !index.empty();
  }
};

/// One value of the parameter in all its forms.
struct ChosenAlpha {
  double alpha2;        ///< length^2
  double alpha;         ///< its signed root
  std::uint32_t index;  ///< of the spectrum; 0 below the first entry
  std::string name;     ///< for --alpha2 auto and auto:NAME: of what was taken; else empty
  std::string reason;   ///< and why it is notable
};

/// Declares --alpha2, --alpha, --inverse-alpha, --index on a command.
/// @param takes_list  lists with commas instead of one value.
/// @param otherwise   what happens without any of them, for the help.
void add_alpha_options(CLI::App& command, AlphaOptions& options, bool takes_list,
                       const std::string& otherwise);

/// Looks at what was typed before any work is done; the range of an index is not known yet.
/// @throws UsageError for a text that is not what the option takes, and for a list where one value
/// is taken.
void check(const AlphaOptions& options, bool takes_list);

/// The values that were asked for, in their order; none if none was.
/// @throws UsageError for a text that is not what the option takes.
[[nodiscard]] std::vector<ChosenAlpha> chosen_alphas(const AlphaOptions& options,
                                                     const Loaded& input);

/// "alpha2 2, alpha 1.4142135623730951, index 7" for reports; "index 0, the empty complex".
[[nodiscard]] std::string text_of(const ChosenAlpha& alpha);

/// Says on standard error what `auto` stood for among `chosen`, unless --quiet.
void say_how(const InputOptions& options, const std::vector<ChosenAlpha>& chosen);

/// From where to where alpha2 means something for these points, for messages on alphas that do not
/// suit them.
[[nodiscard]] std::string scale_text(const Loaded& input);

/// Where the weights of an input come from.
[[nodiscard]] orthoball::WeightMeaning meaning_of_weights(const Loaded& input);

/// `--alpha2 auto`: the alpha that is worth looking at first.
[[nodiscard]] ChosenAlpha automatic_alpha(const Loaded& input);

/// The value at an index of the spectrum. Index 0, the empty complex, has alpha2 -infinity.
[[nodiscard]] ChosenAlpha alpha_at(const Loaded& input, std::uint32_t index);
