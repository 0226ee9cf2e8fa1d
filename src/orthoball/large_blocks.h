// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace orthoball {

/// While one lives anywhere in the program, the memory of large arrays is kept when they are freed
/// and used for the next ones; when the last ends, it goes back to the system.
///
/// The first touch of a page costs far more than any later one: the system has to find and clear
/// it. Who builds large things one after the other holds one of these meanwhile; what the library
/// builds holds one itself. Large arrays use what is kept before they take more, but nothing else
/// can use it: the peak of memory rises, by up to a tenth at 100,000 sites, by little at more.
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
/// Of which number the address of a block is a multiple.
inline constexpr std::size_t kAlignment = 4096;

/// At least so many bytes with unspecified values. What is never touched costs no memory, unless it
/// is memory used again.
/// @throws std::bad_alloc
[[nodiscard]] void* allocate(std::size_t bytes);
/// Ends a block that allocate() gave for so many bytes.
void free(void* block, std::size_t bytes) noexcept;

/// Whether blocks are used again: on Linux, and not under sanitizers, which want to see each.
[[nodiscard]] bool are_reused();
/// What is kept at the moment, in bytes.
[[nodiscard]] std::size_t kept_bytes();

}  // namespace large_blocks

}  // namespace orthoball
