// SPDX-License-Identifier: MIT
#include "orthoball/memory_budget.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "generators/point_families.h"
#include "orthoball/alpha_shapes.h"
#include "orthoball/error.h"

namespace orthoball {
namespace {

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30U;

// A system whose /proc and /sys say what a test wants, in a folder of its own.
class System {
 public:
  explicit System(const std::string& name)
      : root_(std::filesystem::temp_directory_path() / ("orthoball_memory_" + name)) {
    std::filesystem::remove_all(root_);
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  ~System() { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories(
        (root_.string() + path).substr(0, (root_.string() + path).rfind('/')));
    std::ofstream(root_.string() + path) << text;
  }
  [[nodiscard]] std::optional<AvailableMemory> available() const {
    return available_memory(root_.string());
  }

 private:
  std::filesystem::path root_;
};

TEST(AvailableMemory, IsWhatTheMachineHasFree) {
  const System system("machine");
  system.write("/proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable:    4194304 kB\nSwap: 1 kB\n");
  ASSERT_TRUE(system.available());
  EXPECT_EQ(system.available()->bytes, 4 * kGiB);
  EXPECT_EQ(system.available()->reason, "free on this machine");
}

TEST(AvailableMemory, IsUnknownWhereNothingTellsIt) { EXPECT_FALSE(System("nothing").available()); }

TEST(AvailableMemory, IsWhatTheControlGroupLeavesAndCachedFilesGiveWay) {
  const System system("v2");
  system.write("/proc/meminfo", "MemAvailable: 9000000 kB\n");
  system.write("/proc/self/cgroup", "0::/user/job\n");
  system.write("/sys/fs/cgroup/user/job/memory.max", "max\n");
  system.write("/sys/fs/cgroup/user/job/memory.current", "5\n");
  system.write("/sys/fs/cgroup/user/memory.max", std::to_string(2 * kGiB));
  system.write("/sys/fs/cgroup/user/memory.current", std::to_string(kGiB + 1000));
  system.write("/sys/fs/cgroup/user/memory.stat", "anon 7\nactive_file 9\ninactive_file 900\n");
  ASSERT_TRUE(system.available());
  EXPECT_EQ(system.available()->bytes, kGiB - 100);
  EXPECT_EQ(system.available()->reason, "left to this process by its control group");
}

TEST(AvailableMemory, KnowsTheFirstVersionOfControlGroupsFromInsideAContainer) {
  const System system("v1");
  system.write("/proc/meminfo", "MemAvailable: 9000000 kB\n");
  system.write("/proc/self/cgroup", "5:cpu,cpuacct:/x\n4:memory:/docker/abc\n0::/\n");
  system.write("/sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(kGiB));
  system.write("/sys/fs/cgroup/memory/memory.usage_in_bytes", std::to_string(2 * kGiB));
  ASSERT_TRUE(system.available());
  EXPECT_EQ(system.available()->bytes, 0U);  // already over it
}

TEST(MemoryText, HasTwoFiguresOrMore) {
  EXPECT_EQ(memory_text(0), "0 bytes");
  EXPECT_EQ(memory_text(1023), "1023 bytes");
  EXPECT_EQ(memory_text(1536), "1.5 KiB");
  EXPECT_EQ(memory_text(9 * kGiB / 2), "4.5 GiB");
  EXPECT_EQ(memory_text(1023 * kGiB), "1.0 TiB");
  EXPECT_EQ(memory_text(640 * kGiB), "640 GiB");
}

TEST(MemoryBudget, RefusesWhatALimitDoesNotLeave) {
  const MemoryBudget budget(400 * kGiB);
  EXPECT_NO_THROW(budget.require(300 * kGiB, "the work"));
  try {
    budget.require(500 * kGiB, "the work");
    FAIL();
  } catch (const LimitError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "the work: about 500 GiB of memory needed, 400 GiB left of the limit of 400 GiB; give "
        "it more, or set another limit with --memory-limit");
  }
}

TEST(MemoryBudget, RefusesMoreThanAnyMachineHas) {
  EXPECT_THROW(MemoryBudget().require(std::uint64_t{1} << 60U, "too much"), LimitError);
  EXPECT_NO_THROW(MemoryBudget().require(1, "little"));
}

TEST(AlphaShapes, AreNotBegunWithoutTheMemoryForThem) {
  const auto points = generators::points_of(generators::PointFamily::uniform, 3, 1000, 1);
  EXPECT_THROW(AlphaShapes(points, {.memory = MemoryBudget(1)}), LimitError);
  EXPECT_EQ(AlphaShapes(points, {.memory = MemoryBudget(64 * kGiB)}).points().size(), 1000U);
  // Nothing is asked of the system for work this small.
  EXPECT_EQ(AlphaShapes(points).points().size(), 1000U);
}

TEST(AlphaShapes, AreLeftBeforeTheFiltrationIfThereAreMoreCellsThanUsual) {
  // Two skew lines: every two edges, one on each, make a tetrahedron.
  std::vector<double> coordinates;
  for (int i = 0; i < 300; ++i) {
    coordinates.insert(coordinates.end(), {1.0 * i, 0.0, 0.0});
    coordinates.insert(coordinates.end(), {0.0, 1.0 * i, 100.0});
  }
  const WeightedPoints points(3, coordinates, WeightKind::none, {});
  int stages = 0;
  BuildOptions options{.on_stage = [&](BuildStage) { ++stages; }};
  const std::uint64_t usual = alpha_shapes_memory(3, points.size());
  ASSERT_LT(10 * usual, filtration_memory(3, points.size(), 299 * 299));
  // Enough for what the process holds and the triangulation, not for the filtration.
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> resident >> resident;
  options.memory = MemoryBudget(4096 * resident + 2 * usual);
  EXPECT_THROW(AlphaShapes(points, options), LimitError);
  EXPECT_EQ(stages, 2);
}

}  // namespace
}  // namespace orthoball
