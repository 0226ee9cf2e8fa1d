#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""shape --manifold: closed surfaces, judged by nothing but the files that were written."""

import collections
import csv
import json
import struct
import unittest

from program import C60, EIGHT, ROOT, SAMPLES, InAFolder

SHARED = ROOT.parent / "shared" / "data"
TORI = SAMPLES / "linked_tori.csv"


def binary_stl(path):
    """Triangles of places."""
    data = path.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield [numbers[k:k + 3] for k in (3, 6, 9)]


def obj(path):
    """Triangles of places."""
    places = []
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        if kind == "v":
            places.append(tuple(map(float, words)))
        elif kind == "f":
            yield [places[int(word) - 1] for word in words]
        else:
            assert kind == "#", line


def faults(triangles):
    """Why triangles of places are no oriented closed manifold."""
    after = collections.defaultdict(dict)
    found = []
    for triangle in triangles:
        if len(set(triangle)) != 3:
            found.append(f"a triangle with two equal corners: {triangle}")
        for i in range(3):
            vertex, right, left = (triangle[(i + k) % 3] for k in range(3))
            if right in after[vertex]:
                found.append(f"{vertex} {right} is twice a side in this direction")
            after[vertex][right] = left
    for vertex, ring in after.items():
        start = at = next(iter(ring))
        steps = 0
        while at in ring:
            at = ring[at]
            steps += 1
            if at == start:
                break
        if steps != len(ring) or at != start:
            found.append(f"around {vertex} is no single ring")
    return found


class Manifold(InAFolder):
    def solid(self, *arguments, name="print.obj"):
        path = self.folder / name
        report = json.loads(
            self.done("shape", *arguments, "--manifold", "--json", "-o", path).stdout)
        return report["manifold"], path

    def test_of_samples_is_closed_at_any_alpha(self):
        inputs = [TORI, C60]
        for name in ["cloud/tore3D_1307.off", "cloud/cgal_kitten.xyz", "mol/1crn.cif",
                     "mol/1grm_gramicidin.pdb"]:
            if (SHARED / name).exists():
                inputs.append(SHARED / name)
        for path in inputs:
            summary = json.loads(self.done("summary", path, "--json").stdout)
            size = summary["spectrum_size"]
            for index in [size // 5, size // 2, 4 * size // 5, size]:
                with self.subTest(path=path, index=index):
                    report, file = self.solid(path, "--index", index)
                    self.assertEqual(faults(obj(file)), [])
                    self.assertTrue(report["volume"] > 0 or index < size)
                    self.assertEqual(bool(report["offending_vertices"]), bool(report["changes"]))

    def test_is_written_to_every_format(self):
        for ending in ["ply", "obj", "off", "stl", "vtu", "glb"]:
            self.solid(TORI, "--alpha2", "auto", name=f"print.{ending}")
        self.assertEqual(faults(binary_stl(self.folder / "print.stl")), [])
        for ending in ["geojson", "svg"]:
            self.solid(EIGHT, "--index", 1000, name=f"print.{ending}")

    def test_of_the_plane_has_rings_that_touch_nowhere(self):
        _, path = self.solid(EIGHT, "--index", 1200, name="print.geojson")
        features = json.loads(path.read_text())["features"]
        self.assertEqual(len(features), 1)
        seen = set()
        for polygon in features[0]["geometry"]["coordinates"]:
            for ring in polygon:
                for place in map(tuple, ring[1:]):
                    self.assertNotIn(place, seen)
                    seen.add(place)

    def test_lists_what_was_changed_and_left_out(self):
        table = self.folder / "changes.csv"
        report, _ = self.solid(TORI, "--index", 2700, "--changes", table)
        rows = list(csv.DictReader(table.read_text().splitlines()))
        changed = [row for row in rows if row["change"] != "dropped"]
        self.assertEqual([row["change"] for row in changed],
                         [entry["change"] for entry in report["changes"]])
        self.assertEqual(sum(int(row["cells"]) for row in changed),
                         report["added_cells"] + report["removed_cells"])
        self.assertAlmostEqual(sum(float(row["volume"]) for row in changed),
                               report["added_volume"] + report["removed_volume"])
        dropped = collections.Counter(
            len(row["rows"].split()) for row in rows if row["change"] == "dropped")
        self.assertEqual([dropped[k] for k in (1, 2, 3)], report["dropped"])
        self.assertGreater(len(changed), 0)
        self.assertGreater(sum(dropped.values()), 0)

    def test_lists_nothing_that_edits_had_left_out(self):
        table = self.folder / "changes.csv"
        for edits in (["--regularized"], ["--region", "1"]):
            report, _ = self.solid(TORI, "--index", 2700, *edits, "--changes", table)
            rows = list(csv.DictReader(table.read_text().splitlines()))
            dropped = [row for row in rows if row["change"] == "dropped"]
            self.assertEqual(len(dropped), sum(report["dropped"]), edits)

    def test_says_that_there_is_no_solid(self):
        result = self.done("shape", C60, "--index", 1, "--manifold", "-o", self.folder / "a.ply")
        self.assertIn("no solid: the shape has no tetrahedra at this alpha", result.stderr)

    def test_changes_need_manifold_and_a_file_of_their_own(self):
        output = self.folder / "a.ply"
        self.refused(2, "shape", C60, "-o", output, "--changes", self.folder / "a.csv")
        self.refused(2, "shape", C60, "-o", output, "--manifold", "--changes", output)
        self.refused(2, "shape", C60, "-o", output, "--manifold", "--changes",
                     self.folder / "a.txt")
        self.assertFalse(output.exists())


if __name__ == "__main__":
    unittest.main()
