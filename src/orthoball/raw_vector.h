// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace orthoball {

/// Leaves elements that are given no value as the memory is, so that pages are first touched where
/// they are filled. For types that are copied as bytes.
template <class T>
class RawAllocator : public std::allocator<T> {
 public:
  /// The same for another type.
  template <class U>
  struct rebind {
    using other = RawAllocator<U>;  ///< as allocators name it
  };

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

/// A vector whose resize() leaves new elements without a value.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace orthoball
