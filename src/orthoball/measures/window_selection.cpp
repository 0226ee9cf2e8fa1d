// SPDX-License-Identifier: MIT
#include "orthoball/measures/window_selection.h"

#include <array>
#include <cstddef>
#include <cstring>

#include "orthoball/exact/processor.h"

#ifdef ORTHOBALL_WIDE_CODE
#include <immintrin.h>
#endif

namespace orthoball {
namespace {

struct Window {
  std::uint32_t first, length;
  const std::uint64_t* wanted;  // or null
};

// Elements begin..end - 1 of those to be selected, written to `out`, which has room for them and
// one more.
std::size_t select_one_by_one(const std::uint32_t* enters, std::uint32_t begin, std::uint32_t end,
                              const Window& window, std::uint32_t* out) {
  std::size_t size = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    const bool is_wanted = window.wanted == nullptr || (window.wanted[i / 64] >> i % 64 & 1U) != 0;
    out[size] = i;
    size += ((enters[i] - window.first < window.length) & is_wanted) ? 1U : 0U;
  }
  return size;
}

#ifdef ORTHOBALL_WIDE_CODE

// [bits]: the numbers of the bits that are set, ascending.
constexpr auto kPlaces = [] {
  std::array<std::array<std::uint8_t, 8>, 256> places{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    std::size_t size = 0;
    for (std::uint8_t bit = 0; bit < 8; ++bit) {
      if ((bits >> bit & 1U) != 0) places[bits][size++] = bit;
    }
  }
  return places;
}();
// [bits]: how many they are.
constexpr auto kCounts = [] {
  std::array<std::uint8_t, 256> counts{};
  for (unsigned bits = 1; bits < 256; ++bits) {
    counts[bits] = static_cast<std::uint8_t>(counts[bits / 2] + bits % 2);
  }
  return counts;
}();

// Eight at a time. There must be room for eight more.
ORTHOBALL_AVX2 std::size_t select_by_eights(const std::uint32_t* enters, std::uint32_t begin,
                                            std::uint32_t end, const Window& window,
                                            std::uint32_t* out) {
  // Unsigned comparisons are signed ones of numbers with the sign changed.
  const __m256i sign = _mm256_set1_epi32(INT32_MIN);
  const __m256i first = _mm256_set1_epi32(static_cast<int>(window.first));
  const __m256i length = _mm256_xor_si256(_mm256_set1_epi32(static_cast<int>(window.length)), sign);
  std::size_t size = 0;
  std::uint32_t i = begin;
  for (; i + 8 <= end; i += 8) {
    const __m256i index = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(enters + i));
    const __m256i from_first = _mm256_xor_si256(_mm256_sub_epi32(index, first), sign);
    const __m256i is_inside = _mm256_cmpgt_epi32(length, from_first);
    auto bits = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(is_inside)));
    if (window.wanted != nullptr) {
      std::uint16_t two_bytes = 0;  // bits i..i + 7 are among them
      std::memcpy(&two_bytes, reinterpret_cast<const std::byte*>(window.wanted) + i / 8, 2);
      bits &= unsigned{two_bytes} >> i % 8;
    }
    __m128i places = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPlaces[bits].data()));
    const __m256i numbers =
        _mm256_add_epi32(_mm256_cvtepu8_epi32(places), _mm256_set1_epi32(static_cast<int>(i)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + size), numbers);
    size += kCounts[bits];
  }
  return size + select_one_by_one(enters, i, end, window, out + size);
}
#else
constexpr auto select_by_eights = select_one_by_one;
#endif

}  // namespace

std::size_t select_in_window(std::span<const std::uint32_t> enters, std::uint32_t begin,
                             std::uint32_t end, std::uint32_t first, std::uint32_t length,
                             std::span<const std::uint64_t> wanted,
                             std::vector<std::uint32_t>& selected) {
  if (selected.size() < end - begin + std::size_t{8}) selected.resize(end - begin + std::size_t{8});
  const Window window{first, length, wanted.empty() ? nullptr : wanted.data()};
  return has_avx2() ? select_by_eights(enters.data(), begin, end, window, selected.data())
                    : select_one_by_one(enters.data(), begin, end, window, selected.data());
}

}  // namespace orthoball
