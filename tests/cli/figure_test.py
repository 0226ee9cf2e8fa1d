#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pictures that `figure` draws of planar data.

Usage: figure_test.py PROGRAM [unittest options]
"""

import json
import re
import unittest
import xml.etree.ElementTree as xml

from program import EIGHT, InAFolder, TWO_BALLS

SVG = "{http://www.w3.org/2000/svg}"
DISKS = "x,y,r\n0,0,1\n1.5,0,1\n0.7,1.2,0.8\n6,0,1\n"
PLANE = ["--columns", "x,y", "--radius-column", "r"]


class Figure(InAFolder):
    def disks(self):
        return self.file("disks.csv", DISKS)

    def drawn(self, *arguments):
        return xml.fromstring(self.done("figure", *arguments).stdout)

    def classes(self, picture):
        return {path.get("class") for path in picture.iter(f"{SVG}path") if path.get("class")}

    def words(self, picture):
        return [text.text for text in picture.iter(f"{SVG}text")]

    def test_the_sheet_has_three_panels(self):
        picture = self.drawn(self.disks(), *PLANE)
        self.assertLessEqual({"disks", "parts", "triangles", "union"}, self.classes(picture))
        words = self.words(picture)
        self.assertEqual(words[0], "disks.csv")
        self.assertRegex(words[1], r"^alpha2 0, index \d+: 4 disks, area [\d.]+, perimeter [\d.]+, "
                                   r"2 components, 0 holes$")

    def test_its_numbers_are_those_of_measure(self):
        words = self.words(self.drawn(self.disks(), *PLANE, "--alpha2", "0.5"))
        shown = re.search(r"area ([\d.]+), perimeter ([\d.]+)", words[1]).groups()
        report = json.loads(
            self.done("measure", self.disks(), *PLANE, "--alpha2", "0.5", "--json").stdout)
        self.assertEqual(shown, (f"{report['volume']:.6g}", f"{report['area']:.6g}"))

    def test_panels_style_title_and_width_are_options(self):
        picture = self.drawn(self.disks(), *PLANE, "--panels", "complex", "--title", "Four disks",
                             "--style", "print", "--width", "200")
        self.assertNotIn("parts", self.classes(picture))
        self.assertEqual(self.words(picture)[0], "Four disks")
        self.assertEqual(picture.get("width"), "248")
        bare = self.drawn(self.disks(), *PLANE, "--no-legend")
        self.assertEqual(self.words(bare), [])

    def test_points_without_weights_are_drawn_at_a_notable_alpha(self):
        path = self.folder / "eight.svg"
        self.assertIn("alpha2 auto", self.done("figure", EIGHT, "-o", path).stderr)
        self.assertIn("1 component, 2 holes", path.read_text())

    def test_the_plot_marks_the_alpha_of_the_figure(self):
        path = self.folder / "plot.svg"
        self.done("figure", self.disks(), *PLANE, "--alpha2", "0.25", "--plot", path)
        self.assertIn("figure (0.5)", path.read_text())

    def test_mistakes_are_explained(self):
        disks = self.disks()
        for arguments, message in [
            ([TWO_BALLS], "figure draws disks in the plane, and these points are in space"),
            ([disks, *PLANE, "--panels", "disks,edges"], 'there is no panel "edges"'),
            ([disks, *PLANE, "-o", "figure.png"], "a picture is SVG"),
            ([disks, *PLANE, "-o", self.folder / "a.svg", "--plot", self.folder / "a.svg"],
             "--plot and -o name the same file"),
            ([disks, *PLANE, "--alpha2", "0,1"], "takes one alpha"),
            ([disks, *PLANE, "--width", "0"], "--width"),
        ]:
            self.assertIn(message, self.refused(2, "figure", *arguments))


if __name__ == "__main__":
    unittest.main()
