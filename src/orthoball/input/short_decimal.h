// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace orthoball {

/// A decimal as most files write it: digits * 10^-decimals, trailing zeros kept.
struct ShortDecimal {
  std::int64_t digits = 0;  ///< less than 10^18 in size
  int decimals = 0;         ///< within [-280, 298]; negative where an exponent makes it so
};

/// 10^n for n in 0..18.
inline constexpr std::array<std::int64_t, 19> kIntegerPowersOfTen = [] {
  std::array<std::int64_t, 19> powers{};
  powers[0] = 1;
  for (std::size_t n = 1; n < powers.size(); ++n) powers[n] = 10 * powers[n - 1];
  return powers;
}();

namespace short_decimal_detail {

// Appends the run of figures at `at` to `digits` and returns where it ends; eight at a time, told
// and weighed as bytes of one integer. Wraps around beyond 19 figures.
inline const char* append_figures(const char* at, const char* end, std::uint64_t& digits) {
  if constexpr (std::endian::native == std::endian::little) {
    while (end - at >= 8) {
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, at, 8);
      // Figures are 0x30 to 0x39: the high half is 3, and still is when 6 is added. A carry comes
      // from a byte that is no figure, and reaches those behind it only.
      const std::uint64_t others =
          ((bytes & 0xF0F0F0F0F0F0F0F0U) ^ 0x3030303030303030U) |
          (((bytes + 0x0606060606060606U) & 0xF0F0F0F0F0F0F0F0U) ^ 0x3030303030303030U);
      const auto count = others == 0 ? 8 : std::countr_zero(others) / 8;
      if (count == 0) return at;
      // Zeros move in front of fewer than eight figures.
      bytes = (bytes - 0x3030303030303030U) << (64 - 8 * count);
      bytes = bytes * 10 + (bytes >> 8U);  // pairs, in every other byte
      bytes = ((bytes & 0x000000FF000000FFU) * 0x000F424000000064U +
               (bytes >> 16U & 0x000000FF000000FFU) * 0x0000271000000001U) >>
              32U;
      digits = digits * static_cast<std::uint64_t>(
                            kIntegerPowersOfTen[static_cast<std::size_t>(count)]) +
               bytes;
      at += count;
      if (count < 8) return at;
    }
  }
  for (; at != end && *at >= '0' && *at <= '9'; ++at) {
    digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
  }
  return at;
}

}  // namespace short_decimal_detail

/// Reads the number that begins at `at`: optional sign, at most 18 figures with an optional point,
/// optional e or E and an exponent of at most three figures. Exact.
/// @return where the number ends, for the caller to see what follows; null where there is none of
///         this kind, which says nothing about other kinds (see parse_decimal).
inline const char* parse_short_decimal(const char* at, const char* end, ShortDecimal& number) {
  using short_decimal_detail::append_figures;
  const bool is_negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const begin = at;
  at = append_figures(at, end, digits);
  std::ptrdiff_t figures = at - begin, decimals = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    at = append_figures(at, end, digits);
    decimals = at - fraction;
    figures += decimals;
  }
  if (figures == 0 || figures > 18) return nullptr;
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    const bool is_below = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    std::uint64_t exponent = 0;
    const char* const exponent_begin = at;
    at = append_figures(at, end, exponent);
    if (at == exponent_begin || at - exponent_begin > 3 || exponent > 280) return nullptr;
    decimals += static_cast<std::ptrdiff_t>(is_below ? exponent : -exponent);
  }
  number.digits = static_cast<std::int64_t>(is_negative ? -digits : digits);
  number.decimals = static_cast<int>(decimals);
  return at;
}

}  // namespace orthoball
