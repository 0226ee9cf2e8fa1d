#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes docs/cli.md from the program's own --help, or with --check compares the two."""

import argparse
import pathlib
import re
import subprocess
import sys

REFERENCE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "cli.md"
OPENING = """# Command line reference

Written by `tools/cli_reference.py` from the program's `--help`; a test compares the two.
"""


def help_text(program, *command):
    result = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=True)
    # CLI11 prints the program's path as it was called.
    return result.stdout.replace(program, "orthoball").strip("\n")


def reference(program):
    overview = help_text(program)
    after = re.split(r"^Subcommands:\s*$|^Commands:\s*$", overview, flags=re.MULTILINE)[-1]
    listed = after.strip("\n").split("\n\n")[0]  # what follows are words and examples
    commands = re.findall(r"^  ([a-z]+)\s", listed, flags=re.MULTILINE)
    if not commands:
        raise SystemExit("no commands found in the program's --help")
    sections = [("orthoball", overview)]
    sections += [(f"orthoball {command}", help_text(program, command)) for command in commands]
    return OPENING + "".join(f"\n## {title}\n\n```text\n{text}\n```\n" for title, text in sections)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the program orthoball")
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    options = parser.parse_args()

    text = reference(options.program)
    if not options.check:
        REFERENCE.write_text(text)
        return 0
    if REFERENCE.exists() and REFERENCE.read_text() == text:
        return 0
    print("docs/cli.md is not what --help prints; `make docs` writes it anew")
    return 1


if __name__ == "__main__":
    sys.exit(main())
