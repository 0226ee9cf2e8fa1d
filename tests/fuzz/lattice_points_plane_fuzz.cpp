// SPDX-License-Identifier: MIT
#include "fuzz/check_points.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orthoball::fuzz;
  check_points<2>(lattice_points_from_bytes<2>({data, size}));
  return 0;
}
