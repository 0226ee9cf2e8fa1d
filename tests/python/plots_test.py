# SPDX-License-Identifier: MIT
"""Pictures: what is drawn where."""

import numpy as np
import pytest

from orthoball import AlphaShapes, InputError

pytestmark = pytest.mark.partner


@pytest.fixture(autouse=True)
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot
    pyplot.close("all")


def test_signatures_are_drawn_as_steps(cloud, pyplot):
    shapes = AlphaShapes(cloud)
    ax = shapes.plot_signatures()
    assert [line.get_label() for line in ax.lines] == ["components", "tunnels", "voids"]
    assert np.array_equal(ax.lines[1].get_ydata(), shapes.signatures["betti"][:, 1])
    assert ax.lines[0].get_drawstyle() == "steps-post" and ax.get_xlabel() == "alpha"
    _, given = pyplot.subplots()
    assert shapes.plot_signatures("volume", "regular", axis="index", ax=given) is given
    assert [line.get_label() for line in given.lines][:2] == ["volume", "regular, dimension 0"]
    given.figure.canvas.draw()
    with pytest.raises(InputError, match="no column 'bettis'"):
        shapes.plot_signatures("bettis")
    with pytest.raises(InputError, match="the axis is 'r'"):
        shapes.plot_signatures(axis="r")


def test_a_plane_shape_is_filled_and_its_singular_parts_stand_out(plane):
    shapes = AlphaShapes(plane)
    ax = shapes.plot_shape(alpha=0.04)
    shape = shapes.shape(alpha=0.04)
    assert len(ax.patches) == len(shape.to_shapely().geoms)
    assert len(ax.collections[0].get_segments()) == len(shape.edges)
    assert len(ax.lines[1].get_xdata()) == len(shape.vertices)
    ax.figure.canvas.draw()
    assert [line.get_label() for line in shapes.plot_signatures("betti").lines] == [
        "components",
        "holes",
    ]


def test_a_shape_in_space_is_drawn(cloud):
    shapes = AlphaShapes(cloud)
    for shape in (shapes.shape(), shapes.shape(alpha=0.09), shapes.shape(index=0)):
        ax = shape.plot()
        ax.figure.canvas.draw()
        assert ax.name == "3d"
    AlphaShapes(np.zeros((0, 3))).plot_shape().figure.canvas.draw()


def test_signatures_of_no_points_are_empty_pictures(pyplot):
    ax = AlphaShapes(np.zeros((0, 2))).plot_signatures()
    assert all(len(line.get_xdata()) == 0 for line in ax.lines)
