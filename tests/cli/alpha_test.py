#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The command alpha, and --alpha2 auto:NAME, which takes what it lists."""

import csv
import io
import json
import unittest

from program import C60, EIGHT, SAMPLES, InAFolder

TORI = SAMPLES / "linked_tori.csv"


class Alpha(InAFolder):
    def candidates(self, *arguments):
        return {entry["name"]: entry
                for entry in json.loads(self.done("alpha", *arguments, "--json").stdout)}

    def test_the_rings_are_what_lasts(self):
        found = self.candidates(TORI)
        signature = found["signature"]
        self.assertEqual(signature["rank"], 1)
        self.assertEqual([signature[f"betti_{k}"] for k in range(3)], [2, 4, 2])
        self.assertLess(signature["stable_from"], signature["alpha2"])
        self.assertLess(signature["alpha2"], signature["stable_to"])
        manifold = found["manifold"]
        self.assertEqual([manifold[f"betti_{k}"] for k in range(3)], [2, 2, 0])
        self.assertIsNone(found["solid_from"]["stable_to"])
        self.assertEqual([entry["rank"] for entry in found.values()],
                         list(range(1, len(found) + 1)))

    def test_forms_agree(self):
        rows = list(csv.DictReader(io.StringIO(self.done("alpha", EIGHT, "--format", "csv").stdout)))
        found = self.candidates(EIGHT)
        self.assertEqual([row["name"] for row in rows], list(found))
        text = self.done("alpha", EIGHT).stdout
        for row in rows:
            self.assertEqual(row["index"], str(found[row["name"]]["index"] or ""))
            self.assertIn(f" {row['name']}: ", text)
        path = self.folder / "a.csv"
        self.done("alpha", EIGHT, "-o", path)
        self.assertTrue(path.read_text().startswith("rank,name,index,alpha2,alpha,"))

    def test_of_a_molecule_has_the_molecule_and_a_probe(self):
        found = self.candidates(C60)
        self.assertEqual(found["dual_complex"]["alpha2"], 0)
        self.assertEqual(found["probe"]["alpha"], 1.4)

    def test_every_command_takes_them_by_name(self):
        index = self.candidates(EIGHT)["signature"]["index"]
        summary = json.loads(
            self.done("summary", EIGHT, "--json", "--alpha2", "auto:signature").stdout)
        self.assertEqual(summary["at"][0]["index"], index)
        self.assertEqual(summary["at"][0]["name"], "signature")
        for command, output in [("shape", "a.svg"), ("signatures", "a.csv"), ("filter", "a.csv"),
                                ("measure", "a.json"), ("figure", "a.svg")]:
            said = self.done(command, EIGHT, "--alpha2", "auto:signature", "-o",
                             self.folder / output).stderr
            self.assertIn("alpha2 auto: signature, ", said)
        self.done("pockets", C60, "--alpha2", "auto:probe")

    def test_resamples_are_seeded(self):
        found = [self.candidates(EIGHT, "--resamples", 4, "--seed", seed) for seed in (1, 1, 2)]
        self.assertEqual(found[0], found[1])
        self.assertNotEqual(found[0], found[2])
        connected = found[0]["connected"]
        self.assertEqual(connected["found"], 4)
        self.assertLessEqual(connected["alpha_low"], connected["alpha_median"])
        self.assertIsNone(self.candidates(EIGHT)["connected"]["found"])
        self.assertIn(" of 4, ", self.done("alpha", EIGHT, "--resamples", 4).stdout)

    def test_a_name_that_there_is_not_is_explained(self):
        said = self.refused(2, "shape", EIGHT, "--alpha2", "auto:best", "-o", self.folder / "a.svg")
        self.assertIn("there is no such candidate; there are all_vertices, ", said)
        line = self.file("line.csv", "x,y,z\n0,0,0\n1,0,0\n2,0,0\n")
        said = self.refused(2, "shape", line, "--alpha2", "auto:manifold", "-o",
                            self.folder / "a.ply")
        self.assertIn("these points have no such alpha; the first simplex enters at alpha2 0, the "
                      "last at 0.25", said)

    def test_an_absurd_alpha_is_told_the_scale_of_the_points(self):
        said = self.done("shape", C60, "--alpha", "1000", "-o", self.folder / "a.ply").stderr
        self.assertIn("the convex hull of the points: the first simplex enters at alpha2 -", said)
        said = self.done("shape", TORI, "--alpha2", "-1", "-o", self.folder / "a.ply").stderr
        self.assertIn("no boundary at this alpha; the file has none: the first simplex", said)
        self.assertIn("; solid at 0.30", said)

    def test_of_no_sites_is_said(self):
        path = self.file("empty.csv", "x,y,z\n")
        self.assertIn("no sites", self.done("alpha", path, "--allow-empty").stdout)


if __name__ == "__main__":
    unittest.main()
