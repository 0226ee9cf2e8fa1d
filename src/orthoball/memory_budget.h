// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace orthoball {

/// How much memory there is for this process, and why not more.
struct AvailableMemory {
  std::uint64_t bytes = 0;  ///< beyond what the process holds
  std::string reason;       ///< in words: "free on this machine", "left by the control group"
};

/// The least of what the system has free (MemAvailable), what the control groups (versions 1 and 2)
/// leave, and what the limit of the address space leaves. Empty where the system tells none of
/// them. Costs some 0.1 ms.
/// @param root  where /proc and /sys are found.
[[nodiscard]] std::optional<AvailableMemory> available_memory(const std::string& root = {});

/// Holds large work to the memory there is, before it begins instead of when it is too late.
class MemoryBudget {
 public:
  /// What the system has at the time of each question.
  MemoryBudget() = default;
  /// Instead of that: at most `limit` bytes for the process, whatever the system says.
  explicit MemoryBudget(std::uint64_t limit) : limit_(limit) {}

  /// @param bytes  what `work` will take beyond what the process holds; an estimate.
  /// @param work   in words, with its size: "the filtration of 5 sites".
  /// @throws LimitError that says what is needed and what there is. Nothing is asked of the system
  ///         for less than 64 MiB.
  void require(std::uint64_t bytes, const std::string& work) const;

 private:
  std::optional<std::uint64_t> limit_;
};

// Peaks of memory beyond the points themselves, in bytes. Measured over families of points; right
// within about a quarter where cells are as many as usual: 6.7 a site in space, 2 in the plane.

/// Of triangulating so many sites.
[[nodiscard]] std::uint64_t triangulation_memory(int dimension, std::size_t sites);
/// Of the triangulation and then the filtration, before the number of cells is known.
[[nodiscard]] std::uint64_t alpha_shapes_memory(int dimension, std::size_t sites);
/// Of the filtration, beyond the triangulation it is made of.
[[nodiscard]] std::uint64_t filtration_memory(int dimension, std::size_t sites, std::size_t cells);
/// Of a Filter, beyond the filtration.
[[nodiscard]] std::uint64_t filter_memory(std::size_t simplices);
/// Of persistence pairs, beyond the filtration: those that last, or all.
[[nodiscard]] std::uint64_t persistence_memory(std::size_t simplices, bool all);
/// Of a scan of the signatures, beyond the filtration.
[[nodiscard]] std::uint64_t signature_memory(std::size_t simplices);

/// "1.5 GiB".
[[nodiscard]] std::string memory_text(std::uint64_t bytes);

}  // namespace orthoball
