# SPDX-License-Identifier: MIT
"""What is known of all shapes at once, as arrays."""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._files import Written

NONE = 4294967295
"""Stands where an array of vertices has a place without one."""


class Role(enum.IntEnum):
    """What a simplex is in one shape."""

    exterior = 0
    """Not in the complex."""
    singular = 1
    """In the complex, a face of nothing in it."""
    regular = 2
    """A face of something in the complex, on its boundary."""
    interior = 3
    """Inside the shape."""


class Simplices(NamedTuple):
    """All simplices of one dimension k, neighbours in space near each other.

    A simplex is exterior below the index `enters`, singular from there, regular from `regular`,
    interior from `interior` on; the number of entries of the spectrum plus 1 stands for never.
    """

    vertices: NDArray[np.uint32]
    """(n, k + 1) input rows, ascending."""
    enters: NDArray[np.uint32]
    """(n,) indices of the spectrum, from 1; a view."""
    regular: NDArray[np.uint32]
    """(n,) indices of the spectrum."""
    interior: NDArray[np.uint32]
    """(n,) indices of the spectrum."""


class Filtration(Written):
    """All simplices in the exact order of their appearance: every prefix is a complex.

    Ordered by exact alpha2, then dimension, then rows. Iterating gives `(simplex, alpha2)`, the
    simplex as a tuple of rows. The arrays are those that `orthoball filter` writes as NPZ, but that
    never is the spectrum's size plus 1 in them. Views, or found when first asked for and kept.
    """

    _format_of_ending = {"jsonl": "json"}

    def __init__(self, columns: _core.FilterColumns, threads: int | None):
        self._columns, self._threads = columns, threads

    def to_bytes(self, format: str) -> bytes:
        """What `orthoball filter` writes: "csv", "json", an object a line, or "npz"."""
        return self._columns.file(format, self._threads)

    @cached_property
    def dimension(self) -> NDArray[np.uint8]:
        """(n,) 0 to D."""
        return self._columns.dimension

    @cached_property
    def vertices(self) -> NDArray[np.uint32]:
        """(n, D + 1) input rows, ascending, filled up with NONE."""
        return self._columns.vertices

    @cached_property
    def alpha2(self) -> NDArray[np.float64]:
        """(n,) length^2, never decreasing; the double nearest to the exact value."""
        return self._columns.alpha2(self._threads)

    @cached_property
    def enters(self) -> NDArray[np.uint32]:
        """(n,) indices of the spectrum, from 1."""
        return self._columns.enters

    @cached_property
    def regular(self) -> NDArray[np.uint32]:
        """(n,) indices of the spectrum."""
        return self._columns.regular(self._threads)

    @cached_property
    def interior(self) -> NDArray[np.uint32]:
        """(n,) indices of the spectrum."""
        return self._columns.interior(self._threads)

    def __len__(self) -> int:
        return len(self.enters)

    def __iter__(self) -> Iterator[tuple[tuple[int, ...], float]]:
        widths = (self.dimension + 1).tolist()
        for row, width, alpha2 in zip(self.vertices, widths, self.alpha2.tolist()):
            yield tuple(row[:width].tolist()), alpha2

    def __repr__(self) -> str:
        return f"<orthoball.Filtration of {len(self)} simplices>"


class Region(NamedTuple):
    """A part of a shape."""

    volume: float
    """Of its cells, length^D."""
    area: float
    """Of its boundary, length^(D-1); singular facets count on both sides."""
    rows: NDArray[np.uint32]
    """(k,) its vertices, ascending."""
    cells: NDArray[np.uint32]
    """(c, D + 1) its cells, as rows."""
    betti: tuple[int, ...]
    """Components, tunnels and (in space) voids of the region alone."""


class ShapeEdits(NamedTuple):
    """What thresholds have done to a shape."""

    holes_filled: int
    """How many holes were not larger than the threshold."""
    volume_filled: float
    """Of those, length^D."""
    regions_dropped: int
    """How many regions were not larger than the threshold."""
    volume_dropped: float
    """Of those, length^D."""


class Nearest(NamedTuple):
    """The nearest points of a boundary."""

    points: NDArray[np.float64]
    """(n, D) where they are; 0 where there is no boundary."""
    distances: NDArray[np.float64]
    """(n,) how far away; infinity where there is no boundary."""
    simplices: NDArray[np.uint32]
    """(n, D) the simplices that they are on, as rows, filled up with NONE."""


class Located(NamedTuple):
    """Where points are with respect to a shape."""

    regions: NDArray[np.uint32]
    """(n,) numbers of regions from 1, in the order of `Shape.regions`; 0 outside the shape."""
    simplices: NDArray[np.uint32]
    """(n, D + 1) the simplices of the triangulation that hold the points, as rows, filled up with
    NONE; nothing but NONE outside the convex hull."""
    nearest: Nearest
    """The nearest points of the boundary."""

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `orthoball locate`, simplices as lists of rows; what
        there is not is missing."""
        import pandas

        def rows(simplices: NDArray[np.uint32]) -> list[list[int] | None]:
            return [[row for row in one if row != NONE] or None for one in simplices.tolist()]

        has_boundary = np.isfinite(self.nearest.distances)
        regions = pandas.array(self.regions, dtype="UInt32")
        regions[self.regions == 0] = pandas.NA
        columns = {
            "inside": self.regions > 0,
            "region": regions,
            "distance": np.where(has_boundary, self.nearest.distances, np.nan),
        }
        for axis, places in zip("xyz", self.nearest.points.T):
            columns[axis] = np.where(has_boundary, places, np.nan)
        columns["nearest"] = rows(self.nearest.simplices)
        columns["simplex"] = rows(self.simplices)
        return pandas.DataFrame(columns).rename_axis("row")


class PowerCells(NamedTuple):
    """Power (weighted Voronoi) cells, by row. Hidden points and duplicates have none."""

    rows: NDArray[np.uint32]
    """(k,) whose they are, ascending."""
    volumes: NDArray[np.float64]
    """(k,) length^D."""
    areas: NDArray[np.float64]
    """(k,) of the whole surface, length^(D-1)."""
    exposed_area: NDArray[np.float64]
    """(k,) of that, what is on the box or on the sphere."""
    facet_counts: NDArray[np.uint32]
    """(k,) neighbours with a facet in common."""
    are_clipped: NDArray[np.bool_]
    """(k,) whether the box or the ball cuts it."""
    surfaces: tuple[tuple[NDArray[np.float64], list[tuple[int, NDArray[np.uint32]]]], ...]
    """Of each cell (corners (c, D), facets): of a facet the row of the neighbour behind it, NONE on the
    box or the sphere, and its corners, counterclockwise seen from outside. Empty unless asked for."""


class OutlineCurve(NamedTuple):
    """A closed curve of the outline of disks, made of arcs; the disks are to its left."""

    rows: NDArray[np.uint32]
    """(k,) whose circle an arc is of."""
    arcs: NDArray[np.float64]
    """(k, 8) centre x and y, radius, from x and y, to x and y (lengths), and the angle that it turns by,
    counterclockwise, 0 to 2 pi."""


class NotableAlpha(NamedTuple):
    """An index that stands out."""

    name: str
    """One word: "all_vertices", "connected", "solid", ..."""
    reason: str
    """Half a sentence."""
    index: int | None
    """None where there is no such index."""
    alpha2: float
    """Its label, length^2; 0 where there is no index."""
    alpha: float
    """The signed root of alpha2, a length."""


class Signatures(Mapping[str, NDArray[Any]], Written):
    """Quantities as functions of the index: one row an index, columns as in a dict or as attributes.

    index, alpha2 (length^2), alpha, betti (n, D), euler, exterior, singular, regular, interior
    (n, D + 1: simplices by dimension in that role), volume (length^D; in the plane the area),
    area_singular, area_regular, area (length^(D-1); in the plane lengths; area counts singular facets
    twice), length (in space: sum of edge length x complementary angle).

    Of unions of balls: index, alpha2, alpha, betti, euler, volume, area.
    """

    def __init__(self, columns: dict[str, NDArray[Any]], file: Callable[[str], bytes]):
        self._columns, self._file = columns, file

    def to_bytes(self, format: str) -> bytes:
        """What `orthoball signatures` writes of these indices or alpha2: "csv", "json" or "npz"."""
        return self._file(format)

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def __getattr__(self, name: str) -> NDArray[Any]:
        columns = self.__dict__.get("_columns", {})  # empty while a copy is made
        if name in columns:
            return columns[name]
        raise AttributeError(f"signatures have no column {name!r}; they are {list(columns)}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `orthoball signatures`: betti_0, exterior_0, ..."""
        import pandas

        flat = {}
        for name, column in self.items():
            if column.ndim == 1:
                flat[name] = column
            else:
                flat.update({f"{name}_{k}": column[:, k] for k in range(column.shape[1])})
        return pandas.DataFrame(flat)

    def __repr__(self) -> str:
        return f"<orthoball.Signatures at {len(self['index'])} indices: {', '.join(self)}>"


@dataclass(frozen=True, eq=False)
class Solid(Written):
    """What a closed manifold has and lacks against the shape that it is near to: of `Shape.manifold`."""

    surface_count: int
    """Components of the boundary."""
    euler: int
    """Euler number of the boundary: 2 a sphere, 0 a torus."""
    added: float
    """Volume of cells that were added, length^D."""
    removed: float
    """Volume of cells that were removed, length^D."""
    changes: tuple[SolidChange, ...]
    """Place by place, the largest volume first."""
    offending: NDArray[np.uint32]
    """(k,) rows of the vertices at which the boundary of the shape's cells is no manifold."""
    offending_edges: int
    """In space: edges with more than two boundary triangles."""
    dropped: tuple[int, ...]
    """How many singular simplices were left out, by dimension 0 to D - 1."""
    _core: _core.OneSolid = field(repr=False)
    """The solid itself."""

    def to_bytes(self, format: str) -> bytes:
        """What `orthoball shape --manifold --changes` writes, "csv" or "json": changes, then the
        singular simplices that were left out."""
        return self._core.file(format)


class SolidChange(NamedTuple):
    """Cells joined through facets that were all added to a shape, or all removed from it."""

    is_added: bool
    """Or removed."""
    cell_count: int
    """How many cells."""
    volume: float
    """length^D."""
    centre: NDArray[np.float64]
    """(D,) the mean of their vertices."""
    rows: NDArray[np.uint32]
    """(k,) of their vertices, ascending."""
