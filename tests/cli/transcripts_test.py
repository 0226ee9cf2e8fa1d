#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Executes the transcripts of README.md and docs/ and compares what they show.

A transcript is a block marked `console`: lines after `$ ` are run by a shell, with the program on
the PATH, in a folder that holds a copy of examples/; the lines up to the next `$ ` are what it
prints. A line `...` stands for any number of lines. Long numbers are compared to 11 digits: the last
ones of a measure are those of the machine's sine and arc tangent.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LONG_NUMBER = re.compile(r"( *)(-?\d+\.\d{8,}(?:e[+-]?\d+)?)")
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def steps(block):
    """(command, expected output) of each `$ ` line of a block."""
    for step in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, output = step.partition("\n")
        yield command, output


def shortened(text):
    """With long numbers rounded, and one blank before them for any that align them."""
    return LONG_NUMBER.sub(lambda found: f"{found[1][:1]}{float(found[2]):.11g}", text)


def matches(expected, printed):
    pattern = "".join(
        "(?:.*\n)*?" if line == "...\n" else re.escape(line)
        for line in shortened(expected).splitlines(True)
    )
    return re.fullmatch(pattern, shortened(printed)) is not None


def faults(document, folder, environment):
    for block in BLOCK.findall(document.read_text()):
        for command, expected in steps(block):
            result = subprocess.run(
                command, shell=True, cwd=folder, env=environment, text=True, check=False,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            )
            if "built without the viewer" in result.stdout:
                continue
            if not matches(expected, result.stdout):
                name = document.relative_to(ROOT)
                yield f"{name}: $ {command}\n--- shown\n{expected}--- printed\n{result.stdout}"


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    documents = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    found = []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "examples", pathlib.Path(folder) / "examples")
        environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
        for document in documents:
            found += faults(document, folder, environment)
    print("\n".join(found) if found else "every transcript is what the program prints")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
