#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every C++ file is formatted, or with --write formats it, by .clang-format."""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("src", "cli", "python", "tests", "benchmarks", "examples")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="clang-format-14")
    parser.add_argument("--write", action="store_true", help="format instead of checking")
    options = parser.parse_args()

    files = [
        path
        for folder in FOLDERS
        for suffix in ("*.h", "*.cpp")
        for path in sorted((ROOT / folder).rglob(suffix))
    ]
    how = ["-i"] if options.write else ["--dry-run", "-Werror"]
    return subprocess.run([options.program, *how, *files], cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
