#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `pockets` says of unions of balls, compared with closed forms and with `measure`.

Usage: pockets_test.py PROGRAM [unittest options]
"""

import ast
import csv
import io
import json
import math
import os
import pathlib
import shutil
import unittest

from program import C60, EIGHT, InAFolder, SAMPLES, TWO_BALLS, ply

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
                                            "atom_names", "atom_areas", "mouths"])
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
            self.assertEqual(row["atom_names"].split(";"), pocket["atom_names"])
            self.assertEqual(list(map(float, row["atom_areas"].split())), pocket["atom_areas"])
            self.assertEqual(int(row["mouths"]), len(pocket["mouths"]))
            self.assertEqual(list(map(float, row["mouth_areas"].split())),
                             [mouth["area"] for mouth in pocket["mouths"]])

    def test_atoms_and_rims_are_named(self):
        names = {}
        for line in pathlib.Path(DNA).read_text().splitlines():
            if line[:6] in ("ATOM  ", "HETATM") and line[17:20] != "HOH":
                names[len(names)] = "/".join([line[21].strip(), line[17:20].strip() + " " +
                                              line[22:27].strip(), line[12:16].strip()])
        for pocket in self.pockets(DNA)["pockets"]:
            self.assertEqual(pocket["atom_names"], [names[row] for row in pocket["atoms"]])
            for mouth in pocket["mouths"]:
                self.assertEqual(mouth["rim_names"], [names[row] for row in mouth["rim"]])
        (pocket,) = self.of_ring((0, 1))["pockets"]
        self.assertEqual((pocket["atom_names"], pocket["mouths"][0]["rim_names"]), (None, None))

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


class Files(Pockets):
    def files(self, folder):
        return ["--mesh", folder / "p.ply", "--script", folder / "p.pml"]

    def test_a_mesh_has_the_boundary_of_every_pocket(self):
        path = self.folder / "p.ply"
        report = json.loads(self.done("pockets", DNA, "--json", "--mesh", path).stdout)
        vertices, triangles = ply(path)
        self.assertEqual(len({tuple(vertex[:3]) for vertex in vertices}),
                         len({vertex[3] for vertex in vertices}))
        for number, pocket in enumerate(report["pockets"], 1):
            own = [triangle for triangle in triangles if triangle[1] == number]
            rows = {vertices[v][3] for corners, _, _ in own for v in corners}
            self.assertLessEqual(rows, set(pocket["atoms"]))
            open_rows = {vertices[v][3] for corners, _, mouth in own if mouth for v in corners}
            self.assertEqual(open_rows, {row for mouth in pocket["mouths"] for row in mouth["rim"]})
            sides = [side for (a, b, c), _, _ in own for side in [(a, b), (b, c), (c, a)]]
            self.assertEqual(sorted(sides), sorted((b, a) for a, b in sides))
        self.assertEqual({triangle[1] for triangle in triangles},
                         set(range(1, len(report["pockets"]) + 1)))

    def test_in_the_plane_a_mesh_has_edges(self):
        path, mesh = self.file("ring.csv", ring((0, 1))), self.folder / "p.ply"
        self.done("pockets", path, "--columns", "x,y", "--radius-column", "r", "--mesh", mesh)
        vertices, edges = ply(mesh)
        self.assertEqual(len(vertices), 22)
        self.assertEqual([mouth for _, _, mouth in edges].count(1), 1)
        self.assertEqual(len(edges), 22)

    def test_a_script_names_the_atoms_of_the_table(self):
        rows = [line for line in pathlib.Path(DNA).read_text().splitlines()
                if line[:6] in ("ATOM  ", "HETATM")]
        names = [(row[21].strip(), row[22:27].strip(), row[12:16].strip()) for row in rows]
        (self.folder / "sub").mkdir()
        script = self.folder / "sub" / "p.pml"
        shutil.copy(DNA, self.folder / "dna.pdb")
        found = json.loads(self.done("pockets", "dna.pdb", "--json", "--script", "sub/p.pml",
                                     cwd=self.folder).stdout)["pockets"]
        text = script.read_text()
        self.assertIn('os.path.dirname(__script__), "../dna.pdb")', text)
        parts = [ast.literal_eval(line[len("show_part"):]) for line in text.splitlines()
                 if line.startswith("show_part(")]
        self.assertEqual([part[0] for part in parts],
                         [f"pocket_{i + 1}" for i in range(len(found))])
        for (_, _, balls, residues), pocket in zip(parts, found, strict=True):
            self.assertGreater(len(balls), 0)
            self.assertEqual(balls, sorted(balls, key=lambda ball: -ball[3]))
            atoms = [(chain, residue, atom) for chain, residue, atoms in residues
                     for atom in atoms.split()]
            known = {names.index(atom) for atom in atoms if atom in names}
            self.assertEqual(len(atoms), len(pocket["atoms"]))
            self.assertGreater(len(known), 0.9 * len(atoms))

    def test_a_script_of_chimerax_is_told_by_its_ending(self):
        script = self.folder / "p.CXC"
        self.done("pockets", C60, "--script", script)
        text = script.read_text()
        for words in ['\nopen "', "c60.xyz\" id 1\n", "\nmarker #2 position ",
                      '\nrename #2 "pocket_1"\n']:
            self.assertIn(words, text)
        self.assertNotIn("name frozen", text)  # atoms of an XYZ file have no names

    def test_names_and_inputs_that_do_not_fit_are_refused(self):
        for option, name, words in [("--mesh", "p.obj", "must end in .ply"),
                                    ("--script", "p.py", "must end in .pml or .cxc"),
                                    ("--script", "-", "must end in .pml or .cxc")]:
            place = name if name == "-" else self.folder / name
            self.assertIn(words, self.refused(2, "pockets", C60, option, place, "-o", os.devnull))
        self.assertIn("the viewer opens the input itself",
                      self.refused(2, "pockets", EIGHT, "--script", self.folder / "p.pml"))
        self.assertIn("name the same file", self.refused(
            2, "pockets", C60, "--mesh", self.folder / "p.ply", "-o", self.folder / "p.ply"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_files_do_not_depend_on_threads(self):
        found = []
        for threads in ["1", "4"]:
            folder = self.folder / threads
            folder.mkdir()
            self.done("pockets", DNA, "--probe", "0.5", "--threads", threads, *self.files(folder))
            found.append([path.read_bytes() for path in sorted(folder.iterdir())])
        self.assertEqual(len(found[0]), 2)
        self.assertTrue(found[0] == found[1])

    def test_files_that_cannot_be_written_are_3(self):
        for option, name in [("--mesh", "p.ply"), ("--script", "p.pml")]:
            place = self.folder / "none" / name
            self.assertIn(str(place), self.refused(3, "pockets", DNA, option, place))
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
