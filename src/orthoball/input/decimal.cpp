// SPDX-License-Identifier: MIT
#include "orthoball/input/decimal.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

// Numbers of text files are read as the decimals they are: the digits as one integer, the exponent
// beside it. The nearest double follows from these by one exact operation when both are small
// (W. Clinger, "How to read floating point numbers accurately", 1990) and from the text otherwise.

namespace orthoball {
namespace {

constexpr double kLargestInteger = 9007199254740992.0;        // 2^53
constexpr Int128 kLargestWeight = Int128{1} << 106;           // two doubles
constexpr std::int64_t kLargestExponent = 1'000'000'000'000;  // longer than any text

constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kExactPowers = 22;  // 10^22 is the last power of ten that is a double

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equals_lower(std::string_view text, std::string_view word) {
  return text.size() == word.size() && std::equal(text.begin(), text.end(), word.begin(),
                                                  [](char a, char b) { return lower(a) == b; });
}

// `text` without its sign spells no number; what does it spell?
DecimalFault fault_of(std::string_view text) {
  const bool is_nan = text.size() >= 3 && equals_lower(text.substr(0, 3), "nan") &&
                      (text.size() == 3 || text[3] == '(');
  return is_nan || equals_lower(text, "inf") || equals_lower(text, "infinity")
             ? DecimalFault::not_finite
             : DecimalFault::not_a_number;
}

Int128 power_of_ten(int exponent) {
  Int128 power = 1;
  while (exponent-- > 0) power *= 10;
  return power;
}

// The double nearest to an unsigned number in the grammar of parse_decimal.
double nearest_of_text(std::string_view text) {
  double value = 0.0;
  const auto fortran = text.find_first_of("dD");
  if (fortran == std::string_view::npos) {
    fast_float::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
  std::string with_e(text);
  with_e[fortran] = 'e';
  fast_float::from_chars(with_e.data(), with_e.data() + with_e.size(), value);
  return value;
}

bool is_one_operation(Int128 magnitude, std::int64_t exponent) {
  return magnitude <= Int128{1} << 53 && exponent >= -kExactPowers && exponent <= kExactPowers;
}

double by_one_operation(Int128 magnitude, std::int64_t exponent) {
  const auto integer = static_cast<double>(static_cast<std::int64_t>(magnitude));
  return exponent < 0 ? integer / kPowersOfTen[static_cast<std::size_t>(-exponent)]
                      : integer * kPowersOfTen[static_cast<std::size_t>(exponent)];
}

double nearest_double(Int128 digits, int exponent) {
  const Int128 magnitude = digits < 0 ? -digits : digits;
  double value = 0.0;
  if (is_one_operation(magnitude, exponent)) {
    value = by_one_operation(magnitude, exponent);
  } else {
    constexpr auto kHalf = static_cast<Int128>(1'000'000'000'000'000'000);
    const std::string low = std::to_string(static_cast<std::int64_t>(magnitude % kHalf));
    std::string text = std::to_string(static_cast<std::int64_t>(magnitude / kHalf % kHalf));
    text = std::to_string(static_cast<std::int64_t>(magnitude / kHalf / kHalf)) +
           std::string(18 - text.size(), '0') + text + std::string(18 - low.size(), '0') + low;
    value = nearest_of_text(text + "e" + std::to_string(exponent));
  }
  return digits < 0 ? -value : value;
}

// The same number in the other form; `text` is how it is written.
DecimalNumber number_of(const ShortDecimal& number, std::string_view text) {
  if (number.digits == 0) return {};
  std::int64_t digits = number.digits;
  int exponent = -number.decimals;
  for (; digits % 10 == 0; digits /= 10) ++exponent;
  const Int128 magnitude = digits < 0 ? -digits : digits;
  double nearest = 0.0;
  if (is_one_operation(magnitude, exponent)) {
    nearest = by_one_operation(magnitude, exponent);
  } else {
    if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
    nearest = nearest_of_text(text);
  }
  return {digits < 0 ? -nearest : nearest, exponent, true, digits};
}

// Digits of more than 19 figures: `text` holds figures and at most one point. Leading zeros do
// not count, `trailing` zeros are left out. False where more than 38 figures remain.
bool long_digits(std::string_view text, Int128& digits, std::int64_t& trailing) {
  const auto last = text.find_last_not_of("0.");
  digits = 0;
  trailing = 0;
  if (last == std::string_view::npos) return true;
  for (const char c : text.substr(last + 1)) trailing += c != '.';
  std::string_view rest = text.substr(0, last + 1);
  rest.remove_prefix(rest.find_first_not_of("0."));
  int count = 0;
  for (const char c : rest) {
    if (c == '.') continue;
    if (++count > 38) return false;
    digits = digits * 10 + (c - '0');
  }
  return true;
}

}  // namespace

DecimalParse parse_decimal(std::string_view text) {
  if (ShortDecimal number; parse_short_decimal(text.data(), text.data() + text.size(), number) ==
                           text.data() + text.size()) {
    return {number_of(number, text), DecimalFault::none};
  }
  const char* at = text.data();
  const char* const end = at + text.size();
  const bool is_negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  const char* const unsigned_begin = at;

  std::uint64_t short_digits = 0;  // right as long as there are at most 19 figures
  while (at != end && is_digit(*at)) {
    short_digits = 10 * short_digits + static_cast<std::uint64_t>(*at++ - '0');
  }
  std::int64_t figures = at - unsigned_begin;
  std::int64_t exponent = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    while (at != end && is_digit(*at)) {
      short_digits = 10 * short_digits + static_cast<std::uint64_t>(*at++ - '0');
    }
    exponent = fraction - at;
    figures -= exponent;
  }
  const auto fail = [&](DecimalFault fault) { return DecimalParse{{}, fault}; };
  const std::string_view whole(unsigned_begin, static_cast<std::size_t>(end - unsigned_begin));
  if (figures == 0) return fail(fault_of(whole));
  const char* const digits_end = at;
  if (at != end && (lower(*at) == 'e' || lower(*at) == 'd')) {
    ++at;
    const bool is_below = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    if (at == end) return fail(DecimalFault::not_a_number);
    std::int64_t written = 0;
    for (; at != end && is_digit(*at); ++at) {
      written = std::min(kLargestExponent, 10 * written + (*at - '0'));
    }
    exponent += is_below ? -written : written;
  }
  if (at != end) return fail(fault_of(whole));

  DecimalNumber number;
  if (figures <= 19) {
    number.digits = static_cast<Int128>(short_digits);
    if (short_digits == 0) return {};
    for (; short_digits % 10 == 0; short_digits /= 10) ++exponent;
    number.digits = static_cast<Int128>(short_digits);
  } else {
    std::int64_t trailing = 0;
    number.is_exact =
        long_digits({unsigned_begin, static_cast<std::size_t>(digits_end - unsigned_begin)},
                    number.digits, trailing);
    exponent += trailing;
    if (number.is_exact && number.digits == 0) return {};
  }
  number.nearest = number.is_exact && is_one_operation(number.digits, exponent)
                       ? by_one_operation(number.digits, exponent)
                       : nearest_of_text(whole);
  if (std::isinf(number.nearest)) return fail(DecimalFault::out_of_range);
  if (number.nearest == 0.0) return {};
  if (number.is_exact) {
    number.exponent = static_cast<int>(exponent);  // small, as the number is within range
  } else {
    number.digits = 0;
  }
  if (is_negative) {
    number.digits = -number.digits;
    number.nearest = -number.nearest;
  }
  return {number, DecimalFault::none};
}

DecimalNumber decimal_number(Int128 digits, int exponent) {
  if (digits == 0) return {};
  constexpr auto kLong = Int128{1} << 62;  // divisions of short numbers are far faster
  for (; (digits > kLong || digits < -kLong) && digits % 10 == 0; digits /= 10) ++exponent;
  if (digits <= kLong && digits >= -kLong) {
    auto rest = static_cast<std::int64_t>(digits);
    for (; rest % 10 == 0; rest /= 10) ++exponent;
    digits = rest;
  }
  const double nearest = nearest_double(digits, exponent);
  if (nearest == 0.0) return {};
  return {nearest, exponent, true, digits};
}

void DecimalRows::reserve(std::size_t rows) {
  coordinates_.reserve(rows * static_cast<std::size_t>(dimension_));
  if (kind_ != WeightKind::none) weights_.reserve(rows);
  if (kind_ == WeightKind::weight) weights_low_.reserve(rows);
}

// Appends the row as integers; false, with nothing appended, where that cannot be.
bool DecimalRows::fits(std::span<const DecimalNumber> coordinates, const DecimalNumber& weight) {
  int decimals = decimals_;
  bool is_exact = true;
  const auto see = [&](const DecimalNumber& number) {
    is_exact = is_exact && number.is_exact;
    decimals = std::max(decimals, -number.exponent);
  };
  for (const DecimalNumber& number : coordinates) see(number);
  if (kind_ == WeightKind::radius) see(weight);
  if (kind_ == WeightKind::weight) {
    is_exact = is_exact && weight.is_exact;
    decimals = std::max(decimals, (1 - weight.exponent) / 2);
  }
  if (!is_exact || (decimals > decimals_ && !widen(decimals))) return false;

  const std::size_t before = coordinates_.size();
  const auto append = [this](std::vector<double>& integers, const DecimalNumber& number) {
    const Int128 magnitude = number.digits < 0 ? -number.digits : number.digits;
    const int power = number.digits == 0 ? 0 : number.exponent + decimals_;
    if (!is_one_operation(magnitude, power)) return false;
    // Beyond 2^53 the product is even: no product above 2^53 is rounded down to it.
    const double integer = by_one_operation(magnitude, power);
    if (integer > kLargestInteger) return false;
    largest_ = std::max(largest_, integer);
    integers.push_back(number.digits < 0 ? -integer : integer);
    return true;
  };
  for (const DecimalNumber& number : coordinates) {
    if (append(coordinates_, number)) continue;
    coordinates_.resize(before);
    return false;
  }
  if (kind_ == WeightKind::none) return true;
  bool has_weight = false;
  if (kind_ == WeightKind::radius) {
    has_weight = append(weights_, weight);
  } else {
    const Int128 magnitude = weight.digits < 0 ? -weight.digits : weight.digits;
    const int power = weight.digits == 0 ? 0 : weight.exponent + 2 * decimals_;
    if (power <= 32 && magnitude <= kLargestWeight / power_of_ten(power)) {
      const Int128 integer = weight.digits * power_of_ten(power);
      const auto high = static_cast<double>(integer);
      weights_.push_back(high);
      weights_low_.push_back(static_cast<double>(integer - static_cast<Int128>(high)));
      largest_weight_ = std::max(largest_weight_, integer < 0 ? -integer : integer);
      has_weight = true;
    }
  }
  if (!has_weight) coordinates_.resize(before);
  return has_weight;
}

// Counts in units of 10^-decimals from now on; false, with nothing changed, where that cannot be.
bool DecimalRows::widen(int decimals) {
  const int power = decimals - decimals_;
  if (largest_ > 0.0) {
    if (power > kExactPowers) return false;
    const double factor = kPowersOfTen[static_cast<std::size_t>(power)];
    if (largest_ * factor > kLargestInteger) return false;
  }
  if (largest_weight_ > 0 &&
      (power > 16 || largest_weight_ > kLargestWeight / power_of_ten(2 * power))) {
    return false;
  }
  if (largest_ > 0.0) {
    const double factor = kPowersOfTen[static_cast<std::size_t>(power)];
    for (double& integer : coordinates_) integer *= factor;
    if (kind_ == WeightKind::radius) {
      for (double& integer : weights_) integer *= factor;
    }
    largest_ *= factor;
  }
  if (largest_weight_ > 0) {
    const Int128 factor = power_of_ten(2 * power);
    for (std::size_t row = 0; row < weights_.size(); ++row) {
      const Int128 integer =
          factor * (static_cast<Int128>(weights_[row]) + static_cast<Int128>(weights_low_[row]));
      weights_[row] = static_cast<double>(integer);
      weights_low_[row] = static_cast<double>(integer - static_cast<Int128>(weights_[row]));
    }
    largest_weight_ *= factor;
  }
  decimals_ = decimals;
  return true;
}

void DecimalRows::become_doubles() {
  for (double& number : coordinates_) {
    number = nearest_double(static_cast<Int128>(number), -decimals_);
  }
  for (std::size_t row = 0; row < weights_.size(); ++row) {
    auto integer = static_cast<Int128>(weights_[row]);
    if (kind_ == WeightKind::weight) integer += static_cast<Int128>(weights_low_[row]);
    weights_[row] =
        nearest_double(integer, kind_ == WeightKind::weight ? -2 * decimals_ : -decimals_);
  }
  weights_low_ = {};
  is_fixed_ = false;
}

void DecimalRows::add(std::span<const DecimalNumber> coordinates, const DecimalNumber& weight) {
  ++rows_;
  if (is_fixed_) {
    if (fits(coordinates, weight)) return;
    become_doubles();
  }
  for (const DecimalNumber& number : coordinates) coordinates_.push_back(number.nearest);
  if (kind_ != WeightKind::none) weights_.push_back(weight.nearest);
}

bool DecimalRows::add_short(std::span<const ShortDecimal> numbers) {
  if (!is_fixed_ || kind_ == WeightKind::weight) return false;
  const auto axes = static_cast<std::size_t>(dimension_);
  std::array<double, 4> integers;
  double largest = largest_;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::int64_t digits = numbers[i].digits;
    int power = decimals_ - numbers[i].decimals;
    for (; power < 0 && digits % 10 == 0; digits /= 10) {
      if (digits == 0) power = -1;
      ++power;
    }
    if (power < 0 || power > 18) {
      if (digits != 0) return false;
      power = 0;
    }
    const Int128 product = Int128{digits} * kIntegerPowersOfTen[static_cast<std::size_t>(power)];
    constexpr Int128 kLargest = Int128{1} << 53;
    if (product > kLargest || product < -kLargest) return false;
    integers[i] = static_cast<double>(static_cast<std::int64_t>(product));
    largest = std::max(largest, std::abs(integers[i]));
  }
  largest_ = largest;
  ++rows_;
  coordinates_.insert(coordinates_.end(), integers.begin(), integers.begin() + dimension_);
  if (numbers.size() > axes) weights_.push_back(integers[axes]);
  return true;
}

void DecimalRows::add_nearest(std::span<const double> numbers) {
  const auto axes = static_cast<std::size_t>(dimension_);
  ++rows_;
  coordinates_.insert(coordinates_.end(), numbers.begin(), numbers.begin() + dimension_);
  if (numbers.size() > axes) weights_.push_back(numbers[axes]);
}

WeightedPoints DecimalRows::points() && {
  if (!is_fixed_) {
    return {dimension_, std::move(coordinates_), kind_, std::move(weights_)};
  }
  if (std::all_of(weights_low_.begin(), weights_low_.end(), [](double x) { return x == 0.0; })) {
    weights_low_ = {};
  }
  return WeightedPoints::fixed_point(dimension_, decimals_, std::move(coordinates_), kind_,
                                     std::move(weights_), std::move(weights_low_));
}

}  // namespace orthoball
