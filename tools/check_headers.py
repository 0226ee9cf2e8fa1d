#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the headers of src/orthoball: each compiles alone, each public name is documented, and each
source that is cited is in docs/references.bib.

A declaration is documented by a comment directly above it or at its end, or by belonging to a run
of declarations without an empty line that a comment opens. Types, free functions, constants of the
namespace, public member functions, and fields that are arrays (whose shape must be said) need one.
What its signature, its type or its body says in full does not: constructors, operators, friends,
other fields, enumerators, members defined where they stand, and namespaces named x_detail.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src"

SCOPE = re.compile(r"^(?:export\s+)?(?:inline\s+)?(namespace|class|struct|enum|union|extern \"C\")\b")
TOKENS = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])*\'|[{};]|\n|[^/"\'{};\n]+|.',
    re.DOTALL,
)


class Scope:
    def __init__(self, kind, name, public):
        self.kind, self.name, self.public = kind, name, public


def declared_name(text):
    """The name that a declaration without comments introduces, for the message."""
    text = re.sub(r"\[\[.*?\]\]", "", text).split("=")[0].strip()
    while (stripped := re.sub(r"<[^<>]*>", "", text)) != text:
        text = stripped
    if match := re.search(r"\b(?:class|struct|union|enum(?: class)?|using|concept)\s+(\w+)", text):
        return match.group(1)
    match = re.search(r"([~\w]+)\s*\(", text) or re.search(r"(\w+)\s*(?:=|\{|\[|$)", text)
    return match.group(1) if match else text.strip()


class Reader:
    """Walks one header, keeping the stack of scopes, and collects undocumented declarations."""

    def __init__(self, text):
        self.text = text
        self.scopes = [Scope("namespace", "", True)]
        self.faults = []
        self.lines = text.split("\n")

    def documented(self, first, last):
        """Whether the declaration on lines first..last (from 0) has a comment or belongs to a run."""
        if "///<" in self.lines[last] or re.search(r"//", self.lines[last]):
            return True
        line = first - 1
        while line >= 0 and self.lines[line].strip():
            text = self.lines[line].strip()
            if text.startswith("//"):
                return True
            if text.endswith(":") or SCOPE.match(re.sub(r"^template\s*<.*?>\s*", "", text)):
                return False
            line -= 1
        return False

    def is_exempt(self, text, defined):
        scope = self.scopes[-1]
        plain = re.sub(r"\[\[.*?\]\]", "", text).strip()
        if not plain or re.match(r"(using\s+(namespace\b|[\w:]+$)|static_assert|extern template|friend\b|#)", plain):
            return True
        if re.search(r"\boperator\b", plain):
            return True
        if re.match(r"(template\s*<.*?>\s*)?(class|struct|enum(\s+class)?)\s+\w+$", plain) and not defined:
            return True  # a forward declaration
        if re.match(r"template\b.*\b(class|struct)\s+\w+<", plain):
            return True  # a specialisation
        if scope.kind in ("class", "struct") and not re.match(r"(class|struct|enum|using)\b", plain):
            if "(" not in plain.split("=")[0] and not re.search(r"\b(vector|array|span)\s*<", plain):
                return True  # a field that is not an array
            if re.match(rf"(explicit\s+|constexpr\s+|~)*{re.escape(scope.name)}\s*\(", plain):
                return True
            if defined:
                return True
        return False

    def judge(self, text, first, last, defined):
        if all(scope.public for scope in self.scopes) and not self.is_exempt(text, defined):
            if not self.documented(first, last):
                self.faults.append((first + 1, declared_name(text)))

    def run(self):
        tokens = [(match.group(), match.start()) for match in TOKENS.finditer(self.text)]
        declaration, first, parentheses, skip = "", None, 0, 0
        number = 0
        position = 0
        while position < len(tokens):
            token, _ = tokens[position]
            position += 1
            if token.startswith(("//", "/*")):
                number += token.count("\n")
                continue
            if token == "\n":
                declaration += " " if declaration else ""
                number += 1
                continue
            if skip:  # inside a function's body or an initialiser
                skip += {"{": 1, "}": -1}.get(token, 0)
                if skip == 0 and not self.initialiser:
                    declaration, first = "", None
                continue
            if token not in ("{", "}", ";"):
                if token.lstrip().startswith("#"):
                    while position < len(tokens) and tokens[position][0] != "\n":
                        position += 1
                    continue
                if not declaration.strip() and token.strip():
                    first = number
                declaration += token
                parentheses = declaration.count("(") - declaration.count(")")
                access = re.match(r"\s*(public|private|protected)\s*:(?!:)\s*", declaration)
                if access:
                    self.scopes[-1].public = access.group(1) == "public"
                    declaration = declaration[access.end():]
                    first = number if declaration.strip() else None
                continue
            text = declaration.strip()
            if token == ";":
                if parentheses <= 0:
                    if text:
                        self.judge(text, first, number, False)
                    declaration, first = "", None
            elif token == "}":
                if len(self.scopes) > 1:
                    self.scopes.pop()
                declaration, first = "", None
            elif parentheses > 0:
                skip, self.initialiser = 1, True
            else:
                bare = re.sub(r"^template\s*<.*?>\s*(?=class|struct|union)", "", text)
                scope = SCOPE.match(bare)
                if scope and scope.group(1) == "enum":
                    self.judge(text, first, first, True)
                    end = position
                    while tokens[end][0] != "}":
                        number += tokens[end][0].count("\n")
                        end += 1
                    position = end + 1
                    declaration, first = "", None
                elif scope:
                    kind = scope.group(1)
                    name = declared_name(bare)
                    if kind != "namespace":
                        self.judge(text, first, first, True)
                    hidden = kind == "namespace" and name.endswith("detail")
                    self.scopes.append(Scope(kind, name, kind != "class" and not hidden))
                    declaration, first = "", None
                else:
                    is_function = "(" in text and not re.search(r"=\s*$", text)
                    if is_function:
                        self.judge(text, first, number, True)
                    skip, self.initialiser = 1, not is_function
        return self.faults


def undocumented(path):
    name = path.relative_to(SOURCE)
    return [f"{name}:{line}: {what} is not documented" for line, what in Reader(path.read_text()).run()]


def uncited():
    """Keys cited in the library that docs/references.bib lacks."""
    references = ROOT / "docs" / "references.bib"
    known = set(re.findall(r"^@\w+\{(\w+),", references.read_text(), re.MULTILINE))
    for path in sorted([*SOURCE.rglob("*.h"), *SOURCE.rglob("*.cpp")]):
        for key in re.findall(r"@cite\s+(\w+)", path.read_text()):
            if key not in known:
                yield f"{path.relative_to(SOURCE)}: @cite {key} is not in docs/references.bib"


def compile_alone(path, compiler, includes):
    """What the compiler says to a file that includes nothing but this header."""
    name = path.relative_to(SOURCE)
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as unit:
        unit.write(f'#include "{name}"\n')
        unit.flush()
        flags = [flag for folder in (SOURCE, *includes) for flag in ("-I", str(folder))]
        command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *flags]
        result = subprocess.run([*command, unit.name], capture_output=True, text=True, check=False)
    return [f"{name} does not compile alone:\n{result.stderr}"] if result.returncode else []


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--include", action="append", default=[], help="folder of generated headers")
    options = parser.parse_args()

    headers = sorted(SOURCE.rglob("*.h"))
    faults = [*uncited(), *(fault for path in headers for fault in undocumented(path))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda path: compile_alone(path, options.compiler, options.include), headers):
            faults += found
    print("\n".join(faults) if faults else f"{len(headers)} headers: documented, each compiles alone")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
