# SPDX-License-Identifier: MIT
"""Names of other programs, with what they mean there."""

import numpy as np
import pytest

from orthoball import AlphaShapes, InputError
from orthoball.compat import alphashape as ours
from orthoball.compat import gudhi as ours_gudhi
from orthoball.compat.matlab import alphaShape

pytestmark = pytest.mark.partner

SPACE = np.random.default_rng(31).random((120, 3))
PLANE = np.random.default_rng(32).random((300, 2))


def test_the_tree_is_one_of_gudhi_with_its_values():
    gudhi = pytest.importorskip("gudhi")
    tree = ours_gudhi.AlphaComplex(points=SPACE).create_simplex_tree()
    theirs = gudhi.AlphaComplex(points=SPACE, precision="exact").create_simplex_tree()
    assert isinstance(tree, gudhi.SimplexTree)
    assert (tree.num_vertices(), tree.num_simplices()) == (120, theirs.num_simplices())
    for simplex, value in theirs.get_filtration():
        assert tree.filtration(simplex) == pytest.approx(value, rel=1e-9, abs=1e-15)
    tree.compute_persistence(homology_coeff_field=2)
    assert tree.persistent_betti_numbers(0.001, 0.001) == list(AlphaShapes(SPACE).betti(0.001))


def test_the_relative_precision_is_kept_and_without_effect():
    complex_class = ours_gudhi.AlphaComplex
    assert complex_class.get_float_relative_precision() == 1e-5
    complex_class.set_float_relative_precision(0.5)
    assert complex_class.get_float_relative_precision() == 0.5
    complex_class.set_float_relative_precision(1e-5)
    for wrong in (0, 1, -1, float("nan")):
        with pytest.raises(ValueError, match="between 0 and 1"):
            complex_class.set_float_relative_precision(wrong)


def test_the_options_of_the_tree():
    pytest.importorskip("gudhi")
    complex_ = ours_gudhi.AlphaComplex(PLANE, precision="exact")
    whole = complex_.create_simplex_tree()
    some = complex_.create_simplex_tree(max_alpha_square=0.001)
    assert 300 < some.num_simplices() < whole.num_simplices()
    roots = complex_.create_simplex_tree(output_squared_values=False)
    for simplex, value in whole.get_filtration():
        assert roots.filtration(simplex) == np.sqrt(value)
    without = complex_.create_simplex_tree(default_filtration_value=True)
    assert np.isnan(without.filtration([0]))
    assert complex_.get_point(7) == PLANE[7].tolist()
    assert complex_.shapes.site_count == 300
    assert ours_gudhi.AlphaComplex().create_simplex_tree().num_simplices() == 0
    weighted = ours_gudhi.AlphaComplex(PLANE, weights=np.full(300, 0.5)).create_simplex_tree()
    assert weighted.filtration([0]) == -0.5
    with pytest.raises(ValueError, match="precision"):
        ours_gudhi.AlphaComplex(PLANE, precision="approximate")


def kept_by_alphashape(points, alpha):
    """The simplices whose radius is below 1/alpha. What alphashape makes of them has its holes
    filled, and in space edges and faces that occur in two orders are taken for boundary."""
    alphashape = pytest.importorskip("alphashape")
    return [s.tolist() for s, radius in alphashape.alphasimplices(points) if radius < 1 / alpha]


@pytest.mark.parametrize("alpha", [3.0, 9.0, 20.0, 40.0])
def test_alphashape_keeps_the_same_triangles(alpha):
    shapely = pytest.importorskip("shapely")
    kept = [shapely.Polygon(PLANE[s]) for s in kept_by_alphashape(PLANE, alpha)]
    expected = shapely.union_all(kept)
    assert ours.alphashape(PLANE, alpha).symmetric_difference(expected).area < 1e-12
    alphashape = pytest.importorskip("alphashape")
    assert expected.difference(alphashape.alphashape(PLANE, alpha)).area < 1e-12


def test_alphashape_keeps_the_same_tetrahedra():
    kept = SPACE[kept_by_alphashape(SPACE, 2.0)]
    volumes = np.abs(np.linalg.det(kept[:, 1:] - kept[:, :1])) / 6
    mesh = ours.alphashape(SPACE, 2.0)
    assert mesh.is_watertight and mesh.volume == pytest.approx(volumes.sum())


def test_a_function_is_no_alpha():
    with pytest.raises(TypeError, match="one number"):
        ours.alphashape([[0, 0], [1, 0], [0, 1]], lambda indices, radius: 1.0)


def test_zero_stands_for_the_convex_hull():
    spatial = pytest.importorskip("scipy.spatial")
    assert ours.alphashape(SPACE, 0).volume == pytest.approx(spatial.ConvexHull(SPACE).volume)
    assert ours.alphashape(PLANE, -1).area == pytest.approx(spatial.ConvexHull(PLANE).volume)


def test_optimizealpha_is_the_largest_that_keeps_all_points_in_one_polygon():
    shapely = pytest.importorskip("shapely")
    points = PLANE[:60]
    best = ours.optimizealpha(points)

    def is_one(alpha):
        region = shapely.union_all(
            [shapely.Polygon(points[s]) for s in kept_by_alphashape(points, alpha)]
        )
        return region.geom_type == "Polygon" and region.intersects(shapely.points(points)).all()

    assert is_one(best * (1 - 1e-9)) and not is_one(best * (1 + 1e-9))
    region = ours.alphashape(points)
    assert region.geom_type == "Polygon" and region.equals(ours.alphashape(points, best))
    assert AlphaShapes(points).shape(inverse_alpha=best).vertices.shape == (0,)
    assert ours.optimizealpha(points, upper=1.0) == 1.0
    assert ours.optimizealpha(points, lower=1e9) == 0.0
    assert ours.optimizealpha([[0, 0], [1, 1]]) == 0.0


def test_alphashape_takes_and_gives_objects_of_geopandas_and_shapely():
    geopandas, shapely = pytest.importorskip("geopandas"), pytest.importorskip("shapely")
    frame = geopandas.GeoDataFrame(geometry=[shapely.Point(*p) for p in PLANE], crs="EPSG:3857")
    result = ours.alphashape(frame, 9.0)
    assert isinstance(result, geopandas.GeoDataFrame) and result.crs == frame.crs
    expected = ours.alphashape(PLANE, 9.0)
    assert result.geometry[0].equals(expected)
    assert ours.alphashape(shapely.MultiPoint(PLANE), 9.0).equals(expected)
    assert ours.alphashape(PLANE, 1e9).is_empty


def test_the_alpha_shape_of_a_block_is_known():
    grid = np.array([[x, y, z] for x in range(3) for y in range(3) for z in range(3)], dtype=float)
    block = alphaShape(grid)
    assert block.Alpha == block.criticalAlpha("all-points") == pytest.approx(3**0.5 / 2)
    assert block.alphaSpectrum().tolist() == [block.Alpha]
    assert (block.volume(), block.surfaceArea()) == pytest.approx((8, 24))
    assert (block.volume(0), block.surfaceArea(0)) == pytest.approx((8, 24))
    assert block.numRegions() == 1 and np.array_equal(block.Points, grid)
    assert len(block.boundaryFacets()) == 48
    assert (
        len(block.alphaTriangulation())
        == len(block.alphaTriangulation(0))
        == len(block.shape.cells)
    )
    assert block.inShape([[1, 1, 1], [0, 0, 0], [2.5, 1, 1]]).tolist() == [True, True, False]
    x, y = np.meshgrid([-1, 0.5], [0.5, 1.5, 9])
    assert block.inShape(x, y, 1.0).tolist() == [[False, True], [False, True], [False, False]]
    assert block.shapes.site_count == 27
    with pytest.raises(ValueError, match="there is surfaceArea"):
        block.perimeter()
    with pytest.raises(ValueError, match="there is volume"):
        block.area()
    with pytest.raises(ValueError, match="there is no region 1; they are 0 to 0"):
        block.volume(1)
    with pytest.raises(ValueError, match="a radius is 0 or more"):
        block.Alpha = -1
    with pytest.raises(ValueError, match="the type is 'all'"):
        block.criticalAlpha("all")


def discs():
    """The points of MATLAB's documentation of numRegions: two discs of five rings."""
    angle = np.arange(24) * (2 * np.pi / 24)
    rings = [r * np.column_stack([np.cos(angle), np.sin(angle)]) for r in range(1, 6)]
    disc = np.vstack([[[0, 0]], *rings])
    return np.vstack([disc, disc + [15, 0]])


def test_regions_of_the_documentation_of_matlab():
    shape = alphaShape(discs(), 2.5)
    assert shape.numRegions() == 2
    assert round(shape.perimeter(), 4) == 62.6526
    assert shape.perimeter(0) == pytest.approx(240 * np.sin(np.pi / 24))
    assert round(shape.alphaSpectrum()[0], 4) == 52.5066
    one = alphaShape(
        [(-1.5, 3.2), (1.8, 3.3), (-3.7, 1.5), (-1.5, 1.3), (0.8, 1.2), (3.3, 1.5), (-4, -1),
         (-2.3, -0.7), (0, -0.5), (2, -1.5), (3.7, -0.8), (-3.5, -2.9), (-0.9, -3.9), (2, -3.5),
         (3.5, -2.25)]
    )  # fmt: skip
    assert round(one.Alpha, 8) == 1.76179149 == round(one.criticalAlpha("one-region"), 8)
    assert round(one.area(), 4) == 34.3025
    hull = alphaShape(one.Points, np.inf)
    assert (round(hull.area(), 4), len(hull.alphaTriangulation())) == (44.8725, 18)


def test_thresholds_fill_holes_and_suppress_regions():
    points = [p for p in discs().tolist() if p[0] > 10 or np.hypot(*p) > 1.5]
    shape = alphaShape(points, 1.4)
    full, ring = 24 / 2 * 25 * np.sin(np.pi / 12), shape.area(1)
    hole = full - ring
    assert shape.numRegions() == 2 and hole == pytest.approx(12 * 4 * np.sin(np.pi / 12))
    assert len(shape.boundaryFacets()) == 72 and len(shape.boundaryFacets(0)) == 24
    assert shape.inShape([[0, 0]]).tolist() == [False]
    assert shape.inShape([[3, 0], [15, 0]], region=0).tolist() == [False, True]
    shape.RegionThreshold = ring * (1 + 1e-9)
    assert shape.numRegions() == 1 and shape.area() == pytest.approx(full)
    shape.HoleThreshold = hole * (1 + 1e-9)  # holes come first: the ring is as large as the disc
    assert shape.numRegions() == 2 and shape.area() == pytest.approx(2 * full)
    assert shape.inShape([[0, 0]]).all() and len(shape.boundaryFacets()) == 48
    same = alphaShape(points, 1.4, HoleThreshold=20.0, RegionThreshold=full * 1.001)
    assert (same.HoleThreshold, same.RegionThreshold) == (20.0, full * 1.001)
    assert same.numRegions() == 0 and same.area() == 0


def test_the_radius_may_be_given_and_given_anew():
    shape = alphaShape(PLANE[:, 0], PLANE[:, 1], 0.02)
    assert shape.Alpha == 0.02
    many = shape.numRegions()
    areas = [shape.area(region) for region in range(many)]
    assert many > 1 and areas == sorted(areas, reverse=True)
    assert sum(areas) == pytest.approx(shape.area())
    assert sum(map(shape.perimeter, range(many))) == pytest.approx(shape.perimeter())
    shape.Alpha = shape.criticalAlpha("one-region")
    assert shape.numRegions() == 1
    assert len(np.unique(shape.alphaTriangulation())) == len(PLANE)
    hull = alphaShape(PLANE, alpha=np.inf)
    spatial = pytest.importorskip("scipy.spatial")
    assert hull.area() == pytest.approx(spatial.ConvexHull(PLANE).volume)
    assert {frozenset(e) for e in hull.boundaryFacets().tolist()} == {
        frozenset(e) for e in spatial.ConvexHull(PLANE).simplices.tolist()
    }
    spectrum = hull.alphaSpectrum()
    assert (np.diff(spectrum) < 0).all()
    hull.Alpha = spectrum[0]
    assert hull.area() == pytest.approx(spatial.ConvexHull(PLANE).volume)
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    assert len(hull.plot().patches) == 1
    with pytest.raises(ValueError, match="there is area"):
        hull.volume()
    with pytest.raises(ValueError, match="there is perimeter"):
        hull.surfaceArea()


def test_matlabs_points_are_checked():
    with pytest.raises(InputError, match="needs points"):
        alphaShape()
    with pytest.raises(InputError, match="the columns have 3, 2 numbers"):
        alphaShape([0, 1, 2], [0, 1])
    with pytest.raises(InputError, match="needs points"):
        alphaShape(np.random.default_rng(1).random((9, 2))).inShape()
