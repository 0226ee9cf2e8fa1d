// SPDX-License-Identifier: MIT
#pragma once

// ORTHOBALL_WIDE_CODE: whether functions are compiled for wider vectors than every processor of the
// architecture has; ORTHOBALL_AVX2, ORTHOBALL_AVX2_FMA, ORTHOBALL_AVX512: in front of such a
// function, but behind its attributes in brackets, or clang takes it for an error. Such code is
// called only if the function of the same name below says so, and gives the same results as the
// plain code that is called otherwise. The CMake option ORTHOBALL_VECTORS=OFF leaves it out.
#if defined(ORTHOBALL_VECTORS) && defined(__x86_64__) && defined(__GNUC__)
#define ORTHOBALL_WIDE_CODE
#define ORTHOBALL_AVX2 __attribute__((target("avx2")))
#define ORTHOBALL_AVX2_FMA __attribute__((target("avx2,fma")))
#ifdef __clang__
#define ORTHOBALL_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,fma")))
#else  // which takes narrower vectors unless asked
#define ORTHOBALL_AVX512 \
  __attribute__((target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")))
#endif
#else
#define ORTHOBALL_AVX2
#define ORTHOBALL_AVX2_FMA
#define ORTHOBALL_AVX512
#endif

namespace orthoball {

/// Whether code for vectors of four doubles was compiled and this processor can run it.
[[nodiscard]] bool has_avx2();
/// The same with fused products and sums; code that uses them must ask for them one by one, as no
/// product is fused that is not meant to be.
[[nodiscard]] bool has_avx2_fma();
/// The same for vectors of eight doubles.
[[nodiscard]] bool has_avx512();

}  // namespace orthoball
