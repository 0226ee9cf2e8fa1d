#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what `orthoball persistence --representatives FILE.ply` wrote as SVG, for the guide.

Usage: class_picture.py FILE.ply PICTURE.svg [--turn AZIMUTH,ELEVATION] [--voids]

Sites of components are dots, cycles of tunnels coloured lines, the triangles that fill them in the
same colour; with --voids also what encloses voids. Seen from a direction in degrees, without
perspective; what is farther is paler.
"""

import argparse
import math
import pathlib
import struct

COLOURS = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
SIZE, MARGIN = 600, 20


def read(path):
    """(vertices, faces, edges) as tuples: (x, y, z, row, class), (i, j, k, class, filling), ..."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    counts = [int(line.split()[2]) for line in header.decode().splitlines()
              if line.startswith("element")]
    parts = []
    for count, form in zip(counts, ["<dddIi", "<BiiiiB", "<iii"]):
        record = struct.Struct(form)
        size = count * record.size
        parts.append(list(record.iter_unpack(data[:size])))
        data = data[size:]
    vertices, faces, edges = parts
    return vertices, [face[1:] for face in faces], edges


class View:
    def __init__(self, vertices, azimuth, elevation):
        a, e = math.radians(azimuth), math.radians(elevation)
        right = (-math.sin(a), math.cos(a), 0.0)
        towards = (math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e))
        up = (-math.cos(a) * math.sin(e), -math.sin(a) * math.sin(e), math.cos(e))
        turned = [tuple(sum(p * q for p, q in zip(axis, vertex)) for axis in (right, up, towards))
                  for vertex in vertices]
        low, high = ([f(place[i] for place in turned) for i in range(3)] for f in (min, max))
        self.scale = SIZE / max(high[0] - low[0], high[1] - low[1], 1e-300)
        self.size = [round((high[i] - low[i]) * self.scale + 2 * MARGIN) for i in range(2)]
        depth = max(high[2] - low[2], 1e-300)
        self.places = [((x - low[0]) * self.scale + MARGIN, (high[1] - y) * self.scale + MARGIN,
                        (z - low[2]) / depth) for x, y, z in turned]

    def path(self, corners):
        return "M" + "L".join(f"{self.places[i][0]:.1f} {self.places[i][1]:.1f}" for i in corners)

    def depth(self, corners):
        return sum(self.places[i][2] for i in corners) / len(corners)


def drawing(vertices, faces, edges, view, voids):
    with_edges = {of for *_, of in edges}
    colour = {of: COLOURS[i % len(COLOURS)] for i, of in enumerate(sorted(with_edges))}
    with_faces = {of for *_, of, filling in faces if not filling}
    items = []
    for i, (*_, of) in enumerate(vertices):
        if of not in with_edges and of not in with_faces:
            pale = 0.15 + 0.5 * view.places[i][2]
            items.append((view.depth([i]), f'<path d="{view.path([i])}h0" stroke="#45525e" '
                          f'stroke-width="2.4" opacity="{pale:.2f}"/>'))
    for *corners, of, filling in faces:
        if filling:
            items.append((view.depth(corners), f'<path d="{view.path(corners)}Z" '
                          f'fill="{colour[of]}" fill-opacity="0.45"/>'))
        elif voids:
            items.append((view.depth(corners), f'<path d="{view.path(corners)}Z" fill="#cfe3f5" '
                          'fill-opacity="0.35" stroke="#7ba3c7" stroke-width="0.4"/>'))
    for *ends, of in edges:
        items.append((view.depth(ends), f'<path d="{view.path(ends)}" stroke="{colour[of]}" '
                      'stroke-width="3.5"/>'))
    return [text for _, text in sorted(items)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--turn", default="30,35")
    parser.add_argument("--voids", action="store_true")
    options = parser.parse_args()
    vertices, faces, edges = read(options.mesh)
    view = View([vertex[:3] for vertex in vertices], *map(float, options.turn.split(",")))
    width, height = view.size
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}">', '<rect width="100%" height="100%" fill="#fff"/>',
             '<g fill="none" stroke-linecap="round" stroke-linejoin="round">',
             *drawing(vertices, faces, edges, view, options.voids), "</g>", "</svg>", ""]
    options.picture.write_text("\n".join(lines))


if __name__ == "__main__":
    main()
