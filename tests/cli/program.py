# SPDX-License-Identifier: MIT
"""What tests of the program share. Importing this takes PROGRAM from the command line and goes to
the source tree.
"""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SAMPLES = ROOT / "examples" / "data"
MALFORMED = ROOT.parent / "shared" / "data" / "malformed"
PROGRAM = os.path.abspath(sys.argv.pop(1))
os.chdir(ROOT)

TWO_BALLS = str(SAMPLES / "two_balls.xyzr")
C60 = str(SAMPLES / "c60.xyz")
EIGHT = str(SAMPLES / "figure_eight.csv")


def orthoball(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=False,
                          **{"text": True, **options})


class InAFolder(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = pathlib.Path(self.keeper.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def done(self, *arguments, **options):
        result = orthoball(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def refused(self, status, *arguments, **options):
        result = orthoball(*arguments, **options)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, r"\A(orthoball: .+\n)+\Z")
        return result.stderr


def ply(path):
    """(vertices, elements) of a binary mesh of regions: (x, y, z, row), (vertices, region, mouth)."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    lines = header.decode().splitlines()
    counts = {words[1]: int(words[2]) for words in map(str.split, lines) if words[0] == "element"}
    size = 2 if "edge" in counts else 3
    vertex = struct.Struct("<dddI")
    element = struct.Struct("<" + "B" * (size == 3) + "i" * size + "i" +
                            "B" * ("property uchar mouth" in lines))
    end = vertex.size * counts.pop("vertex")
    first = size == 3
    elements = [(numbers[first:first + size], *numbers[first + size:])
                for numbers in element.iter_unpack(data[end:])]
    assert [len(elements)] == list(counts.values())
    return list(vertex.iter_unpack(data[:end])), elements
