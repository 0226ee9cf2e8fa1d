// SPDX-License-Identifier: MIT
#include "orthoball/input/probe_radius.h"

#include <fmt/format.h>

#include "orthoball/error.h"
#include "orthoball/input/decimal.h"

namespace orthoball {

ProbeRadius probe_radius(std::string_view text) {
  const DecimalParse parse = parse_decimal(text);
  const DecimalNumber& number = parse.number;
  if (parse.fault != DecimalFault::none || number.nearest < 0.0) {
    throw InputError(
        InputError::Reason::wrong_argument, InputError::kNoRow,
        fmt::format("\"{}\" is not the radius of a probe, which is 0 or more and finite",
                    text.substr(0, 40)));
  }
  ProbeRadius probe{number.nearest, {}, 0};
  constexpr Int128 kLargest = Int128{1} << 53;
  constexpr int kMostDecimals = 400;
  Int128 digits = number.digits;
  int exponent = number.exponent;
  for (; exponent > 0 && digits <= kLargest; --exponent) digits *= 10;
  if (number.is_exact && exponent <= 0 && exponent >= -kMostDecimals && digits <= kLargest) {
    probe.digits = static_cast<std::int64_t>(digits);
    probe.decimals = -exponent;
  }
  return probe;
}

}  // namespace orthoball
