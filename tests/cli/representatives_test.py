#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `persistence --representatives` writes of shapes whose holes are known."""

import csv
import json
import math
import struct
import unittest

from program import C60, EIGHT, ROOT, SAMPLES, InAFolder

TORI = SAMPLES / "linked_tori.csv"
GRAMICIDIN = ROOT.parent / "shared" / "data" / "mol" / "1grm_gramicidin.pdb"


def sites(path):
    with open(path, encoding="utf-8") as file:
        return [tuple(float(x) for x in row.values()) for row in csv.DictReader(file)]


def length(places, ring):
    return sum(math.dist(places[a], places[b]) for a, b in zip(ring, ring[1:] + ring[:1]))


class Representatives(InAFolder):
    def classes(self, *arguments):
        path = self.folder / "classes.json"
        self.done("persistence", *arguments, "-o", self.folder / "pairs.csv", "--representatives",
                  path)
        found = json.loads(path.read_text())
        pairs = (self.folder / "pairs.csv").read_text().splitlines()[1:]
        return found, pairs

    def test_of_linked_tori_go_around_them_and_fill_them(self):
        places = sites(TORI)
        found, pairs = self.classes(TORI, "--minimum-length", "0.1")
        self.assertEqual([one["dimension"] for one in found], [0, 0, 1, 1, 1, 1, 2, 2])
        self.assertEqual(len(found), len(pairs))
        self.assertEqual(len(found[1]["rows"]), len(places) // 2)  # just before both are one
        tunnels = found[2:6]
        for tunnel in tunnels:
            self.assertEqual(len(tunnel["rings"]), 1)
            ring = tunnel["rings"][0]
            self.assertAlmostEqual(length(places, ring), tunnel["length"], places=9)
            self.assertEqual(sorted(ring), tunnel["rows"])
            self.assertEqual(len(tunnel["death_simplex"]), 3)
        lengths = sorted(tunnel["length"] for tunnel in tunnels)
        # Rings of radius 2 and tubes of radius 0.5: around a tube, and along the inside of a ring.
        for measured in lengths[:2]:
            self.assertAlmostEqual(measured, math.pi, delta=0.15)
        for measured in lengths[2:]:
            self.assertAlmostEqual(measured, 3 * math.pi, delta=0.6)
        for void in found[6:]:
            self.assertGreater(void["volume"], 0.9 * 2 * math.pi**2 * 2 * 0.25)
            self.assertGreater(len(void["cells"]), 1000)

    def test_walls_of_voids_are_closed(self):
        found, _ = self.classes(C60, "--homology-dimension", "2")
        self.assertEqual(len(found), 1)
        sides = {}
        for triangle in found[0]["triangles"]:
            for i in range(3):
                side = frozenset((triangle[i], triangle[(i + 1) % 3]))
                sides[side] = sides.get(side, 0) + 1
        self.assertEqual({count % 2 for count in sides.values()}, {0})
        self.assertEqual(len(found[0]["rows"]), 60)

    def test_in_the_plane_are_outlines_of_holes(self):
        found, _ = self.classes(EIGHT, "--homology-dimension", "1", "--minimum-length", "0.1")
        self.assertEqual(len(found), 2)  # of a figure eight
        for hole in found:
            self.assertEqual(len(hole["rings"]), 1)
            self.assertGreater(len(hole["cells"]), 100)
            self.assertGreater(hole["volume"], 0.1)

    def test_can_be_asked_for_at_one_alpha(self):
        at = json.loads(self.done("summary", TORI, "--json", "--alpha2", "0.0625").stdout)["at"][0]
        found, _ = self.classes(TORI, "--representatives-alpha2", "0.0625")
        for k, betti in enumerate(at["betti"]):
            self.assertEqual(sum(one["dimension"] == k for one in found), betti)
        self.assertEqual({one["index"] for one in found}, {at["index"]})

    def test_ply_has_the_same(self):
        found, _ = self.classes(TORI, "--minimum-length", "0.1")
        path = self.folder / "classes.ply"
        self.done("persistence", TORI, "--minimum-length", "0.1", "-o", self.folder / "pairs.csv",
                  "--representatives", path)
        header, _, data = path.read_bytes().partition(b"end_header\n")
        counts = [int(line.split()[2]) for line in header.decode().splitlines()
                  if line.startswith("element")]
        vertex, face, edge = struct.Struct("<dddIi"), struct.Struct("<BiiiiB"), struct.Struct("<iii")
        self.assertEqual(len(data), sum(
            count * one.size for count, one in zip(counts, [vertex, face, edge])))
        vertices = list(vertex.iter_unpack(data[:counts[0] * vertex.size]))
        data = data[counts[0] * vertex.size:]
        faces = list(face.iter_unpack(data[:counts[1] * face.size]))
        edges = list(edge.iter_unpack(data[counts[1] * face.size:]))
        for number, one in enumerate(found, start=1):
            rows = {row for *_, row, of in vertices if of == number}
            self.assertLessEqual(set(one["rows"]), rows)
            self.assertEqual(sum(of == number for *_, of, filling in faces if not filling),
                             len(one.get("triangles", [])))
            self.assertEqual(sum(of == number for *_, of in edges),
                             sum(map(len, one.get("rings", []))))
        self.assertEqual(sum(filling for *_, filling in faces), 4)

    @unittest.skipUnless(GRAMICIDIN.exists(), "needs the shared data")
    def test_finds_the_pore_of_gramicidin(self):
        found, _ = self.classes(GRAMICIDIN, "--homology-dimension", "1")
        lives = [(one["death"] - one["birth"], one) for one in found]
        _, pore = max(lives, key=lambda life: life[0])
        self.assertEqual(len(pore["rings"]), 1)
        self.assertGreater(pore["death"], 0)  # open where the atoms have their radii

    def test_mistakes_are_explained(self):
        pairs = self.folder / "a.json"
        for arguments, message in [
            (["--representatives", self.folder / "a.csv"], "must end in .json or .ply"),
            (["-o", pairs, "--representatives", pairs], "name the same file"),
            (["--representatives-alpha2", "1"], "--representatives"),
            (["--representatives", pairs, "--representatives-alpha2", "x"],
             "--representatives-alpha2"),
        ]:
            self.assertIn(message, self.refused(2, "persistence", C60, *arguments))
        self.assertFalse(pairs.exists())


if __name__ == "__main__":
    unittest.main()
