# SPDX-License-Identifier: MIT
"""Agreement with other packages on common ground."""

import numpy as np
import pytest

from orthoball import AlphaShapes

pytestmark = pytest.mark.partner

SPACE = np.random.default_rng(21).random((300, 3))
PLANE = np.random.default_rng(22).random((400, 2))


def by_simplex(pairs):
    return {tuple(sorted(simplex)): value for simplex, value in pairs}


@pytest.mark.parametrize("points", [SPACE, PLANE], ids=["space", "plane"])
@pytest.mark.parametrize("precision", ["safe", "exact"])
def test_gudhi_has_the_same_filtration(points, precision):
    gudhi = pytest.importorskip("gudhi")
    theirs = gudhi.AlphaComplex(points=points, precision=precision).create_simplex_tree()
    ours = by_simplex(AlphaShapes(points).filtration())
    expected = by_simplex(theirs.get_filtration())
    assert ours.keys() == expected.keys()
    for simplex, alpha2 in ours.items():
        assert alpha2 == pytest.approx(expected[simplex], rel=1e-9, abs=1e-15)


def test_gudhi_has_the_same_weighted_filtration():
    gudhi = pytest.importorskip("gudhi")
    weights = np.random.default_rng(23).random(300) * 0.02
    shapes = AlphaShapes(SPACE, weights)
    complex_ = gudhi.AlphaComplex(points=SPACE, weights=weights, precision="exact")
    theirs = complex_.create_simplex_tree()  # gudhi's iterators do not keep it
    expected = by_simplex(theirs.get_filtration())
    ours = by_simplex(shapes.filtration())
    assert ours.keys() == expected.keys()
    assert len(shapes.hidden) > 0
    for simplex, alpha2 in ours.items():
        assert alpha2 == pytest.approx(expected[simplex], rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("points", [SPACE, PLANE], ids=["space", "plane"])
def test_gudhi_has_the_same_persistence(points):
    gudhi = pytest.importorskip("gudhi")
    tree = gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree()
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0)
    for diagram in AlphaShapes(points).persistence():
        expected = tree.persistence_intervals_in_dimension(diagram.dimension)
        ours = diagram.alpha2[diagram.alpha2[:, 0] < diagram.alpha2[:, 1]]
        order, other = np.lexsort(ours.T), np.lexsort(expected.T)
        np.testing.assert_allclose(ours[order], expected[other], rtol=1e-9)


@pytest.mark.parametrize("points", [SPACE, PLANE], ids=["space", "plane"])
def test_scipy_has_the_same_delaunay_cells_and_hull(points):
    spatial = pytest.importorskip("scipy.spatial")
    shapes = AlphaShapes(points)
    last = shapes.shape(index=len(shapes.spectrum))
    expected = {frozenset(cell) for cell in spatial.Delaunay(points).simplices.tolist()}
    assert {frozenset(cell) for cell in last.cells.tolist()} == expected
    hull = spatial.ConvexHull(points)
    assert last.volume == pytest.approx(hull.volume) and last.area == pytest.approx(hull.area)
    facets = last.triangles if points.shape[1] == 3 else last.edges
    assert {frozenset(f) for f in facets.tolist()} == {
        frozenset(f) for f in hull.simplices.tolist()
    }
