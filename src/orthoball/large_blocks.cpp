// SPDX-License-Identifier: MIT
//
// Blocks are ranges of units of 2 MiB, aligned, so that the system can move a unit from one address
// to another by changing one entry of its tables. Freed units wait on a stack; a new block is a
// range of fresh addresses to whose beginning these are moved. Each moved unit is a mapping of its
// own, of which the system allows a process some 65,000: beyond kMostUnits none are kept or moved.
// Elsewhere than on Linux, and under sanitizers, which want to see every allocation, blocks are the
// allocator's.
#include "orthoball/large_blocks.h"

#include <new>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define ORTHOBALL_SANITIZED
#endif
#endif
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(ORTHOBALL_SANITIZED)
#define ORTHOBALL_UNITS
#endif

#if defined(ORTHOBALL_UNITS)

#include <sys/mman.h>

#include <cstdint>
#include <mutex>
#include <vector>

namespace orthoball {
namespace {

constexpr std::size_t kUnit = std::size_t{2} << 20U;
constexpr std::size_t kMostUnits = 30'000;
static_assert(kUnit % large_blocks::kAlignment == 0);

// Fresh addresses that begin where a unit does; null if there are none.
std::byte* map_units(std::size_t units) {
  const std::size_t bytes = units * kUnit;
  void* const mapped =
      mmap(nullptr, bytes + kUnit, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
  auto* const all = static_cast<std::byte*>(mapped);
  const std::size_t before = (kUnit - reinterpret_cast<std::uintptr_t>(all) % kUnit) % kUnit;
  if (before != 0) munmap(all, before);
  munmap(all + before + bytes, kUnit - before);
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
    if (--reusers_ == 0) release();
  }

  std::byte* allocate(std::size_t units) {
    const std::lock_guard lock(mutex_);
    // So that free() needs no memory.
    if (reusers_ != 0) free_.reserve(free_.size() + in_use_ + units);
    std::byte* block = map_units(units);
    if (block == nullptr) {
      release();
      block = map_units(units);
    }
    if (block != nullptr && !fill(block, units)) block = map_units(units);
    if (block == nullptr) throw std::bad_alloc();
    in_use_ += units;
    return block;
  }
  void free(std::byte* block, std::size_t units) {
    const std::lock_guard lock(mutex_);
    in_use_ -= units;
    if (reusers_ == 0 || in_use_ + free_.size() + units > kMostUnits ||
        free_.capacity() < free_.size() + units) {
      munmap(block, units * kUnit);
      return;
    }
    while (units-- > 0) free_.push_back(block + units * kUnit);  // the first one on top
  }

  std::size_t kept() {
    const std::lock_guard lock(mutex_);
    return free_.size() * kUnit;
  }

 private:
  void release() {
    for (std::byte* unit : free_) munmap(unit, kUnit);
    free_.clear();
    free_.shrink_to_fit();
  }

  // Moves what is kept to the beginning of a fresh block. False, and the block is no more, if the
  // system does not let us; then the addresses of the unit at hand may be another's already, and
  // must be left alone.
  bool fill(std::byte* block, std::size_t units) {
    for (std::size_t i = 0; i < units && !free_.empty(); ++i) {
      std::byte* const to = block + i * kUnit;
      if (mremap(free_.back(), kUnit, kUnit, MREMAP_MAYMOVE | MREMAP_FIXED, to) == MAP_FAILED) {
        if (i > 0) munmap(block, i * kUnit);
        if (i + 1 < units) munmap(to + kUnit, (units - i - 1) * kUnit);
        return false;
      }
      free_.pop_back();
    }
    return true;
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
bool large_blocks::are_reused() { return true; }
std::size_t large_blocks::kept_bytes() { return units().kept(); }

}  // namespace orthoball

#else

namespace orthoball {

LargeBlockReuse::LargeBlockReuse() = default;
LargeBlockReuse::~LargeBlockReuse() = default;

void* large_blocks::allocate(std::size_t bytes) {
  return ::operator new (bytes, std::align_val_t{kAlignment});
}
void large_blocks::free(void* block, std::size_t) noexcept {
  ::operator delete (block, std::align_val_t{kAlignment});
}
bool large_blocks::are_reused() { return false; }
std::size_t large_blocks::kept_bytes() { return 0; }

}  // namespace orthoball

#endif
