// SPDX-License-Identifier: MIT
#pragma once

#include <string>

// What people type for the parameter, as the alpha2 that is meant: each formed exactly from the
// decimal text and rounded once to the nearest double. All throw UsageError that names `option` for
// a text that is no finite number, or whose alpha2 is beyond the double range.

/// The number itself.
[[nodiscard]] double alpha2_from_text(const std::string& option, const std::string& text);
/// X|X|.
[[nodiscard]] double alpha2_from_alpha(const std::string& option, const std::string& text);
/// 1 / (X|X|); zero is an error.
[[nodiscard]] double alpha2_from_inverse_alpha(const std::string& option, const std::string& text);
