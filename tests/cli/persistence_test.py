#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `persistence` writes, compared with closed forms and with `signatures`.

Usage: persistence_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import unittest

from program import C60, EIGHT, InAFolder, SAMPLES, TWO_BALLS

TORI = str(SAMPLES / "linked_tori.csv")


class Persistence(InAFolder):
    def pairs(self, *arguments):
        return json.loads(self.done("persistence", *arguments, "--json").stdout)

    def test_two_balls_join_half_way(self):
        self.assertEqual(self.done("persistence", TWO_BALLS).stdout,
                         "dimension,birth,death,birth_simplex,death_simplex\n"
                         "0,-1,,0,\n"
                         "0,-1,1.25,1,0 1\n")

    def test_linked_tori_have_two_voids_and_four_tunnels(self):
        lasting = self.pairs(TORI, "--minimum-length", "0.1")
        self.assertEqual([pair["dimension"] for pair in lasting], [0, 0, 1, 1, 1, 1, 2, 2])
        self.assertEqual([pair["death"] for pair in lasting].count(None), 1)

    def test_as_many_live_as_the_betti_numbers_say(self):
        for path in [C60, EIGHT]:
            pairs = self.pairs(path, "--indices")
            table = csv.DictReader(io.StringIO(
                self.done("signatures", path, "--samples", "50").stdout))
            for row in table:
                index = int(row["index"])
                for k in range(3 if path == C60 else 2):
                    living = [pair for pair in pairs if pair["dimension"] == k
                              and pair["birth"] <= index
                              and (pair["death"] is None or pair["death"] > index)]
                    self.assertEqual(len(living), int(row[f"betti_{k}"]))

    def test_formats_say_the_same(self):
        rows = list(csv.DictReader(io.StringIO(self.done("persistence", C60).stdout)))
        pairs = self.pairs(C60)
        lines = self.done("persistence", C60, "--format", "gudhi").stdout.splitlines()
        self.assertEqual(len(rows), len(pairs))
        for row, pair, line in zip(rows, pairs, lines, strict=True):
            self.assertEqual(int(row["dimension"]), pair["dimension"])
            self.assertEqual(float(row["birth"]), pair["birth"])
            self.assertEqual(float(row["death"]) if row["death"] else None, pair["death"])
            self.assertEqual([int(x) for x in row["birth_simplex"].split()], pair["birth_simplex"])
            self.assertEqual(len(pair["birth_simplex"]), pair["dimension"] + 1)
            self.assertEqual(line.split(), ["2", row["dimension"], row["birth"],
                                            row["death"] or "inf"])

    def test_gudhi_has_no_empty_column_for_numbers_beyond_doubles(self):
        far = self.file("far.csv", "x,y\n0,0\n1e300,0\n0,1e300\n")
        lines = self.done("persistence", far, "--all", "--format", "gudhi").stdout.splitlines()
        self.assertEqual(sorted(lines), ["2 0 0 inf"] * 3 + ["2 1 inf inf"])
        indices = self.done("persistence", far, "--all", "--format", "gudhi", "--indices").stdout
        self.assertNotIn("2 1 inf", indices)

    def test_all_pairs_are_all_simplices(self):
        pairs = self.pairs(C60, "--all")
        simplices = self.done("filter", C60).stdout.count("\n") - 1
        self.assertEqual(sum(1 + (pair["death"] is not None) for pair in pairs), simplices)
        tunnels = self.pairs(C60, "--all", "--homology-dimension", "1")
        self.assertEqual(tunnels, [pair for pair in pairs if pair["dimension"] == 1])

    def test_the_ending_tells_the_format(self):
        for name, begin in [("a.json", "[\n{"), ("a.pers", "2 0 "), ("a.csv", "dimension,")]:
            path = self.folder / name
            self.done("persistence", C60, "-o", path)
            self.assertTrue(path.read_text().startswith(begin))

    def test_plots_have_a_mark_for_each_class(self):
        path = self.folder / "plot.svg"
        for kind, mark in [("diagram", "Z"), ("barcode", "H")]:
            self.done("persistence", TORI, "--minimum-length", "0.1", "-o", self.folder / "a.csv",
                      "--plot", path, "--plot-kind", kind)
            plot = path.read_text()
            for k, count in enumerate([2, 4, 2]):
                drawn = plot.split(f'class="dimension {k}"')[1].split('d="')[1].split('"')[0]
                self.assertEqual(drawn.count(mark), count + (kind == "diagram"))  # the legend's
            self.assertEqual(plot.count(">never<"), kind == "diagram")

    def test_mistakes_are_explained(self):
        plot = self.folder / "plot.svg"
        for arguments, message in [
            ([EIGHT, "--homology-dimension", "2"], "of the dimensions 0 to 1"),
            ([C60, "--minimum-length", "-1"], "0 or more"),
            ([C60, "--minimum-length", "long"], "--minimum-length"),
            ([C60, "--plot", plot, "-o", plot], "name the same file"),
            ([C60, "--plot", self.folder / "plot.png"], "a picture is SVG"),
            ([C60, "--plot-kind", "barcode"], "--plot"),
        ]:
            self.assertIn(message, self.refused(2, "persistence", *arguments))


if __name__ == "__main__":
    unittest.main()
