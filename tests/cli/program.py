# SPDX-License-Identifier: MIT
"""What tests of the program share. Importing this takes PROGRAM from the command line and goes to
the source tree.
"""

import os
import pathlib
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
