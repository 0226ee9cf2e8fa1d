#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `measure` says of unions of balls, compared with closed forms and with itself.

Usage: measure_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import math
import os
import pathlib
import subprocess
import unittest

from program import C60, EIGHT, InAFolder, PROGRAM, SAMPLES, TWO_BALLS, orthoball, ply

DNA = str(SAMPLES / "bdna_dodecamer.pdb")
TABLES = ["--per-atom", "--per-residue", "--contacts", "--residue-contacts", "--voids",
          "--derivatives"]


class Measure(InAFolder):
    def measure(self, *arguments):
        return json.loads(self.done("measure", *arguments, "--json").stdout)

    def table(self, option, *arguments):
        path = self.folder / "table.csv"
        self.done("measure", *arguments, option, path)
        return list(csv.DictReader(io.StringIO(path.read_text())))

    def balls(self, text, name="balls.xyzr"):
        return self.file(name, text)


class Numbers(Measure):
    def test_two_unit_balls_at_distance_1(self):
        report = self.measure(self.balls("0 0 0 1\n1 0 0 1\n"))
        self.assertAlmostEqual(report["volume"], 7.0685834706, places=9)
        self.assertAlmostEqual(report["area"], 18.8495559215, places=9)
        self.assertAlmostEqual(report["mean_curvature"], 16.0004465427, places=9)
        self.assertEqual((report["euler"], report["betti"]), (1, [1, 0, 0]))
        self.assertEqual((report["void_count"], report["voids"]), (0, []))

    def test_has_the_promised_keys(self):
        keys = ["input", "dimension", "alpha2", "alpha", "index", "probe", "volume", "area",
                "mean_curvature", "molecular_surface", "euler", "betti", "balls", "voids_of", "void_count", "voids"]
        for sample, dimension in [(C60, 3), (EIGHT, 2)]:
            report = self.measure(sample, "--probe", "0.08")
            self.assertEqual([key for key in keys if key not in report], [])
            self.assertEqual((report["dimension"], report["probe"]), (dimension, 0.08))
            self.assertEqual(len(report["betti"]), dimension)
            self.assertEqual(len(report["voids"]), report["void_count"])
            self.assertEqual(report["void_count"], report["betti"][-1])
            for void in report["voids"]:
                self.assertEqual(len(void["largest_ball"]["centre"]), dimension)
                self.assertEqual(len(void["atoms"]), len(void["atom_areas"]))
                self.assertAlmostEqual(sum(void["atom_areas"]), void["area"])
                self.assertLess(void["born"], void["dies"])
            self.assertGreater(report["void_count"], 0)

    def test_the_ball_inside_c60_touches_all_its_atoms(self):
        report = self.measure(C60)
        self.assertEqual(report["euler"], 2)
        (void,) = report["voids"]
        self.assertEqual(void["atoms"], list(range(60)))
        rows = [line.split() for line in pathlib.Path(C60).read_text().splitlines()[2:]]
        ball = void["largest_ball"]
        least = min(math.dist(ball["centre"], map(float, row[1:4])) - 1.7 for row in rows)
        self.assertAlmostEqual(ball["radius"], least, places=9)
        self.assertLess(void["born"], 0)
        self.assertGreater(void["dies"], 0)

    def test_a_probe_gives_the_molecular_surface(self):
        # Two unit balls 2 apart, a probe of 1.5: its circle has the radius sqrt(2.5^2 - 1).
        balls = self.balls("0 0 0 1\n2 0 0 1\n", "two.xyzr")
        surface = self.measure(balls, "--probe", "1.5")["molecular_surface"]
        circle, turn = math.sqrt(2.5 ** 2 - 1), math.atan2(1, math.sqrt(2.5 ** 2 - 1))
        toroidal = 4 * math.pi * 1.5 * (circle * turn - 1.5 / 2.5)
        self.assertAlmostEqual(surface["toroidal_area"], toroidal, places=12)
        self.assertAlmostEqual(surface["convex_area"], 4 * math.pi * (1 + 1 / 2.5), places=12)
        self.assertEqual(surface["concave_area"], 0)
        self.assertAlmostEqual(surface["area"],
                               surface["toroidal_area"] + surface["convex_area"], places=12)
        text = self.done("measure", balls, "--probe", "1.5").stdout
        self.assertIn(f"\nmolecular area   {surface['area']}\n", text)
        self.assertIsNone(self.measure(balls)["molecular_surface"])
        self.assertIsNone(self.measure(EIGHT, "--probe", "1")["molecular_surface"])

    def test_a_huge_probe_leaves_few_digits_and_says_so(self):
        balls = self.balls("0 0 0 1\n2 0 0 1\n", "two.xyzr")
        self.assertNotIn("rounding", self.done("measure", balls, "--probe", "10").stderr)
        self.assertIn("rounding changes the molecular volume by up to",
                      self.done("measure", balls, "--probe", "1e5").stderr)

    def test_cells_that_are_refused_leave_no_table(self):
        table, cells = self.folder / "table.csv", self.folder / "cells.csv"
        far = ",".join(["-1e300"] * 3 + ["1e300"] * 3)
        self.refused(2, "measure", DNA, "--per-atom", table, "--cells", cells, f"--cells-box={far}")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_disks(self):
        report = self.measure(self.file("disks.csv", "x,y,r\n0,0,1\n1,0,1\n"), "--radius-column",
                              "r", "--dimension", "2")
        lens = 2 * math.pi / 3 - math.sqrt(3) / 2
        self.assertAlmostEqual(report["volume"], 2 * math.pi - lens, places=12)
        self.assertAlmostEqual(report["area"], 8 * math.pi / 3, places=12)
        self.assertIsNone(report["mean_curvature"])

    def test_the_text_names_measures_by_dimension(self):
        text = self.done("measure", C60).stdout
        for word in ["\nvolume  ", "Å³\n", "\narea  ", "Å²\n", "\nmean curvature", " Å\n", "\nvoids ",
                     "60 exposed", "1 void\n"]:
            self.assertIn(word, text)
        text = self.done("measure", EIGHT, "--probe", "0.08").stdout
        for word in ["\narea  ", "\nperimeter ", "\nholes ", "\nprobe            0.08\n"]:
            self.assertIn(word, text)
        self.assertNotIn("curvature", text)

    def test_only_the_first_voids_are_in_the_text(self):
        # Balls along the edges of ten separate cages: every cage an octahedron.
        rows = [(40 * k + x, y, z, 0.9) for k in range(10)
                for x, y, z in [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]]
        path = self.balls("".join(f"{x} {y} {z} {r}\n" for x, y, z, r in rows))
        text = self.done("measure", path).stdout
        self.assertIn("\n  7    ", text)
        self.assertIn("\n  and 3 smaller; --voids FILE lists all\n", text)
        voids = self.table("--voids", path)
        self.assertEqual([row["void"] for row in voids], [str(i + 1) for i in range(10)])
        for row in voids:
            self.assertAlmostEqual(float(row["radius"]), 0.1, places=9)
            self.assertAlmostEqual(float(row["volume"]), 0.00907, places=5)

    def test_rows_that_have_no_part_are_counted_by_the_reason(self):
        path = self.balls("0 0 0 2\n0 0 0 2\n0 0 0 1\n9 0 0 -1\n5 0 0 1\n")
        report = self.measure(path)
        self.assertEqual(report["balls"], {"exposed": 2, "buried": 0, "hidden": 1, "duplicates": 1,
                                           "empty": 1})
        self.assertIn("2 exposed, 1 hidden inside others, 1 duplicate, 1 empty\n",
                      self.done("measure", path).stdout)


    def test_voids_of_the_shape_are_polyhedra(self):
        # The six corners of an octahedron: the union closes a small void inside.
        path = self.balls("".join(f"{x} {y} {z} 0.9\n" for x, y, z in [
            (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]))
        balls, shape = [self.measure(path, *options) for options in [[], ["--voids-of", "shape"]]]
        self.assertEqual((balls["voids_of"], shape["voids_of"]), ("balls", "shape"))
        (small,), (large,) = balls["voids"], shape["voids"]
        self.assertAlmostEqual(large["volume"], 4 / 3, places=12)
        self.assertAlmostEqual(large["area"], 4 * math.sqrt(3), places=12)
        self.assertIsNone(large["atom_areas"])
        self.assertIsNone(large["largest_ball"])
        for key in ["atoms", "born", "dies"]:
            self.assertEqual(large[key], small[key])
        self.assertEqual({key: balls[key] for key in ["volume", "area", "betti", "void_count"]},
                         {key: shape[key] for key in ["volume", "area", "betti", "void_count"]})
        (row,) = self.table("--voids", path, "--voids-of", "shape")
        self.assertEqual((float(row["volume"]), row["atom_areas"], row["radius"]),
                         (large["volume"], "", ""))
        text = self.done("measure", path, "--voids-of", "shape").stdout
        self.assertIn("\nin the alpha shape\nvoids ", text)
        self.assertNotIn("largest", text)
        self.refused(2, "measure", path, "--voids-of", "cells")

    def test_holes_of_a_shape_in_the_plane(self):
        path = self.file("disks.csv", "x,y,r\n0,0,0.6\n1,0,0.6\n0,1,0.6\n1,1,0.6\n")
        (hole,) = self.measure(path, "--radius-column", "r", "--dimension", "2", "--voids-of",
                               "shape")["voids"]
        self.assertAlmostEqual(hole["volume"], 1, places=12)
        self.assertAlmostEqual(hole["area"], 4, places=12)


class Alpha(Measure):
    def test_is_0_unless_given(self):
        self.assertEqual(self.measure(C60)["alpha2"], 0)
        self.assertEqual(self.measure(EIGHT)["alpha2"], 0)
        report = self.measure(EIGHT, "--alpha2", "auto")
        self.assertEqual(report["name"], "solid")
        self.assertIn("alpha2 auto: solid", self.done("measure", EIGHT, "--alpha2", "auto").stderr)

    def test_adds_to_the_squares_of_radii(self):
        grown = self.balls("0 0 0 2\n1 0 0 2\n", "grown.xyzr")
        for options in [["--alpha2", "3"], ["--alpha", "1.7320508075688772"]]:
            report = self.measure(self.balls("0 0 0 1\n1 0 0 1\n"), *options)
            expected = self.measure(grown)
            for key in ["volume", "area", "mean_curvature"]:
                self.assertAlmostEqual(report[key], expected[key], places=9)

    def test_radii_of_0_are_said_with_what_would_be_right(self):
        for options in [[], ["--alpha2", "-1"]]:
            result = self.done("measure", EIGHT, *options)
            self.assertIn("warning: no ball has a radius above 0", result.stderr)
            self.assertIn("--probe", result.stderr)
            self.assertIn("0 exposed", result.stdout)
        for options in [["--alpha2", "0.01"], ["--probe", "0.1"], ["--quiet"]]:
            self.assertEqual(self.done("measure", EIGHT, *options).stderr, "")
        empty = self.file("empty.csv", "x,y,z\n")
        self.assertEqual(self.done("measure", empty, "--allow-empty").stderr, "")

    def test_the_empty_complex_has_no_alpha(self):
        report = self.measure(C60, "--index", "0")
        self.assertEqual((report["alpha2"], report["alpha"], report["index"]), (None, None, 0))
        self.assertEqual((report["volume"], report["area"], report["euler"]), (0, 0, 0))
        self.assertIn("\nat               index 0, the empty complex\n",
                      self.done("measure", C60, "--index", "0").stdout)


class Probe(Measure):
    def test_is_the_same_as_reading_larger_radii(self):
        lines = pathlib.Path(C60).read_text().splitlines()[2:]
        rows = [" ".join(line.split()[1:4]) for line in lines]
        grown = self.balls("".join(f"{row} 3.1\n" for row in rows))
        for options in [[], ["--alpha2", "1.5"], ["--index", "15"]]:
            one = self.measure(C60, "--probe", "1.4", *options)
            other = self.measure(grown, *options)
            for key in other.keys() - {"input", "probe", "molecular_surface"}:
                self.assertEqual(one[key], other[key], key)
            self.assertEqual(one["input"]["decimals"], other["input"]["decimals"])

    def test_is_read_exactly(self):
        # In decimals the balls touch; in doubles 0.7 + 0.1 is less than 0.8.
        points = self.balls("0 0 0 0.7\n1.6 0 0 0.7\n")
        self.assertEqual(self.measure(points, "--probe", "0.1")["betti"][0], 1)
        self.assertEqual(self.measure(points, "--probe", "1e-1")["input"]["decimals"], 1)
        self.assertEqual(self.measure(points, "--probe", "0.10000000000000000001")["betti"][0], 2)

    def test_refuses_what_is_no_radius(self):
        for text, words in [("-1", "0 or more"), ("x", "not a number"), ("nan", "not finite"),
                            ("1e400", "beyond the range")]:
            self.assertIn(words, self.refused(2, "measure", C60, f"--probe={text}"))

    def test_refuses_imaginary_balls_by_line_and_row(self):
        path = self.balls("0 0 0 1\n3 0 0 -0.5\n")
        text = self.refused(1, "measure", path, "--probe", "1.4")
        self.assertIn(f"{path}:2: row 1: radius is -0.5", text)
        self.assertIn("0 or more", text)
        path = self.file("weights.csv", "x,y,w\n0,0,1\n\n1,0,-4\n")
        text = self.refused(1, "measure", path, "--weight-column", "w", "--dimension", "2",
                            "--probe", "1")
        self.assertIn("row 1: weight is -4", text)
        self.done("measure", path, "--weight-column", "w", "--dimension", "2", "--probe", "0")


class Tables(Measure):
    def total(self, rows, column):
        return math.fsum(float(row[column]) for row in rows)

    def assert_close(self, a, b):
        self.assertLess(abs(a - b), 1e-12 * max(abs(a), abs(b), 1.0))

    def test_balls_add_up_to_the_totals(self):
        for arguments in [[DNA], [DNA, "--probe", "1.4"], [DNA, "--alpha2", "4"],
                          [EIGHT, "--probe", "0.08"]]:
            report = self.measure(*arguments)
            rows = self.table("--per-atom", *arguments)
            self.assertEqual([int(row["row"]) for row in rows], list(range(len(rows))))
            self.assertEqual(len(rows), report["input"]["sites"])
            self.assert_close(self.total(rows, "area"), report["area"])
            self.assert_close(self.total(rows, "volume"), report["volume"])
            exposed = sum(float(row["area"]) > 0 for row in rows)
            self.assertEqual(exposed, report["balls"]["exposed"])

    def test_atoms_are_named(self):
        rows = self.table("--per-atom", DNA, "--probe", "1.4")
        self.assertEqual(list(rows[0]), ["row", "chain", "residue", "atom", "element", "radius",
                                         "area", "volume"])
        first = rows[0]
        self.assertEqual((first["chain"], first["residue"], first["atom"], first["element"]),
                         ("A", "DC 1", "O5'", "O"))
        self.assertEqual(first["radius"], "2.92")

    def test_residues_are_the_sums_of_their_atoms(self):
        rows = self.table("--per-residue", DNA)
        sums = {}
        for row in self.table("--per-atom", DNA):
            entry = sums.setdefault((row["chain"], row["residue"]), [0, 0.0, 0.0])
            entry[0] += 1
            entry[1] += float(row["area"])
            entry[2] += float(row["volume"])
        self.assertEqual([(row["chain"], row["residue"]) for row in rows], list(sums))
        for row, (atoms, area, volume) in zip(rows, sums.values(), strict=True):
            self.assertEqual(int(row["atoms"]), atoms)
            self.assert_close(float(row["area"]), area)
            self.assert_close(float(row["volume"]), volume)

    def test_residues_need_names(self):
        for sample in [C60, TWO_BALLS]:
            self.assertIn("names no residues",
                          self.refused(2, "measure", sample, "--per-residue", self.folder / "r.csv"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_contacts_are_the_facets_of_power_cells(self):
        (contact,) = self.table("--contacts", self.balls("0 0 0 1\n1 0 0 1\n"))
        self.assertEqual((contact["row_1"], contact["row_2"]), ("0", "1"))
        self.assertAlmostEqual(float(contact["area"]), 0.75 * math.pi, places=12)
        self.assertAlmostEqual(float(contact["exposed_length"]), math.sqrt(3) * math.pi, places=12)
        pairs = [(int(row["row_1"]), int(row["row_2"])) for row in self.table("--contacts", DNA)]
        self.assertEqual(pairs, sorted(set(pairs)))
        complex_at_0 = csv.DictReader(io.StringIO(
            self.done("filter", DNA, "--alpha2", "0", "--quiet").stdout))
        edges = sorted(tuple(map(int, row["vertices"].split())) for row in complex_at_0
                       if row["dimension"] == "1")
        self.assertEqual(pairs, edges)

    def test_contacts_add_up_to_those_of_residues(self):
        residue = {row["row"]: (row["chain"], row["residue"])
                   for row in self.table("--per-atom", DNA)}
        between = sum(float(row["area"]) for row in self.table("--contacts", DNA)
                      if residue[row["row_1"]] != residue[row["row_2"]])
        rows = self.table("--residue-contacts", DNA)
        self.assert_close(sum(float(row["area"]) for row in rows), between)
        pairs = {(r["chain_1"], r["residue_1"], r["chain_2"], r["residue_2"]) for r in rows}
        self.assertEqual(len(pairs), len(rows))
        self.assertIn(("A", "DC 1", "A", "DG 2"), pairs)
        self.assertIn(("A", "DC 1", "B", "DG 12"), pairs)

    def test_derivatives_are_differences(self):
        balls = [[0, 0, 0, 1], [1.2, 0.1, 0, 1.1], [0.3, 1, 0.2, 0.9]]

        def measured(change, row, column):
            moved = [list(ball) for ball in balls]
            moved[row][column] += change
            return self.measure(self.balls("".join(" ".join(map(str, b)) + "\n" for b in moved)))

        rows = self.table("--derivatives", self.balls(
            "".join(" ".join(map(str, b)) + "\n" for b in balls)))
        step = 1e-5
        for column, name in enumerate(["x", "y", "z", "radius"]):
            plus, minus = measured(step, 1, column), measured(-step, 1, column)
            for measure in ["area", "volume"]:
                slope = (plus[measure] - minus[measure]) / (2 * step)
                self.assertAlmostEqual(float(rows[1][f"{measure}_by_{name}"]), slope, places=7)

    def test_voids_are_those_of_the_report(self):
        report = self.measure(C60, "--alpha2", "0.5")
        (row,) = self.table("--voids", C60, "--alpha2", "0.5")
        (void,) = report["voids"]
        for column in ["volume", "area", "born", "dies"]:
            self.assertEqual(float(row[column]), void[column])
        self.assertEqual(list(map(int, row["atoms"].split())), void["atoms"])
        self.assertEqual(list(map(float, row["atom_areas"].split())), void["atom_areas"])
        self.assertEqual([float(row[axis]) for axis in "xyz"], void["largest_ball"]["centre"])
        self.assertEqual(float(row["radius"]), void["largest_ball"]["radius"])

    def test_numbers_beyond_the_double_range_are_empty_with_a_warning(self):
        path = self.balls("0 0 0 1e200\n3e200 0 0 1\n")
        table = self.folder / "table.csv"
        result = self.done("measure", path, "--per-atom", table, "--json")
        self.assertIsNone(json.loads(result.stdout)["volume"])
        self.assertIn("shown as null", result.stderr)
        self.assertIn("shown as an empty field", result.stderr)
        rows = list(csv.DictReader(io.StringIO(table.read_text())))
        self.assertEqual((rows[0]["radius"], rows[0]["volume"]), ("1e+200", ""))


    def test_numbers_beyond_the_double_range_are_null_in_json(self):
        path, table = self.balls("0 0 0 1e200\n3e200 0 0 1\n"), self.folder / "table.json"
        said = self.done("measure", path, "--per-atom", table).stderr
        self.assertIn("shown as null", said)
        self.assertNotIn("an empty field", said)
        self.assertIsNone(json.loads(table.read_text())[0]["volume"])

    def test_a_table_in_json_is_that_in_csv(self):
        def values(cell, other):
            if isinstance(other, list):
                separator = ";" if other and isinstance(other[0], str) else None
                return [values(*pair) for pair in
                        zip(cell.split(separator), other, strict=True)]
            return None if cell == "" else type(other)(cell)

        for arguments in [[DNA, "--alpha2", "3"], [C60], [EIGHT, "--probe", "0.08"]]:
            for option in TABLES:
                if "residue" in option and arguments[0] != DNA:
                    continue
                rows = self.table(option, *arguments)
                path = self.folder / "table.JSON"
                self.done("measure", *arguments, option, path)
                found = json.loads(path.read_text())
                self.assertGreater(len(found), 0, option)
                for row, one in zip(rows, found, strict=True):
                    self.assertEqual(list(row), list(one))
                    self.assertEqual({key: values(row[key], one[key]) for key in row}, one)

    def test_every_row_is_named(self):
        atoms = {row["row"]: (row["chain"], row["residue"], row["atom"])
                 for row in self.table("--per-atom", DNA)}
        self.assertEqual(len(set(atoms.values())), len(atoms))
        for row in self.table("--contacts", DNA):
            for i in "12":
                self.assertEqual((row[f"chain_{i}"], row[f"residue_{i}"], row[f"atom_{i}"]),
                                 atoms[row[f"row_{i}"]])
        for row in self.table("--derivatives", DNA):
            self.assertEqual((row["chain"], row["residue"], row["atom"]), atoms[row["row"]])
        voids = self.table("--voids", DNA, "--alpha2", "3")
        self.assertGreater(len(voids), 0)
        report = self.measure(DNA, "--alpha2", "3")["voids"]
        for row, void in zip(voids, report, strict=True):
            names = ["/".join(atoms[atom]) for atom in row["atoms"].split()]
            self.assertEqual(row["atom_names"].split(";"), names)
            self.assertEqual(void["atom_names"], names)

    def test_plain_points_have_no_names(self):
        (contact,) = self.table("--contacts", self.balls("0 0 0 1\n1 0 0 1\n"))
        self.assertEqual([contact[f"{key}_{i}"] for key in ["chain", "residue", "atom"]
                          for i in "12"], [""] * 6)
        for sample, options in [(EIGHT, ["--probe", "0.08"]), (C60, [])]:
            for row in self.table("--voids", sample, *options):
                self.assertEqual(row["atom_names"], "")
            for void in self.measure(sample, *options)["voids"]:
                self.assertIsNone(void["atom_names"])


class Pictures(Measure):
    def test_a_pdb_has_the_atoms_with_their_areas(self):
        path = self.folder / "a.pdb"
        self.done("measure", DNA, "--probe", "1.4", "--pdb", path)
        rows = self.table("--per-atom", DNA, "--probe", "1.4")
        lines = path.read_text().splitlines()
        self.assertEqual(len(lines), len(rows) + 1)
        self.assertEqual(lines[-1].rstrip(), "END")
        source = [line for line in pathlib.Path(DNA).read_text().splitlines()
                  if line.startswith("ATOM")]
        for line, row, original in zip(lines, rows, source):
            self.assertEqual(len(line), 80)
            self.assertEqual(line[12:16] + line[17:27], original[12:16] + original[17:27])
            self.assertEqual(line[30:60], original[30:54] + "  1.00")
            self.assertAlmostEqual(float(line[60:66]), float(row["area"]), delta=0.00501)
            self.assertEqual(line[76:78].strip().capitalize(), row["element"])
        again = self.measure(path, "--probe", "1.4")
        self.assertEqual(again["area"], self.measure(DNA, "--probe", "1.4")["area"])

    def test_a_pdb_says_what_does_not_fit(self):
        path = self.folder / "a.pdb"
        said = self.done("measure", self.balls("0 0 0 10\n100 0 0 1\n"), "--pdb", path).stderr
        self.assertIn(f"warning: 1 area in {path} beyond", said)
        self.assertIn("1.00999.99", path.read_text())
        os.remove(path)
        text = self.refused(3, "measure", self.balls("0 0 0 1\n0 10000 0 1\n"), "--pdb", path)
        self.assertIn("row 1: y is 10000; a PDB file holds coordinates from -999.999", text)
        self.assertFalse(path.exists())

    def test_mesh_and_script_show_the_void_of_c60(self):
        mesh, script = self.folder / "v.ply", self.folder / "v.cxc"
        report = json.loads(self.done("measure", C60, "--json", "--mesh", mesh, "--script",
                                      script).stdout)
        vertices, triangles = ply(mesh)
        self.assertEqual(sorted(vertex[3] for vertex in vertices), list(range(60)))
        self.assertEqual(len(triangles), 2 * 60 - 4)
        self.assertEqual({triangle[1] for triangle in triangles}, {1})
        radius = report["voids"][0]["largest_ball"]["radius"]
        self.assertRegex(script.read_text(),
                         rf"\nmarker #2 position [-0-9.,]* radius {radius:.3f} color #")

    def test_endings_tell_what_a_file_is(self):
        for option, name, words in [("--pdb", "a.csv", ".pdb or .ent"), ("--mesh", "a.pdb", ".ply"),
                                    ("--script", "a", ".pml or .cxc")]:
            self.assertIn(f"must end in {words}",
                          self.refused(2, "measure", C60, option, self.folder / name))


class Outputs(Measure):
    def every_table(self, folder):
        tables = [(option, f"{option.strip('-')}.csv") for option in TABLES]
        pictures = [("--pdb", "a.pdb"), ("--mesh", "v.ply"), ("--script", "v.cxc")]
        return [word for option, name in tables + pictures for word in [option, folder / name]]

    def test_results_do_not_depend_on_threads(self):
        found = []
        for threads in ["1", "4"]:
            folder = self.folder / threads
            folder.mkdir()
            text = self.done("measure", DNA, "--probe", "0.5", "--threads", threads,
                             *self.every_table(folder)).stdout
            found.append((text, [path.read_bytes() for path in sorted(folder.iterdir())]))
        self.assertEqual(len(found[0][1]), len(TABLES) + 3)
        self.assertTrue(found[0] == found[1])

    def test_the_name_tells_the_format_of_the_report(self):
        output = self.folder / "report.json"
        self.done("measure", C60, "-o", output)
        self.assertEqual(json.loads(output.read_text())["dimension"], 3)
        self.done("measure", C60, "-o", output, "--format", "text")
        self.assertTrue(output.read_text().startswith("input "))

    def test_every_output_needs_a_place_of_its_own(self):
        for arguments in [["--per-atom", "a.csv", "--voids", "a.csv"],
                          ["--per-atom", "a.csv", "--contacts", "./a.csv"],
                          ["--derivatives", "a.csv", "-o", self.folder / "a.csv"]]:
            self.assertIn("the same file", self.refused(2, "measure", C60, *arguments, cwd=self.folder))
        self.assertIn("--per-atom -: the report goes to standard output",
                      self.refused(2, "measure", C60, "--per-atom", "-"))
        result = self.done("measure", C60, "--per-atom", "-", "-o", self.folder / "report.txt")
        self.assertTrue(result.stdout.startswith("row,chain,"))

    def test_a_table_is_csv_or_json(self):
        for option in TABLES:
            self.assertIn("must end in .csv or .json",
                          self.refused(2, "measure", DNA, option, self.folder / "table.pdb"))
        self.done("measure", DNA, "--per-residue", self.folder / "table")
        self.done("measure", DNA, "--per-residue", os.devnull)

    def test_more_memory_than_the_limit_is_refused_before_it_is_used(self):
        # Cells of a lattice with a void each, so that the report is long.
        path = self.balls("".join(f"{x} {y} {z} 0.75\n" for x in range(14) for y in range(14)
                                  for z in range(14)))
        for command in ["measure", "pockets"]:
            table = [] if command == "pockets" else ["--per-atom", self.folder / "atoms.csv"]
            refused, low, high = set(), 1, 128
            while high - low > 1:
                limit = (low + high) // 2
                result = orthoball(command, path, "--json", "--threads", "1", "--memory-limit",
                                   f"{limit}M", *table)
                if result.returncode == 0:
                    high = limit
                else:
                    low = limit
                    self.assertEqual((result.returncode, result.stdout), (3, ""))
                    refused.add(result.stderr.split(": about ")[0].split(": ")[-1])
            self.assertLess(high, 128)
            self.assertIn("the report", refused)
            (self.folder / "atoms.csv").unlink(missing_ok=True)
            self.refused(3, command, path, "--json", "--memory-limit", f"{low}M", *table)
            self.assertEqual([file.name for file in self.folder.iterdir()], [path.name])

    def test_an_output_that_is_the_input_is_refused(self):
        path = self.balls("0 0 0 1\n", "balls.csv")
        for option in ["-o", *TABLES]:
            self.assertIn("is the input", self.refused(2, "measure", path, "--input-format", "xyzr",
                                                       option, path))
        self.assertEqual(path.read_text(), "0 0 0 1\n")

    def test_an_output_that_cannot_be_written_is_3(self):
        for option in ["-o", *TABLES]:
            for output in ["/dev/full", self.folder / "none" / "table.csv"]:
                self.assertIn(str(output), self.refused(3, "measure", DNA, option, output))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_bad_data_leaves_no_file(self):
        path = self.balls("0 0 0 1\n1 0 0 -1\n", "bad.xyzr")
        self.refused(1, "measure", path, "--probe", "1", *self.every_table(self.folder)[:2])
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bad.xyzr"])

    def test_progress_tells_the_stages(self):
        said = self.done("measure", C60, "--progress", "always").stderr
        for stage in ["reading", "triangulation", "filtration", "measuring"]:
            self.assertRegex(said, rf"orthoball: {stage}: \d+\.\d\d s\n")

    def test_a_reader_that_needs_no_more_is_3_without_a_word(self):
        reader, writer = os.pipe()
        os.close(reader)
        result = subprocess.run([PROGRAM, "measure", DNA, "--per-atom", "-", "-o", os.devnull],
                                stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
        os.close(writer)
        self.assertEqual((result.returncode, result.stderr), (3, ""))


if __name__ == "__main__":
    unittest.main()
