// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "orthoball/large_blocks.h"

namespace orthoball {

/// std::allocator, but that large arrays live in large_blocks.
template <class T>
class BlockAllocator {
 public:
  using value_type = T;  ///< as allocators name it

  BlockAllocator() = default;
  template <class U>
  BlockAllocator(const BlockAllocator<U>& /*other*/) {}  // NOLINT: converts as std::allocator does

  /// Memory for `count` of them.
  /// @throws std::bad_alloc
  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / (2 * sizeof(T))) throw std::bad_alloc();
    if (!is_large(count)) return std::allocator<T>().allocate(count);
    return static_cast<T*>(large_blocks::allocate(count * sizeof(T)));
  }
  /// Ends what allocate() gave for `count`.
  void deallocate(T* array, std::size_t count) noexcept {
    if (!is_large(count)) return std::allocator<T>().deallocate(array, count);
    large_blocks::free(array, count * sizeof(T));
  }
  /// Any of them can free what another has allocated.
  [[nodiscard]] bool operator==(const BlockAllocator& /*other*/) const { return true; }

 private:
  static bool is_large(std::size_t count) { return count * sizeof(T) >= large_blocks::kLeast; }
};

/// Leaves elements that are given no value as the memory is, so that pages are first touched where
/// they are filled. For types that are copied as bytes.
template <class T>
class RawAllocator : public BlockAllocator<T> {
 public:
  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>& /*other*/) {}  // NOLINT: converts as std::allocator does

  /// Leaves `*place` as it is.
  template <class U>
  void construct(U* /*place*/) noexcept {}
  /// Gives `*place` a value.
  template <class U, class First, class... Rest>
  void construct(U* place, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(place)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
  }
};

/// A vector that may be large.
template <class T>
using BlockVector = std::vector<T, BlockAllocator<T>>;

/// The same, but that resize() leaves new elements without a value.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace orthoball
