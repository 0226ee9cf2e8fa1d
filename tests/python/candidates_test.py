# SPDX-License-Identifier: MIT
"""Which alpha to take, and alphas by name."""

import pathlib

import numpy as np
import pytest

import orthoball
from orthoball import AlphaCandidate, AlphaCandidates, AlphaShapes, InputError


@pytest.fixture(scope="module")
def tori():
    root = pathlib.Path(__file__).resolve().parents[2]
    return AlphaShapes(orthoball.read(root / "examples/data/linked_tori.csv"))


def test_candidates_tell_of_the_shapes_there(tori):
    candidates = tori.alpha_candidates()
    assert isinstance(candidates, AlphaCandidates) and "signature" in repr(candidates)
    by_name = {one.name: one for one in candidates}
    assert len(by_name) == len(candidates)
    assert {one.name for one in tori.notable_alphas()} < set(by_name)
    there = [one for one in candidates if one.index is not None]
    assert [one.stability for one in there] == sorted(
        (one.stability for one in there), reverse=True
    )
    for one in there:
        shape = tori.shape(index=one.index)
        assert one.betti == shape.betti and one.reason
        assert (one.volume, one.area) == (shape.volume, shape.area)
        assert tori.spectrum[one.index - 1] == one.alpha2
        assert one.alpha == pytest.approx(np.sqrt(one.alpha2)) and one.stable_from <= one.alpha2
        assert one.stable_to is None or one.alpha2 <= one.stable_to
        assert one.alpha == 0 or one.inverse_alpha == 1 / one.alpha
        assert one.found is None and one.same_betti is None and one.alpha_median is None
    assert by_name["signature"].betti == (2, 4, 2)


def test_what_there_is_not_is_none():
    (lonely,) = [one for one in AlphaShapes([[0, 0]]).alpha_candidates() if one.name == "solid"]
    assert lonely.index is None and lonely.betti is None and lonely.volume is None
    assert isinstance(lonely, AlphaCandidate)


def test_resamples_tell_how_alphas_spread(plane):
    shapes = AlphaShapes(plane)
    candidates = shapes.alpha_candidates(resamples=5, seed=3)
    connected = next(one for one in candidates if one.name == "connected")
    assert connected.found == 5 and 0 <= connected.same_betti <= 5
    assert connected.alpha_low <= connected.alpha_median <= connected.alpha_high
    assert candidates.to_bytes("csv") == shapes.alpha_candidates(resamples=5, seed=3).to_bytes(
        "csv"
    )
    assert candidates.to_bytes("csv") != shapes.alpha_candidates(resamples=5, seed=4).to_bytes(
        "csv"
    )
    with pytest.raises(InputError, match="share"):
        shapes.alpha_candidates(resamples=1, share=0.0)
    with pytest.raises(InputError, match="resamples and seed are whole numbers"):
        shapes.alpha_candidates(resamples=-1)


@pytest.mark.partner
def test_candidates_are_a_table(tori, tmp_path):
    pandas = pytest.importorskip("pandas")
    candidates = tori.alpha_candidates()
    table = candidates.to_pandas()
    assert table["name"].tolist() == [one.name for one in candidates]
    candidates.write(tmp_path / "candidates.csv")
    assert list(pandas.read_csv(tmp_path / "candidates.csv").columns) == list(table.columns)
    with pytest.raises(InputError, match='"npz" is no format of this; there are csv and json'):
        candidates.write(tmp_path / "candidates.npz")
    assert [path.name for path in tmp_path.iterdir()] == ["candidates.csv"]


def test_alphas_are_taken_by_name(tori):
    one = next(one for one in tori.alpha_candidates() if one.name == "signature")
    name = "auto:signature"
    shape = tori.shape(alpha2=name)
    assert (shape.index, shape.alpha2, shape.betti) == (one.index, one.alpha2, (2, 4, 2))
    assert tori.shape("auto").index == tori.shape().index == tori.automatic_alpha().index
    assert tori.betti(name) == (2, 4, 2)
    assert np.array_equal(tori.role(2, alpha2=name), tori.role(2, index=one.index))
    assert len(tori.filtration(alpha2=name)) == len(tori.filtration(index=one.index))
    assert tori.signatures_at([name, 0.0]).index.tolist() == [one.index, tori.index(0.0)]
    assert tori.signatures_at("auto").index.tolist() == [tori.automatic_alpha().index]
    assert tori.ball_signatures(name).alpha2.tolist() == [one.alpha2]
    assert tori.balls(name).alpha2 == one.alpha2
    assert [v.volume for v in tori.voids(name)] == [h.volume for h in tori.shape(name).holes()]


def test_names_of_molecules_are_of_their_balls(samples):
    shapes = AlphaShapes(orthoball.read(samples / "c60.xyz"))
    assert shapes.shape("auto:dual_complex").alpha2 == 0
    assert shapes.shape("auto:probe").alpha == pytest.approx(1.4)
    assert shapes.balls("auto", probe=1.4).alpha2 == 0


def test_an_alpha_that_there_is_not_is_told_with_the_scale(tori, plane):
    with pytest.raises(InputError, match="NAME one of .*signature.*"):
        tori.shape("auto:best")
    with pytest.raises(InputError, match="'largest'; it must be a number"):
        tori.shape("largest")
    scale = "no such alpha; the first simplex enters at alpha2 0"
    with pytest.raises(InputError, match=scale + ".*; in one piece at .*; solid at "):
        tori.shape("auto:probe")
    with pytest.raises(InputError, match="one of alpha2, alpha, inverse_alpha and index"):
        tori.shape("auto", alpha=1.0)
    with pytest.raises(InputError, match="there are no sites"):
        AlphaShapes(np.zeros((0, 2))).shape("auto:solid")


def test_alphas_beyond_the_range_of_doubles_have_names_too():
    shapes = AlphaShapes([[0, 0], [1e200, 0], [0, 1e200], [1e200, 1.5e200]])
    one = next(one for one in shapes.alpha_candidates() if one.name == "connected")
    assert one.alpha2 is None and one.index is not None
    shape = shapes.shape("auto:connected")
    assert (shape.index, shape.alpha2) == (one.index, np.inf)
