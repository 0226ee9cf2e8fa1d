// SPDX-License-Identifier: MIT
#include "fuzz/reader.h"
#include "orthoball/input/formats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return orthoball::fuzz::read_bytes(orthoball::read_pdb, data, size);
}
