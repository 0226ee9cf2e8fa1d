// SPDX-License-Identifier: MIT
#include "orthoball/exact/processor.h"

namespace orthoball {

#ifdef ORTHOBALL_WIDE_CODE

bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
bool has_avx2_fma() { return has_avx2() && __builtin_cpu_supports("fma") != 0; }
bool has_avx512() {
  return has_avx2_fma() && __builtin_cpu_supports("avx512f") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}

#else

bool has_avx2() { return false; }
bool has_avx2_fma() { return false; }
bool has_avx512() { return false; }

#endif

}  // namespace orthoball
