// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace orthoball {

/// How many threads a computation may use. Results never depend on it.
class Threads {
 public:
  /// One for each core.
  Threads();
  /// At most so many, 0 standing for 1. More than there are cores are allowed, and of no use.
  explicit Threads(unsigned most) : count_(most == 0 ? 1 : most) {}

  [[nodiscard]] unsigned count() const { return count_; }
  /// As many of them as have at least `least` elements each of a work of `size` elements, at least
  /// one: small works stay on one thread.
  [[nodiscard]] Threads for_work(std::size_t size, std::size_t least) const;

 private:
  unsigned count_;
};

namespace parallel_detail {

void run_tasks(Threads threads, std::size_t tasks, const void* body,
               void (*call)(const void* body, std::size_t task));

}  // namespace parallel_detail

/// Calls `body(task)` once for every task in 0..tasks - 1 and returns when all calls have: on one
/// thread in order, on several at the same time, in any order. Throws what a call throws; then some
/// others may not have been made. `body` is called from several threads at once.
template <class Body>
void parallel_for(Threads threads, std::size_t tasks, const Body& body) {
  if (threads.count() == 1 || tasks < 2) {
    for (std::size_t task = 0; task < tasks; ++task) body(task);
    return;
  }
  parallel_detail::run_tasks(threads, tasks, &body, [](const void* it, std::size_t task) {
    (*static_cast<const Body*>(it))(task);
  });
}

/// Cuts 0..size - 1 into `parts` ranges of nearly equal length and calls
/// `body(part, begin, end)` for each as parallel_for does; some are empty if there are more parts
/// than elements.
template <class Body>
void parallel_parts(Threads threads, std::size_t size, std::size_t parts, const Body& body) {
  parallel_for(threads, parts, [&](std::size_t part) {
    const std::size_t length = size / parts, longer = size % parts;
    const std::size_t begin = part * length + (part < longer ? part : longer);
    body(part, begin, begin + length + (part < longer ? 1 : 0));
  });
}

}  // namespace orthoball
