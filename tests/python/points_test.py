# SPDX-License-Identifier: MIT
"""What AlphaShapes takes, and how it refuses the rest."""

import types

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, InputError


def spectrum(*arguments, **options):
    return AlphaShapes(*arguments, **options).spectrum.tolist()


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int64, np.int32, np.uint8, np.uint64])
def test_numbers_that_doubles_hold_are_taken_as_they_are(cube, dtype):
    assert spectrum(cube.astype(dtype)) == spectrum(cube)


def test_lists_and_strided_arrays_are_taken(cube):
    assert spectrum(cube.tolist()) == spectrum(cube)
    assert spectrum(np.asfortranarray(cube)) == spectrum(cube)
    assert spectrum(np.repeat(cube, 2, axis=0)[::2]) == spectrum(cube)


def test_float32_is_widened_and_not_rounded_again():
    points = np.random.default_rng(1).random((20, 2), dtype=np.float32)
    assert spectrum(points) == spectrum(points.astype(np.float64))


def test_radii_are_squared_with_their_sign_and_weights_are_not(cube):
    radii = np.array([1, -1, 0.5, 0, 1, 1, 1, 1])
    assert spectrum(cube, radii=radii) == spectrum(cube, np.sign(radii) * radii**2)
    assert spectrum(cube, radii=1) == spectrum(cube, weights=1.0)
    assert AlphaShapes(cube, radii=radii).weights.tolist() == (np.sign(radii) * radii**2).tolist()
    assert AlphaShapes(cube).weights is None


@pytest.mark.parametrize(
    "points, message, row",
    [
        ([[0, 0], [1, np.nan]], "row 1: ", 1),
        ([[0, 0], [1, 1], [np.inf, 2]], "row 2: ", 2),
        ([[0, 0], [2**53 + 1, 1]], "row 1: points has an integer beyond 2\\^53", 1),
        ([[0, 0], [1, 1, 1]], "row 1: points has 3 numbers, row 0 has 2", 1),
        (np.zeros(3), r"shape \(3,\); it must be \(n, 2\) or \(n, 3\)", None),
        (np.zeros((4, 4)), r"shape \(4, 4\)", None),
        (np.zeros((2, 2), dtype=complex), "of type complex128", None),
        (np.zeros((2, 2), dtype=bool), "of type bool", None),
        (np.array([[0, 0], [1, "x"]], dtype=object), "row 1: points of type object", 1),
    ],
)
def test_wrong_points_are_refused_with_their_row(points, message, row):
    with pytest.raises(InputError, match=message) as error:
        AlphaShapes(points)
    assert error.value.row == row
    assert isinstance(error.value, ValueError)
    assert error.value.reason in ("not_finite", "wrong_size", "wrong_argument")


def test_wrong_weights_are_refused(cube):
    with pytest.raises(InputError, match="row 3: ") as error:
        AlphaShapes(cube, [0, 0, 0, np.nan, 0, 0, 0, 0])
    assert error.value.row == 3
    with pytest.raises(InputError, match=r"weights have the shape \(2,\); it must be \(8,\)"):
        AlphaShapes(cube, [1, 2])
    with pytest.raises(InputError, match="both given"):
        AlphaShapes(cube, 1, radii=1)
    with pytest.raises(InputError, match="no table"):
        AlphaShapes(cube, radii="bondi")


def test_no_points_and_few_points_are_right():
    empty = AlphaShapes(np.zeros((0, 3)))
    assert (empty.site_count, empty.affine_dimension, len(empty.spectrum)) == (0, -1, 0)
    assert empty.shape().triangles.shape == (0, 3)
    assert len(empty.filtration()) == 0
    assert empty.balls().volume == 0
    one = AlphaShapes([[1.0, 2.0, 3.0]])
    assert one.spectrum.tolist() == [0]
    assert one.affine_dimension == 0
    equal = AlphaShapes(np.ones((4, 2)))
    assert equal.duplicates.tolist() == [[1, 0], [2, 0], [3, 0]]
    flat = AlphaShapes([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
    assert (flat.affine_dimension, flat.dimension) == (2, 3)
    assert flat.shape(index=len(flat.spectrum)).volume == 0


def test_hidden_sites_are_listed():
    shapes = AlphaShapes([[0, 0], [0.1, 0], [4, 0]], radii=[3, 0.1, 1])
    assert shapes.hidden.tolist() == [1]


class OfOpen3D:
    """A point cloud as Open3D has it: `points` is no array, but becomes one."""

    class Vectors:
        def __init__(self, points):
            self._points = points

        def __array__(self, dtype=None, copy=None):
            return np.asarray(self._points, dtype=dtype)

    def __init__(self, points):
        self.points = self.Vectors(points)


def test_a_cloud_of_open3d_is_taken(cube):
    assert spectrum(OfOpen3D(cube)) == spectrum(cube)


@pytest.mark.partner
def test_clouds_and_meshes_of_the_installed_open3d_are_taken(cube):
    open3d = pytest.importorskip("open3d", exc_type=ImportError)
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(cube))
    assert spectrum(cloud) == spectrum(cube)
    box = open3d.geometry.TriangleMesh.create_box()
    assert spectrum(box) == spectrum(np.asarray(box.vertices))


def test_atoms_without_elements_need_radii(cube):
    atoms = types.SimpleNamespace(positions=cube, n_atoms=8)
    with pytest.raises(InputError, match="elements of the atoms are not told"):
        AlphaShapes(atoms)
    assert spectrum(atoms, radii=1.5) == spectrum(cube, radii=1.5)
    assert spectrum(atoms, radii="none") == spectrum(cube)
    atoms.elements = ["C"] * 7 + ["Xx"]
    with pytest.raises(InputError, match='row 7: element "Xx" has no radius in bondi'):
        AlphaShapes(atoms)


@pytest.mark.partner
def test_meshes_of_trimesh_and_pyvista_are_taken(cube):
    trimesh, pyvista = pytest.importorskip("trimesh"), pytest.importorskip("pyvista")
    assert spectrum(trimesh.PointCloud(cube)) == spectrum(cube)
    box = trimesh.creation.box()
    assert spectrum(box) == spectrum(np.asarray(box.vertices))
    assert spectrum(pyvista.PolyData(cube)) == spectrum(cube)


@pytest.mark.partner
def test_tables_of_pandas_are_taken(samples, plane):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"name": "a", "Y": plane[:, 1], "x": plane[:, 0], "r": 0.1})
    assert spectrum(frame) == spectrum(plane)
    assert spectrum(frame, radii="r") == spectrum(plane, radii=0.1)
    assert spectrum(frame[["x", "Y"]].rename(columns={"x": "a", "Y": "b"})) == spectrum(plane)
    with pytest.raises(InputError, match="there is no column 'q'"):
        AlphaShapes(frame, weights="q")
    with pytest.raises(InputError, match="do not tell the coordinates"):
        AlphaShapes(frame.drop(columns="x"))


@pytest.mark.partner
def test_points_of_geopandas_are_taken(plane):
    geopandas, shapely = pytest.importorskip("geopandas"), pytest.importorskip("shapely")
    series = geopandas.GeoSeries([shapely.Point(*p) for p in plane])
    frame = geopandas.GeoDataFrame({"crown": 0.1}, index=series.index, geometry=series)
    assert spectrum(series) == spectrum(plane)
    assert spectrum(frame, radii="crown") == spectrum(plane, radii=0.1)
    lines = geopandas.GeoSeries([shapely.Point(0, 0), shapely.LineString([(0, 0), (1, 1)])])
    with pytest.raises(InputError, match="row 1: the geometry is LineString"):
        AlphaShapes(lines)


@pytest.mark.partner
def test_molecules_of_other_packages_are_those_of_our_reader(samples):
    path = str(samples / "bdna_dodecamer.pdb")
    ours = AlphaShapes(orthoball.read(path, waters=True))

    def is_ours(structure, digits):
        shapes = AlphaShapes(structure)
        assert shapes.site_count == ours.site_count
        np.testing.assert_allclose(shapes.points, ours.points, rtol=0, atol=digits)
        np.testing.assert_allclose(shapes.weights, ours.weights, rtol=1e-12)
        assert shapes.automatic_alpha().name == "dual_complex"

    mda = pytest.importorskip("MDAnalysis")
    is_ours(mda.Universe(path), 1e-5)
    is_ours(mda.Universe(path).atoms, 1e-5)
    pdb = pytest.importorskip("Bio.PDB")
    is_ours(pdb.PDBParser(QUIET=True).get_structure("it", path), 1e-5)
    gemmi = pytest.importorskip("gemmi")
    is_ours(gemmi.read_structure(path), 1e-12)
    is_ours(gemmi.read_structure(path)[0], 1e-12)
    io = pytest.importorskip("ase.io")
    is_ours(io.read(path), 1e-12)


def test_the_row_that_is_no_number_is_named():
    with pytest.raises(InputError) as caught:
        AlphaShapes(np.array([[1, 2], [3, None]], dtype=object))
    assert caught.value.row == 1
    with pytest.raises(InputError) as caught:
        AlphaShapes(np.array([[1, 2], [3, 4]], dtype=object))
    assert caught.value.row is None


def test_masked_rows_are_refused(cube):
    mask = np.zeros(cube.shape, dtype=bool)
    assert spectrum(np.ma.array(cube, mask=mask)) == spectrum(cube)
    mask[5, 1] = True
    with pytest.raises(InputError, match="masked") as caught:
        AlphaShapes(np.ma.array(cube, mask=mask))
    assert caught.value.row == 5


@pytest.mark.parametrize("threads", [0, -1, 1025, 10**9, 1.5, "2"])
def test_threads_are_a_number_of_them(cube, threads):
    with pytest.raises(InputError, match="from 1 to 1024"):
        AlphaShapes(cube, threads=threads)


def test_a_molecule_that_was_read_stays_one_with_other_radii(samples):
    reading = orthoball.read(samples / "bdna_dodecamer.pdb")
    shapes = AlphaShapes(reading, radii=1.7)
    assert shapes.automatic_alpha().name == "dual_complex"
    assert set(shapes.weights) == {1.7**2}
    with pytest.raises(InputError, match="read\\(path, radii='alvarez'\\)"):
        AlphaShapes(reading, radii="alvarez")
