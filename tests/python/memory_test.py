# SPDX-License-Identifier: MIT
"""Who owns what, and that nothing is left behind."""

import gc
import pathlib
import threading
import weakref

import numpy as np
import pytest

from orthoball import AlphaShapes


def resident():
    """Bytes of memory that the process holds."""
    status = pathlib.Path("/proc/self/status").read_text()
    return int(status.partition("VmRSS:")[2].split()[0]) * 1024


def used(points):
    shapes = AlphaShapes(points, radii=0.01)
    shapes.signatures, shapes.filtration(), shapes.persistence()
    shape = shapes.shape()
    shape.triangles, shape.cells, shape.volume
    balls = shapes.balls(probe=0.01)
    balls.contacts, balls.derivatives, balls.voids, balls.pockets
    shapes.signatures.to_bytes("csv"), balls.to_bytes("per_atom", "json")
    fewer = AlphaShapes(points[:200])
    fewer.shape("auto:connected").manifold().solid.to_bytes("csv")
    fewer.persistence(0).representatives()


@pytest.mark.skipif(not pathlib.Path("/proc/self/status").exists(), reason="reads /proc")
def test_a_hundred_instances_leave_nothing_behind():
    points = np.random.default_rng(5).random((2000, 3))
    for _ in range(20):
        used(points)
    gc.collect()
    before = resident()
    for _ in range(100):
        used(points)
    gc.collect()
    # One instance holds 2 MB and more in its arrays.
    assert resident() - before < 30e6


def test_shapes_end_when_nobody_names_them_any_more(cloud):
    gc.collect()
    gc.disable()
    try:
        shapes = AlphaShapes(cloud)
        ended = weakref.ref(shapes)
        shapes.signatures, shapes.points, shapes.weights, shapes.shape("auto:connected").volume
        shapes.persistence().representatives(), shapes.balls().to_bytes("per_atom", "csv")
        shapes.shape().manifold(), shapes.filtration().to_bytes("npz")
        del shapes
        assert ended() is None
    finally:
        gc.enable()


def test_arrays_outlive_what_they_are_of(cloud):
    kept = []
    for _ in range(3):
        shapes = AlphaShapes(cloud, radii=0.1)
        balls = shapes.balls()
        kept.append(
            [
                shapes.spectrum, shapes.simplices(1).enters, shapes.points, shapes.hidden,
                shapes.shape().triangles, balls.areas, balls.derivatives.volume_by_centre,
                shapes.filtration().vertices, shapes.signatures["volume"],
            ]  # fmt: skip
        )
        del shapes, balls
        gc.collect()
    for _ in range(5):  # what was freed would be written over
        AlphaShapes(np.random.default_rng(6).random((300, 3)))
    for arrays in kept[1:]:
        for ours, first in zip(arrays, kept[0], strict=True):
            assert np.array_equal(ours, first)


def test_views_cost_nothing_and_cannot_be_written(cloud):
    shapes = AlphaShapes(cloud)
    spectrum = shapes.spectrum
    assert np.shares_memory(spectrum, shapes.spectrum)
    assert np.shares_memory(shapes.simplices(2).enters, shapes.simplices(2).enters)
    shape = shapes.shape()
    arrays = [
        spectrum, shapes.points, shapes.simplices(1).vertices, shape.triangles, shape.edges,
        shapes.signatures["betti"], shapes.filtration().alpha2, shapes.balls().areas,
    ]  # fmt: skip
    for array in arrays:
        assert array.flags.c_contiguous
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0


def test_the_callers_array_may_change_afterwards(cloud):
    points = cloud.copy()
    shapes = AlphaShapes(points)
    volume = shapes.shape().volume
    points[:] = 0
    assert np.array_equal(shapes.points, cloud) and shapes.shape().volume == volume


def test_two_threads_build_at_once_and_others_run_meanwhile():
    points = np.random.default_rng(9).random((40000, 3))
    expected = AlphaShapes(points[:20000]).spectrum, AlphaShapes(points[20000:]).spectrum
    results, ticks, done = [None, None], 0, threading.Event()

    def build(i):
        results[i] = AlphaShapes(points[20000 * i : 20000 * (i + 1)]).spectrum

    def wait():
        for worker in workers:
            worker.join()
        done.set()

    workers = [threading.Thread(target=build, args=(i,)) for i in range(2)]
    for worker in workers:
        worker.start()
    threading.Thread(target=wait).start()
    while not done.wait(0.001):
        ticks += 1
    assert all(np.array_equal(a, b) for a, b in zip(results, expected, strict=True))
    # With the lock held, this thread would have run before and after the work only.
    assert ticks > 20


def test_many_threads_read_one_object(cloud):
    shapes = AlphaShapes(cloud)
    results = []
    workers = [
        threading.Thread(target=lambda: results.append(shapes.signatures["volume"].sum()))
        for _ in range(4)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(set(results)) == 1
