# SPDX-License-Identifier: MIT
"""Weights made from the data."""

import os
import subprocess
import sys

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, ConflictError, EnforcedWeights, InputError, LimitError

needs_solver = pytest.mark.skipif(
    not orthoball.has_linear_solver(), reason="the solver CLP is not installed"
)


def half_mean_squares(points, neighbours):
    squares = ((points[:, None] - points[None]) ** 2).sum(axis=2)
    return np.sort(squares, axis=1)[:, 1 : neighbours + 1].mean(axis=1) / 2


@pytest.mark.parametrize("name", ["cloud", "plane"])
def test_weights_from_density_are_half_the_mean_square_distances(name, request):
    points = request.getfixturevalue(name)
    weights = orthoball.density_weights(points, 7)
    np.testing.assert_allclose(weights, half_mean_squares(points, 7), rtol=1e-14)
    shapes = AlphaShapes(points, weights="density:7", threads=1)
    assert np.array_equal(shapes.weights, weights) and len(shapes.hidden) == 0


def test_density_of_a_file_stays_decimal_and_is_no_molecule(samples):
    reading = orthoball.read(samples / "c60.xyz")
    atoms, shapes = AlphaShapes(reading), AlphaShapes(reading, "density:3")
    assert atoms.automatic_alpha().name == "dual_complex"
    assert shapes.automatic_alpha().name != "dual_complex"
    assert shapes.decimals == atoms.decimals + 2
    np.testing.assert_allclose(shapes.weights, half_mean_squares(reading.points, 3), rtol=1e-5)
    assert np.array_equal(orthoball.density_weights(reading, 3), shapes.weights)
    assert orthoball.density_weights(np.zeros((0, 2)), 3).tolist() == []


@pytest.mark.partner
def test_density_of_objects_ignores_what_they_weigh(cloud):
    pandas, ase = pytest.importorskip("pandas"), pytest.importorskip("ase")
    expected = orthoball.density_weights(cloud, 4)
    table = pandas.DataFrame(cloud, columns=["x", "y", "z"])
    assert np.array_equal(AlphaShapes(table, "density:4").weights, expected)
    atoms = ase.Atoms("X200", positions=cloud)  # an element without a radius
    assert np.array_equal(AlphaShapes(atoms, "density:4").weights, expected)
    assert np.array_equal(orthoball.density_weights(atoms, 4), expected)


@pytest.mark.parametrize(
    "text", ["density:", "density:0", "density:-1", "density:2.5", "density:x"]
)
def test_what_is_no_density_is_told(cloud, text):
    with pytest.raises(InputError, match="density:K is, K neighbours from 1"):
        AlphaShapes(cloud, weights=text)


def test_too_many_neighbours_and_two_kinds_of_weights_are_told(cloud, samples):
    with pytest.raises(InputError, match="200"):
        AlphaShapes(cloud, weights="density:200")
    for wrong in (0, -3):
        with pytest.raises(InputError, match=f"the neighbours are {wrong}"):
            orthoball.density_weights(cloud, wrong)
    with pytest.raises(InputError, match="weights and radii are both given"):
        AlphaShapes(cloud, weights="density:3", radii=1.0)
    with pytest.raises(InputError, match="weights and radii are both given"):
        AlphaShapes(orthoball.read(samples / "c60.xyz"), weights="density:3", radii=1.0)
    with pytest.raises(InputError, match="the points are no table"):
        AlphaShapes(cloud, weights="densities")


# The edge 0 1 is long, and crosses the short edge 2 3 in the middle.
CROSS = [[0, 0], [10, 0], [5, 1], [5, -1]]


@needs_solver
def test_enforced_simplices_are_there_and_little_is_changed():
    shapes = AlphaShapes(CROSS)
    assert shapes.are_present([[1, 0], [3, 2], [0, 3, 2]], alpha2=100).tolist() == [
        False,
        True,
        True,
    ]
    held = shapes.enforce([[1, 0]], alpha2=100)
    assert isinstance(held, EnforcedWeights) and "1 of 4 weights changed" in repr(held)
    assert held.shapes.are_present([[0, 1]], alpha2=100).tolist() == [True]
    assert np.array_equal(held.points, shapes.points)
    changes = held.weights - np.zeros(4)
    assert held.changed.tolist() == np.flatnonzero(changes).tolist()
    assert held.total_change == pytest.approx(np.abs(changes).sum())
    assert (held.parts, held.part_of, held.added.tolist()) == ([[0, 1]], [0], [])
    assert held.hidden.tolist() == []
    again = AlphaShapes(held.points, held.weights)
    assert np.array_equal(again.spectrum, held.shapes.spectrum)


@needs_solver
def test_what_is_there_already_needs_no_weights():
    held = AlphaShapes(CROSS).enforce([[2, 3]], alpha2="auto:connected")
    assert held.weights is None and held.total_change == 0 and held.to_bytes().startswith(b"x,y\n")


@needs_solver
def test_simplices_that_exclude_each_other_are_named_or_cut(tmp_path):
    shapes = AlphaShapes(CROSS)
    with pytest.raises(ConflictError, match=r"together: 1 \(0 1\), 2 \(2 3\); leave out") as told:
        shapes.enforce([[0, 2], [1, 0], [2, 3]], alpha2=100)
    assert told.value.simplices == [1, 2] and told.value.reason == "wrong_argument"
    cut = shapes.enforce([[0, 2], [1, 0], [2, 3]], alpha2=100, add_sites=True)
    assert cut.added.tolist() == [4] and cut.points[4].tolist() == [5, 0]
    assert sorted(cut.part_of) == [0, 1, 1, 2, 2]
    assert cut.shapes.are_present(cut.parts, alpha2=100).all()
    assert [0, 4] in cut.parts and [3, 4] in cut.parts
    cut.write(tmp_path / "cut.csv")
    read = orthoball.read(tmp_path / "cut.csv", weight_column="weight")
    assert np.array_equal(read.points, cut.points) and np.array_equal(read.weights, cut.weights)
    with pytest.raises(InputError, match="'json' is no format of points"):
        cut.to_bytes("json")


@needs_solver
def test_simplices_of_a_file_are_those_of_lists(samples, tmp_path):
    shapes = AlphaShapes(orthoball.read(samples / "trees.csv", columns=["x", "y"]))
    (tmp_path / "hedge.txt").write_text("# the hedge\n14 5\n5 9\n")
    of_file, of_list = (
        shapes.enforce(simplices, alpha2=25)
        for simplices in (tmp_path / "hedge.txt", [[14, 5], [5, 9]])
    )
    assert of_file.to_bytes("csv") == of_list.to_bytes("csv")
    assert shapes.are_present(tmp_path / "hedge.txt", alpha2=25).tolist() == [False, False]
    (tmp_path / "hedge.txt").write_text("14 5\n5 99\n")
    with pytest.raises(orthoball.ParseError, match="hedge.txt:2"):
        shapes.enforce(tmp_path / "hedge.txt")


def test_what_is_no_simplex_is_told_by_its_number():
    shapes = AlphaShapes(CROSS)
    for simplex in ([0, -1], [0, 0.5], 3, "01", [], [0, 2**32 - 1]):
        with pytest.raises(InputError, match="simplex 1: it is") as told:
            shapes.enforce([[0, 1], simplex])
        assert told.value.row == 1
    for ask in (shapes.enforce, lambda simplices: shapes.are_present(simplices, index=1)):
        with pytest.raises(
            InputError, match="simplex 1: row 4 of 4; rows are counted from 0"
        ) as told:
            ask([[0, 1], [2, 4]])
        assert told.value.row == 1
    with pytest.raises(InputError, match="simplex 0: 1 rows; there must be 2 to 3"):
        shapes.enforce([[0]])
    with pytest.raises(InputError, match="simplices are sequences of rows"):
        shapes.enforce(7)


def test_without_the_solver_it_says_so(tmp_path):
    """Also where it is installed: a file that is no library stands before it."""
    (tmp_path / "libClp.so.1").write_bytes(b"")
    program = (
        "import orthoball\n"
        "print(orthoball.has_linear_solver())\n"
        f"orthoball.AlphaShapes({CROSS}).enforce([[0, 1]], alpha2=100)\n"
    )
    environment = {**os.environ, "LD_LIBRARY_PATH": str(tmp_path)}
    ran = subprocess.run(
        [sys.executable, "-c", program],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.stdout == "False\n" and ran.returncode == 1
    assert "orthoball._core.LimitError" in ran.stderr and "CLP" in ran.stderr
    assert issubclass(LimitError, ValueError)
