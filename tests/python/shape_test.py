# SPDX-License-Identifier: MIT
"""One shape: what it is made of, its measures, its forms in other packages."""

import gc
import json

import numpy as np
import pytest

import orthoball
from orthoball import NONE, AlphaShapes, InputError, Role


def signed_volume(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


@pytest.fixture
def ring():
    """Points of a grid around an eight-cornered hole, a pair of points and one more beside it."""
    grid = [(x, y) for x in range(6) for y in range(6) if not (1 < x < 4 and 1 < y < 4)]
    return np.array([*grid, (10, 0), (11, 0), (20, 20)], dtype=float)


def test_the_form_of_alpha_does_not_matter(cloud):
    shapes = AlphaShapes(cloud)
    forms = [{"alpha2": 0.04}, {"alpha": 0.2}, {"inverse_alpha": 5}]
    indices = {shapes.shape(**form).index for form in forms}
    assert len(indices) == 1
    shape = shapes.shape(0.04)
    assert (shape.alpha2, shape.alpha, shape.index) == (0.04, 0.2, indices.pop())
    by_index = shapes.shape(index=shape.index)
    assert by_index.alpha2 == shapes.spectrum[shape.index - 1]
    assert np.array_equal(by_index.triangles, shape.triangles)
    assert shapes.shape(index=0).alpha2 == -np.inf
    assert shapes.shape(alpha=-0.5).alpha2 == -0.25 and shapes.shape(alpha=-0.5).alpha == -0.5
    assert shape.shapes is shapes
    with pytest.raises(InputError, match="one of alpha2, alpha, inverse_alpha and index"):
        shapes.shape(1, alpha=1)
    with pytest.raises(InputError, match="indices are 0 to"):
        shapes.shape(index=10**6)
    with pytest.raises(InputError, match="must not be 0"):
        shapes.shape(inverse_alpha=0)
    with pytest.raises(InputError, match="NaN"):
        shapes.shape(alpha=np.nan)


def test_without_alpha_the_automatic_one_is_taken(cloud):
    shapes = AlphaShapes(cloud)
    assert shapes.shape().index == shapes.automatic_alpha().index


def test_the_boundary_encloses_the_volume(cloud):
    shapes = AlphaShapes(cloud)
    shape = shapes.shape()
    regular = shape.triangles[shape.triangle_roles == Role.regular]
    assert len(shape.triangles) == len(shape.triangle_roles)
    assert signed_volume(shapes.points, regular) == pytest.approx(shape.volume)
    corners = shapes.points[shape.cells]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    assert (volumes > 0).all() and volumes.sum() == pytest.approx(shape.volume)
    assert shape.betti == shapes.betti(index=shape.index)
    assert shape.signature["volume"][0] == shape.volume
    a, b, c = shapes.points[shape.triangles].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    sides = np.where(shape.triangle_roles == Role.singular, 2, 1)
    assert areas @ sides == pytest.approx(shape.area)


def test_singular_simplices_are_left_out_of_a_regularized_shape(cloud):
    shapes = AlphaShapes(cloud)
    whole = shapes.shape(alpha=0.09)
    solid = shapes.shape(alpha=0.09, regularized=True)
    assert not whole.regularized and solid.regularized
    assert (whole.triangle_roles == Role.singular).any()
    assert len(whole.edges) == len(whole.edge_roles) > 0 and len(whole.vertices) > 0
    assert set(whole.edge_roles) == {Role.singular}
    assert (solid.triangle_roles == Role.regular).all()
    assert len(solid.edges) == len(solid.vertices) == 0
    assert solid.area < whole.area and solid.volume == whole.volume
    used = {*whole.triangles.ravel(), *whole.edges.ravel(), *whole.vertices}
    assert set(whole.rows) == used
    assert "solid part of the shape at index" in repr(solid)


def test_a_plane_shape_has_holes_edges_and_points(ring):
    shapes = AlphaShapes(ring)
    shape = shapes.shape(alpha=0.8)
    assert shape.betti == (3, 1)
    assert shape.volume == pytest.approx(18)
    assert shape.area == pytest.approx(20 + (4 + 4 * 2**0.5) + 2)
    assert (
        np.array_equal(shape.triangles, shape.cells)
        and (shape.triangle_roles == Role.interior).all()
    )
    singular = shape.edges[shape.edge_roles == Role.singular]
    assert singular.tolist() == [[len(ring) - 3, len(ring) - 2]]
    assert shape.vertices.tolist() == [len(ring) - 1]
    a, b = ring[shape.edges[shape.edge_roles == Role.regular]].transpose(1, 0, 2)
    assert (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2 == pytest.approx(shape.volume)


def test_regions_are_sorted_by_size(ring):
    shapes = AlphaShapes(ring)
    shape = shapes.shape(alpha=0.8)
    large, pair, alone = shape.regions()
    assert (large.volume, large.area) == pytest.approx((18, 24 + 4 * 2**0.5))
    assert len(large.rows) == len(ring) - 3 and len(large.cells) == len(shape.cells)
    assert pair.rows.tolist() == [len(ring) - 3, len(ring) - 2] and pair.area == 2
    assert alone.rows.tolist() == [len(ring) - 1] and alone.cells.shape == (0, 3)
    (solid,) = shape.regions("facets")
    assert solid.volume == large.volume == shape.regions("cells")[0].volume
    assert len(shapes.shape(alpha=0.8, regularized=True).regions()) == 1
    assert shapes.shape(index=0).regions() == ()
    with pytest.raises(InputError, match='joined by "edges"'):
        shape.regions("edges")


def test_holes_are_filled_and_regions_left_out(ring):
    shapes = AlphaShapes(ring)
    whole = shapes.shape(alpha=0.8)
    assert [region.betti for region in whole.regions()] == [(1, 1), (1, 0), (1, 0)]
    (hole,) = whole.holes()
    assert hole.area == pytest.approx(4 + 4 * 2**0.5) and len(hole.rows) == 8
    assert hole.volume == pytest.approx(7)
    filled = shapes.shape(alpha=0.8, hole_threshold=hole.volume)
    assert filled.edits == (1, hole.volume, 0, 0.0) and filled.holes() == ()
    assert (filled.edits.holes_filled, filled.edits.volume_filled) == (1, hole.volume)
    assert filled.volume == pytest.approx(25) and filled.betti == (3, 0)
    assert filled.contains([[2.5, 2.5]]).all() and not whole.contains([[2.5, 2.5]]).any()
    assert len(filled.cells) == len(whole.cells) + len(hole.cells)
    large = shapes.shape(alpha=0.8, region_threshold=1)
    assert large.edits.regions_dropped == 2 and large.edits.volume_dropped == 0
    assert large.betti == (1, 1) and len(large.vertices) == 0
    pair = shapes.shape(alpha=0.8, region=2)
    assert pair.rows.tolist() == whole.regions()[1].rows.tolist()
    assert (pair.volume, pair.area, pair.betti) == (0, 2, (1, 0))
    assert "parts of the shape at index" in repr(pair)
    assert pair.signature["volume"][0] == whole.volume
    for options, message in [
        ({"region": 4}, "there is no region 4; there are 3 regions"),
        ({"region": 0}, "there is no region 0"),
        ({"region_threshold": -1}, "it must be 0 or more"),
        ({"hole_threshold": np.nan}, "it must be 0 or more"),
    ]:
        with pytest.raises(InputError, match=message):
            shapes.shape(alpha=0.8, **options)


def test_parts_outlive_the_names_of_their_family(ring):
    shape = AlphaShapes(ring).shape(alpha=0.8, region=1)
    del ring
    gc.collect()
    assert len(shape.to_bytes("ply")) > 0 and len(shape.regions()) == 1


def test_located_points_have_regions_simplices_and_distances(ring):
    shape = AlphaShapes(ring).shape(alpha=0.8)
    points = [[0.5, 0.5], [10.5, 0], [2.5, 2.5], [-5, 0]]
    found = shape.locate(points)
    assert found.regions.tolist() == [1, 2, 0, 0]
    assert ((found.simplices != NONE).sum(axis=1) > 0).tolist() == [True, True, True, False]
    assert (found.simplices[1][:2] == shape.regions()[1].rows).all()
    nearest = shape.nearest(points)
    for one, other in zip(found.nearest, nearest):
        assert np.array_equal(one, other)
    assert (found.regions > 0).tolist() == shape.contains(points).tolist()


def test_points_are_in_the_shape_or_not(ring):
    shapes = AlphaShapes(ring)
    shape = shapes.shape(alpha=0.8)
    assert shape.contains(ring).all()
    # Inside, on the boundary, in the hole, on the edge, beside it, far away.
    points = [[0.5, 0.5], [0, 2.5], [2.5, 2.5], [10.5, 0], [10.5, 1e-300], [-5, 0]]
    assert shape.contains(points).tolist() == [True, True, False, True, False, False]
    enters = shapes.enters_at(points)
    assert enters[-1] == len(shapes.spectrum) + 1
    assert not shapes.shape(index=enters[2] - 1).contains(points)[2]
    assert shapes.shape(index=enters[2]).contains(points)[2]
    with pytest.raises(InputError, match="they must have 2, as the sites do"):
        shape.contains([[0, 0, 0]])
    with pytest.raises(InputError, match="row 1: "):
        shape.contains([[0, 0], [np.nan, 0]])


def test_the_nearest_point_of_the_boundary(ring):
    shapes = AlphaShapes(ring)
    points, distances, simplices = shapes.shape(alpha=0.8).nearest([[-3, 2], [10.5, 2], [20, 25]])
    assert points.tolist() == [[0, 2], [10.5, 0], [20, 20]]
    assert distances.tolist() == [3, 2, 5]
    last = len(ring) - 1
    assert simplices[1:].tolist() == [[last - 2, last - 1], [last, orthoball.NONE]]
    solid = shapes.shape(alpha=0.8, regularized=True).nearest([[20, 25]])
    assert solid.points.tolist() == [[5, 5]]
    nothing = shapes.shape(index=0).nearest([[1, 1]])
    assert np.isinf(nothing.distances).all() and (nothing.simplices == orthoball.NONE).all()
    with pytest.raises(InputError, match="they must have 2"):
        shapes.shape().nearest([[0, 0, 0]])


@pytest.mark.partner
def test_trimesh_and_shapely_agree_about_distances(cloud, plane):
    trimesh, shapely = pytest.importorskip("trimesh"), pytest.importorskip("shapely")
    shape = AlphaShapes(cloud).shape()
    points = np.random.default_rng(3).random((60, 3)) * 1.4 - 0.2
    corners = cloud[shape.triangles]
    for point, nearest, distance in zip(points, *shape.nearest(points)[:2]):
        theirs = trimesh.triangles.closest_point(corners, np.broadcast_to(point, (len(corners), 3)))
        assert distance == pytest.approx(np.linalg.norm(theirs - point, axis=1).min())
        assert distance == pytest.approx(np.linalg.norm(nearest - point))
    shape = AlphaShapes(plane).shape()
    points = np.random.default_rng(4).random((60, 2)) * 1.4 - 0.2
    theirs = shapely.distance(shape.to_shapely().boundary, shapely.points(points))
    assert shape.nearest(points).distances == pytest.approx(theirs)


def test_a_decimal_is_in_the_shape_of_its_file(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y\n0.1,0.2\n0.3,0.7\n")
    shapes = AlphaShapes(orthoball.read(path))
    assert shapes.shape(index=2).contains([[0.1, 0.2], [0.2, 0.45], [0.2, 0.46]]).tolist() == [
        True, True, False,
    ]  # fmt: skip


@pytest.mark.partner
def test_shapely_agrees_about_what_is_inside(plane):
    shapely = pytest.importorskip("shapely")
    shape = AlphaShapes(plane).shape()
    points = np.random.default_rng(5).random((2000, 2))
    assert np.array_equal(
        shape.contains(points), shapely.intersects_xy(shape.to_shapely(), *points.T)
    )


@pytest.mark.partner
def test_scipy_agrees_about_cells_in_space(cloud):
    spatial = pytest.importorskip("scipy.spatial")
    shapes = AlphaShapes(cloud)
    points = np.random.default_rng(6).random((2000, 3))
    inside = spatial.Delaunay(cloud).find_simplex(points) >= 0
    assert np.array_equal(shapes.shape(index=len(shapes.spectrum)).contains(points), inside)
    shape = shapes.shape(alpha=0.12)
    kept = shape.cells[:, None]
    edges = np.moveaxis(cloud[kept][..., 1:, :] - cloud[kept][..., :1, :], -1, -2)
    weights = np.linalg.solve(edges, (points[None] - cloud[kept][..., 0, :])[..., None])[..., 0]
    in_cells = ((weights >= 0).all(axis=-1) & (weights.sum(axis=-1) <= 1)).any(axis=0)
    assert np.array_equal(shape.contains(points), in_cells)


def test_geojson_has_everything(ring):
    collection = AlphaShapes(ring).shape(alpha=0.8).to_geojson()
    kinds = [feature["geometry"]["type"] for feature in collection["features"]]
    assert kinds == ["MultiPolygon", "LineString", "Point"]
    (polygon,) = collection["features"][0]["geometry"]["coordinates"]
    assert len(polygon) == 2
    json.dumps(collection)


def test_files_are_those_of_the_program(cloud, ring, tmp_path):
    shape = AlphaShapes(cloud).shape()
    for ending in ("ply", "obj", "off", "stl", "vtu", "glb"):
        shape.write(tmp_path / f"shape.{ending}")
        assert (tmp_path / f"shape.{ending}").read_bytes() == shape.to_bytes(ending)
    assert shape.to_bytes("ply").startswith(b"ply\n")
    assert shape.to_bytes("ply", roles=True) != shape.to_bytes("ply")
    assert b"<svg" in AlphaShapes(ring).shape().to_bytes("svg")
    AlphaShapes(ring).shape().write(str(tmp_path / "map.json"))
    assert json.loads((tmp_path / "map.json").read_text())["type"] == "FeatureCollection"
    with pytest.raises(InputError, match='"xyz" is no format of shapes'):
        shape.write(tmp_path / "shape.xyz")
    with pytest.raises(InputError, match="polygons are for points in the plane"):
        shape.to_geojson()
    with pytest.raises(OSError):
        shape.write(tmp_path / "missing" / "shape.ply")
    assert not [path for path in tmp_path.iterdir() if path.suffix == ".part"]


@pytest.mark.partner
def test_shapely_agrees_about_area_and_holes(ring, plane):
    shapely = pytest.importorskip("shapely")
    shape = AlphaShapes(ring).shape(alpha=0.8)
    region = shape.to_shapely()
    assert isinstance(region, shapely.MultiPolygon) and region.is_valid
    assert region.area == pytest.approx(18) and len(region.geoms[0].interiors) == 1
    shapes = AlphaShapes(plane)
    for index in range(1, len(shapes.spectrum) + 1, 20):
        region = shapes.shape(index=index).to_shapely()
        assert region.is_valid
        assert region.area == pytest.approx(shapes.shape(index=index).volume)
    assert AlphaShapes(ring).shape(index=0).to_shapely().is_empty
    with pytest.raises(InputError, match="are in space"):
        AlphaShapes(np.eye(3)).shape().to_shapely()


@pytest.mark.partner
def test_trimesh_agrees_about_volume_and_area(cloud):
    pytest.importorskip("trimesh")
    shapes = AlphaShapes(cloud)
    shape = shapes.shape(index=len(shapes.spectrum))
    mesh = shape.to_trimesh()
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(shape.volume) and mesh.area == pytest.approx(shape.area)
    rows = mesh.vertex_attributes["row"]
    assert np.array_equal(mesh.vertices, cloud[rows])
    assert np.array_equal(rows[mesh.faces], shape.triangles)
    with pytest.raises(InputError, match="are in the plane"):
        AlphaShapes(cloud[:, :2]).shape().to_trimesh()


@pytest.mark.partner
def test_pyvista_and_meshio_have_all_simplices(cloud, tmp_path):
    pyvista, meshio = pytest.importorskip("pyvista"), pytest.importorskip("meshio")
    shapes = AlphaShapes(cloud)
    shape = shapes.shape(alpha=0.09)
    count = len(shape.vertices) + len(shape.edges) + len(shape.triangles)
    data = shape.to_pyvista()
    assert isinstance(data, pyvista.PolyData) and data.n_cells == count
    assert np.array_equal(data.points, cloud[data.point_data["row"]])
    assert (data.cell_data["role"] == Role.regular).sum() == (shape.triangle_roles == 2).sum()
    hull = shapes.shape(index=len(shapes.spectrum)).to_pyvista()
    assert hull.volume == pytest.approx(shapes.signatures["volume"][-1])
    mesh = shape.to_meshio()
    assert {block.type: len(block.data) for block in mesh.cells} == {
        "vertex": len(shape.vertices), "line": len(shape.edges), "triangle": len(shape.triangles),
    }  # fmt: skip
    mesh.write(tmp_path / "shape.vtu")
    assert np.array_equal(meshio.read(tmp_path / "shape.vtu").points, mesh.points)
    empty = shapes.shape(index=0)
    assert empty.to_pyvista().n_cells == 0 and empty.to_meshio().cells == []
