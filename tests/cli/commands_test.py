#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each command promises to other programs: tables, JSON, shapes.

Usage: commands_test.py PROGRAM [unittest options]
"""

import csv
import fractions
import io
import json
import math
import pathlib
import struct
import unittest
import zipfile

from program import C60, EIGHT, InAFolder, TWO_BALLS, orthoball


class Summary(InAFolder):
    KEYS = ["input", "dimension", "affine_dimension", "distinct_sites", "hidden", "duplicates",
            "simplices", "attached", "spectrum_size", "alpha2_min", "alpha2_max", "hull_volume",
            "hull_area", "notable"]

    def summary(self, *arguments):
        return json.loads(self.done("summary", *arguments, "--json").stdout)

    def test_has_the_promised_keys(self):
        for sample, dimension in [(C60, 3), (EIGHT, 2)]:
            summary = self.summary(sample)
            self.assertEqual([key for key in self.KEYS if key not in summary], [])
            self.assertEqual([key for key in ["file", "format", "sites", "decimals", "radii"]
                              if key not in summary["input"]], [])
            self.assertEqual(summary["dimension"], dimension)
            self.assertEqual(len(summary["simplices"]), dimension + 1)
            self.assertEqual(len(summary["attached"]), dimension + 1)
            names = [notable["name"] for notable in summary["notable"]]
            expected = ["all_vertices", "all_vertices_in_cells", "connected", "one_region", "solid",
                        "solid_from"] + [f"gap_{k}" for k in range(dimension)]
            self.assertEqual(names, expected)
            for notable in summary["notable"]:
                self.assertEqual(set(notable), {"name", "reason", "index", "alpha2", "alpha"})

    def test_hidden_and_duplicate_rows_are_listed(self):
        path = self.file("balls.csv", "x,y,z,r\n0,0,0,1\n5,0,0,1\n0,0,0,1\n0,0,0,0.5\n")
        summary = self.summary(path, "--columns", "x,y,z", "--radius-column", "r")
        self.assertEqual(summary["hidden"], [3])
        self.assertEqual(summary["duplicates"], [[2, 0]])
        self.assertEqual(summary["distinct_sites"], 3)
        self.assertEqual(summary["input"]["sites"], 4)

    def test_hidden_atoms_are_named_in_the_text(self):
        atom = "ATOM      {}  {:3} GLY A  12      11.104   6.134  -6.504  1.00 10.00           {}\n"
        path = self.file("same.pdb", atom.format(1, "CA", "C") + atom.format(2, "HA2", "H"))
        self.assertRegex(self.done("summary", path).stdout, r"\nhidden +1 \(row 1 HA2 of GLY 12 in A\)\n")
        path = self.file("same.xyz", "2\n\nC 0 0 0\nH 0 0 0\n")
        self.assertRegex(self.done("summary", path).stdout, r"\nhidden +1 \(row 1 H\)\n")

    def test_empty_input_is_an_answer_where_it_is_allowed(self):
        path = self.file("empty.csv", "x,y,z\n")
        summary = self.summary(path, "--allow-empty")
        self.assertEqual(summary["spectrum_size"], 0)
        self.assertIsNone(summary["alpha2_min"])
        self.assertIsNone(summary["alpha2_max"])
        self.assertEqual(summary["affine_dimension"], -1)
        self.assertEqual(summary["hull_volume"], 0)
        self.done("summary", path, "--allow-empty")
        self.done("signatures", path, "--allow-empty", "--plot", self.folder / "plot.svg")
        self.done("shape", path, "--allow-empty", "-o", self.folder / "shape.glb")
        self.done("filter", path, "--allow-empty")

    def test_a_flat_set_in_space_has_twice_its_polygon_as_area(self):
        path = self.file("square.csv", "x,y,z\n0,0,0\n2,0,0\n0,2,0\n2,2,0\n")
        summary = self.summary(path)
        self.assertEqual(summary["affine_dimension"], 2)
        self.assertEqual(summary["hull_volume"], 0)
        self.assertEqual(summary["hull_area"], 8)

    def test_the_name_of_the_output_tells_the_format(self):
        output = self.folder / "summary.json"
        self.done("summary", C60, "-o", output)
        self.assertEqual(json.loads(output.read_text())["dimension"], 3)
        for arguments in [["-o", self.folder / "summary.txt"], ["-o", output, "--format", "text"]]:
            self.done("summary", C60, *arguments)
            self.assertTrue(arguments[1].read_text().startswith("input "))

    def test_measures_the_shape_that_is_asked_for(self):
        at = self.summary(TWO_BALLS, "--alpha2", "-1,2")["at"]
        self.assertEqual([entry["betti"][0] for entry in at], [2, 1])
        self.assertEqual([entry["index"] for entry in at], [1, 2])

    def test_one_is_singular(self):
        path = self.file("four.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n")
        self.assertIn("4 triangles, 1 tetrahedron\n", orthoball("summary", path).stdout)

    def test_the_text_names_reading_and_notable_alphas(self):
        text = self.done("summary", C60).stdout
        for word in ["60 in space", "bondi", "notable alphas", "solid_from", "hull volume", "Å³"]:
            self.assertIn(word, text)


class SignaturesOfBalls(InAFolder):
    def rows(self, *arguments):
        return json.loads(self.done("signatures", "--balls", "--json", *arguments).stdout)

    def test_are_the_unions_that_measure_tells(self):
        for sample, alphas in [(C60, ["-1", "0", "1", "20"]), (EIGHT, ["0.01", "3", "50000"])]:
            rows = self.rows(sample, "--alpha2=" + ",".join(alphas))
            self.assertEqual(len(rows), len(alphas))
            for alpha2, row in zip(alphas, rows):
                report = json.loads(
                    self.done("measure", sample, "--json", "--alpha2=" + alpha2).stdout)
                for key in ["index", "alpha2", "alpha", "betti", "euler"]:
                    self.assertEqual(row[key], report[key])
                for key in ["volume", "area"]:
                    self.assertAlmostEqual(row[key] / report[key], 1, places=11)

    def test_are_sampled_without_an_alpha(self):
        self.assertEqual(len(self.rows(EIGHT)), 100)
        self.assertEqual(len(self.rows(EIGHT, "--samples", "7")), 7)

    def test_begin_with_no_balls(self):
        rows = self.rows(C60, "--index", "0")
        self.assertEqual((rows[0]["alpha2"], rows[0]["volume"], rows[0]["area"]), (None, 0, 0))

    def test_have_no_plot(self):
        self.refused(2, "signatures", C60, "--balls", "--plot", "plot.svg")


class Signatures(InAFolder):
    def test_csv_has_the_promised_columns(self):
        for sample, dimension in [(C60, 3), (EIGHT, 2)]:
            head = self.done("signatures", sample).stdout.split("\n", 1)[0].split(",")
            roles = [f"{role}_{k}" for role in ["exterior", "singular", "regular", "interior"]
                     for k in range(dimension + 1)]
            self.assertEqual(
                head,
                ["index", "alpha2", "alpha"] + [f"betti_{k}" for k in range(dimension)] + ["euler"]
                + roles + ["volume", "area_singular", "area_regular", "area", "length"])

    def test_rows_are_every_index_and_agree_with_json(self):
        rows = list(csv.DictReader(io.StringIO(self.done("signatures", C60).stdout)))
        entries = json.loads(self.done("signatures", C60, "--json").stdout)
        self.assertEqual([int(row["index"]) for row in rows], list(range(1, len(rows) + 1)))
        for row, entry in zip(rows, entries, strict=True):
            self.assertEqual(float(row["alpha2"]), entry["alpha2"])
            self.assertEqual([int(row[f"betti_{k}"]) for k in range(3)], entry["betti"])
            self.assertEqual([int(row[f"singular_{k}"]) for k in range(4)], entry["singular"])
            self.assertEqual(float(row["length"]), entry["length"])
            self.assertEqual(set(entry), {
                "index", "alpha2", "alpha", "betti", "euler", "exterior", "singular", "regular",
                "interior", "volume", "area_singular", "area_regular", "area", "length"})

    def test_values_are_echoed_in_the_order_asked_for(self):
        entries = json.loads(self.done("signatures", TWO_BALLS, "--alpha2", "2,-5,-1",
                                       "--json").stdout)
        self.assertEqual([entry["alpha2"] for entry in entries], [2, -5, -1])
        self.assertEqual([entry["index"] for entry in entries], [2, 0, 1])
        self.assertEqual(entries[1]["betti"], [0, 0, 0])
        self.assertEqual(entries[1]["volume"], 0)

    def test_length_is_null_in_the_plane(self):
        entry = json.loads(self.done("signatures", EIGHT, "--alpha2", "1", "--json").stdout)[0]
        self.assertIsNone(entry["length"])
        self.assertEqual(len(entry["betti"]), 2)

    def test_alpha_is_squared_exactly_and_rounded_once(self):
        texts = ["0.1", "1.1", "-0.3", "3.0000000000000001", "123456789.123456789", "1e-150",
                 "-7.25e10", "0.30000000000000004", "+2", ".5", "-.5", "1d1"]
        for form, power in [("--alpha", 1), ("--inverse-alpha", -1)]:
            result = self.done("signatures", TWO_BALLS, f"{form}={','.join(texts)}", "--json")
            for text, entry in zip(texts, json.loads(result.stdout), strict=True):
                x = fractions.Fraction(text.replace("d", "e"))
                exact = (x * abs(x)) ** power
                self.assertEqual(entry["alpha2"], exact.numerator / exact.denominator, text)
                self.assertEqual(math.copysign(1, entry["alpha"]), math.copysign(1, x))

    def test_every_printed_alpha2_gives_back_its_own_index(self):
        rows = list(csv.DictReader(io.StringIO(self.done("signatures", C60).stdout)))
        values = ",".join(row["alpha2"] for row in rows)
        entries = json.loads(self.done("signatures", C60, f"--alpha2={values}", "--json").stdout)
        labels = [row["alpha2"] for row in rows]
        for row, entry in zip(rows, entries, strict=True):
            if labels.count(row["alpha2"]) == 1:
                self.assertEqual(entry["index"], int(row["index"]))

    def test_samples_spread_over_the_spectrum_with_both_ends(self):
        rows = list(csv.DictReader(io.StringIO(
            self.done("signatures", EIGHT, "--samples", "5").stdout)))
        indices = [int(row["index"]) for row in rows]
        size = json.loads(self.done("summary", EIGHT, "--json").stdout)["spectrum_size"]
        self.assertEqual((len(indices), indices[0], indices[-1]), (5, 1, size))
        self.assertEqual(indices, sorted(set(indices)))

    def test_npz_holds_the_same_columns(self):
        output = self.folder / "table.npz"
        self.done("signatures", C60, "-o", output)
        with zipfile.ZipFile(output) as archive:
            self.assertIsNone(archive.testzip())
            names = archive.namelist()
            volume = archive.read("volume.npy")
        self.assertIn("betti.npy", names)
        rows = list(csv.DictReader(io.StringIO(self.done("signatures", C60).stdout)))
        size = struct.unpack_from("<H", volume, 8)[0]
        self.assertEqual(list(struct.unpack_from(f"<{len(rows)}d", volume, 10 + size)),
                         [float(row["volume"]) for row in rows])

    def test_a_plot_comes_beside_the_table(self):
        plot = self.folder / "plot.svg"
        result = self.done("signatures", C60, "--plot", plot)
        self.assertTrue(result.stdout.startswith("index,"))
        self.assertIn("</svg>", plot.read_text())


class Filter(InAFolder):
    def test_csv_counts_from_one_and_leaves_never_empty(self):
        text = self.done("filter", TWO_BALLS).stdout
        self.assertTrue(
            text.startswith("position,dimension,vertices,alpha2,enters,regular,interior\n"))
        rows = list(csv.DictReader(io.StringIO(text)))
        self.assertEqual([row["position"] for row in rows], ["1", "2", "3"])
        self.assertEqual(rows[2]["vertices"], "0 1")
        self.assertEqual(rows[2]["interior"], "")

    def test_every_face_comes_before_its_cofaces(self):
        seen = set()
        for row in csv.DictReader(io.StringIO(self.done("filter", C60).stdout)):
            vertices = tuple(map(int, row["vertices"].split()))
            self.assertEqual(list(vertices), sorted(vertices))
            self.assertEqual(len(vertices), int(row["dimension"]) + 1)
            for i in range(len(vertices)):
                face = vertices[:i] + vertices[i + 1:]
                self.assertTrue(not face or face in seen)
            seen.add(vertices)

    def test_formats_say_the_same(self):
        rows = list(csv.DictReader(io.StringIO(self.done("filter", C60).stdout)))
        lines = self.done("filter", C60, "--json").stdout.splitlines()
        for row, line in zip(rows, lines, strict=True):
            entry = json.loads(line)
            self.assertEqual(" ".join(map(str, entry["vertices"])), row["vertices"])
            self.assertEqual(float(row["alpha2"]), entry["alpha2"])
            never = lambda text: int(text) if text else None
            self.assertEqual(never(row["regular"]), entry["regular"])
        output = self.folder / "filter.npz"
        self.done("filter", C60, "-o", output)
        with zipfile.ZipFile(output) as archive:
            self.assertIsNone(archive.testzip())
            enters = archive.read("enters.npy")
        size = struct.unpack_from("<H", enters, 8)[0]
        self.assertEqual(list(struct.unpack_from(f"<{len(rows)}I", enters, 10 + size)),
                         [int(row["enters"]) for row in rows])

    def test_with_an_alpha_it_is_the_complex_there(self):
        rows = list(csv.DictReader(io.StringIO(
            self.done("filter", C60, "--alpha2", "0").stdout)))
        entry = json.loads(self.done("signatures", C60, "--alpha2", "0", "--json").stdout)[0]
        inside = sum(sum(entry[role]) for role in ["singular", "regular", "interior"])
        self.assertEqual(len(rows), inside)


class Shape(InAFolder):
    def test_every_format_is_written_by_its_name(self):
        starts = {"ply": b"ply\n", "obj": b"# ", "off": b"OFF\n", "stl": b"boundary", "vtu": b"<?xml",
                  "glb": b"glTF"}
        for ending, start in starts.items():
            output = self.folder / f"surface.{ending}"
            result = self.done("shape", C60, "--alpha2", "3", "-o", output, "--roles")
            self.assertTrue(output.read_bytes().startswith(start), ending)
            self.assertIn("alpha2 3, alpha 1.7320508075688772, index ", result.stderr)
        for ending, start in {"geojson": b'{"type"', "svg": b"<svg", "ply": b"ply\n"}.items():
            output = self.folder / f"outline.{ending}"
            self.done("shape", EIGHT, "-o", output)
            self.assertTrue(output.read_bytes().startswith(start), ending)

    def test_auto_is_said(self):
        output = self.folder / "surface.ply"
        self.assertIn("alpha2 auto: dual_complex", self.done("shape", C60, "-o", output).stderr)
        self.assertIn("alpha2 auto: solid", self.done("shape", EIGHT, "-o", output).stderr)

    def test_the_report_names_the_alpha_that_auto_took(self):
        output = self.folder / "surface.ply"
        for sample, options, name in [(C60, [], "dual_complex"), (C60, ["--alpha2", "auto"], "dual_complex"),
                                      (EIGHT, [], "solid"), (EIGHT, ["--alpha2", "1"], None)]:
            report = json.loads(self.done("shape", sample, *options, "-o", output, "--json").stdout)
            self.assertEqual(report["name"], name)
        at = json.loads(self.done("summary", EIGHT, "--alpha2", "1,auto", "--json").stdout)["at"]
        self.assertEqual([entry["name"] for entry in at], [None, "solid"])

    def test_the_report_counts_what_is_written(self):
        output = self.folder / "surface.ply"
        report = json.loads(self.done("shape", C60, "--alpha2", "100", "-o", output,
                                      "--json").stdout)
        self.assertEqual(report["singular"], [0, 0, 0])
        self.assertIn(f"element face {report['regular']}\n".encode(), output.read_bytes())
        self.assertIn(f"element vertex {report['vertices']}\n".encode(), output.read_bytes())
        entry = json.loads(self.done("signatures", C60, "--alpha2", "100", "--json").stdout)[0]
        self.assertEqual(report["regular"], entry["regular"][2])

    def test_triangle_formats_say_what_they_leave_out(self):
        output = self.folder / "surface.stl"
        self.assertIn("left out", self.done("shape", TWO_BALLS, "--alpha2", "2", "-o",
                                            output).stderr)
        words = "no place for roles"
        self.assertIn(words, self.done("shape", C60, "-o", output, "--roles").stderr)
        self.assertIn(words, self.done("shape", C60, "-o", output, "--roles", "--json").stderr)
        self.assertNotIn(words, self.done("shape", C60, "-o", output).stderr)
        self.assertNotIn(words, self.done("shape", C60, "-o", self.folder / "a.off", "--roles").stderr)

    def test_regularized_leaves_singular_simplices_out(self):
        result = self.done("shape", TWO_BALLS, "--alpha2", "2", "--format", "obj", "--regularized")
        self.assertNotIn("\nl ", result.stdout)
        self.assertIn("no boundary", result.stderr)

    def test_geojson_rings_are_closed_and_turn_as_rfc_7946_says(self):
        text = self.done("shape", EIGHT, "--format", "geojson").stdout
        feature = json.loads(text)["features"][0]
        self.assertEqual(feature["geometry"]["type"], "MultiPolygon")
        for polygon in feature["geometry"]["coordinates"]:
            for i, ring in enumerate(polygon):
                self.assertEqual(ring[0], ring[-1])
                area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:]))
                self.assertEqual(area > 0, i == 0)


class Shuffled(InAFolder):
    def test_rows_in_another_order_change_nothing_but_row_numbers(self):
        lines = pathlib.Path(EIGHT).read_text().splitlines()
        head, rows = lines[:1], lines[1:]
        shuffled = self.file("shuffled.csv", "\n".join(head + rows[::-1]) + "\n")
        for arguments in [["signatures"], ["shape", "--format", "obj", "--alpha2", "0.01"]]:
            first = self.done(arguments[0], EIGHT, *arguments[1:]).stdout
            second = self.done(arguments[0], shuffled, *arguments[1:]).stdout
            self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main()
