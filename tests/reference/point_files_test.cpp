// SPDX-License-Identifier: MIT
// Points of the shared data, where that folder lies beside the project: tables, meshes and point
// clouds as they are found in the wild, and malformed ones.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "orthoball/error.h"
#include "orthoball/input/read.h"

namespace orthoball {
namespace {

const std::filesystem::path kData =
    std::filesystem::path(ORTHOBALL_SOURCE_DIR) / ".." / "shared" / "data";

struct Accepted {
  std::string file;
  std::size_t sites;
  int dimension;
  std::optional<int> decimals;
  ReadOptions options;
  friend void PrintTo(const Accepted& file, std::ostream* out) { *out << file.file; }
};

class AcceptedFile : public testing::TestWithParam<Accepted> {};

TEST_P(AcceptedFile, HasItsSitesAndDecimals) {
  if (!std::filesystem::exists(kData)) GTEST_SKIP() << "no data in ../shared/data";
  const Accepted& expected = GetParam();
  const Reading reading = read((kData / expected.file).string(), expected.options);
  EXPECT_EQ(reading.points.size(), expected.sites);
  EXPECT_EQ(reading.points.dimension(), expected.dimension);
  EXPECT_EQ(reading.points.decimals(), expected.decimals);
}

const ReadOptions kRadii = {.dimension = 3, .radius_column = "4"};

INSTANTIATE_TEST_SUITE_P(
    SharedData, AcceptedFile,
    testing::Values(Accepted{"cloud/bunny.off", 35947, 3, 12, {}},
                    Accepted{"cloud/cgal_blobby.xyz", 3288, 3, {}, {}},
                    Accepted{"cloud/cgal_circles.ply", 1101, 3, {}, {}},
                    Accepted{"cloud/cgal_half.xyz", 325, 3, {}, {}},
                    Accepted{"cloud/cgal_kitten.xyz", 5210, 3, 10, {}},
                    Accepted{"cloud/cgal_oni.pwn", 1435, 3, 6, {}},
                    Accepted{"cloud/galaxies_mr19_mock.csv", 8000, 3, 3, {}},
                    Accepted{"cloud/grid_10_10_10_in_0_1.off", 1000, 3, 1, {}},
                    Accepted{"cloud/human.off", 4706, 3, 6, {}},
                    Accepted{"cloud/lidar_simple.las", 1065, 3, 2, {}},
                    Accepted{"cloud/lidar_test1_4.las", 1000, 3, {}, {}},
                    Accepted{"cloud/lidar_vegetation_1_3.las", 10683, 3, 3, {}},
                    Accepted{"cloud/sphere3D_pts_on_grid.off", 17284, 3, 2, {}},
                    Accepted{"cloud/tore3D_1307.off", 1307, 3, 6, {}},
                    Accepted{"gis/airports.csv", 3376, 2, 8, {}},
                    Accepted{"gis/amacrine.txt", 294, 2, 4, {}},
                    Accepted{"gis/finpines.txt", 126, 2, 13, {}},
                    Accepted{"gis/la-riots.csv", 63, 2, 8, {}},
                    Accepted{"gis/osteo36.txt", 29, 3, {}, {}},
                    Accepted{"material/liq-900K.dat", 864, 3, 5, {.columns = {"2", "3", "4"}}},
                    Accepted{"points/airports_2d.txt", 3376, 2, 8, {}},
                    Accepted{"points/Vol3.txt", 3, 3, 0, kRadii},
                    Accepted{"points/grid10_w.txt", 1000, 3, 3, kRadii},
                    Accepted{"points/bunny_first5000.txt", 5000, 3, 10, {}}));

INSTANTIATE_TEST_SUITE_P(
    Malformed, AcceptedFile,
    testing::Values(Accepted{"malformed/huge_1e300.txt", 5, 3, {}, {.dimension = 3}},
                    Accepted{"malformed/max_double.txt", 4, 3, {}, {.dimension = 3}},
                    Accepted{"malformed/denormals.txt", 5, 3, {}, {.dimension = 3}},
                    Accepted{"malformed/underflow_1e-400.txt", 4, 3, 0, {.dimension = 3}},
                    Accepted{"malformed/negative_zero.txt", 5, 3, 0, {.dimension = 3}},
                    Accepted{"malformed/huge_radius.txt", 4, 3, {}, kRadii},
                    Accepted{"malformed/quoted.csv", 2, 2, 0, {.dimension = 2}},
                    Accepted{"malformed/ok.off", 4, 3, 0, {}},
                    Accepted{"malformed/off_index_out_of_range.off", 3, 3, 0, {}},
                    Accepted{"malformed/ply_list_before_xyz.ply", 2, 3, 0, {}},
                    Accepted{"malformed/ply_big_endian_ok.ply", 2, 3, {}, {}}));

struct Refused {
  std::string file;
  std::string message;  // what the error says, the file's name left out
  ReadOptions options;
  friend void PrintTo(const Refused& file, std::ostream* out) { *out << file.file; }
};

class RefusedFile : public testing::TestWithParam<Refused> {};

TEST_P(RefusedFile, IsRefusedWithItsPlaceAndReason) {
  if (!std::filesystem::exists(kData)) GTEST_SKIP() << "no data in ../shared/data";
  const Refused& expected = GetParam();
  const std::string path = (kData / expected.file).string();
  try {
    static_cast<void>(read(path, expected.options));
    ADD_FAILURE() << "accepted";
  } catch (const ParseError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, path.size()), path);
    EXPECT_NE(std::string(error.what()).find(expected.message), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Malformed, RefusedFile,
    testing::Values(
        Refused{"malformed/overflow_1e400.txt", ":1: column 1 is \"1e400\"", {.dimension = 3}},
        Refused{"malformed/nan.txt", ":3: column 1 is \"nan\"", {.dimension = 3}},
        Refused{"malformed/inf_radius.txt", ":2: column 4 is \"inf\"", kRadii},
        Refused{"malformed/mixed_columns.txt", ":2: 4 columns, expected 3", {.dimension = 3}},
        Refused{"malformed/ragged.csv", ":3: 2 columns, expected 3", {}},
        Refused{"malformed/formula.csv", ":2: column 1 (\"x\") is \"=1+1\"", {}},
        Refused{"malformed/semicolon.csv", ":1: semicolons", {}},
        Refused{"malformed/header_only.csv", "no point or atom found", {}},
        Refused{"malformed/off_count_lies.off", "1000000000 vertices announced, 2 found", {}},
        Refused{"malformed/ply_count_lies.ply", "announced, 1 found", {}},
        Refused{"malformed/ply_binary_truncated.ply", "10 times 12 bytes needed, 50 present", {}},
        Refused{"malformed/ply_no_xyz.ply", "no properties x, y", {}},
        Refused{"malformed/las_truncated.las", "byte 107: 1065 points announced, 52 found", {}},
        Refused{"malformed/las_count_lies.las", "byte 107: 4294967295 points announced", {}},
        Refused{"malformed/las_offset_outside.las", "byte 96: point data begin at", {}},
        Refused{"malformed/las_record_length_zero.las", "byte 105: the record length is 0", {}},
        Refused{"malformed/las_nan_scale.las", "byte 131: the scale is nan", {}},
        Refused{"malformed/las_marked_compressed.las", "byte 104: compressed LAS", {}},
        Refused{"malformed/lammps_bad_atom_count.data", "LAMMPS", {}},
        Refused{"malformed/gzip_bomb_64MB.xyz.gz", "more than 200 times", {}},
        Refused{"malformed/gzip_truncated.pdb.gz", "ends early", {}},
        Refused{"malformed/gzip_garbage.pdb.gz", "corrupt", {}},
        Refused{"cloud/lidar_plane.laz", "LAZ", {}}, Refused{"mol/ligs3d.sdf", "obabel", {}},
        Refused{"mol/small01.mol", "obabel", {}},
        Refused{"mol/2r9r_kchannel.xyz.bz2", "bunzip2", {}},
        Refused{"material/peptide.lammps.data", "LAMMPS", {}}));

}  // namespace
}  // namespace orthoball
