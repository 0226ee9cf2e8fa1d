// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace orthoball {

/// While one lives anywhere in the program, the memory of large arrays is kept when they are freed
/// and used for the next ones; when the last ends, it goes back to the system.
///
/// The first touch of a page costs far more than any later one: the system has to find and clear
/// it. Who builds large things one after the other holds one of these meanwhile; what the library
/// builds holds one itself. It costs no memory: what is kept is used before more is taken.
class LargeBlockReuse {
 public:
  LargeBlockReuse();
  ~LargeBlockReuse();
  LargeBlockReuse(const LargeBlockReuse&) = delete;
  LargeBlockReuse& operator=(const LargeBlockReuse&) = delete;
};

/// Memory for large arrays, straight from the system; any thread may call.
namespace large_blocks {

/// From how many bytes on an array is large.
inline constexpr std::size_t kLeast = std::size_t{4} << 20U;

/// At least so many bytes, aligned for anything, with unspecified values. What is not touched costs
/// no memory.
/// @throws std::bad_alloc
[[nodiscard]] void* allocate(std::size_t bytes);
/// Ends a block that allocate() gave for so many bytes.
void free(void* block, std::size_t bytes) noexcept;

}  // namespace large_blocks

}  // namespace orthoball
