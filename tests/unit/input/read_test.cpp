// SPDX-License-Identifier: MIT
#include "orthoball/input/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "orthoball/error.h"

namespace orthoball {
namespace {

// A folder that lives as long as this.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "orthoball_read_test/") {
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ + name, std::ios::binary) << bytes;
    return path_ + name;
  }

 private:
  std::string path_;
};

std::string format_of(const std::string& name, const std::string& bytes,
                      const ReadOptions& options = {}) {
  const TemporaryFolder folder;
  return read(folder.file(name, bytes), options).format;
}

std::string error_of(const std::string& name, const std::string& bytes,
                     const ReadOptions& options = {}) {
  const TemporaryFolder folder;
  try {
    static_cast<void>(read(folder.file(name, bytes), options));
  } catch (const ParseError& error) {
    return error.what();
  }
  return {};
}

TEST(Read, ABallWithoutRadiusIsAFaultOfTheFileAtItsLine) {
  const std::string error = error_of("a.xyzr", "# balls\n\n1 2 3\n");
  EXPECT_NE(error.find("a.xyzr:3: fewer than four columns"), std::string::npos) << error;
}

TEST(Read, TheFileNameTellsTheFormat) {
  EXPECT_EQ(format_of("a.csv", "1,2,3\n"), "table");
  EXPECT_EQ(format_of("A.TXT", "1 2 3\n"), "table");
  EXPECT_EQ(format_of("a.b.off", "OFF\n1 0 0\n1 2 3\n"), "off");
  EXPECT_EQ(format_of("a.obj", "v 1 2 3\n"), "obj");
  EXPECT_EQ(format_of("a.json", R"({"type": "Point", "coordinates": [1, 2]})"), "geojson");
  EXPECT_EQ(format_of("a.xyzr", "1 2 3 4\n"), "xyzr");
}

TEST(Read, AnXyzFileWithoutACountIsATable) {
  EXPECT_EQ(format_of("a.xyz", "1\nwater\nO 0 0 0\n"), "xyz");
  EXPECT_EQ(format_of("a.xyz", "1 2 3\n4 5 6\n"), "table");
  EXPECT_NE(error_of("a.xyz", "-1\nwater\n").find(".xyz:1:"), std::string::npos);
}

TEST(Read, AFixedPointCommandTellsThe1995Format) {
  EXPECT_EQ(format_of("a.txt", "#fix: 7.3\n1 2 3 0.5\n"), "alpha_1995");
  EXPECT_EQ(format_of("a.xyz", "#fix: 7.3\n1 2 3 0.5\n"), "alpha_1995");
  EXPECT_EQ(format_of("a.txt", "#fix: 7.3\n1 2 3\n", {.format = "table"}), "table");
  EXPECT_EQ(format_of("a", "#title: t\n#fix: 6.2\n0 0 0\n"), "alpha_1995");
  EXPECT_EQ(format_of("a.1995", "#fix: 6.2\n0 0 0\n"), "alpha_1995");
}

TEST(Read, TheFormatCanBeNamed) {
  EXPECT_EQ(format_of("a.weights", "1 2 3\n", {.format = "table"}), "table");
  EXPECT_NE(error_of("a.weights", "1 2 3\n").find("--input-format: table, alpha_1995, off"),
            std::string::npos);
  EXPECT_NE(error_of("a", "1 2 3\n").find("without an ending"), std::string::npos);
  for (const char* name : {"table", "pdb", "cif", "geojson"}) {
    const auto& names = input_formats();
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(Read, OtherFormatsAreRefusedWithAWayToConvert) {
  EXPECT_NE(error_of("a.laz", "LASF").find("laspy"), std::string::npos);
  EXPECT_NE(error_of("a.sdf", "").find("obabel"), std::string::npos);
  EXPECT_NE(error_of("a.mol", "").find("obabel"), std::string::npos);
  EXPECT_NE(error_of("a.lammps.data", "").find("LAMMPS"), std::string::npos);
  EXPECT_NE(error_of("a.xyz.bz2", "").find("bunzip2"), std::string::npos);
  EXPECT_NE(error_of("a.csv.zst", "").find("unzstd"), std::string::npos);
}

TEST(Read, AFileWithoutSitesIsAnErrorUnlessAllowed) {
  EXPECT_NE(error_of("a.csv", "x,y,z\n").find("no point or atom found"), std::string::npos);
  EXPECT_NE(error_of("a.pdb", ""), "");
  EXPECT_EQ(error_of("a.csv", "x,y,z\n", {.allow_empty = true}), "");
}

TEST(Read, ATableWithoutRowsHasTheDimensionOfItsHeader) {
  const TemporaryFolder folder;
  const auto dimension = [&](const std::string& text, std::vector<std::string> columns) {
    ReadOptions options{.allow_empty = true};
    options.columns = std::move(columns);
    return read(folder.file("a.csv", text), options).points.dimension();
  };
  EXPECT_EQ(dimension("lat,lon\n", {}), 2);
  EXPECT_EQ(dimension("x,y,z\n", {}), 3);
  EXPECT_EQ(dimension("", {}), 3);
  EXPECT_EQ(dimension("", {"1", "2"}), 2);
}

TEST(Read, TextFormatsRefuseOtherBytes) {
  EXPECT_NE(error_of("a.csv", std::string("1,2\n3,\0", 7)).find(".csv:2: a NUL byte"),
            std::string::npos);
  EXPECT_NE(error_of("a.off", "\x89PNG\r\n").find("PNG"), std::string::npos);
  EXPECT_EQ(error_of("a.csv", "\xef\xbb\xbfx,y\n1,2\n"), "");
}

TEST(Read, WhatIsLargerThanTheMemoryIsRefusedByTheNameOfTheFile) {
  const TemporaryFolder folder;
  const std::string table = folder.file("a.csv", "1,2,3\n");
  EXPECT_THROW(static_cast<void>(read(table, {.memory = MemoryBudget(1)})), LimitError);
  EXPECT_EQ(read(table, {.memory = MemoryBudget(std::uint64_t{1} << 40U)}).points.size(), 1U);
  try {
    static_cast<void>(read(table, {.memory = MemoryBudget(0)}));
    FAIL();
  } catch (const LimitError& error) {
    EXPECT_EQ(std::string(error.what()).find(table + ": about 6 bytes of memory needed"), 0U);
  }
}

TEST(Read, OptionsMustFitEachOther) {
  const TemporaryFolder folder;
  const std::string table = folder.file("a.csv", "1,2,3,4\n");
  const std::string molecule = folder.file("a.xyz", "1\n\nO 0 0 0\n");
  for (const ReadOptions& options :
       {ReadOptions{.dimension = 4}, ReadOptions{.radius_column = "1", .weight_column = "2"},
        ReadOptions{.columns = {"1"}}, ReadOptions{.dimension = 3, .columns = {"1", "2"}},
        ReadOptions{.format = "excel"}}) {
    EXPECT_THROW(static_cast<void>(read(table, options)), InputError);
  }
  EXPECT_THROW(static_cast<void>(read(molecule, {.radius_column = "4"})), InputError);
  EXPECT_THROW(static_cast<void>(read("-", {})), InputError);
}

}  // namespace
}  // namespace orthoball
