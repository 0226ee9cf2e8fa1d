// SPDX-License-Identifier: MIT
#include "orthoball/output/molecule.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

WeightedPoints points(std::vector<double> coordinates, int dimension = 3) {
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

std::string pdb(const WeightedPoints& atoms, const SiteLabels& labels,
                const std::vector<double>& values, PdbLosses* losses = nullptr) {
  return written([&](ByteSink& s) {
    const PdbLosses found = write_pdb(s, atoms, labels, values);
    if (losses != nullptr) *losses = found;
  });
}

TEST(Pdb, HasARecordForEveryRowInTheColumnsOfTheFormat) {
  SiteLabels labels;
  labels.chain = {"A", "B", "", "AB"};
  labels.residue = {"ALA", "DC", "CA", "HOH"};
  labels.residue_id = {"12", "-5", "301", "7A"};
  labels.atom = {"CA", "HO5'", "CA", "O"};
  labels.element = {"C", "H", "Ca", "O"};
  const auto text = pdb(points({1, -2.5, 1234.5678, -999.9994, 0, -0.0001, 1, 2, 3, 4, 5, 6}),
                        labels, {0, 12.345678, 100.5, 999.99});
  EXPECT_EQ(lines(text),
            (std::vector<std::string>{
                "ATOM      1  CA  ALA A  12       1.000  -2.5001234.568  1.00  0.00           C  ",
                "ATOM      2 HO5'  DC B  -5    -999.999   0.000   0.000  1.00 12.35           H  ",
                "ATOM      3 CA    CA   301       1.000   2.000   3.000  1.00100.50          CA  ",
                "ATOM      4  O   HOHAB   7A      4.000   5.000   6.000  1.00999.99           O  ",
                "END" + std::string(77, ' ')}));
}

TEST(Pdb, NamesWhatIsNotKnown) {
  SiteLabels elements;
  elements.element = {"Fe"};
  EXPECT_EQ(lines(pdb(points({1, 2, 3}), elements, {1}))[0],
            "ATOM      1 FE   UNK     1       1.000   2.000   3.000  1.00  1.00          FE  ");
  EXPECT_EQ(lines(pdb(points({1, 2}, 2), {}, {1}))[0],
            "ATOM      1  X   UNK     1       1.000   2.000   0.000  1.00  1.00           X  ");
  EXPECT_EQ(pdb(points({}), {}, {}), "END" + std::string(77, ' ') + "\n");
}

TEST(Pdb, CountsWhatDoesNotFit) {
  SiteLabels labels;
  labels.atom = {"CA", "C1234", "C"};
  labels.residue = {"ALA", "A1ABC", "C"};
  labels.residue_id = {"10000", "123456789", "A000"};
  labels.chain = {"A", "ABC", "A"};
  PdbLosses losses;
  const double infinity = std::numeric_limits<double>::infinity();
  const auto text = lines(pdb(points({0, 0, 0, 1, 1, 1, 2, 2, 2}), labels,
                              {1000, infinity, -std::numeric_limits<double>::infinity()}, &losses));
  EXPECT_EQ(losses.values, 3U);
  EXPECT_EQ(losses.labels, 4U);
  EXPECT_EQ(text[0].substr(12, 15), " CA  ALA AA000 ");
  EXPECT_EQ(text[1].substr(12, 15), "C123 A1AAB1234 ");
  EXPECT_EQ(text[2].substr(12, 15), " C     C AA000 ");
  EXPECT_EQ(text[0].substr(60, 6), "999.99");
  EXPECT_EQ(text[1].substr(60, 6), "999.99");
  EXPECT_EQ(text[2].substr(60, 6), "-99.99");
}

TEST(Pdb, NumbersBeyond99999CountOnWithLetters) {
  std::vector<double> coordinates(3 * 100037);
  const auto text = lines(pdb(points(coordinates), {}, std::vector<double>(100037)));
  EXPECT_EQ(text[99998].substr(0, 12), "ATOM  99999 ");
  EXPECT_EQ(text[99999].substr(0, 12), "ATOM  A0000 ");
  EXPECT_EQ(text[100035].substr(0, 12), "ATOM  A0010 ");
}

TEST(Pdb, CoordinatesThatDoNotFitAreRefusedByRow) {
  for (const double x : {9999.9996, -999.9996, 1e300}) {
    std::ostringstream out;
    ByteSink sink(out);
    try {
      write_pdb(sink, points({0, 0, 0, 0, x, 0}), {}, std::vector<double>(2));
      ADD_FAILURE() << x;
    } catch (const LimitError& error) {
      EXPECT_NE(std::string(error.what()).find("row 1: y is "), std::string::npos) << error.what();
    }
    sink.flush();
    EXPECT_EQ(out.str(), "");
  }
  EXPECT_NO_THROW(require_pdb_points(points({9999.9994, -999.9994, 0})));
}

ViewerScene scene() {
  ViewerScene scene{"a \"b\".pdb", "two\nlines", "voids", {}};
  scene.parts.push_back({"void_1", "void 1", {{{1, 2, 3.25}, 1.5}, {{1, 2, 4}, 0.5}}, {}});
  for (const unsigned row : {0U, 1U, 2U, 3U}) scene.parts[0].atoms.emplace_back(row);
  scene.parts.push_back({"void_2", "void 2", {}, {}});
  return scene;
}

SiteLabels scene_labels() {
  SiteLabels labels;
  labels.chain = {"A", "A", "", "B"};
  labels.residue_id = {"12", "12", "-5", "7A"};
  labels.atom = {"O5'", "CA", "CB", ""};
  return labels;
}

TEST(ViewerScript, OfPymolIsPython) {
  const std::string text =
      written([](ByteSink& s) { write_viewer_script(s, Viewer::pymol, scene(), scene_labels()); });
  for (const char* const part :
       {"# two lines\npython\n", R"(os.path.dirname(__script__), "a \"b\".pdb"), "molecule"))",
        "    cmd.group(\"voids\", name)\n",
        "# void 1\nshow_part(\"void_1\", (0.902, 0.624, 0.000), [(1.000, 2.000, 3.250, 1.500), "
        "(1.000, 2.000, 4.000, 0.500)], [(\"A\", \"12\", \"O5' CA\"), (\"\", \"-5\", \"CB\")])\n",
        "# void 2\nshow_part(\"void_2\", (0.337, 0.706, 0.914), [], [])\n",
        "cmd.zoom()\npython end\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }
}

TEST(ViewerScript, OfChimeraxIsCommands) {
  EXPECT_EQ(written([](ByteSink& s) {
              write_viewer_script(s, Viewer::chimerax, scene(), scene_labels());
            }),
            "# two lines\n"
            "open \"a \\\"b\\\".pdb\" id 1\n"
            "color #1 lightgray\n"
            "\n# void 1\n"
            "marker #2 position 1.000,2.000,3.250 radius 1.500 color #e69f00\n"
            "marker #2 position 1.000,2.000,4.000 radius 0.500 color #e69f00\n"
            "rename #2 \"void_1\"\n"
            "name frozen void_1_atoms #1/A:12@O5',CA | #1:-5@CB\n"
            "\n# void 2\n"
            "\nview\n");
}

TEST(ViewerScript, IsToldByItsEnding) {
  EXPECT_EQ(viewer_of("pml"), Viewer::pymol);
  EXPECT_EQ(viewer_of("cxc"), Viewer::chimerax);
  EXPECT_FALSE(viewer_of("py"));
}

}  // namespace
}  // namespace orthoball
