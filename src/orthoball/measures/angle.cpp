// SPDX-License-Identifier: MIT
#include "orthoball/measures/angle.h"

#include <cstddef>

#include "orthoball/exact/processor.h"

namespace orthoball {
namespace {

[[gnu::always_inline]] inline void angles(const double* __restrict x, const double* __restrict y,
                                          std::size_t count, double* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = angle_from_x_axis(x[i], y[i]);
}

#ifdef ORTHOBALL_WIDE_CODE
[[gnu::noinline]] ORTHOBALL_AVX2 void angles_avx2(const double* x, const double* y,
                                                  std::size_t count, double* out) {
  angles(x, y, count, out);
}
[[gnu::noinline]] ORTHOBALL_AVX512 void angles_avx512(const double* x, const double* y,
                                                      std::size_t count, double* out) {
  angles(x, y, count, out);
}
#endif

}  // namespace

void angles_from_x_axis(std::span<const double> x, std::span<const double> y,
                        std::span<double> out) {
#ifdef ORTHOBALL_WIDE_CODE
  if (has_avx512()) return angles_avx512(x.data(), y.data(), x.size(), out.data());
  if (has_avx2()) return angles_avx2(x.data(), y.data(), x.size(), out.data());
#endif
  angles(x.data(), y.data(), x.size(), out.data());
}

}  // namespace orthoball
