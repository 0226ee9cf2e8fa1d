#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the samples beside this file, or with --check compares them with what it would write.

All arithmetic is decimal with 50 digits and the results are rounded to a fixed number of decimals,
so every machine writes the same bytes.
"""

import argparse
import pathlib
import sys
from decimal import Decimal, getcontext

getcontext().prec = 50
FOLDER = pathlib.Path(__file__).resolve().parent


def sine(x):
    """sin x by its power series; exact to 40 digits for |x| < 20."""
    total = term = x
    n = 1
    while abs(term) > Decimal(10) ** -45:
        n += 2
        term *= -x * x / (n * (n - 1))
        total += term
    return total


def arctangent(x):
    """arctan x by its power series, |x| < 1/2."""
    total = power = x
    n = 1
    while abs(power) > Decimal(10) ** -48:
        n += 2
        power *= -x * x
        total += power / n
    return total


PI = 16 * arctangent(Decimal(1) / 5) - 4 * arctangent(Decimal(1) / 239)  # Machin 1706
GOLDEN = (1 + Decimal(5).sqrt()) / 2


def cosine(x):
    return sine(x + PI / 2)


def fixed(x, decimals):
    """x with so many decimals, never -0."""
    rounded = x.quantize(Decimal(1).scaleb(-decimals))
    return f"{rounded if rounded else abs(rounded):f}"


# The repeating unit of B-DNA in cylindrical coordinates: atom, r [Angstrom], phi [degrees],
# z [Angstrom]. Arnott, Hukins: Optimised parameters for A-DNA and B-DNA. Biochemical and
# Biophysical Research Communications 47 (1972). The base pair's dyad is the x axis.
RISE, TWIST = Decimal("3.38"), Decimal(36)
BACKBONE = [
    ("P", "8.91", "95.2", "2.08"),
    ("OP1", "10.20", "91.1", "1.86"),
    ("OP2", "8.82", "103.3", "1.29"),
    ("O5'", "7.73", "88.0", "1.83"),
    ("C5'", "7.70", "79.8", "2.77"),
    ("C4'", "7.59", "69.9", "2.04"),
    ("O4'", "6.22", "66.0", "1.83"),
    ("C3'", "8.20", "69.9", "0.64"),
    ("O3'", "8.75", "61.4", "0.25"),
    ("C2'", "7.04", "73.2", "-0.24"),
    ("C1'", "5.86", "67.4", "0.47"),
]
BASES = {
    "A": [
        ("N9", "4.63", "76.6", "0.42"),
        ("C8", "4.84", "93.0", "0.50"),
        ("N7", "3.95", "105.4", "0.43"),
        ("C5", "2.74", "94.0", "0.28"),
        ("C6", "1.41", "107.2", "0.15"),
        ("N6", "1.83", "154.0", "0.14"),
        ("N1", "0.86", "40.1", "0.03"),
        ("C2", "2.17", "30.6", "0.04"),
        ("N3", "3.24", "47.0", "0.16"),
        ("C4", "3.33", "70.5", "0.28"),
    ],
    "G": [
        ("N9", "4.63", "76.6", "0.42"),
        ("C8", "4.82", "93.2", "0.50"),
        ("N7", "3.92", "105.7", "0.42"),
        ("C5", "2.70", "94.0", "0.28"),
        ("C6", "1.39", "109.3", "0.15"),
        ("O6", "1.71", "154.6", "0.13"),
        ("N1", "0.92", "37.9", "0.03"),
        ("C2", "2.28", "28.7", "0.03"),
        ("N2", "3.01", "4.2", "-0.10"),
        ("N3", "3.29", "46.7", "0.16"),
        ("C4", "3.33", "70.3", "0.28"),
    ],
    "C": [
        ("N1", "4.63", "76.6", "0.42"),
        ("C2", "3.40", "67.4", "0.27"),
        ("O2", "3.69", "47.9", "0.18"),
        ("N3", "2.31", "83.9", "0.22"),
        ("C4", "2.94", "110.0", "0.32"),
        ("N4", "2.76", "136.6", "0.27"),
        ("C5", "4.35", "107.0", "0.47"),
        ("C6", "4.99", "92.2", "0.52"),
    ],
    "T": [
        ("N1", "4.63", "76.6", "0.42"),
        ("C2", "3.42", "67.3", "0.27"),
        ("O2", "3.64", "47.8", "0.18"),
        ("N3", "2.36", "85.2", "0.23"),
        ("C4", "2.98", "111.9", "0.32"),
        ("O4", "2.82", "136.3", "0.27"),
        ("C5", "4.38", "106.9", "0.47"),
        ("C7", "5.40", "119.8", "0.58"),
        ("C6", "5.01", "92.3", "0.52"),
    ],
}
COMPLEMENT = {"A": "T", "T": "A", "C": "G", "G": "C"}


def bdna(sequence):
    """A double helix as PDB. A strand runs down the helix; the other is its image by the dyad."""
    lines = [
        "REMARK   1 B-DNA FROM THE FIBRE MODEL OF ARNOTT AND HUKINS (1972), NO HYDROGENS",
        "REMARK   1 WRITTEN BY MAKE_SAMPLES.PY",
    ]
    serial = 0
    count = len(sequence)
    for chain in "AB":
        for number in range(1, count + 1):
            pair = number if chain == "A" else count + 1 - number
            base = sequence[pair - 1] if chain == "A" else COMPLEMENT[sequence[pair - 1]]
            mirror = 1 if chain == "A" else -1
            atoms = BACKBONE[3:] if number == 1 else BACKBONE  # no phosphate at the 5' end
            for atom, r, phi, z in atoms + BASES[base]:
                serial += 1
                angle = (mirror * Decimal(phi) - TWIST * (pair - 1)) * PI / 180
                height = mirror * Decimal(z) - RISE * (pair - 1)
                x, y = Decimal(r) * cosine(angle), Decimal(r) * sine(angle)
                lines.append(
                    f"ATOM  {serial:5d}  {atom:<3s}  D{base} {chain}{number:4d}    "
                    f"{fixed(x, 3):>8s}{fixed(y, 3):>8s}{fixed(height, 3):>8s}"
                    f"  1.00  0.00          {atom[0]:>2s}"
                )
        serial += 1
        lines.append(f"TER   {serial:5d}       D{base} {chain}{count:4d}")
    lines.append("END")
    return lines


def c60():
    """Buckminsterfullerene as XYZ: an icosahedron of edge 2a + b with every corner cut off at a."""
    single, double = Decimal("1.455"), Decimal("1.40")  # 60 bonds, 30 bonds [Angstrom]
    edge = 2 * single + double
    corners = []
    for one in (1, -1):
        for golden in (GOLDEN, -GOLDEN):
            corners += [(0, one, golden), (one, golden, 0), (golden, 0, one)]
    corners = [tuple(edge / 2 * x for x in corner) for corner in corners]
    lines = ["60", "C60, bonds 1.455 and 1.40 Angstrom"]
    for a in corners:
        for b in corners:
            length2 = sum((x - y) ** 2 for x, y in zip(a, b))
            if 0 < length2 < edge * edge * Decimal("1.5"):
                atom = (x + (y - x) * single / edge for x, y in zip(a, b))
                lines.append("C " + " ".join(f"{fixed(x, 6):>10s}" for x in atom))
    return lines


def linked_tori():
    """Two tori R = 2, r = 1/2, one through the other, 987 points evenly by area on each."""
    big, small = Decimal(2), Decimal("0.5")
    count, step = 987, 610  # Fibonacci numbers: a lattice without a seam
    lines = ["x,y,z"]
    for second in (False, True):
        for i in range(count):
            u = 2 * PI * i / count
            share = 2 * PI * (i * step % count) / count
            v = share
            for _ in range(30):  # to v + (r / R) sin v = share: equal areas; each step gains a factor 4
                v = share - small / big * sine(v)
            rho, height = big + small * cosine(v), small * sine(v)
            x, y, z = rho * cosine(u), rho * sine(u), height
            if second:
                x, y, z = x + 2, -z, y
            lines.append(",".join(fixed(c, 4) for c in (x, y, z)))
    return lines


def uneven_torus():
    """A torus R = 2 whose tube is 0.65 thick on one side and 0.15 on the other, in rings of evenly spaced
    points; on the thick side there are ten times fewer for the same area."""
    big, middle, sway = Decimal(2), Decimal("0.4"), Decimal("0.25")
    lines = ["x,y,z"]
    number = 0
    for first, spacing in ((-PI / 2, Decimal("0.08") * Decimal(10).sqrt()), (PI / 2, Decimal("0.08"))):
        rings = round(PI * big / spacing)
        for ring in range(rings):
            u = first + PI * (2 * ring + 1) / (2 * rings)
            small = middle + sway * cosine(u)
            count = round(2 * PI * small / spacing)
            for i in range(count):
                v = PI * (2 * i + number % 2) / count  # every second ring between the points of the first
                rho = big + small * cosine(v)
                place = (rho * cosine(u), rho * sine(u), small * sine(v))
                lines.append(",".join(fixed(c, 3) for c in place))
            number += 1
    return lines


def figure_eight():
    """800 points of the plane in two rings of mean radius 1 that share the origin."""
    lines = ["x,y"]
    plastic = Decimal("1.32471795724474602596")  # x^3 = x + 1: the evenest sequence in the plane
    for i in range(800):
        turn = (i / plastic) % 1
        across = (i / plastic**2) % 1
        side = 1 if i % 2 else -1
        radius = Decimal("0.85") + Decimal("0.3") * across
        angle = 2 * PI * turn
        lines.append(f"{fixed(side * (1 + radius * cosine(angle)), 4)},{fixed(radius * sine(angle), 4)}")
    return lines


def trees():
    """36 trees on a plot of 60 by 40 metres, with the radius of each crown."""
    lines = ["x,y,crown"]
    plastic = Decimal("1.32471795724474602596")
    for i in range(1, 37):
        x, y = 60 * (i / plastic % 1), 40 * (i / plastic**2 % 1)
        sway, swing, size = ((i * i * GOLDEN * k) % 1 for k in (1, 2, 3))
        place = (x + 7 * sway, y + 7 * swing, 3 + 3 * size**2)
        lines.append(",".join(fixed(c, 2) for c in place))
    return lines


SAMPLES = {
    "bdna_dodecamer.pdb": lambda: bdna("CGCGAATTCGCG"),
    "c60.xyz": c60,
    "linked_tori.csv": linked_tori,
    "uneven_torus.csv": uneven_torus,
    "figure_eight.csv": figure_eight,
    "trees.csv": trees,
    "two_balls.xyzr": lambda: ["0 0 0 1", "3 0 0 1"],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    options = parser.parse_args()

    stale = []
    for name, lines in SAMPLES.items():
        text = "\n".join(lines()) + "\n"
        path = FOLDER / name
        if not options.check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            stale.append(name)
    for name in stale:
        print(f"examples/data/{name} is not what make_samples.py writes")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
