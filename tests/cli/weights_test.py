#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""weights_test.py PROGRAM: weights that are made from the data."""

import csv
import json
import struct
import unittest

from program import InAFolder, SAMPLES

TORUS = SAMPLES / "uneven_torus.csv"


class FromDensity(InAFolder):
    def signatures(self, *options):
        table = self.folder / "table.csv"
        self.done("signatures", TORUS, *options, "-o", table, "--quiet")
        rows = csv.DictReader(table.read_text().splitlines())
        return [(float(row["alpha2"]), tuple(int(row[f"betti_{k}"]) for k in range(3))) for row in rows]

    def test_one_alpha_serves_sparse_and_dense_parts(self):
        torus = (1, 2, 1)
        self.assertNotIn(torus, [betti for _, betti in self.signatures()])
        weighted = self.signatures("--weights", "density:12")
        right = [alpha2 for alpha2, betti in weighted if betti == torus]
        self.assertLess(right[0], -0.002)
        self.assertGreater(right[-1], 0.015)
        between = [betti for alpha2, betti in weighted if right[0] <= alpha2 <= right[-1]]
        self.assertEqual(set(between), {torus})

    def test_every_command_takes_it_and_says_so(self):
        source = self.file("points.csv", "x,y\n0,0\n1,0\n0,1\n4,4\n9,0\n")
        commands = [("summary",), ("signatures",), ("shape", "--format", "svg"), ("filter",),
                    ("measure",), ("persistence",), ("figure",)]
        for command, *options in commands:
            said = self.done(command, source, *options, "--weights", "density:2")
            words = "density, half the mean square distance to the 2 nearest"
            self.assertIn(words, said.stdout + said.stderr, command)

    def test_the_weights_are_the_formula(self):
        source = self.file("line.csv", "x,y,r\n0,0,7\n0.1,0,8\n0.3,0,9\n")
        lines = self.done("filter", source, "--weights", "density:1", "--format", "json").stdout
        vertices = [json.loads(line) for line in lines.splitlines() if '"dimension":0' in line]
        alpha2 = {tuple(row["vertices"]): row["alpha2"] for row in vertices}
        self.assertEqual(alpha2, {(0,): -0.005, (1,): -0.005, (2,): -0.02})

    def test_rows_and_threads_do_not_matter(self):
        lines = TORUS.read_text().splitlines()
        backwards = self.file("back.csv", "\n".join([lines[0], *reversed(lines[1:])]) + "\n")
        option = ("--weights", "density:12", "--json", "--quiet")
        one = json.loads(self.done("summary", TORUS, *option, "--threads", "1").stdout)
        other = json.loads(self.done("summary", backwards, *option, "--threads", "4").stdout)
        del one["input"], other["input"]
        self.assertEqual(one, other)

    def test_refuses_what_is_no_density(self):
        for text in ("density", "density:", "density:0", "density:-1", "density:2.5", "dense:3", "8"):
            said = self.refused(2, "summary", TORUS, "--weights", text)
            self.assertIn(f'"{text}" is no way to make weights; density:K is', said)
        for other in (("--radius-column", "x"), ("--weight-column", "x"), ("--radii", "none")):
            self.refused(2, "summary", TORUS, "--weights", "density:3", *other)

    def test_needs_more_positions_than_neighbours(self):
        source = self.file("few.csv", "x,y\n0,0\n1,0\n0,0\n")
        said = self.refused(1, "summary", source, "--weights", "density:2")
        self.assertIn("few.csv: the 2 nearest neighbours are asked for, and there are 2 sites at "
                      "different positions; there must be more than neighbours", said)
        one = self.file("one.csv", "x,y\n0,0\n")
        said = self.refused(1, "summary", one, "--weights", "density:1")
        self.assertIn("the nearest neighbour is asked for, and there is 1 site at", said)
        far = self.file("far.csv", "x,y\n0,0\n1e200,0\n")
        said = self.refused(1, "summary", far, "--weights", "density:1")
        self.assertIn("far.csv:2: row 0: the squared distances", said)


PLANE = """x,y
0,0
4,0
4,3
0,3
2,1.5
7,9
"""


class Enforced(InAFolder):
    def enforce(self, points, simplices, *options):
        source = self.file("points.csv", points)
        wanted = self.file("wanted.txt", simplices)
        output = self.folder / "weighted.csv"
        said = self.done("enforce", source, wanted, *options, "-o", output)
        return said.stderr, output

    def present(self, table, alpha2, *options):
        """The simplices of the complex, by their rows."""
        lines = self.done("filter", table, *options, "--alpha2", alpha2, "--quiet").stdout.splitlines()
        return {tuple(map(int, line.split(",")[2].split())) for line in lines[1:]}

    def test_what_is_written_is_read_back_exactly(self):
        said, table = self.enforce(PLANE, "0 2\n", "--alpha2", "3")
        self.assertRegex(said, r"1 simplex held at alpha2 3: \d of 6 weights changed, by [\d.]+ in total")
        weighted = self.present(table, 3, "--weight-column", "weight")
        self.assertIn((0, 2), weighted)
        self.assertNotIn((0, 2), self.present(self.folder / "points.csv", 3))
        again = self.folder / "again.csv"
        said = self.done("enforce", table, self.folder / "wanted.txt", "--weight-column", "weight",
                         "--alpha2", "3", "-o", again)
        self.assertIn("0 of 6 weights changed, by 0 in total", said.stderr)
        self.assertEqual(again.read_text(), table.read_text())

    def test_radii_stay_the_weights_they_are(self):
        balls = "x,y,r\n0,0,0.3\n4,0,0.1\n4,3,0.7\n0,3,0\n2,1.5,-0.2\n50,50,1.1\n"
        said, table = self.enforce(balls, "0 2\n", "--alpha2", "3", "--radius-column", "r")
        rows = [line.split(",") for line in table.read_text().splitlines()]
        self.assertEqual(rows[0], ["x", "y", "weight"])
        self.assertEqual(rows[6], ["50", "50", "1.21"])

    def test_nothing_changes_where_all_is_there(self):
        said, table = self.enforce(PLANE, "0 1 4\n", "--alpha2", "9")
        self.assertIn("0 of 6 weights changed, by 0 in total", said)
        rows = PLANE.splitlines()
        expected = [rows[0] + ",weight", *(row + ",0" for row in rows[1:])]
        self.assertEqual(table.read_text().splitlines(), expected)

    def test_excluding_simplices_are_named(self):
        source = self.file("points.csv", PLANE)
        wanted = self.file("wanted.txt", "# diagonals\n2 5\n0 2\n3 1\n")
        said = self.refused(1, "enforce", source, wanted, "-o", self.folder / "no.csv")
        self.assertEqual(said, f"orthoball: {wanted}:3: no weights hold these simplices together: "
                               "line 3 (0 2), line 4 (1 3); leave out one of them, or --add-sites\n")
        self.assertFalse((self.folder / "no.csv").exists())

    def test_a_triangle_excludes_the_edge_across_it(self):
        square = self.file("square.csv", "x,y\n0,0\n4,0\n4,3\n0,3\n")
        both = self.file("both.txt", "0 1 2\n1 3\n")
        said = self.refused(1, "enforce", square, both)
        self.assertIn("line 1 (0 1 2), line 2 (1 3)", said)

    def test_doubles_are_held_as_they_will_be_read(self):
        points = self.folder / "points.npy"
        header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"
        header += b" " * (128 - 10 - len(header) - 1) + b"\n"
        points.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header +
                           struct.pack("<4d", 0.0, 0.0, 0.009, 0.0))
        output = self.folder / "out.csv"
        alpha2 = "2.0249999999999998e-05"
        self.done("enforce", points, self.file("edge.txt", "0 1\n"), "--alpha2", alpha2, "-o",
                  output)
        option = ["--weight-column", "weight"] if "weight" in output.read_text() else []
        lines = self.done("filter", output, *option, "--alpha2", alpha2).stdout
        self.assertIn("0 1", lines)

    def test_of_many_hidden_rows_ten_are_named(self):
        inside = "".join(f"{50 + k},{50 + k}\n" for k in range(1, 13))
        said, _ = self.enforce("x,y\n0,0\n300,0\n0,300\n" + inside, "0 1 2\n", "--alpha2", "1e6")
        self.assertIn("warning: these rows are hidden now: 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 2 more\n", said)

    def test_sites_are_added_where_simplices_meet(self):
        said, table = self.enforce(PLANE, "0 2\n3 1\n5 2\n", "--alpha2", "3", "--add-sites")
        self.assertIn("3 simplices held at alpha2 3: ", said)
        self.assertIn("orthoball: 0 sites added\n", said)  # row 4 stands where the diagonals cross
        for line in ("line 1 (0 2)", "line 2 (1 3)"):
            self.assertIn(f"orthoball: {line} is held in parts, cut at row 4\n", said)
        self.assertNotIn("line 3 (2 5) is held", said)
        weighted = self.present(table, 3, "--weight-column", "weight")
        self.assertLessEqual({(0, 4), (2, 4), (1, 4), (3, 4), (2, 5)}, weighted)

        moved = PLANE.replace("2,1.5", "3.5,1.5")
        said, table = self.enforce(moved, "0 2\n3 1\n5 2\n", "--alpha2", "3", "--add-sites")
        self.assertIn("orthoball: 1 site added\n"
                      "orthoball: row 6 (2 1.5) on line 1 (0 2), line 2 (1 3)\n", said)
        rows = table.read_text().splitlines()
        self.assertEqual(len(rows), 8)
        self.assertTrue(rows[7].startswith("2,1.5,"))
        weighted = self.present(table, 3, "--weight-column", "weight")
        self.assertLessEqual({(0, 6), (2, 6), (1, 6), (3, 6), (2, 5)}, weighted)

    def test_simplices_are_checked_with_their_line(self):
        source = self.file("points.csv", "x,y\n0,0\n1,1\n2,2\n5,1\n")
        for text, message in [
            ("0 1\n0 9\n", ":2: row 9 of 4; rows of the points are counted from 0"),
            ("0 1 2 3\n", ":1: 4 corners; a simplex in the plane has 2 or 3"),
            ("0 1\n# three\n0 1 2\n", ":3: its corners lie on one line; they must span it"),
            ("2 2\n", ":1: row 2 twice; the corners of a simplex are different"),
            ("", ": there is no simplex in it"),
        ]:
            wanted = self.file("wanted.txt", text)
            said = self.refused(1, "enforce", source, wanted)
            self.assertIn(f"orthoball: {wanted}{message}", said)
        self.refused(1, "enforce", source, self.folder / "none.txt")
        self.refused(2, "enforce", source)
        wanted = self.file("wanted.txt", "0 1\n")
        self.refused(2, "enforce", source, wanted, "--index", "3")
        self.refused(2, "enforce", source, wanted, "-o", source)
        self.refused(2, "enforce", source, wanted, "-o", wanted)


if __name__ == "__main__":
    unittest.main()
