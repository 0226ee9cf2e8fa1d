// SPDX-License-Identifier: MIT
#include "oracles/sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace orthoball::oracles {

namespace {

// The first 32 bits of the fraction of a root: of the first primes' cube roots for the rounds, of
// their square roots for the start.
std::uint32_t fraction_bits(double root) {
  return static_cast<std::uint32_t>((root - std::floor(root)) * 0x1p32);
}

std::array<int, 64> first_primes() {
  std::array<int, 64> primes{};
  std::size_t count = 0;
  for (int candidate = 2; count < primes.size(); ++candidate) {
    bool is_prime = true;
    for (std::size_t i = 0; i < count; ++i) is_prime = is_prime && candidate % primes[i] != 0;
    if (is_prime) primes[count++] = candidate;
  }
  return primes;
}

using State = std::array<std::uint32_t, 8>;

void add_block(State& state, const unsigned char* block,
               const std::array<std::uint32_t, 64>& constants) {
  std::array<std::uint32_t, 64> words{};
  for (std::size_t i = 0; i < 64; ++i) words[i / 4] = words[i / 4] << 8U | block[i];
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t a = words[i - 15], b = words[i - 2];
    words[i] = words[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3U)) + words[i - 7] +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10U));
  }
  State s = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
    const std::uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
    const std::uint32_t first = s[7] +
                                (std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25)) +
                                choice + constants[i] + words[i];
    const std::uint32_t second =
        (std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22)) + majority;
    s = {first + second, s[0], s[1], s[2], s[3] + first, s[4], s[5], s[6]};
  }
  for (std::size_t i = 0; i < 8; ++i) state[i] += s[i];
}

}  // namespace

std::string sha256(std::string_view text) {
  const std::array<int, 64> primes = first_primes();
  std::array<std::uint32_t, 64> constants{};
  State state{};
  for (std::size_t i = 0; i < 64; ++i) constants[i] = fraction_bits(std::cbrt(primes[i]));
  for (std::size_t i = 0; i < 8; ++i) state[i] = fraction_bits(std::sqrt(primes[i]));

  std::string padded(text);
  padded += '\x80';
  while (padded.size() % 64 != 56) padded += '\0';
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(text.size());
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 0xFFU);
  for (std::size_t at = 0; at < padded.size(); at += 64) {
    add_block(state, reinterpret_cast<const unsigned char*>(padded.data()) + at, constants);
  }
  std::string digits;
  for (const std::uint32_t word : state) {
    for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 0xFU];
  }
  return digits;
}

}  // namespace orthoball::oracles
