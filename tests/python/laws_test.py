# SPDX-License-Identifier: MIT
"""What holds for any points, through Python."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import orthoball
from orthoball import AlphaShapes, ConflictError

numbers = st.integers(-6, 6) | st.floats(-4, 4, allow_subnormal=False)


@st.composite
def weighted_points(draw):
    dimension = draw(st.sampled_from([2, 3]))
    row = st.tuples(*[numbers] * dimension)
    points = np.array(draw(st.lists(row, max_size=14, unique=True)), dtype=float)
    points = points.reshape(-1, dimension) + 0.0  # no negative zeros
    weights = draw(st.none() | st.lists(numbers, min_size=len(points), max_size=len(points)))
    return points, None if weights is None else np.array(weights, dtype=float)


def simplices(shapes):
    """Every simplex as a set of rows with its three indices."""
    return {
        (frozenset(vertices), *map(int, ranks))
        for k in range(shapes.dimension + 1)
        for table in [shapes.simplices(k)]
        for vertices, *ranks in zip(table.vertices.tolist(), *table[1:])
    }


@settings(max_examples=60, deadline=None)
@given(weighted_points(), st.randoms(use_true_random=False))
def test_shuffled_rows_rename_simplices_and_change_nothing_else(sites, random):
    points, weights = sites
    order = list(range(len(points)))
    random.shuffle(order)
    ours = AlphaShapes(points, weights)
    shuffled = AlphaShapes(points[order], None if weights is None else weights[order])
    assert np.array_equal(ours.spectrum, shuffled.spectrum)
    renamed = {
        (frozenset(order[row] for row in rows), *ranks) for rows, *ranks in simplices(shuffled)
    }
    assert renamed == simplices(ours)
    for name, column in ours.signatures.items():
        assert np.array_equal(column, shuffled.signatures[name]), name


@settings(max_examples=40, deadline=None)
@given(weighted_points(), st.integers(-30, 30))
def test_a_power_of_two_scales_everything_exactly(sites, power):
    points, weights = sites
    ours = AlphaShapes(points, weights)
    scaled = AlphaShapes(
        np.ldexp(points, power), None if weights is None else np.ldexp(weights, 2 * power)
    )
    assert np.array_equal(scaled.spectrum, np.ldexp(ours.spectrum, 2 * power))
    assert simplices(scaled) == simplices(ours)
    volume = np.ldexp(ours.signatures["volume"], ours.dimension * power)
    assert np.array_equal(scaled.signatures["volume"], volume)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-9, 9)] * 3), max_size=12, unique=True), st.data())
def test_rigid_motions_of_a_lattice_keep_values(points, data):
    points = np.array(points, dtype=float).reshape(-1, 3)
    axes = data.draw(st.permutations(range(3)))
    signs = np.array(data.draw(st.tuples(*[st.sampled_from([-1, 1])] * 3)))
    shift = np.array(data.draw(st.tuples(*[st.integers(-50, 50)] * 3)))
    ours, moved = AlphaShapes(points), AlphaShapes(points[:, axes] * signs + shift)
    assert np.array_equal(ours.spectrum, moved.spectrum)
    assert np.array_equal(ours.signatures["betti"], moved.signatures["betti"])
    np.testing.assert_allclose(ours.signatures["volume"], moved.signatures["volume"], atol=1e-9)
    np.testing.assert_allclose(ours.signatures["area"], moved.signatures["area"], atol=1e-9)


@settings(max_examples=40, deadline=None)
@given(weighted_points())
def test_betti_numbers_and_counts_agree_about_the_euler_number(sites):
    shapes = AlphaShapes(*sites)
    signatures = shapes.signatures
    signs = (-1) ** np.arange(shapes.dimension + 1)
    in_complex = (signatures["singular"] + signatures["regular"] + signatures["interior"]).astype(
        int
    )
    assert np.array_equal(in_complex @ signs, signatures["euler"])
    assert np.array_equal(signatures["betti"].astype(int) @ signs[:-1], signatures["euler"])


@settings(max_examples=30, deadline=None)
@given(weighted_points())
def test_alive_classes_are_counted_by_betti_numbers(sites):
    shapes = AlphaShapes(*sites)
    diagrams = shapes.persistence()
    for index in range(1, len(shapes.spectrum) + 1):
        alive = [((d.index[:, 0] <= index) & (index < d.index[:, 1])).sum() for d in diagrams]
        assert tuple(alive) == tuple(shapes.signatures["betti"][index - 1])


@settings(max_examples=30, deadline=None)
@given(weighted_points(), st.integers(1, 4))
def test_threads_change_nothing(sites, threads):
    one, more = AlphaShapes(*sites, threads=1), AlphaShapes(*sites, threads=threads)
    for ours, theirs in zip(one.filtration(), more.filtration(), strict=True):
        assert ours == theirs


@settings(max_examples=30, deadline=None)
@given(weighted_points())
def test_representatives_are_cycles_in_the_complex_that_they_are_shown_in(sites):
    shapes = AlphaShapes(*sites)
    for one in shapes.persistence().representatives():
        assert shapes.are_present(one.cycle, index=one.index).all()
        if one.dimension == 0:
            continue
        faces = [np.delete(one.cycle, leave_out, axis=1) for leave_out in range(one.dimension + 1)]
        _, counts = np.unique(np.sort(np.concatenate(faces)), axis=0, return_counts=True)
        assert (counts % 2 == 0).all()


@settings(max_examples=30, deadline=None)
@given(weighted_points(), st.floats(0, 1))
def test_manifolds_have_two_facets_at_every_ridge(sites, share):
    shapes = AlphaShapes(*sites)
    closed = shapes.shape(index=round(share * len(shapes.spectrum))).manifold()
    facets = closed.triangles if shapes.dimension == 3 else closed.edges
    assert len(facets) == 0 or closed.volume > 0
    ridges = [np.delete(facets, leave_out, axis=1) for leave_out in range(shapes.dimension)]
    _, counts = np.unique(np.sort(np.concatenate(ridges)), axis=0, return_counts=True)
    assert (counts == 2).all()


@settings(max_examples=30, deadline=None)
@given(weighted_points(), st.integers(1, 6))
def test_weights_from_density_hide_nothing_and_scale(sites, neighbours):
    points, _ = sites
    points = np.unique(np.round(points, 3), axis=0)
    if len(points) <= neighbours:
        return
    weights = orthoball.density_weights(points, neighbours)
    assert len(AlphaShapes(points, weights).hidden) == 0
    assert np.array_equal(orthoball.density_weights(4 * points, neighbours), 16 * weights)


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.tuples(*[st.integers(0, 20)] * 2), min_size=4, max_size=9, unique=True), st.data()
)
def test_enforced_edges_are_there_or_conflict(points, data):
    if not orthoball.has_linear_solver():
        return
    row = st.integers(0, len(points) - 1)
    edges = data.draw(st.lists(st.lists(row, min_size=2, max_size=2, unique=True), max_size=3))
    try:
        held = AlphaShapes(points).enforce(edges, alpha2=4)
    except ConflictError as error:
        assert len(error.simplices) > 0
        held = AlphaShapes(points).enforce(edges, alpha2=4, add_sites=True)
        assert len(held.parts) > len(edges)
    assert held.shapes.are_present(held.parts, alpha2=4).all()
