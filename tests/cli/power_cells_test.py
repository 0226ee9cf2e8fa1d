#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The power cells that `measure --cells` writes, as tables, VTU and OBJ.

Usage: power_cells_test.py PROGRAM [unittest options]
"""

import base64
import collections
import csv
import io
import json
import math
import os
import re
import struct
import unittest

from program import C60, EIGHT, InAFolder, SAMPLES

DNA = str(SAMPLES / "bdna_dodecamer.pdb")
TWO = "0 0 0 1\n1 0 0 1\n"
BOX = "--cells-box=-2,-2,-2,3,2,2"


def vtu_array(text, name, code):
    encoded = re.search(f'Name="{name}"[^>]*>([^<]*)<', text).group(1)
    (size,) = struct.unpack("<Q", base64.b64decode(encoded[:12]))
    data = base64.b64decode(encoded[12:])
    assert len(data) == size
    return [number for (number,) in struct.iter_unpack("<" + code, data)]


def polyhedra(text):
    """[cell] of a VTU: the corners of its faces, as points."""
    numbers = vtu_array(text, "points", "d")
    points = list(zip(numbers[::3], numbers[1::3], numbers[2::3]))
    faces = iter(vtu_array(text, "faces", "q"))
    return [[[points[next(faces)] for _ in range(next(faces))] for _ in range(count)]
            for count in faces]


def volume(faces):
    total = 0.0
    for first, *others in faces:
        for b, c in zip(others, others[1:]):
            total += (first[0] * (b[1] * c[2] - b[2] * c[1]) +
                      first[1] * (b[2] * c[0] - b[0] * c[2]) +
                      first[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6


class Cells(InAFolder):
    def cells(self, *arguments, name="cells.csv"):
        path = self.folder / name
        self.done("measure", *arguments, "-o", os.devnull, "--cells", path)
        return path.read_text()

    def table(self, *arguments):
        return list(csv.DictReader(io.StringIO(self.cells(*arguments))))

    def two(self):
        return self.file("two.xyzr", TWO)


class InABox(Cells):
    def test_two_balls_halve_the_box(self):
        rows = self.table(self.two(), BOX)
        self.assertEqual(list(rows[0]), ["row", "chain", "residue", "atom", "element", "volume",
                                         "area", "exposed_area", "facets", "is_clipped"])
        for row in rows:
            self.assertEqual((row["volume"], row["area"], row["exposed_area"], row["facets"],
                              row["is_clipped"]), ("40", "72", "56", "1", "1"))

    def test_the_box_is_around_the_balls_and_is_told(self):
        path = self.folder / "cells.csv"
        for arguments, box in [([], "-1.3,-1.3,-1.3,2.3,1.3,1.3"),
                               (["--alpha2", "3"], "-2.5,-2.5,-2.5,3.5,2.5,2.5"),
                               (["--probe", "1"], "-2.5,-2.5,-2.5,3.5,2.5,2.5")]:
            said = self.done("measure", self.two(), "--cells", path, *arguments).stderr
            self.assertEqual(said, f"orthoball: power cells end at the box {box}\n")
            found = path.read_text()
            again = self.done("measure", self.two(), "--cells", path, f"--cells-box={box}",
                              *arguments)
            self.assertEqual((again.stderr, path.read_text()), ("", found))
        quiet = self.done("measure", self.two(), "--cells", path, "--quiet")
        self.assertEqual(quiet.stderr, "")

    def test_atoms_are_named_and_fill_the_box(self):
        rows = self.table(DNA, "--cells-box=-16,-17,-47,16,17,10")
        self.assertEqual(len(rows), 486)
        self.assertEqual([rows[0][name] for name in ["row", "chain", "residue", "atom", "element"]],
                         ["0", "A", "DC 1", "O5'", "O"])
        self.assertAlmostEqual(sum(float(row["volume"]) for row in rows), 32 * 34 * 57, places=7)
        facets = sum(int(row["facets"]) for row in rows)
        self.assertEqual(facets % 2, 0)

    def test_rows_without_a_cell_have_zeros(self):
        rows = self.table(self.file("hidden.xyzr", "0 0 0 2\n0 0 0 1\n0 0 0 2\n5 0 0 1\n"))
        for row in rows[1:3]:
            self.assertEqual([row[name] for name in ["volume", "area", "facets", "is_clipped"]],
                             ["0"] * 4)

    def test_a_vtu_holds_closed_polyhedra(self):
        text = self.cells(DNA, name="cells.vtu")
        rows = self.table(DNA)
        cells = polyhedra(text)
        self.assertEqual(vtu_array(text, "row", "I"), list(range(486)))
        self.assertEqual(set(vtu_array(text, "types", "B")), {42})
        volumes = vtu_array(text, "volume", "d")
        self.assertEqual(volumes, [float(row["volume"]) for row in rows])
        for faces, exact in zip(cells, volumes, strict=True):
            self.assertAlmostEqual(volume(faces), exact, delta=1e-10 * (1 + abs(exact)))
            sides = collections.Counter((a, b) for face in faces
                                        for a, b in zip(face, face[1:] + face[:1]))
            for (a, b), count in sides.items():
                self.assertEqual(count, sides[(b, a)])

    def test_the_plane_has_polygons(self):
        text = self.cells(EIGHT, name="cells.obj")
        objects = re.findall(r"^o row_(\d+)\n((?:v .* 0\n)+)f (.*)\n", text, re.MULTILINE)
        rows = self.table(EIGHT)
        self.assertEqual(len(objects), len(rows))
        first = 1
        for (row, corners, polygon), line in zip(objects, rows, strict=True):
            self.assertEqual(row, line["row"])
            points = [tuple(map(float, corner.split()[1:3])) for corner in corners.splitlines()]
            numbers = list(map(int, polygon.split()))
            self.assertEqual(numbers, list(range(first, first + len(points))))
            first += len(points)
            area = sum(a[0] * b[1] - a[1] * b[0]
                       for a, b in zip(points, points[1:] + points[:1])) / 2
            self.assertAlmostEqual(area, float(line["volume"]), places=12)


class InBalls(Cells):
    def test_they_are_the_parts_of_the_union(self):
        path = self.folder / "atoms.csv"
        for sample, options in [(DNA, ["--probe", "1.4"]), (EIGHT, ["--probe", "0.08"])]:
            self.done("measure", sample, *options, "--per-atom", path)
            atoms = list(csv.DictReader(io.StringIO(path.read_text())))
            rows = self.table(sample, *options, "--cells-within", "balls")
            for atom, row in zip(atoms, rows, strict=True):
                self.assertEqual((row["volume"], row["exposed_area"]), (atom["volume"], atom["area"]))

    def test_contacts_are_a_part_of_the_surface(self):
        (row, _) = self.table(self.two(), "--cells-within", "balls")
        self.assertAlmostEqual(float(row["area"]) - float(row["exposed_area"]), 0.75 * math.pi)
        self.assertEqual(row["facets"], "1")

    def test_surfaces_come_as_near_as_is_wanted(self):
        exact = 7.0685834706 / 2
        for tolerance in [0.02, 0.001]:
            text = self.cells(self.two(), "--cells-within", "balls", "--cells-tolerance", tolerance,
                              name="cells.vtu")
            for faces in polyhedra(text):
                self.assertLess(volume(faces), exact)
                self.assertGreater(volume(faces), exact - 10 * tolerance)
            for number in vtu_array(text, "volume", "d"):
                self.assertAlmostEqual(number, exact)

    def test_the_title_says_what_it_is(self):
        text = self.cells(C60, "--cells-within", "balls", "--probe", "0.5", name="cells.obj")
        self.assertRegex(text, r"\A# power cells of c60\.xyz with a probe of 0\.5, within the "
                               r"balls at alpha2 0, index \d+\no row_0\nv ")


class Usage(Cells):
    def test_names_and_numbers_are_checked(self):
        two = self.two()
        for arguments, words in [
                (["--cells", "a.ply"], "must end in .csv or .json or .vtu or .obj"),
                (["--cells", "-", "-o", "report.txt"], "must end in"),
                (["--cells-within", "balls"], "requires --cells"),
                (["--cells-box", "0,0,0,1,1,1"], "requires --cells"),
                (["--cells", "a.csv", "--cells-box", "0,0,1,1"],
                 "--cells-box: 4 numbers; in space it takes 6"),
                (["--cells", "a.csv", "--cells-box", "0,0,0,1,0,1"],
                 "--cells-box: y from 0 to 0; the first must be the smaller"),
                (["--cells", "a.csv", "--cells-box", "0,0,0,1,,1"], "--cells-box: \"\" is"),
                (["--cells", "a.csv", "--cells-box", "0,0,0,1,1,1", "--cells-within", "balls"],
                 "there is no box"),
                (["--cells", "a.csv", "--cells-tolerance", "0"], "is not from 0.0001 to 0.5"),
                (["--cells", "a.csv", "--cells-within", "cubes"], "cubes"),
                (["--cells", "a.csv", "--cells-box=0,0,0,1e299,1e299,1e299"], "2^150 times")]:
            said = self.refused(2, "measure", two, *arguments, cwd=self.folder)
            self.assertIn(words, said)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["two.xyzr"])

    def test_results_do_not_depend_on_threads(self):
        for options in [[], ["--cells-within", "balls"]]:
            one, four = (self.cells(DNA, *options, "--threads", threads, name="cells.vtu")
                         for threads in ["1", "4"])
            self.assertTrue(one == four)

    def test_a_file_that_cannot_be_written_is_3(self):
        for output in [self.folder / "none" / "cells.vtu"]:
            self.assertIn(str(output), self.refused(3, "measure", DNA, "--cells", output))

    def test_no_sites_make_no_cells(self):
        empty = self.file("empty.xyzr", "# nothing\n")
        for options in [[], ["--cells-within", "balls"]]:
            for name in ["cells.csv", "cells.vtu", "cells.obj"]:
                self.assertNotIn("row_", self.cells(empty, "--allow-empty", *options, name=name))
        report = self.done("measure", empty, "--allow-empty", "--json", "--cells",
                           self.folder / "cells.csv").stdout
        self.assertEqual(json.loads(report)["volume"], 0)


if __name__ == "__main__":
    unittest.main()
