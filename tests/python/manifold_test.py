# SPDX-License-Identifier: MIT
"""The nearest solid with a closed manifold as its boundary."""

import json
from collections import Counter

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, InputError, Shape, Solid, SolidChange


def is_closed(shape):
    """Whether every edge of the boundary is in two triangles, in the plane every vertex in two edges."""
    facets = shape.triangles if shape.shapes.dimension == 3 else shape.edges
    corners = range(facets.shape[1])
    ridges = Counter(
        tuple(sorted(np.delete(facet, leave_out).tolist()))
        for facet in facets
        for leave_out in corners
    )
    return all(count == 2 for count in ridges.values())


@pytest.mark.parametrize("name", ["cloud", "plane"])
def test_the_solid_is_closed_and_says_what_was_changed(name, request):
    shapes = AlphaShapes(request.getfixturevalue(name))
    shape = next(
        shape
        for index in range(len(shapes.spectrum) // 2, len(shapes.spectrum))
        for shape in [shapes.shape(index=index, regularized=True)]
        if len(shape.cells) > 20 and not is_closed(shape)
    )
    closed = shape.manifold()
    assert isinstance(closed, Shape) and is_closed(closed)
    assert shape.solid is None and "closed manifold near the solid part" in repr(closed)
    solid = closed.solid
    assert isinstance(solid, Solid) and len(solid.offending) > 0
    assert solid.offending_edges >= 0 and solid.surface_count > 0
    assert (closed.index, closed.alpha2, closed.shapes) == (shape.index, shape.alpha2, shapes)
    assert closed.volume == pytest.approx(shape.volume + solid.added - solid.removed)
    before, after = (set(map(frozenset, one.cells.tolist())) for one in (shape, closed))
    assert isinstance(solid.changes[0], SolidChange)
    assert sum(c.cell_count for c in solid.changes if c.is_added) == len(after - before)
    assert sum(c.cell_count for c in solid.changes if not c.is_added) == len(before - after)
    added = sum(change.volume for change in solid.changes if change.is_added)
    assert added == pytest.approx(solid.added)
    for change in solid.changes:
        np.testing.assert_allclose(change.centre, shapes.points[change.rows].mean(axis=0))


def test_all_that_shapes_do_works_on_it(cloud):
    shapes = AlphaShapes(cloud)
    closed = shapes.shape().manifold()
    inside = shapes.points[closed.cells].mean(axis=1)
    assert closed.contains(inside).all() and not closed.contains([[9, 9, 9]]).any()
    assert (closed.locate(inside).regions > 0).all()
    assert closed.nearest([[9, 9, 9]]).distances[0] > 0
    assert sum(region.volume for region in closed.regions()) == pytest.approx(closed.volume)
    assert len(closed.edges) == len(closed.vertices) == 0 and closed.regularized
    assert closed.betti[2] == closed.solid.surface_count - closed.betti[0]
    assert closed.to_bytes("stl") and closed.manifold().solid.changes == ()


@pytest.mark.partner
def test_trimesh_finds_it_watertight(samples):
    pytest.importorskip("trimesh")
    shapes = AlphaShapes(orthoball.read(samples / "linked_tori.csv").points)
    closed = shapes.shape("auto:signature").manifold()
    mesh = closed.to_trimesh()
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(closed.volume) and mesh.area == pytest.approx(closed.area)
    assert mesh.euler_number == closed.solid.euler


def test_what_is_dropped_is_listed(tmp_path):
    # A triangle that is filled, and an edge that is not.
    shapes = AlphaShapes([[0, 0], [2, 0], [1, 1.5], [6, 0], [8, 0]])
    closed = shapes.shape(alpha2=1.5).manifold()
    assert closed.solid.dropped == (0, 1) and closed.solid.changes == ()
    rows = json.loads(closed.solid.to_bytes("json"))
    assert [(row["change"], row["rows"]) for row in rows] == [("dropped", [3, 4])]
    closed.solid.write(tmp_path / "changes.csv")
    assert (
        (tmp_path / "changes.csv").read_text().startswith("change,cells,volume,x,y,rows\ndropped,")
    )
    with pytest.raises(InputError, match='"xlsx" is no format'):
        closed.solid.write(tmp_path / "changes.xlsx")


def test_shapes_without_cells_have_an_empty_solid():
    for points in (np.zeros((0, 3)), [[0, 0, 0]], [[0, 0, 0], [1, 0, 0]], np.eye(3)):
        shapes = AlphaShapes(points)
        closed = shapes.shape(index=len(shapes.spectrum)).manifold()
        assert (closed.volume, closed.area, closed.solid.surface_count) == (0, 0, 0)
        assert closed.betti == (0, 0, 0) and len(closed.triangles) == 0


def test_solids_outlive_what_they_are_of(cloud):
    solid = AlphaShapes(cloud).shape().manifold().solid
    assert solid.to_bytes("csv").startswith(b"change,")
    closed = AlphaShapes(cloud).shape().manifold()
    assert closed.volume > 0 and is_closed(closed)
