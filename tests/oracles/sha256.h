// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace orthoball::oracles {

/// The SHA-256 digest of a text as 64 hexadecimal digits (FIPS 180-4).
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace orthoball::oracles
