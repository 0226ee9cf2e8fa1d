// SPDX-License-Identifier: MIT
//
// Blocks are ranges of units of 2 MiB, aligned, so that the system can move a unit from one address
// to another by changing one entry of its tables. Freed units wait on a stack; a new block is a
// range of fresh addresses to whose beginning these are moved. Elsewhere than on Linux, and under
// sanitizers, which want to see every allocation, blocks are the allocator's.
#include "orthoball/large_blocks.h"

#include <new>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if defined(__has_feature)
#if !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer)
#define ORTHOBALL_UNITS
#endif
#else
#define ORTHOBALL_UNITS
#endif
#endif

#if defined(ORTHOBALL_UNITS)

#include <sys/mman.h>

#include <cstdint>
#include <mutex>
#include <vector>

namespace orthoball {
namespace {

constexpr std::size_t kUnit = std::size_t{2} << 20U;

std::byte* map_anywhere(std::size_t bytes) {
  void* const block =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (block == MAP_FAILED) throw std::bad_alloc();
  return static_cast<std::byte*>(block);
}

// Fresh addresses that begin where a unit does.
std::byte* map_units(std::size_t units) {
  const std::size_t bytes = units * kUnit;
  std::byte* const all = map_anywhere(bytes + kUnit);
  const std::size_t before = (kUnit - reinterpret_cast<std::uintptr_t>(all) % kUnit) % kUnit;
  if (before != 0) munmap(all, before);
  if (before != kUnit) munmap(all + before + bytes, kUnit - before);
  return all + before;
}

class Units {
 public:
  void begin_reuse() {
    const std::lock_guard lock(mutex_);
    ++reusers_;
  }
  void end_reuse() {
    const std::lock_guard lock(mutex_);
    if (--reusers_ != 0) return;
    for (std::byte* unit : free_) munmap(unit, kUnit);
    free_.clear();
    free_.shrink_to_fit();
  }

  std::byte* allocate(std::size_t units) {
    std::byte* const block = map_units(units);
    const std::lock_guard lock(mutex_);
    try {
      for (std::size_t i = 0; i < units && !free_.empty() && move_to(block + i * kUnit); ++i) {
      }
      // So that free() needs no memory.
      if (reusers_ != 0) free_.reserve(free_.size() + in_use_ + units);
    } catch (...) {
      munmap(block, units * kUnit);
      throw;
    }
    in_use_ += units;
    return block;
  }
  void free(std::byte* block, std::size_t units) {
    const std::lock_guard lock(mutex_);
    in_use_ -= units;
    if (reusers_ == 0 || free_.capacity() < free_.size() + units) {
      munmap(block, units * kUnit);
      return;
    }
    while (units-- > 0) free_.push_back(block + units * kUnit);  // the first one on top
  }

 private:
  // Brings the unit on top of the stack to `address`, in the place of a fresh one; false if the
  // system does not let us.
  bool move_to(std::byte* address) {
    if (mremap(free_.back(), kUnit, kUnit, MREMAP_MAYMOVE | MREMAP_FIXED, address) != MAP_FAILED) {
      free_.pop_back();
      return true;
    }
    // The fresh one may be gone.
    if (mmap(address, kUnit, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1,
             0) == MAP_FAILED) {
      throw std::bad_alloc();
    }
    return false;
  }

  std::mutex mutex_;
  std::size_t reusers_ = 0;
  std::size_t in_use_ = 0;        // units of blocks
  std::vector<std::byte*> free_;  // a stack
};

// Never destroyed: arrays may outlive everything.
Units& units() {
  static Units& all = *new Units;
  return all;
}

std::size_t units_of(std::size_t bytes) { return (bytes + kUnit - 1) / kUnit; }

}  // namespace

LargeBlockReuse::LargeBlockReuse() { units().begin_reuse(); }
LargeBlockReuse::~LargeBlockReuse() { units().end_reuse(); }

void* large_blocks::allocate(std::size_t bytes) { return units().allocate(units_of(bytes)); }
void large_blocks::free(void* block, std::size_t bytes) noexcept {
  units().free(static_cast<std::byte*>(block), units_of(bytes));
}

}  // namespace orthoball

#else

namespace orthoball {

LargeBlockReuse::LargeBlockReuse() = default;
LargeBlockReuse::~LargeBlockReuse() = default;

void* large_blocks::allocate(std::size_t bytes) { return ::operator new(bytes); }
void large_blocks::free(void* block, std::size_t) noexcept { ::operator delete(block); }

}  // namespace orthoball

#endif
