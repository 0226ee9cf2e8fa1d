#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages that `view` writes, from outside: what a browser makes of them is tested in viewer/tests.

Usage: view_test.py PROGRAM [unittest options]
"""

import base64
import gzip
import json
import os
import pathlib
import pty
import re
import shutil
import time
import unittest

from program import C60, EIGHT, InAFolder, orthoball, PROGRAM

HAS_VIEWER = "without the viewer" not in orthoball("view", C60, "-o", "/dev/null").stderr


def header(page):
    """The facts of the data in a page."""
    (text,) = re.findall(r'id="snapshot">\s*([A-Za-z0-9+/=]+)\s*</script>', page)
    data = gzip.decompress(base64.b64decode(text))
    assert data[:8] == b"OBsnap1\n"
    size = int.from_bytes(data[8:16], "little")
    return json.loads(data[16:16 + size])


@unittest.skipIf(HAS_VIEWER, "the viewer is there")
class WithoutTheViewer(InAFolder):
    def test_view_says_so(self):
        self.assertIn("without the viewer", self.refused(3, "view", C60))


@unittest.skipUnless(HAS_VIEWER, "built without the viewer")
class Page(InAFolder):
    def test_is_named_after_the_input_and_its_path_is_printed(self):
        shutil.copy(C60, self.folder / "ball & <co>.xyz")
        result = self.done("view", "ball & <co>.xyz", cwd=self.folder)
        self.assertEqual(result.stdout, "ball & <co>.html\n")
        page = (self.folder / "ball & <co>.html").read_text()
        self.assertIn("<title>ball &amp; &lt;co>.xyz – Orthoball</title>", page)
        self.assertEqual(header(page)["source"], "ball & <co>.xyz")

    def test_of_a_compressed_input_has_neither_ending(self):
        (self.folder / "c60.xyz.gz").write_bytes(gzip.compress(pathlib.Path(C60).read_bytes()))
        self.assertEqual(self.done("view", "c60.xyz.gz", cwd=self.folder).stdout, "c60.html\n")

    def test_goes_to_standard_output_and_is_the_same_bytes(self):
        pages = {self.done("view", EIGHT, "-o", "-", "--threads", n).stdout for n in (1, 1, 2)}
        self.assertEqual(len(pages), 1)
        self.assertTrue(pages.pop().rstrip().endswith("</html>"))

    def test_begins_with_the_alpha_that_was_asked_for(self):
        start = header(self.done("view", EIGHT, "-o", "-", "--alpha", "0.2").stdout)["start"]
        row = json.loads(self.done("signatures", EIGHT, "--alpha", "0.2", "--json").stdout)[0]
        self.assertEqual((start["index"], start["alpha2"], start["reason"]),
                         (row["index"], row["alpha2"], ""))
        auto = header(self.done("view", EIGHT, "-o", "-").stdout)["start"]
        row = json.loads(self.done("signatures", EIGHT, "--alpha2", "auto", "--json").stdout)[0]
        self.assertEqual((auto["index"], auto["alpha2"]), (row["index"], row["alpha2"]))
        self.assertNotEqual(auto["reason"], "")

    def test_takes_the_place_of_an_older_page_but_of_no_other_file(self):
        self.done("view", C60, cwd=self.folder)
        self.done("view", C60, cwd=self.folder)
        other = self.file("c60.html", "<html>mine</html>")
        self.assertIn("will not be replaced", self.refused(2, "view", C60, cwd=self.folder))
        self.assertEqual(other.read_text(), "<html>mine</html>")
        self.done("view", C60, "-o", "c60.html", cwd=self.folder)

    def test_of_bad_data_is_not_begun(self):
        bad = self.file("bad.csv", "1,2,3\n1,2,x\n")
        self.assertIn("bad.csv:2", self.refused(1, "view", bad, cwd=self.folder))
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad.csv"])
        self.assertIn("-o FILE", self.refused(2, "view", "-", "--input-format", "table"))

    def test_holds_nothing_that_a_browser_would_fetch(self):
        page = self.done("view", EIGHT, "-o", "-").stdout
        self.assertIn("default-src 'none'", page)
        self.assertEqual(re.findall(r'<(?:link|script|img)[^>]*(?:src|href)="(?!data:)[^"]*"', page), [])

    def test_is_of_no_sites_too(self):
        empty = self.file("empty.csv", "x,y,z\n")
        self.assertEqual(header(self.done("view", empty, "-o", "-", "--allow-empty").stdout)["sites"], 0)


@unittest.skipUnless(HAS_VIEWER, "built without the viewer")
class Opening(InAFolder):
    def opened(self, *arguments, display=":7"):
        """What a stand-in for xdg-open is given when the program runs on a terminal."""
        note = self.folder / "opened"
        stand_in = self.file("xdg-open", f'#!/bin/sh\necho "$1" > {note}\n')
        stand_in.chmod(0o755)
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.environ.update(PATH=f"{self.folder}:{os.environ['PATH']}", DISPLAY=display,
                              WAYLAND_DISPLAY="")
            os.execv(PROGRAM, [PROGRAM, "view", C60, "--quiet", *arguments])
        shown = b""
        while True:
            try:
                piece = os.read(terminal, 1000)
            except OSError:
                break
            if not piece:
                break
            shown += piece
        self.assertEqual(os.waitpid(child, 0)[1], 0, shown)
        self.assertIn(b"c60.html", shown)
        for _ in range(20 if display and not arguments else 4):
            if note.exists() and note.read_text().endswith("\n"):
                return note.read_text().strip()
            time.sleep(0.1)
        return None

    def test_is_done_on_a_terminal_with_a_display(self):
        self.assertEqual(self.opened(), os.path.realpath(self.folder / "c60.html"))

    def test_is_not_done_without_or_where_it_is_not_wanted(self):
        self.assertIsNone(self.opened("--no-open"))
        self.assertIsNone(self.opened(display=""))


if __name__ == "__main__":
    unittest.main()
