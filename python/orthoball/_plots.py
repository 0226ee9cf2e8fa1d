# SPDX-License-Identifier: MIT
"""Pictures with matplotlib, which is imported where it is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import fault
from ._tables import Role

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes
    from ._shape import Shape

_FILL, _LINE, _SINGULAR, _SITE = "#b8cfe5", "#27527a", "#c8553d", "#555555"
_BETTI = ("components", "tunnels", "voids")
_BETTI_IN_PLANE = ("components", "holes")


def _labels(shapes: AlphaShapes, name: str, width: int) -> Sequence[str]:
    if width == 1:
        return [name]
    if name == "betti":
        return _BETTI_IN_PLANE if shapes.dimension == 2 else _BETTI
    return [f"{name}, dimension {k}" for k in range(width)]


def plot_signatures(shapes: AlphaShapes, columns: Sequence[str], axis: str, ax: Any) -> Any:
    """See AlphaShapes.plot_signatures."""
    from matplotlib import pyplot

    if axis not in ("alpha", "alpha2", "index"):
        raise fault(f'the axis is {axis!r}; it must be "alpha", "alpha2" or "index"')
    signatures = shapes.signatures
    for name in columns:
        if name not in signatures:
            raise fault(f"there is no column {name!r}; the columns are {list(signatures)}")
    if ax is None:
        _, ax = pyplot.subplots()
    for name in columns:
        values = signatures[name]
        values = values if values.ndim == 2 else values[:, np.newaxis]
        for column, label in zip(values.T, _labels(shapes, name, values.shape[1])):
            ax.step(signatures[axis], column, where="post", label=label)
    ax.set_xlabel(axis)
    ax.set_ylabel(", ".join(columns))
    ax.legend()
    return ax


def plot_shape(shape: Shape, ax: Any) -> Any:
    """See Shape.plot."""
    from matplotlib import pyplot

    in_space = shape.shapes.dimension == 3
    if ax is None:
        figure = pyplot.figure()
        ax = figure.add_subplot(projection="3d" if in_space else None)
    if in_space:
        _draw_in_space(shape, ax)
    else:
        _draw_in_plane(shape, ax)
    ax.set_aspect("equal")
    return ax


def _draw_in_plane(shape: Shape, ax: Any) -> None:
    from matplotlib.collections import LineCollection
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    points = shape.shapes.points
    for rings in _core.polygons(shape._core):
        path = Path.make_compound_path(
            *(Path(points[np.append(ring, ring[0])], closed=True) for ring in rings)
        )
        ax.add_patch(PathPatch(path, facecolor=_FILL, edgecolor="none"))
    colours = [_SINGULAR if role == Role.singular else _LINE for role in shape.edge_roles]
    ax.add_collection(LineCollection(points[shape.edges], colors=colours))
    ax.plot(points[:, 0], points[:, 1], ".", color=_SITE, markersize=2)
    alone = points[shape.vertices]
    ax.plot(alone[:, 0], alone[:, 1], ".", color=_SINGULAR)
    ax.autoscale_view()


def _draw_in_space(shape: Shape, ax: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    points = shape.shapes.points
    if len(shape.triangles) > 0:
        ax.add_collection3d(
            Poly3DCollection(
                points[shape.triangles], facecolor=_FILL, edgecolor=_LINE, linewidth=0.3
            )
        )
    if len(shape.edges) > 0:
        ax.add_collection3d(Line3DCollection(points[shape.edges], colors=_SINGULAR))
    if len(shape.vertices) > 0:
        ax.scatter(*points[shape.vertices].T, color=_SINGULAR, s=4)
    if len(points) > 0:
        for set_limits, column in zip((ax.set_xlim, ax.set_ylim, ax.set_zlim), points.T):
            low, high = column.min(), column.max()
            margin = 0.05 * (high - low) or 0.5
            set_limits(low - margin, high + margin)
