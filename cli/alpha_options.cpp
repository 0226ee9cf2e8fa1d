// SPDX-License-Identifier: MIT
#include "cli/alpha_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

#include "cli/alpha_number.h"
#include "cli/query_memory.h"
#include "cli/usage_error.h"
#include "orthoball/filtration/alpha.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/queries/alpha_candidates.h"
#include "orthoball/signatures/notable_alphas.h"

namespace {

template <class Visit>
auto with_filtration(const Loaded& input, const Visit& visit) {
  return std::visit(visit, input.shapes.filtration());
}

std::uint32_t spectrum_size(const Loaded& input) {
  return with_filtration(input, [](const auto& filtration) { return filtration.spectrum_size(); });
}

ChosenAlpha alpha_of(const Loaded& input, double alpha2) {
  const auto index =
      with_filtration(input, [&](const auto& filtration) { return filtration.index(alpha2); });
  return {alpha2, orthoball::alpha_from_alpha2(alpha2), index, {}, {}};
}

// Calls `use` with the parts of a list between commas.
void for_each(const std::string& list, const std::function<void(const std::string&)>& use) {
  if (list.empty()) return;
  for (const std::string& text : CLI::detail::split(list, ',')) use(text);
}

// @param size  of the spectrum; empty where it is not known yet.
std::uint32_t index_from_text(const std::string& text, std::optional<std::uint32_t> size) {
  std::uint32_t index = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, index);
  if (error != std::errc() || stop != end || (size && index > *size)) {
    throw UsageError(fmt::format(
        "--index: \"{}\" is not an index of the spectrum; it must be a whole number from 0{}",
        text.substr(0, 40), size ? fmt::format(" to {}", *size) : " on"));
  }
  return index;
}

constexpr std::string_view kNamed = "auto:";

std::string name_in(const std::string& text) { return text.substr(kNamed.size()); }

// Whether it is auto:NAME.
// @throws UsageError for a name that there is not.
bool check_name(const std::string& text) {
  if (text.rfind(kNamed, 0) != 0) return false;
  const std::vector<std::string> names = orthoball::candidate_names(3);
  if (std::find(names.begin(), names.end(), name_in(text)) == names.end()) {
    throw UsageError(fmt::format("--alpha2 {}: there is no such candidate; there are {}",
                                 text.substr(0, 60), fmt::join(names, ", ")));
  }
  return true;
}

// The candidate of a name.
// @throws UsageError where the input has none, with the scale of its alphas.
ChosenAlpha named_alpha(const Loaded& input, const std::string& name) {
  return with_filtration(input, [&]<int D>(const orthoball::Filtration<D>& filtration) {
    input.memory.require(candidates_memory(D, filtration.size()),
                         input.reading.file + ": the candidates for alpha");
    const auto candidates =
        orthoball::alpha_candidates<D>(filtration, meaning_of_weights(input), input.threads);
    for (const auto& [taken, at, from, to, stability] : candidates) {
      if (taken.name != name || !taken.index) continue;
      return ChosenAlpha{taken.alpha2, taken.alpha, *taken.index, taken.name, taken.reason};
    }
    throw UsageError(fmt::format("--alpha2 auto:{}: these points have no such alpha; {}", name,
                                 scale_text(input)));
  });
}

}  // namespace

void add_alpha_options(CLI::App& command, AlphaOptions& options, bool takes_list,
                       const std::string& otherwise) {
  const std::string group = "Alpha";
  const std::string type = takes_list ? "X[,X...]" : "X";
  auto* const alpha2 =
      command
          .add_option("--alpha2", options.alpha2,
                      "signed squared radius [length^2], or auto, see shape --help,\n"
                      "or auto:NAME, a candidate of orthoball alpha\n(default: " +
                          otherwise + ")")
          ->type_name(takes_list ? type : "X|auto[:NAME]")
          ->group(group);
  auto* const alpha = command
                          .add_option("--alpha", options.alpha,
                                      "signed radius [length]: alpha2 = X|X|, rounded once")
                          ->type_name(type)
                          ->excludes(alpha2)
                          ->group(group);
  auto* const inverse = command
                            .add_option("--inverse-alpha", options.inverse_alpha,
                                        "1/radius [1/length], as some Python packages call alpha")
                            ->type_name(type)
                            ->excludes(alpha2)
                            ->excludes(alpha)
                            ->group(group);
  command
      .add_option("--index", options.index, "index of the spectrum, from 1; 0 is the empty complex")
      ->type_name(takes_list ? "I[,I...]" : "I")
      ->excludes(alpha2)
      ->excludes(alpha)
      ->excludes(inverse)
      ->group(group);
}

std::string scale_text(const Loaded& input) {
  return with_filtration(input,
                         [](const auto& filtration) { return orthoball::scale_text(filtration); });
}

ChosenAlpha alpha_at(const Loaded& input, std::uint32_t index) {
  const double alpha2 =
      index == 0 ? -std::numeric_limits<double>::infinity()
                 : with_filtration(input, [&](const auto& f) { return f.alpha2(index); });
  return {alpha2, orthoball::alpha_from_alpha2(alpha2), index, {}, {}};
}

orthoball::WeightMeaning meaning_of_weights(const Loaded& input) {
  using orthoball::WeightMeaning;
  if (input.reading.is_molecule) return WeightMeaning::molecule_radii;
  const bool is_weighted = input.shapes.points().weight_kind() != orthoball::WeightKind::none;
  return is_weighted ? WeightMeaning::given : WeightMeaning::none;
}

ChosenAlpha automatic_alpha(const Loaded& input) {
  const auto meaning = meaning_of_weights(input);
  const orthoball::NotableAlpha taken = with_filtration(input, [&](const auto& filtration) {
    return orthoball::automatic_alpha(filtration, orthoball::notable_alphas(filtration), meaning);
  });
  return {taken.alpha2, taken.alpha, taken.index.value_or(0), taken.name, taken.reason};
}

std::string text_of(const ChosenAlpha& alpha) {
  if (orthoball::is_of_empty_complex(alpha.index, alpha.alpha2)) {
    return "index 0, the empty complex";
  }
  const auto number = [](double x) {
    return std::isfinite(x) ? fmt::format("{}", x + 0.0) : "beyond double range";
  };
  return fmt::format("alpha2 {}, alpha {}, index {}", number(alpha.alpha2), number(alpha.alpha),
                     alpha.index);
}

void say_how(const InputOptions& options, const std::vector<ChosenAlpha>& chosen) {
  for (const ChosenAlpha& alpha : chosen) {
    if (alpha.name.empty()) continue;
    say(options, fmt::format("alpha2 auto: {}, {}", alpha.name, alpha.reason));
  }
}

void check(const AlphaOptions& options, bool takes_list) {
  for (const std::string* text :
       {&options.alpha2, &options.alpha, &options.inverse_alpha, &options.index}) {
    if (!takes_list && text->find(',') != std::string::npos) {
      throw UsageError(
          fmt::format("\"{}\" is a list; this command takes one alpha", text->substr(0, 40)));
    }
  }
  for_each(options.alpha2, [](const std::string& text) {
    if (text != "auto" && !check_name(text)) (void)alpha2_from_text("--alpha2", text);
  });
  for_each(options.alpha,
           [](const std::string& text) { (void)alpha2_from_alpha("--alpha", text); });
  for_each(options.inverse_alpha, [](const std::string& text) {
    (void)alpha2_from_inverse_alpha("--inverse-alpha", text);
  });
  for_each(options.index,
           [](const std::string& text) { (void)index_from_text(text, std::nullopt); });
}

std::vector<ChosenAlpha> chosen_alphas(const AlphaOptions& options, const Loaded& input) {
  std::vector<ChosenAlpha> chosen;
  for_each(options.alpha2, [&](const std::string& text) {
    chosen.push_back(text == "auto"     ? automatic_alpha(input)
                     : check_name(text) ? named_alpha(input, name_in(text))
                                        : alpha_of(input, alpha2_from_text("--alpha2", text)));
  });
  for_each(options.alpha, [&](const std::string& text) {
    chosen.push_back(alpha_of(input, alpha2_from_alpha("--alpha", text)));
    chosen.back().alpha = alpha2_from_text("--alpha", text);
  });
  for_each(options.inverse_alpha, [&](const std::string& text) {
    chosen.push_back(alpha_of(input, alpha2_from_inverse_alpha("--inverse-alpha", text)));
  });
  for_each(options.index, [&](const std::string& text) {
    chosen.push_back(alpha_at(input, index_from_text(text, spectrum_size(input))));
  });
  return chosen;
}
