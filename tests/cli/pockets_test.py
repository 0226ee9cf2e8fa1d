#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `pockets` says of unions of balls, compared with closed forms and with `measure`.

Usage: pockets_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import math
import os
import pathlib
import unittest

from program import C60, EIGHT, InAFolder, SAMPLES, TWO_BALLS

DNA = str(SAMPLES / "bdna_dodecamer.pdb")


def ring(left_out):
    """Disks of radius 0.9 on a circle of radius 5, without those that are left out."""
    return "x,y,r\n" + "".join(
        f"{5 * math.cos(2 * math.pi * i / 24)},{5 * math.sin(2 * math.pi * i / 24)},0.9\n"
        for i in range(24) if i not in left_out)


class Pockets(InAFolder):
    def pockets(self, *arguments):
        return json.loads(self.done("pockets", *arguments, "--json").stdout)

    def of_ring(self, left_out):
        path = self.file("ring.csv", ring(left_out))
        return self.pockets(path, "--columns", "x,y", "--radius-column", "r")


class Numbers(Pockets):
    def test_kinds_are_told_by_mouths(self):
        for left_out, kind in [((), "void"), ((0, 1), "pocket"), ((0, 1, 12, 13), "channel")]:
            report = self.of_ring(left_out)
            (pocket,) = report["pockets"]
            self.assertEqual(pocket["kind"], kind)
            counts = {name: report[f"{name}_count"] for name in ["void", "pocket", "channel"]}
            self.assertEqual(counts, {**dict.fromkeys(counts, 0), kind: 1})
            self.assertEqual(pocket["depth"] is None, kind == "void")
        self.assertEqual(self.of_ring(range(13, 24))["pockets"], [])

    def test_an_open_ring_is_known_in_closed_form(self):
        (pocket,) = self.of_ring((0, 1))["pockets"]
        gap = 2 * 5 * math.sin(3 * math.pi / 24)
        (mouth,) = pocket["mouths"]
        self.assertAlmostEqual(mouth["area"], gap - 2 * 0.9, places=12)
        self.assertEqual(mouth["rim"], [0, 21])
        self.assertAlmostEqual(pocket["depth"], 25 - gap * gap / 4, places=9)
        self.assertEqual(pocket["atoms"], list(range(22)))
        self.assertAlmostEqual(sum(pocket["atom_areas"]), pocket["area"], places=12)

    def test_voids_are_those_of_measure(self):
        for arguments in [[C60], [C60, "--probe", "0.1"], [EIGHT, "--probe", "0.08"]]:
            voids = json.loads(self.done("measure", *arguments, "--json").stdout)["voids"]
            found = self.pockets(*arguments)["pockets"]
            same = [pocket for pocket in found if pocket["kind"] == "void"]
            self.assertEqual(len(same), len(voids))
            for pocket, void in zip(same, voids, strict=True):
                self.assertAlmostEqual(pocket["volume"], void["volume"], places=9)
                self.assertEqual(pocket["atoms"], void["atoms"])

    def test_has_the_promised_keys(self):
        report = self.pockets(DNA)
        self.assertEqual(list(report), ["input", "dimension", "name", "alpha2", "alpha", "index",
                                        "probe", "void_count", "pocket_count", "channel_count",
                                        "pockets"])
        self.assertGreater(report["channel_count"], 0)
        for pocket in report["pockets"]:
            self.assertEqual(list(pocket), ["kind", "volume", "area", "depth", "atoms",
                                            "atom_areas", "mouths"])
            areas = [mouth["area"] for mouth in pocket["mouths"]]
            self.assertEqual(areas, sorted(areas, reverse=True))
            self.assertGreater(pocket["depth"], 0)
            for mouth in pocket["mouths"]:
                self.assertGreaterEqual(len(mouth["rim"]), 3)
                self.assertLessEqual(set(mouth["rim"]), set(pocket["atoms"]))
        volumes = [pocket["volume"] for pocket in report["pockets"]]
        self.assertEqual(volumes, sorted(volumes, reverse=True))

    def test_alpha_is_0_unless_given_and_can_be_any(self):
        self.assertEqual(self.pockets(C60)["alpha2"], 0)
        self.assertEqual(self.pockets(C60, "--alpha2", "4")["alpha2"], 4)
        self.assertEqual(self.pockets(C60, "--index", "0")["alpha2"], None)
        said = self.done("pockets", C60, "--alpha2", "auto").stderr
        self.assertIn("alpha2 auto: ", said)

    def test_a_probe_grows_radii(self):
        rows = [line.split() for line in pathlib.Path(C60).read_text().splitlines()[2:]]
        grown = self.file("grown.xyzr", "".join(f"{x} {y} {z} 1.8\n" for _, x, y, z in rows))
        one, other = self.pockets(C60, "--probe", "0.1"), self.pockets(grown)
        self.assertEqual(one["pockets"], other["pockets"])
        self.assertEqual(one["probe"], 0.1)

    def test_flat_single_and_no_sites_have_none(self):
        self.assertEqual(self.pockets(TWO_BALLS)["pockets"], [])
        empty = self.file("empty.csv", "x,y,z\n")
        self.assertEqual(self.pockets(empty, "--allow-empty")["pockets"], [])


class Reports(Pockets):
    def test_the_text_counts_and_lists(self):
        text = self.done("pockets", C60, "--probe", "0.1").stdout
        for words in ["\nprobe            0.1 Å\n", "\nat               alpha2 0, ",
                      "\nfound            1 void, 0 pockets, 0 channels\n", "\npockets  kind ",
                      "volume [Å³]", "\n  1      void "]:
            self.assertIn(words, text)
        text = self.done("pockets", EIGHT, "--probe", "0.08").stdout
        for words in ["  perimeter  disks ", "\n  10 ", "\n  and 17 smaller; --format csv lists all\n"]:
            self.assertIn(words, text)

    def test_the_csv_is_the_json(self):
        found = self.pockets(DNA)["pockets"]
        table = self.done("pockets", DNA, "--format", "csv", "--quiet").stdout
        rows = list(csv.DictReader(io.StringIO(table)))
        self.assertEqual([int(row["pocket"]) for row in rows], list(range(1, len(found) + 1)))
        for row, pocket in zip(rows, found, strict=True):
            self.assertEqual(row["kind"], pocket["kind"])
            for key in ["volume", "area", "depth"]:
                self.assertEqual(float(row[key]), pocket[key])
            self.assertEqual(list(map(int, row["atoms"].split())), pocket["atoms"])
            self.assertEqual(int(row["mouths"]), len(pocket["mouths"]))
            self.assertEqual(list(map(float, row["mouth_areas"].split())),
                             [mouth["area"] for mouth in pocket["mouths"]])

    def test_the_name_tells_the_format(self):
        for name, start in [("p.csv", "pocket,kind,"), ("p.json", "{\n"), ("p.txt", "input "),
                            ("p", "input ")]:
            self.done("pockets", C60, "-o", self.folder / name)
            self.assertTrue((self.folder / name).read_text().startswith(start), name)
        self.refused(2, "pockets", C60, "--json", "--format", "csv")
        self.refused(2, "pockets", C60, "--format", "ply")

    def test_results_do_not_depend_on_threads(self):
        for options in [["--json"], ["--format", "csv"], []]:
            one, four = [self.done("pockets", DNA, "--probe", "0.5", *options, "--threads", threads)
                         for threads in ["1", "4"]]
            self.assertEqual(one.stdout, four.stdout)

    def test_refuses_what_is_wrong(self):
        for text, words in [("-1", "0 or more"), ("x", "not a number")]:
            self.assertIn(words, self.refused(2, "pockets", C60, f"--probe={text}"))
        self.refused(2, "pockets", C60, "--alpha2", "1,2")
        path = self.file("balls.xyzr", "0 0 0 1\n3 0 0 -0.5\n")
        self.assertIn(f"{path}:2: row 1: radius is -0.5",
                      self.refused(1, "pockets", path, "--probe", "1"))
        self.assertIn("is the input", self.refused(2, "pockets", path, "-o", path))
        self.assertIn("/dev/full", self.refused(3, "pockets", C60, "-o", "/dev/full"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["balls.xyzr"])

    def test_balls_without_an_inside_are_said(self):
        self.assertIn("warning: no ball has a radius above 0", self.done("pockets", EIGHT).stderr)


if __name__ == "__main__":
    unittest.main()
