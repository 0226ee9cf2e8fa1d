# SPDX-License-Identifier: MIT
"""Diagrams, and what makes their classes."""

import json
import pathlib
import threading
from collections import Counter

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes, Diagram, Diagrams, InputError, Representative, Representatives


@pytest.fixture(scope="module")
def tori():
    root = pathlib.Path(__file__).resolve().parents[2]
    return AlphaShapes(orthoball.read(root / "examples/data/linked_tori.csv"))


def longest(diagram, count):
    births, deaths = np.sqrt(diagram.alpha2).T
    return np.argsort(births - deaths)[:count].tolist()


def test_all_diagrams_are_those_of_each_dimension(cloud):
    shapes = AlphaShapes(cloud)
    diagrams = shapes.persistence()
    assert isinstance(diagrams, Diagrams) and len(diagrams) == 3
    for dimension, diagram in enumerate(diagrams):
        alone = shapes.persistence(dimension)
        assert isinstance(alone, Diagram) and alone.dimension == dimension
        for name in ("alpha2", "index", "births", "deaths"):
            assert np.array_equal(getattr(alone, name), getattr(diagram, name))
        assert alone.to_bytes("csv").count(b"\n") == len(alone) + 1
    assert f"{len(diagrams[0])}, {len(diagrams[1])}" in repr(diagrams)
    assert diagrams.to_bytes("gudhi").count(b"\n") == sum(map(len, diagrams))
    rows = json.loads(diagrams.to_bytes("json", indices=True))
    assert [row["birth"] for row in rows if row["dimension"] == 2] == diagrams[2].index[
        :, 0
    ].tolist()


def test_short_lives_can_be_left_out(cloud):
    shapes = AlphaShapes(cloud)
    lives = np.diff(shapes.persistence(1).alpha2)[:, 0]
    least = float(np.median(lives))
    kept = shapes.persistence(1, minimum_length=least)
    assert np.array_equal(np.diff(kept.alpha2)[:, 0], lives[lives >= least])
    assert np.isinf(shapes.persistence(0, minimum_length=1e9).alpha2[:, 1]).tolist() == [True]
    for wrong in (-1.0, float("nan")):
        with pytest.raises(InputError, match="a length of lives is 0 or more"):
            shapes.persistence(minimum_length=wrong)


def test_a_tunnel_is_a_ring_of_edges_and_filled_by_a_triangle(tori):
    diagram = tori.persistence(1)
    for number in longest(diagram, 4):
        one = diagram.representative(number)
        assert isinstance(one, Representative) and one.dimension == 1
        assert [one.birth, one.death] == diagram.alpha2[number].tolist()
        assert diagram.index[number, 0] <= one.index < diagram.index[number, 1]
        assert one.alpha2 == tori.spectrum[one.index - 1]
        assert np.array_equal(one.birth_simplex, diagram.births[number])
        assert np.array_equal(one.death_simplex, diagram.deaths[number])
        assert set(Counter(one.cycle.ravel().tolist()).values()) == {2}
        (ring,) = one.rings
        steps = np.sort(np.column_stack([ring, np.roll(ring, -1)]), axis=1)
        assert sorted(steps.tolist()) == sorted(one.cycle.tolist())
        points = tori.points
        length = np.linalg.norm(points[ring] - points[np.roll(ring, -1)], axis=1).sum()
        assert one.size == pytest.approx(length) and one.rows.tolist() == sorted(ring.tolist())
        assert one.volume == 0 and len(one.cells) == 0
        assert tori.are_present(one.cycle, index=one.index).all()


def test_a_void_has_cells_and_triangles_around_at_any_index_of_its_life(tori):
    diagram = tori.persistence(2)
    number = longest(diagram, 1)[0]
    birth, death = diagram.index[number].tolist()
    for index in (birth, (birth + death) // 2, death - 1):
        one = diagram.representative(number, index=index)
        holes = tori.voids(index=index)
        (hole,) = [
            hole
            for hole in holes
            if set(map(tuple, hole.cells.tolist())) == set(map(tuple, one.cells.tolist()))
        ]
        assert one.index == index and one.volume == pytest.approx(hole.volume)
        assert one.size == pytest.approx(hole.area)
        assert hole.born == birth and hole.dies == death
        edges = Counter(
            tuple(sorted((a, b))) for t in one.cycle.tolist() for a, b in zip(t, t[1:] + t[:1])
        )
        assert all(count % 2 == 0 for count in edges.values())
    with pytest.raises(InputError):
        diagram.representative(number, index=death)
    with pytest.raises(InputError, match=f"there is no class {len(diagram)}; classes are numbered"):
        diagram.representative(len(diagram))


def test_a_component_is_its_sites(samples):
    shapes = AlphaShapes([[0, 0], [1, 0], [10, 0], [12, 0]])
    diagram = shapes.persistence(0)
    parts = [one.rows.tolist() for one in diagram.representatives(alpha2=1.0)]
    assert sorted(parts) == [[0, 1], [2, 3]]
    assert [one.cells.shape for one in diagram.representatives(alpha2=1.0)] == [(0, 3), (0, 3)]
    (last,) = diagram.representatives("auto:connected")
    assert (
        last.rows.tolist() == [0, 1, 2, 3] and last.death == np.inf and last.death_simplex is None
    )


def test_representatives_of_all_dimensions_are_written(tori, tmp_path):
    diagrams = tori.persistence(minimum_length=0.1)
    found = diagrams.representatives()
    assert isinstance(found, Representatives) and len(found) == sum(map(len, diagrams))
    assert repr(found) == f"<orthoball.Representatives of {len(found)} classes>"
    found.write(tmp_path / "classes.json")
    rows = json.loads((tmp_path / "classes.json").read_text())
    assert [row["rows"] for row in rows] == [one.rows.tolist() for one in found]
    found.write(tmp_path / "classes.ply")
    assert (tmp_path / "classes.ply").read_bytes().startswith(b"ply\n")
    with pytest.raises(InputError, match='"csv" is no format of this; there are json and ply'):
        found.to_bytes("csv")


def test_threads_may_ask_at_once_and_diagrams_outlive_their_shapes(cloud):
    diagrams = AlphaShapes(cloud).persistence()
    found = [None] * 4

    def ask(i):
        found[i] = [one.size for one in diagrams[1].representatives()]

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found[0] and all(sizes == found[0] for sizes in found)


def test_diagrams_are_drawn(tori):
    diagrams = tori.persistence()
    svg = diagrams.figure().decode()
    assert svg.startswith("<svg") and "linked_tori.csv" in svg and svg.rstrip().endswith("</svg>")
    bars = diagrams[1].figure("barcode", axis="index", title="Bars & tunnels").decode()
    assert "Bars &amp; tunnels" in bars and bars != svg
    with pytest.raises(InputError, match='the kind is "pie"'):
        diagrams.figure("pie")
    with pytest.raises(InputError, match='the axis is "r"'):
        diagrams.figure(axis="r")


def test_a_diagram_is_written_by_its_name(cloud, tmp_path):
    diagram = AlphaShapes(cloud).persistence(1)
    diagram.write(tmp_path / "diagram.pers")
    assert (tmp_path / "diagram.pers").read_bytes() == diagram.to_bytes("gudhi")
    diagram.write(tmp_path / "diagram.csv", indices=True)
    assert (tmp_path / "diagram.csv").read_bytes() == diagram.to_bytes("csv", indices=True)
    assert diagram.to_bytes("csv", indices=True) != diagram.to_bytes("csv")
    with pytest.raises(InputError, match="csv, json and gudhi"):
        diagram.write(tmp_path / "diagram.txt")
    assert not (tmp_path / "diagram.txt").exists()
