// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>

namespace nb = nanobind;

/// A NumPy array that Python may not write: results are immutable values.
template <class T>
using Array = nb::ndarray<nb::numpy, const T, nb::c_contig>;

/// What callers hand over; the Python side has made it contiguous and of this type.
template <class T, std::size_t Dimensions>
using Given = nb::ndarray<const T, nb::ndim<Dimensions>, nb::c_contig, nb::device::cpu>;

/// `values` as an array that owns them, without a copy. Its elements are made of numbers of type T
/// and of nothing else: ids, std::array.
template <class T, class Vector>
[[nodiscard]] Array<T> owned(Vector values, std::initializer_list<std::size_t> shape) {
  static_assert(sizeof(typename Vector::value_type) % sizeof(T) == 0);
  auto* const kept = new Vector(std::move(values));
  const nb::capsule owner(kept, [](void* it) noexcept { delete static_cast<Vector*>(it); });
  return Array<T>(kept->data(), shape, owner);
}

/// The same for one number each.
template <class T, class Vector>
[[nodiscard]] Array<T> owned(Vector values) {
  const std::size_t size = values.size();
  return owned<T>(std::move(values), {size});
}

/// A view of what `owner` holds, which lives as long as any such view.
template <class T, class Element>
[[nodiscard]] Array<T> view(std::span<const Element> values, nb::handle owner,
                            std::initializer_list<std::size_t> shape) {
  static_assert(sizeof(Element) % sizeof(T) == 0);
  return Array<T>(values.data(), shape, owner);
}
