# SPDX-License-Identifier: MIT
"""Unions of balls."""

import math

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, InputError


def test_two_balls_have_closed_forms():
    shapes = AlphaShapes([[0, 0, 0], [1, 0, 0]], radii=1)
    balls = shapes.balls()
    assert balls.volume == pytest.approx(2 * (4 / 3 * math.pi) - 5 / 12 * math.pi)
    assert balls.area == pytest.approx(6 * math.pi)
    assert balls.volumes.sum() == pytest.approx(balls.volume)
    assert balls.areas.tolist() == pytest.approx([3 * math.pi, 3 * math.pi])
    assert (balls.betti, balls.euler, balls.index) == ((1, 0, 0), 1, 2)
    assert (balls.alpha2, balls.probe) == (0, 0) and balls.shapes is shapes
    contacts = balls.contacts
    assert contacts.rows.tolist() == [[0, 1]]
    assert contacts.area.tolist() == pytest.approx([0.75 * math.pi])
    assert contacts.exposed_length.tolist() == pytest.approx([2 * math.pi * math.sqrt(0.75)])
    assert "2 balls at alpha2 0.0, probe 0.0" in repr(balls)
    # Both spheres less a cap, and the arc where they meet: -length x angle / 2.
    arc = -math.pi * math.sqrt(3) * (math.pi / 3) / 2
    assert balls.mean_curvature == pytest.approx(6 * math.pi + arc)


def test_alpha2_and_probe_grow_balls_in_their_own_ways():
    shapes = AlphaShapes([[0.0, 0, 0]], radii=1)
    assert shapes.balls(3).volume == pytest.approx(4 / 3 * math.pi * 8)
    assert shapes.balls(0, 1.5).volume == pytest.approx(4 / 3 * math.pi * 2.5**3)
    assert shapes.balls(-2).volume == 0
    assert AlphaShapes([[0.0, 0, 0]]).balls(probe=1).area == pytest.approx(4 * math.pi)
    with pytest.raises(InputError, match="probe is -1"):
        shapes.balls(probe=-1)
    with pytest.raises(InputError, match="probe is inf"):
        shapes.balls(probe=math.inf)
    with pytest.raises(InputError, match="row 1: ") as error:
        AlphaShapes([[0, 0], [5, 5]], [1, -1]).balls(probe=1)
    assert (error.value.row, error.value.reason) == (1, "imaginary_ball")
    with pytest.raises(InputError):
        shapes.balls(math.nan)


def test_in_the_plane_volume_is_area_and_area_perimeter():
    balls = AlphaShapes([[0, 0], [5, 0]], radii=[1, 2]).balls()
    assert balls.volume == pytest.approx(5 * math.pi)
    assert balls.area == pytest.approx(6 * math.pi)
    assert balls.mean_curvature is None
    with pytest.raises(InputError, match="in the plane"):
        balls.molecular_surface


def test_derivatives_are_those_of_differences(cloud):
    points = cloud[:40]
    radii = np.full(40, 0.15)
    derivatives = AlphaShapes(points, radii=radii).balls().derivatives
    step = 1e-6

    def difference(change_points, change_radii, measure):
        def value(sign):
            moved = AlphaShapes(points + sign * change_points, radii=radii + sign * change_radii)
            return getattr(moved.balls(), measure)

        return (value(step) - value(-step)) / (2 * step)

    assert derivatives.volume_by_centre.shape == derivatives.area_by_centre.shape == (40, 3)
    for row in (0, 11):
        radius = np.eye(40)[row]
        assert difference(0, radius, "area") == pytest.approx(
            derivatives.area_by_radius[row], abs=1e-5
        )
        centre = np.zeros((40, 3))
        centre[row, 1] = 1
        by_volume, by_area = difference(centre, 0, "volume"), difference(centre, 0, "area")
        assert by_volume == pytest.approx(derivatives.volume_by_centre[row, 1], abs=1e-5)
        assert by_area == pytest.approx(derivatives.area_by_centre[row, 1], abs=1e-5)


def test_a_cage_has_a_void(samples):
    shapes = AlphaShapes(orthoball.read(samples / "c60.xyz"))
    balls = shapes.balls()
    (inside,) = balls.voids
    assert balls.betti == (1, 0, 1)
    assert len(inside.rows) == len(inside.areas) == 60
    assert inside.areas.sum() == pytest.approx(inside.area)
    assert 0 < inside.volume and inside.born <= balls.index < inside.dies
    assert inside.born_alpha2 == shapes.spectrum[inside.born - 1]
    assert inside.dies_alpha2 == shapes.spectrum[inside.dies - 1]
    centre = shapes.points.mean(axis=0)
    assert np.linalg.norm(inside.largest_ball_centre - centre) < 1e-2
    assert 1 < inside.largest_ball_radius < 3
    assert inside.cells.shape[1] == 4
    (as_pocket,) = balls.pockets
    assert as_pocket.mouths == () and as_pocket.depth is None
    assert as_pocket.volume == pytest.approx(inside.volume)
    assert np.array_equal(as_pocket.rows, inside.rows) and len(as_pocket.cells) == len(inside.cells)


def test_pockets_have_mouths(samples):
    shapes = AlphaShapes(orthoball.read(samples / "bdna_dodecamer.pdb"))
    pockets = shapes.balls(probe=1.4).pockets
    with_mouths = [pocket for pocket in pockets if pocket.mouths]
    assert with_mouths
    for pocket in with_mouths:
        assert pocket.depth > 0
        assert len(pocket.areas) == len(pocket.rows)
        for mouth in pocket.mouths:
            assert mouth.facets.shape[1] == 3
            assert set(mouth.rim) <= set(mouth.facets.ravel()) and mouth.area >= 0


def test_the_molecular_surface_of_one_ball_is_its_sphere():
    surface = AlphaShapes([[0.0, 0, 0]], radii=2).balls(probe=1.4).molecular_surface
    assert surface.volume == pytest.approx(4 / 3 * math.pi * 8)
    assert surface.area == pytest.approx(surface.convex_area) == pytest.approx(16 * math.pi)
    assert (surface.toroidal_area, surface.concave_area) == (0, 0) and surface.probe == 1.4


def test_hidden_balls_have_no_part():
    balls = AlphaShapes([[0, 0, 0], [0.1, 0, 0], [0, 0, 0]], radii=[2, 0.5, 2]).balls()
    assert balls.volumes[1] == balls.volumes[2] == balls.areas[1] == 0
    assert balls.volumes[0] == pytest.approx(balls.volume)
