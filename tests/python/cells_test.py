# SPDX-License-Identifier: MIT
"""Power cells, outlines and figures."""

import math

import numpy as np
import pytest

from orthoball import NONE, AlphaShapes, InputError


def test_power_cells_fill_their_box(cloud):
    shapes = AlphaShapes(cloud, radii=0.05 + 0.1 * cloud[:, 0])
    cells = shapes.power_cells([[0, 0, 0], [1, 1, 1]], surfaces=True)
    assert sorted([*cells.rows, *shapes.hidden]) == list(range(len(cloud)))
    assert cells.volumes.sum() == pytest.approx(1)
    assert cells.exposed_area.sum() == pytest.approx(6)
    assert cells.are_clipped.any() and not cells.are_clipped.all()
    assert len(cells.surfaces) == len(cells.rows)
    for row, volume, count, (corners, facets) in zip(
        cells.rows, cells.volumes, cells.facet_counts, cells.surfaces
    ):
        neighbours = [neighbour for neighbour, _ in facets if neighbour != NONE]
        assert len(neighbours) == count and row not in neighbours
        # The divergence theorem: facets turn counterclockwise seen from outside.
        sixth = 0.0
        for _, loop in facets:
            a, b, c = corners[loop[0]], corners[loop[1:-1]], corners[loop[2:]]
            sixth += (np.cross(b, c) @ a).sum()
        assert sixth / 6 == pytest.approx(volume)
    assert shapes.power_cells().surfaces == ()
    assert shapes.power_cells().volumes.sum() > 1
    with pytest.raises(InputError):
        shapes.power_cells([[0, 0, 0], [1, 1, 0]])
    with pytest.raises(InputError, match="two corners"):
        shapes.power_cells([[0, 0], [1, 1]])


def test_scipy_agrees_about_voronoi_cells(plane):
    spatial = pytest.importorskip("scipy.spatial")
    voronoi = spatial.Voronoi(plane)
    cells = AlphaShapes(plane).power_cells([[-9, -9], [9, 9]])
    for row, area, clipped in zip(cells.rows, cells.volumes, cells.are_clipped):
        region = voronoi.regions[voronoi.point_region[row]]
        assert clipped or area == pytest.approx(spatial.ConvexHull(voronoi.vertices[region]).volume)
    assert (~cells.are_clipped).sum() > 100


def test_cells_in_balls_are_the_parts_of_the_union(cloud):
    balls = AlphaShapes(cloud, radii=0.1).balls()
    cells = balls.power_cells(surfaces=True, tolerance=0.01)
    assert cells.volumes.sum() == pytest.approx(balls.volume)
    assert cells.exposed_area.sum() == pytest.approx(balls.area)
    assert np.allclose(cells.volumes, balls.volumes[cells.rows])
    assert len(cells.surfaces) == len(cells.rows)
    for tolerance in (0, -1, 1, float("nan")):
        with pytest.raises(InputError, match="from 0.0001 to 0.5"):
            balls.power_cells(tolerance=tolerance)
        with pytest.raises(InputError, match="from 0.0001 to 0.5"):
            balls.to_bytes("cells", "vtu", tolerance=tolerance)


def test_the_outline_of_disks_has_their_area_and_perimeter():
    balls = AlphaShapes([[0, 0], [3, 0], [9, 0]], radii=[2, 2, 1]).balls()
    curves = balls.outline()
    assert sorted(len(curve.rows) for curve in curves) == [1, 2]
    perimeter = sum((curve.arcs[:, 2] * curve.arcs[:, 7]).sum() for curve in curves)
    assert perimeter == pytest.approx(balls.area)
    twice = 0.0
    for curve in curves:
        for x, y, radius, x0, y0, x1, y1, turn in curve.arcs:
            assert math.hypot(x0 - x, y0 - y) == pytest.approx(radius)
            twice += radius**2 * turn + x * (y1 - y0) - y * (x1 - x0)
        assert np.allclose(np.roll(curve.arcs[:, 3:5], -1, axis=0), curve.arcs[:, 5:7])
    assert twice / 2 == pytest.approx(balls.volume)
    with pytest.raises(InputError, match="in the plane"):
        AlphaShapes([[0, 0, 0]]).balls().outline()


def test_figures_have_the_panels_that_are_asked_for():
    balls = AlphaShapes([[0, 0], [3, 0], [9, 0]], radii=[2, 2, 1]).balls()
    whole, one = balls.figure(title="three <disks>"), balls.figure("complex", legend=False)
    assert whole.startswith(b"<svg") and b"three &lt;disks" in whole
    assert len(one) < len(whole) and balls.figure("complex", style="print", legend=False) != one
    with pytest.raises(InputError, match="no panel"):
        balls.figure("disk")
    with pytest.raises(InputError, match="the style"):
        balls.figure(style="grey")
    with pytest.raises(InputError, match="in the plane"):
        AlphaShapes([[0, 0, 0]]).balls().figure()
