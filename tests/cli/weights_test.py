#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""weights_test.py PROGRAM: weights that are made from the data."""

import csv
import json
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
        far = self.file("far.csv", "x,y\n0,0\n1e200,0\n")
        said = self.refused(1, "summary", far, "--weights", "density:1")
        self.assertIn("far.csv:2: row 0: the squared distances", said)


if __name__ == "__main__":
    unittest.main()
