#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs two programs and fails unless they print the same, something at all.

same_output.py PROGRAM OTHER_PROGRAM
"""

import subprocess
import sys


def lines(program):
    return subprocess.run([program], capture_output=True, text=True, check=True).stdout.split("\n")


def main():
    first, second = lines(sys.argv[1]), lines(sys.argv[2])
    differing = [pair for pair in zip(first, second) if pair[0] != pair[1]]
    for one, other in differing:
        print(f"{one}\n    but: {other}")
    if len(first) != len(second) or len(first) < 2:
        print(f"{len(first)} and {len(second)} lines")
        return 1
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
