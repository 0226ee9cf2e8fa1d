// SPDX-License-Identifier: MIT
//
// The only file that knows of oneTBB. Without it everything runs on the caller's thread.
#include "orthoball/parallel.h"

#include <algorithm>
#include <optional>

#if defined(ORTHOBALL_TBB)
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif
#if defined(ORTHOBALL_TSAN)
#include <sanitizer/tsan_interface.h>
#endif

namespace orthoball {

#if defined(ORTHOBALL_TBB)

namespace {

// Tells the thread sanitizer, which cannot see into oneTBB, that tasks come after what their caller
// did before, and before what it does next; of two tasks neither comes first. This file itself is
// not instrumented, or it would report what oneTBB's headers do.
class Handover {
 public:
#if defined(ORTHOBALL_TSAN)
  void begin() { __tsan_release(&begun_); }
  void begin_task() { __tsan_acquire(&begun_); }
  void end_task() { __tsan_release(&ended_); }
  void end() { __tsan_acquire(&ended_); }

 private:
  char begun_ = 0, ended_ = 0;
#else
  void begin() {}
  void begin_task() {}
  void end_task() {}
  void end() {}
#endif
};

}  // namespace

Threads::Threads() : count_(static_cast<unsigned>(std::max(1, tbb::info::default_concurrency()))) {}

void parallel_detail::run_tasks(Threads threads, std::size_t tasks, const void* body,
                                void (*call)(const void* body, std::size_t task)) {
  // oneTBB prints a warning where more threads are asked for than its limit, the number of cores.
  std::optional<tbb::global_control> more;
  if (static_cast<int>(threads.count()) > tbb::info::default_concurrency()) {
    more.emplace(tbb::global_control::max_allowed_parallelism, threads.count());
  }
  tbb::task_arena arena(static_cast<int>(threads.count()));
  Handover handover;
  handover.begin();
  arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, tasks,
        [&](std::size_t task) {
          handover.begin_task();
          call(body, task);
          handover.end_task();
        },
        tbb::simple_partitioner());
  });
  handover.end();
}

#else

Threads::Threads() : count_(1) {}

void parallel_detail::run_tasks(Threads, std::size_t tasks, const void* body,
                                void (*call)(const void* body, std::size_t task)) {
  for (std::size_t task = 0; task < tasks; ++task) call(body, task);
}

#endif

Threads Threads::for_work(std::size_t size, std::size_t least) const {
  const std::size_t enough = size / std::max<std::size_t>(least, 1);
  return Threads(static_cast<unsigned>(std::min<std::size_t>(count_, enough)));
}

}  // namespace orthoball
