#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Regions, holes and where points are: `shape --region` and its like, and `locate`.

Usage: regions_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import math
import unittest

from program import C60, EIGHT, InAFolder

# The figure of MATLAB's documentation of numRegions: two discs of rings with 24 points.
DISCS = [(0, 0), (15, 0)] + [
    (radius * math.cos(2 * math.pi * k / 24) + shift, radius * math.sin(2 * math.pi * k / 24))
    for shift in (0, 15)
    for radius in range(1, 6)
    for k in range(24)
]


def square(x, y, size):
    """The corners and the middles of the unit squares of a square."""
    corners = [(x + i, y + j) for i in range(size + 1) for j in range(size + 1)]
    return corners + [(x + i + 0.5, y + j + 0.5) for i in range(size) for j in range(size)]


# A square of 5 x 5 with a hole of 1 x 1 and a hole of 2 x 1, and far away one of 2 x 2.
HOLES = {(1.5, 1.5), (1.5, 3.5), (2.5, 3.5)}
PIERCED = [p for p in square(0, 0, 5) if p not in HOLES] + square(20, 0, 2)


class WithPoints(InAFolder):
    def points(self, name, rows):
        header = "x,y\n" if len(rows[0]) == 2 else "x,y,z\n"
        return self.file(name, header + "".join(",".join(map(repr, row)) + "\n" for row in rows))

    def setUp(self):
        super().setUp()
        self.pierced = self.points("pierced.csv", PIERCED)
        self.out = self.folder / "out.geojson"

    def report(self, path, *options):
        # Regularized, because edges of length 1 divide the hole of 2.
        return json.loads(self.done("shape", path, "--alpha2", "0.25", "-o", self.out, "--json",
                                    "--regularized", *options).stdout)

    def area(self):
        """Of the polygons in the output, their holes taken off."""
        def of_ring(ring):
            return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:])) / 2
        features = json.loads(self.out.read_text())["features"]
        return sum(of_ring(ring) for feature in features
                   if feature["geometry"]["type"] == "MultiPolygon"
                   for polygon in feature["geometry"]["coordinates"] for ring in polygon)


class Shape(WithPoints):
    def test_holes_are_filled_up_to_the_threshold(self):
        for threshold, filled, area in [("0.5", 0, 26), ("1", 1, 27), ("2", 2, 29)]:
            report = self.report(self.pierced, "--hole-threshold", threshold)
            self.assertEqual((report["holes_filled"], self.area()), (filled, area))
        self.assertEqual(report["volume_filled"], 3)

    def test_regions_are_left_out_up_to_the_threshold(self):
        for threshold, dropped, area in [("3.5", 0, 26), ("4", 1, 22), ("22", 2, 0)]:
            report = self.report(self.pierced, "--region-threshold", threshold)
            self.assertEqual((report["regions_dropped"], self.area()), (dropped, area))
        # Holes are filled first: the larger region now has 25.
        self.report(self.pierced, "--region-threshold", "22", "--hole-threshold", "2")
        self.assertEqual(self.area(), 25)

    def test_one_region_is_taken_by_its_number(self):
        for number, area in [("1", 22), ("2", 4)]:
            self.assertEqual(self.report(self.pierced, "--region", number)["region"], int(number))
            self.assertEqual(self.area(), area)
        message = self.refused(2, "shape", self.pierced, "--alpha2", "0.25", "-o", self.out,
                               "--region", "3")
        self.assertIn("there is no region 3; there are 2 regions", message)

    def test_words_say_what_was_done(self):
        said = self.done("shape", self.pierced, "--alpha2", "0.25", "-o", self.out, "--regularized",
                         "--hole-threshold", "1", "--region-threshold", "5").stderr
        self.assertIn("filled 1 hole of area 1; left out 1 region of area 4; 1 region left\n", said)
        said = self.done("shape", self.pierced, "--alpha2", "0.25", "-o", self.out,
                         "--region-threshold", "99").stderr
        self.assertIn("warning: what is left of the shape has no boundary; the file has none\n", said)
        said = self.done("shape", self.pierced, "--alpha2", "1e-9", "-o", self.out).stderr
        self.assertIn("at this alpha the shape is points alone: the first simplex enters at", said)

    def test_every_format_has_the_same_boundary(self):
        options = ["--alpha2", "0.25", "--region", "1", "--hole-threshold", "1", "--regularized"]
        sides = 4 * 5 + 6
        for ending, count in [("ply", lambda b: int(b.split(b"element edge ")[1].split()[0])),
                              ("obj", lambda b: b.count(b"\nl ")),
                              ("vtu", lambda b: int(b.split(b'NumberOfCells="')[1].split(b'"')[0])),
                              ("svg", lambda b: b.split(b'class="regular"')[1].split(b"/>")[0]
                               .count(b"L") + 2)]:
            path = self.folder / f"out.{ending}"
            self.done("shape", self.pierced, "-o", path, *options)
            self.assertEqual(count(path.read_bytes()), sides, ending)
        self.done("shape", self.pierced, "-o", self.folder / "out.glb", *options)

    def test_a_hollow_ball_is_filled(self):
        surface, report = self.folder / "c60.ply", None
        for threshold, filled in [("0", 0), ("1000", 1)]:
            report = json.loads(self.done("shape", C60, "--alpha2", "0", "-o", surface, "--json",
                                          "--hole-threshold", threshold).stdout)
            self.assertEqual(report["holes_filled"], filled)
        header = surface.read_bytes().split(b"end_header")[0].decode()
        self.assertIn(f"element face {report['regular']}\n", header)

    def test_the_regions_of_the_documentation_of_matlab(self):
        path = self.points("discs.csv", DISCS)
        out = ["--alpha", "2.5", "--regularized", "--json", "-o", self.out]
        areas = []
        for number in "12":
            self.done("shape", path, *out, "--region", number)
            areas.append(self.area())
        disc = 24 / 2 * 25 * math.sin(math.pi / 12)
        for area in areas:
            self.assertAlmostEqual(area, disc, 12)
        self.refused(2, "shape", path, *out, "--region", "3")

    def test_mistakes_are_explained(self):
        for option, value, message in [("--region", "0", "whole number from 1"),
                                       ("--region-threshold", "-1", "0 or more"),
                                       ("--hole-threshold", "big", "--hole-threshold")]:
            self.assertIn(message, self.refused(2, "shape", self.pierced, "-o", self.out,
                                                option, value))


class Locate(WithPoints):
    def setUp(self):
        super().setUp()
        self.query = self.points("query.csv", [(0.5, 0.25), (1.5, 1.5), (21, 1), (10, 0), (-4, 0),
                                               (1, 1)])

    def rows(self, *options):
        return json.loads(self.done("locate", self.pierced, self.query, "--alpha2", "0.25",
                                    "--json", *options).stdout)

    def test_tells_inside_region_distance_and_simplex(self):
        rows = self.rows()
        self.assertEqual([row["inside"] for row in rows], [1, 0, 1, 0, 0, 1])
        self.assertEqual([row["region"] for row in rows], [1, None, 2, None, None, 1])
        self.assertEqual([row["distance"] for row in rows], [0.25, 0.5, 1, 5, 4, 0])
        self.assertEqual(rows[4]["simplex"], None)
        self.assertEqual((rows[4]["x"], rows[4]["y"]), (0, 0))
        self.assertEqual([len(row["simplex"]) for row in rows[:4]], [3, 2, 1, 2])
        for row in rows:
            self.assertLessEqual(len(row["nearest"]), 2)

    def test_csv_and_json_say_the_same(self):
        path = self.folder / "table.csv"
        self.done("locate", self.pierced, self.query, "--alpha2", "0.25", "-o", path)
        for row, other in zip(csv.DictReader(io.StringIO(path.read_text())), self.rows(),
                              strict=True):
            for name, value in other.items():
                text = "" if value is None else " ".join(map(str, value)) if isinstance(
                    value, list) else str(value)
                self.assertEqual(row[name], text)

    def test_edits_are_those_of_shape(self):
        self.assertEqual([row["inside"] for row in self.rows("--hole-threshold", "1")],
                         [1, 1, 1, 0, 0, 1])
        self.assertEqual([row["region"] for row in self.rows("--region", "2")],
                         [None, None, 1, None, None, None])

    def test_singular_simplices_count_unless_regularized(self):
        path = self.points("edge.csv", [(0, 0), (1, 0), (1, 1), (5, 0), (6, 0)])
        query = self.points("on.csv", [(5.5, 0), (5.5, 1e-30)])
        out = ["locate", path, query, "--alpha2", "0.5", "--json"]
        self.assertEqual([row["inside"] for row in json.loads(self.done(*out).stdout)], [1, 0])
        self.assertEqual([row["inside"] for row in json.loads(
            self.done(*out, "--regularized").stdout)], [0, 0])

    def test_molecules_are_points_of_a_query(self):
        rows = json.loads(self.done("locate", C60, C60, "--alpha2", "0", "--json").stdout)
        self.assertEqual([row["inside"] for row in rows], [1] * 60)
        self.assertEqual([row["simplex"] for row in rows], [[k] for k in range(60)])

    def test_the_query_has_options_of_its_own(self):
        other = self.file("other.txt", "name a b\np 0.5 0.25\n")
        rows = json.loads(self.done("locate", self.pierced, other, "--alpha2", "0.25", "--json",
                                    "--query-columns", "a,b", "--query-format", "table").stdout)
        self.assertEqual([row["inside"] for row in rows], [1])
        text = self.done("locate", self.pierced, "-", "--alpha2", "0.25", "--query-format", "table",
                         input="0.5 0.25\n").stdout
        self.assertEqual(len(text.splitlines()), 2)

    def test_threads_and_quiet_change_nothing(self):
        first = self.rows()
        self.assertEqual(self.rows("--threads", "1"), first)
        self.assertEqual(self.done("locate", self.pierced, self.query, "--quiet").stderr, "")

    def test_mistakes_are_explained(self):
        self.assertIn("the points have 3 coordinates; those of",
                      self.refused(1, "locate", self.pierced, C60))
        self.assertIn("cannot both be standard input", self.refused(2, "locate", "-", "-"))
        self.assertIn("QUERY", self.refused(2, "locate", EIGHT))
        self.assertIn("missing.csv", self.refused(1, "locate", EIGHT, "missing.csv"))
        unknown = self.points("query.what", [(0, 0)])
        self.assertIn("--query-format", self.refused(1, "locate", self.pierced, unknown))
        self.assertIn("--query-format", self.refused(2, "locate", self.pierced, "-"))


class Query(InAFolder):
    def test_is_not_written_over(self):
        query = self.file("query.csv", "0,0,0\n")
        said = self.refused(2, "locate", C60, query, "-o", query)
        self.assertIn("holds the query", said)
        self.assertEqual(query.read_text(), "0,0,0\n")


if __name__ == "__main__":
    unittest.main()
