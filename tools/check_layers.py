#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds every #include of src/orthoball to the layers listed in src/orthoball/LAYERS.

A file may include its own layer, the layers that LAYERS names for it, and the headers directly in
src/orthoball that include no layer themselves, such as ids.h. The other files directly in
src/orthoball, such as alpha_shapes.h, stand above all layers and may include anything.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent / "src" / "orthoball"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](orthoball/)?([^">]+)[">]', re.MULTILINE)


def allowed_layers(text):
    """{layer: layers it may include}, in the order of the file."""
    layers = {}
    for number, line in enumerate(text.splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        layer, colon, uses = line.partition(":")
        if not colon:
            raise SystemExit(f"LAYERS:{number}: no colon; write `layer: layers it may include`")
        for used in uses.split():
            if used not in layers:
                raise SystemExit(f"LAYERS:{number}: {layer} uses {used}, which is not before it")
        layers[layer.strip()] = set(uses.split())
    return layers


def free_headers():
    """Headers of no layer: directly in src/orthoball, and including no layer."""
    free = {"version.h"}  # made from version.h.in
    for path in ROOT.glob("*.h"):
        ours = [target for own, target in INCLUDE.findall(path.read_text()) if own]
        if not any("/" in target for target in ours):
            free.add(path.name)
    return free


def faults(layers):
    """One line for each include that LAYERS does not allow."""
    found = []
    free = free_headers()
    for path in sorted(ROOT.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        parts = path.relative_to(ROOT).parts
        name = "/".join(parts)
        if len(parts) > 1 and parts[0] not in layers:
            found.append(f"{name}: layer {parts[0]} is not listed in LAYERS")
            continue
        text = path.read_text()
        for match in INCLUDE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            ours, target = match.groups()
            if not ours:
                if (ROOT / target).exists() or (path.parent / target).exists():
                    found.append(f'{name}:{line}: "{target}"; write "orthoball/..." in full')
                continue
            layer = target.split("/")[0] if "/" in target else None
            if len(parts) == 1 or target in free:
                continue
            if layer is None:
                found.append(f"{name}:{line}: includes {target}, which stands above all layers")
            elif layer != parts[0] and layer not in layers[parts[0]]:
                found.append(f"{name}:{line}: layer {parts[0]} may not include {target}")
    return found


def main():
    found = faults(allowed_layers((ROOT / "LAYERS").read_text()))
    print("\n".join(found) if found else "every include keeps to its layer")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
