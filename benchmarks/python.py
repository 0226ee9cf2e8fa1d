#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the Python package with gudhi, alphashape and SciPy: seconds of processor time and of the
clock for the same points, the best of some runs. `make python-bench` runs it.

    benchmarks/python.py [--points 10000,100000] [--runs 3] [--threads 1]
"""

import argparse
import platform
import time

import numpy as np

import orthoball


def ours(threads):
    """Every simplex with its alpha2, as a simplex tree of gudhi has them, and sorted besides."""

    def filtration(points):
        found = orthoball.AlphaShapes(points, threads=threads).filtration()
        return found.vertices, found.alpha2

    return filtration


def polygon(points):
    return orthoball.AlphaShapes(points).shape(inverse_alpha=np.sqrt(len(points)) / 2).to_shapely()


def gudhi_filtration(precision):
    import gudhi

    return lambda points: gudhi.AlphaComplex(
        points=points, precision=precision
    ).create_simplex_tree()


def delaunay_cech(points):
    import gudhi

    return gudhi.DelaunayCechComplex(points=points).create_simplex_tree()


def delaunay(points):
    from scipy.spatial import Delaunay

    return Delaunay(points)


def alphashape_polygon(points):
    import alphashape

    return alphashape.alphashape(points, np.sqrt(len(points)) / 2)


def contestants(dimension, threads):
    """(name, work, most points that it is given)."""
    yield "orthoball, whole filtration", ours(threads), np.inf
    if threads == 1:
        yield "the same on all cores", ours(None), np.inf
    for precision in ("fast", "safe", "exact"):
        yield f"gudhi AlphaComplex {precision}", gudhi_filtration(precision), 100_000
    import gudhi

    if hasattr(gudhi, "DelaunayCechComplex"):
        yield "gudhi DelaunayCechComplex", delaunay_cech, 100_000
    yield "scipy Delaunay (no filtration)", delaunay, np.inf
    if dimension == 2:
        yield "orthoball, one polygon", polygon, np.inf
        yield "alphashape, one polygon", alphashape_polygon, 10_000


def seconds(work, points, runs):
    """The least processor time and the least time by the clock."""
    processor, clock = [], []
    for _ in range(runs):
        before = time.process_time(), time.perf_counter()
        work(points)
        processor.append(time.process_time() - before[0])
        clock.append(time.perf_counter() - before[1])
    return min(processor), min(clock)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", default="10000,100000", help="numbers of points")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--threads", type=int, default=1, help="of orthoball; the others have one")
    options = parser.parse_args()
    print(f"orthoball {orthoball.__version__}, Python {platform.python_version()}, "
          f"{platform.machine()}, {options.threads} thread(s)")  # fmt: skip
    for dimension in (2, 3):
        for count in map(int, options.points.split(",")):
            points = np.random.default_rng(1).random((count, dimension))
            print(f"\n{count} uniform points in {dimension}D: processor, clock [s], times ours")
            first = None
            for name, work, most in contestants(dimension, options.threads):
                if count > most:
                    continue
                processor, clock = seconds(work, points, options.runs)
                first = first or processor
                print(
                    f"  {name:32}{processor:9.3f}{clock:9.3f}{processor / first:9.1f}", flush=True
                )


if __name__ == "__main__":
    main()
