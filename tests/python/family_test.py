# SPDX-License-Identifier: MIT
"""All shapes at once: spectrum, simplices, filtration, signatures, topology."""

import copy
import itertools

import numpy as np
import pytest

from orthoball import NONE, AlphaShapes, Diagram, InputError, Role, __version__


@pytest.fixture
def shapes(cloud):
    return AlphaShapes(cloud)


def test_the_version_is_that_of_the_build(root):
    assert f"VERSION {__version__}\n" in (root / "CMakeLists.txt").read_text()


def test_facts_of_the_input(shapes, cloud):
    assert (shapes.dimension, shapes.affine_dimension, shapes.site_count) == (3, 3, 200)
    assert shapes.decimals is None
    assert np.array_equal(shapes.points, cloud)
    assert shapes.hidden.shape == (0,) and shapes.duplicates.shape == (0, 2)
    assert repr(shapes) == (
        f"<orthoball.AlphaShapes of 200 sites in space: {len(shapes.filtration())} simplices, "
        f"{len(shapes.spectrum)} distinct alpha2>"
    )


def test_the_spectrum_of_a_square_is_known():
    square = AlphaShapes([[0, 0], [2, 0], [0, 2], [2, 2]])
    assert square.spectrum.tolist() == [0, 1, 2]
    assert [square.index(x) for x in (-1, 0, 0.5, 1, 2, 9)] == [0, 1, 1, 2, 3, 3]
    assert square.index([[0.5, 1], [2, -3]]).tolist() == [[1, 2], [3, 0]]
    assert square.index(np.float64(1.5)) == 2
    with pytest.raises(InputError, match="NaN"):
        square.index(np.nan)


def test_simplices_are_those_of_the_filtration(shapes):
    filtration = shapes.filtration()
    assert len(filtration) == sum(len(shapes.simplices(k).enters) for k in range(4))
    known = {
        tuple(v): tuple(map(int, ranks))
        for k in range(4)
        for simplices in [shapes.simplices(k)]
        for v, *ranks in zip(simplices.vertices.tolist(), *simplices[1:])
    }
    listed = zip(filtration, filtration.enters, filtration.regular, filtration.interior)
    for (simplex, alpha2), enters, regular, interior in listed:
        assert known.pop(simplex) == (enters, regular, interior)
        assert alpha2 == shapes.spectrum[enters - 1]
    assert not known
    with pytest.raises(InputError, match="no simplices of dimension 4; dimensions are 0 to 3"):
        shapes.simplices(4)


def test_faces_come_before_what_they_bound(shapes):
    seen, last = set(), -np.inf
    for simplex, alpha2 in shapes.filtration():
        assert alpha2 >= last
        last = alpha2
        if len(simplex) > 1:
            assert seen.issuperset(itertools.combinations(simplex, len(simplex) - 1))
        seen.add(simplex)


def test_the_arrays_of_the_filtration_have_their_shapes(shapes):
    filtration = shapes.filtration()
    n = len(filtration)
    assert filtration.vertices.shape == (n, 4) and filtration.vertices.dtype == np.uint32
    assert filtration.dimension.dtype == np.uint8 and filtration.alpha2.dtype == np.float64
    used = filtration.vertices != NONE
    assert np.array_equal(used.sum(axis=1), filtration.dimension + 1)
    assert repr(filtration) == f"<orthoball.Filtration of {n} simplices>"
    some = shapes.filtration(index=300)
    assert np.array_equal(some.vertices, filtration.vertices[: len(some)])
    assert some.enters[-1] <= 300 < filtration.enters[len(some)]
    assert len(shapes.filtration(alpha2=-1)) == 0


def test_roles_follow_the_indices(shapes):
    for index in (0, 250, len(shapes.spectrum)):
        for k in range(4):
            _, enters, regular, interior = shapes.simplices(k)
            expected = (index >= enters).astype(int) + (index >= regular) + (index >= interior)
            roles = shapes.role(k, index=index)
            assert roles.dtype == np.uint8
            assert np.array_equal(roles, expected)
    square = AlphaShapes([[0, 0], [2, 0], [0, 2], [2, 2]])
    assert square.role(1, alpha=1).tolist().count(Role.singular) == 4
    assert square.role(2, inverse_alpha=0.1).tolist() == [Role.interior, Role.interior]
    assert [role.name for role in Role] == ["exterior", "singular", "regular", "interior"]


def test_signatures_agree_with_the_filtration(shapes):
    signatures = shapes.signatures
    s = len(shapes.spectrum)
    assert signatures is shapes.signatures
    assert np.array_equal(signatures["index"], np.arange(1, s + 1))
    assert np.array_equal(signatures.alpha2, shapes.spectrum)
    assert np.array_equal(signatures.alpha, np.sqrt(shapes.spectrum))
    for k in range(4):
        enters = np.sort(shapes.simplices(k).enters)
        entered = np.searchsorted(enters, signatures["index"], side="right")
        assert np.array_equal(signatures["exterior"][:, k], len(enters) - entered)
    euler = signatures["betti"].astype(int) @ [1, -1, 1]
    assert np.array_equal(signatures["euler"], euler)
    assert signatures.betti[-1].tolist() == [1, 0, 0]
    assert signatures.area == pytest.approx(signatures.area_regular + 2 * signatures.area_singular)
    assert set(dir(signatures)) >= {"betti", "length", "to_pandas"}
    assert len(signatures) == 14
    assert f"at {s} indices" in repr(signatures)
    with pytest.raises(AttributeError, match="no column 'bettis'"):
        signatures.bettis


def test_signatures_at_some_places(shapes):
    all_of_them = shapes.signatures
    some = shapes.signatures_at(index=[400, 7, 0])
    assert some["index"].tolist() == [400, 7, 0]
    assert some["volume"].tolist() == [*all_of_them["volume"][[399, 6]], 0]
    by_alpha2 = shapes.signatures_at([shapes.spectrum[6], -1])
    assert by_alpha2["index"].tolist() == [7, 0]
    assert shapes.signatures_at(shapes.spectrum[6])["index"].tolist() == [7]
    for wrong in (-1, 1.5, len(shapes.spectrum) + 1):
        with pytest.raises(InputError, match="whole number from 0 to"):
            shapes.signatures_at(index=[wrong])


def test_signatures_in_the_plane_have_no_length(plane):
    signatures = AlphaShapes(plane).signatures
    assert "length" not in signatures
    assert signatures["betti"].shape[1] == 2 and signatures["regular"].shape[1] == 3


@pytest.mark.partner
def test_signatures_become_a_table(shapes):
    pytest.importorskip("pandas")
    frame = shapes.signatures.to_pandas()
    assert list(frame.columns)[:8] == [
        "index", "alpha2", "alpha", "betti_0", "betti_1", "betti_2", "euler", "exterior_0",
    ]  # fmt: skip
    assert len(frame) == len(shapes.spectrum)
    assert frame.betti_1.max() == shapes.signatures["betti"][:, 1].max()


def test_ball_signatures_are_those_of_unions(cloud):
    shapes = AlphaShapes(cloud, radii=0.05)
    signatures = shapes.ball_signatures([0, 0.001])
    for i, alpha2 in enumerate((0, 0.001)):
        balls = shapes.balls(alpha2)
        assert signatures["volume"][i] == pytest.approx(balls.volume)
        assert signatures["area"][i] == pytest.approx(balls.area)
        assert tuple(signatures["betti"][i]) == balls.betti
        assert signatures["euler"][i] == balls.euler
        assert signatures["index"][i] == balls.index
    assert signatures["alpha2"].tolist() == [0, 0.001]


def test_betti_numbers_at_one_place(shapes):
    for index in (1, 300, 600):
        expected = tuple(shapes.signatures["betti"][index - 1].tolist())
        assert shapes.betti(index=index) == expected
        assert shapes.betti(shapes.spectrum[index - 1]) == expected
        assert shapes.betti(alpha=np.nextafter(np.sqrt(shapes.spectrum[index - 1]), 9)) == expected


def test_persistence_counts_betti_numbers(shapes):
    betti = shapes.signatures["betti"]
    diagrams = shapes.persistence()
    assert [diagram.dimension for diagram in diagrams] == [0, 1, 2]
    for k, diagram in enumerate(diagrams):
        born, died = diagram.index.T
        for index in (1, 200, 500, len(shapes.spectrum)):
            assert ((born <= index) & (index < died)).sum() == betti[index - 1, k]
        ends = np.append(shapes.spectrum, np.inf)
        assert np.array_equal(diagram.alpha2, ends[diagram.index - 1])
        assert np.array_equal(np.asarray(diagram), diagram.alpha2)
        assert np.array(diagram, dtype=np.float32).dtype == np.float32
        assert diagram.births.shape == (len(diagram), k + 1)
        assert diagram.deaths.shape == (len(diagram), k + 2)
        assert np.array_equal(
            diagram.index[:, 1] > len(shapes.spectrum), diagram.deaths[:, 0] == NONE
        )
        assert repr(diagram) == f"<orthoball.Diagram of dimension {k}: {len(diagram)} classes>"
    one = shapes.persistence(1)
    assert isinstance(one, Diagram) and np.array_equal(one.alpha2, diagrams[1].alpha2)
    assert len(shapes.persistence(1, all=True)) > len(one)
    with pytest.raises(InputError, match="no classes of dimension 3; they are 0 to 2"):
        shapes.persistence(3)


def test_the_simplices_of_a_pair_enter_when_it_is_born_and_dies(shapes):
    enters = {
        simplex: rank for (simplex, _), rank in zip(shapes.filtration(), shapes.filtration().enters)
    }
    diagram = shapes.persistence(1)
    for (born, died), birth, death in zip(
        diagram.index, diagram.births.tolist(), diagram.deaths.tolist()
    ):
        assert enters[tuple(birth)] == born
        assert enters[tuple(death)] == died


def test_notable_alphas(shapes, cloud):
    notable = {alpha.name: alpha for alpha in shapes.notable_alphas()}
    assert list(notable)[:3] == ["all_vertices", "all_vertices_in_cells", "connected"]
    connected = notable["connected"]
    assert shapes.betti(index=connected.index)[0] == 1
    assert shapes.betti(index=connected.index - 1)[0] > 1
    assert connected.alpha2 == shapes.spectrum[connected.index - 1]
    assert connected.alpha == np.sqrt(connected.alpha2)
    assert "component" in connected.reason or "piece" in connected.reason or connected.reason
    assert shapes.automatic_alpha().name == "solid"
    assert AlphaShapes(cloud, 0.01).automatic_alpha().name == "connected"


def test_faults_have_a_row_and_a_reason(plane):
    shapes = AlphaShapes(plane)
    faults = [
        lambda: shapes.shape(region=0),
        lambda: shapes.persistence(7),
        lambda: shapes.persistence(minimum_length=float("nan")),
        lambda: shapes.signatures_at(index=[99999]),
        lambda: shapes.signatures_at(),
        lambda: shapes.signatures_at(0.1, index=1),
        lambda: shapes.alpha_candidates(resamples=-1),
        lambda: shapes.balls().figure(style="x"),
    ]
    for wrong in faults:
        with pytest.raises(InputError) as caught:
            wrong()
        assert caught.value.row is None
        assert caught.value.reason == "wrong_argument"


def test_an_index_is_found_by_name(plane):
    shapes = AlphaShapes(plane)
    assert shapes.index("auto") == shapes.automatic_alpha().index
    assert shapes.index("auto:solid") == shapes.shape(alpha2="auto:solid").index


def test_signatures_can_be_copied(plane):
    signatures = AlphaShapes(plane).signatures
    for copied in (copy.copy(signatures), copy.deepcopy(signatures)):
        assert np.array_equal(copied.volume, signatures.volume)
