// SPDX-License-Identifier: MIT
#include "orthoball/memory_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <sstream>

#include "orthoball/error.h"
#include "orthoball/large_blocks.h"

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace orthoball {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr std::uint64_t kSmall = 64 * kMiB;  // not worth a question

std::uint64_t less(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

// The number that a file holds alone; empty for "max", and where there is no such file.
std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  if (file >> number) return number;
  return std::nullopt;
}

// The number behind `key` at the begin of a line.
std::optional<std::uint64_t> number_behind(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.compare(0, key.size(), key) != 0) continue;
    std::istringstream rest(line.substr(key.size()));
    std::uint64_t number = 0;
    if (rest >> number) return number;
  }
  return std::nullopt;
}

// What the group in this folder leaves: its limit, less what it uses, but for cached files, which
// give way. Empty where it has no limit.
struct GroupFiles {
  const char* limit;
  const char* usage;
  const char* cached;  // in memory.stat
};
constexpr GroupFiles kVersion1{"/memory.limit_in_bytes", "/memory.usage_in_bytes",
                               "total_inactive_file "};
constexpr GroupFiles kVersion2{"/memory.max", "/memory.current", "inactive_file "};

std::optional<std::uint64_t> left_by_group(const std::string& folder, const GroupFiles& files) {
  const auto limit = number_in(folder + files.limit);
  const auto usage = number_in(folder + files.usage);
  if (!limit || !usage) return std::nullopt;
  const std::uint64_t cached = number_behind(folder + "/memory.stat", files.cached).value_or(0);
  return less(*limit, less(*usage, cached));
}

// The least that any group on the way up leaves. In a container the path may name folders that
// cannot be seen there; the mount itself is then the group.
std::optional<std::uint64_t> left_by_groups(const std::string& root) {
  std::optional<std::uint64_t> least;
  const auto see = [&](const std::string& mount, std::string path, const GroupFiles& files) {
    for (;;) {
      if (const auto left = left_by_group(mount + path, files)) {
        least = std::min(least.value_or(*left), *left);
      }
      const std::size_t slash = path.rfind('/');
      if (slash == std::string::npos || path.empty()) return;
      path.resize(slash);
    }
  };
  std::ifstream file(root + "/proc/self/cgroup");
  std::string line;
  while (std::getline(file, line)) {  // "4:memory:/path" and "0::/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string path = line.substr(second + 1);
    if (controllers == ",,") {
      see(root + "/sys/fs/cgroup", path, kVersion2);
      see(root + "/sys/fs/cgroup/unified", path, kVersion2);
    } else if (controllers.find(",memory,") != std::string::npos) {
      see(root + "/sys/fs/cgroup/memory", path, kVersion1);
    }
  }
  return least;
}

// [0]: the address space, [1]: what of it is resident, in bytes.
std::array<std::uint64_t, 2> held(const std::string& root) {
  std::ifstream file(root + "/proc/self/statm");
  std::array<std::uint64_t, 2> pages{};
  file >> pages[0] >> pages[1];
  std::uint64_t size = 4096;
#if defined(__linux__)
  size = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
#endif
  return {pages[0] * size, pages[1] * size};
}

std::optional<std::uint64_t> left_of_address_space(const std::string& root) {
#if defined(__linux__)
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    return less(limit.rlim_cur, held(root)[0]);
  }
#else
  static_cast<void>(root);
#endif
  return std::nullopt;
}

// Per site and per cell, in space and in the plane.
struct Sizes {
  std::uint64_t triangulated_site;
  std::uint64_t cells_of_site;  // tenths
  std::uint64_t site;           // of the filtration, with what it keeps of the triangulation
  std::uint64_t kept_site;      // of the triangulation when it is done
  std::uint64_t kept_cell;
};
constexpr Sizes kPlane{115, 20, 45, 60, 24};
constexpr Sizes kSpace{320, 67, 140, 90, 32};
constexpr std::uint64_t kSimplex = 32;           // bytes of the filtration
constexpr std::uint64_t kSimplexFilter = 10;     // more while a filter is made
constexpr std::uint64_t kSimplexPairs = 15;      // more while lasting pairs are found
constexpr std::uint64_t kSimplexAllPairs = 20;   // or all of them
constexpr std::uint64_t kSimplexSignature = 13;  // more while signatures are scanned

const Sizes& sizes(int dimension) { return dimension == 2 ? kPlane : kSpace; }

// By Euler's relation, but for the facets of the hull, which are few.
std::uint64_t simplices_of(int dimension, std::size_t sites, std::size_t cells) {
  return dimension == 2 ? 5 * cells / 2 + sites : 4 * cells + 2 * sites;
}

std::size_t usual_cells(int dimension, std::size_t sites) {
  return sites / 10 * sizes(dimension).cells_of_site;
}

}  // namespace

std::optional<AvailableMemory> available_memory(const std::string& root) {
  std::optional<AvailableMemory> least;
  const auto see = [&](std::optional<std::uint64_t> bytes, const char* reason) {
    if (bytes && (!least || *bytes < least->bytes)) least = AvailableMemory{*bytes, reason};
  };
  if (const auto kibibytes = number_behind(root + "/proc/meminfo", "MemAvailable:")) {
    see(*kibibytes * 1024, "free on this machine");
  }
  see(left_by_groups(root), "left to this process by its control group");
  see(left_of_address_space(root), "left by the limit of the address space (ulimit -v)");
  return least;
}

void MemoryBudget::require(std::uint64_t bytes, const std::string& work) const {
  std::optional<AvailableMemory> available;
  if (limit_) {
    available =
        AvailableMemory{less(*limit_, held({})[1]), "left of the limit of " + memory_text(*limit_)};
  } else if (bytes >= kSmall) {
    available = available_memory();
  }
  // What is kept for large arrays counts as held.
  if (!available || bytes <= available->bytes + large_blocks::kept_bytes()) return;
  throw LimitError(work + ": about " + memory_text(bytes) + " of memory needed, " +
                   memory_text(available->bytes) + " " + available->reason +
                   "; give it more, or set another limit with --memory-limit");
}

std::uint64_t triangulation_memory(int dimension, std::size_t sites) {
  return sizes(dimension).triangulated_site * sites;
}

std::uint64_t alpha_shapes_memory(int dimension, std::size_t sites) {
  const std::size_t cells = usual_cells(dimension, sites);
  return std::max(triangulation_memory(dimension, sites),
                  sizes(dimension).site * sites + kSimplex * simplices_of(dimension, sites, cells));
}

std::uint64_t filtration_memory(int dimension, std::size_t sites, std::size_t cells) {
  const Sizes& each = sizes(dimension);
  return less(each.site * sites + kSimplex * simplices_of(dimension, sites, cells),
              each.kept_site * sites + each.kept_cell * cells);
}

std::uint64_t filter_memory(std::size_t simplices) { return kSimplexFilter * simplices; }

std::uint64_t persistence_memory(std::size_t simplices, bool all) {
  return (all ? kSimplexAllPairs : kSimplexPairs) * simplices;
}

std::uint64_t signature_memory(std::size_t simplices) { return kSimplexSignature * simplices; }

std::string memory_text(std::uint64_t bytes) {
  constexpr std::array<const char*, 4> kUnits{"KiB", "MiB", "GiB", "TiB"};
  if (bytes < 1024) return std::to_string(bytes) + " bytes";
  double number = static_cast<double>(bytes) / 1024.0;
  std::size_t unit = 0;
  for (; number >= 999.5 && unit + 1 < kUnits.size(); ++unit) number /= 1024.0;
  return number < 9.95 ? fmt::format("{:.1f} {}", number, kUnits[unit])
                       : fmt::format("{:.0f} {}", number, kUnits[unit]);
}

}  // namespace orthoball
