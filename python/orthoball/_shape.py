# SPDX-License-Identifier: MIT
"""One alpha shape."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core, _exports
from ._arrays import as_points, fault
from ._files import Written
from ._tables import (
    NONE,
    Located,
    Nearest,
    Region,
    Role,
    ShapeEdits,
    Signatures,
    Solid,
    SolidChange,
)

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes


class Shape(Written):
    """The alpha shape at one index of the spectrum: made by `AlphaShapes.shape`.

    Vertices are named by their input rows in every array, so that `shapes.points[shape.triangles]`
    are corners. Found when first asked for, then kept.
    """

    _format_of_ending = {"json": "geojson"}

    def __init__(
        self,
        shapes: AlphaShapes,
        index: int,
        alpha2: float,
        regularized: bool,
        hole_threshold: float | None,
        region_threshold: float | None,
        region: int | None,
    ):
        self._shapes = shapes
        self._index, self._alpha2, self._regularized = index, alpha2, regularized
        self._parts = (hole_threshold, region_threshold, region)
        self._solid: Solid | None = None
        if region is not None and not 1 <= region < NONE:
            raise fault(f"there is no region {region}; regions are numbered from 1")
        self._core: _core.OneShape = _core.edited(
            shapes._core, index, alpha2, regularized, hole_threshold, region_threshold, region or 0
        )

    def __repr__(self) -> str:
        solid = "solid part of the " if self.regularized else ""
        solid = "parts of the " + solid if self._parts != (None, None, None) else solid
        solid = "closed manifold near the " + solid if self._solid is not None else solid
        return (
            f"<orthoball.Shape: {solid}shape at index {self.index}, alpha2 {self.alpha2}, "
            f"of {self.shapes.site_count} sites>"
        )

    @property
    def shapes(self) -> AlphaShapes:
        """The family that it is one of."""
        return self._shapes

    @property
    def index(self) -> int:
        """Its index of the spectrum; 0 for the empty shape."""
        return self._index

    @property
    def alpha2(self) -> float:
        """The alpha2 that was asked for, length^2."""
        return self._alpha2

    @property
    def alpha(self) -> float:
        """Its signed root, a length."""
        return float(np.copysign(np.sqrt(abs(self._alpha2)), self._alpha2))

    @property
    def regularized(self) -> bool:
        """Whether singular simplices are left out."""
        return self._regularized

    @property
    def edits(self) -> ShapeEdits:
        """How many holes were filled and regions left out by thresholds."""
        return ShapeEdits(**self._core.edits)

    def manifold(self) -> Shape:
        """The shape nearest to this one that is a solid with a closed manifold as its boundary, to be
        printed or meshed: cells are added or removed where two sheets of the boundary meet in an edge
        or a vertex, as little volume as a local search finds; singular simplices are left out. In
        `solid` of the result is what was changed.

        A manifold: exact, always. Vertices are rows of the input, none is there twice. Without cells
        where the shape has none.
        """
        core = _core.manifold_solid(self._core)
        closed = object.__new__(Shape)
        closed._shapes, closed._index, closed._alpha2 = self._shapes, self._index, self._alpha2
        closed._regularized, closed._parts, closed._core = True, self._parts, core.shape
        facts = core.facts
        changes = tuple(SolidChange(**change) for change in facts.pop("changes"))
        closed._solid = Solid(changes=changes, _core=core, **facts)
        return closed

    @property
    def solid(self) -> Solid | None:
        """Of what `manifold` gives: what was changed. None of other shapes."""
        return self._solid

    # What it is made of.

    @cached_property
    def _boundary(self) -> dict[str, Any]:
        return _core.boundary(self._core)

    def _rows(self, name: str) -> NDArray[np.uint32]:
        rows = self._boundary["rows"][self._boundary[name]]
        rows.flags.writeable = False
        return rows

    @cached_property
    def cells(self) -> NDArray[np.uint32]:
        """(k, D + 1) the tetrahedra, in the plane the triangles, of the shape: positively oriented."""
        return _core.cells(self._core)

    @cached_property
    def triangles(self) -> NDArray[np.uint32]:
        """(k, 3) In space the triangles of the boundary: the regular ones, counterclockwise seen from
        outside, then the singular ones. In the plane the triangles that fill the shape."""
        return self.cells if self._shapes.dimension == 2 else self._rows("triangles")

    @cached_property
    def triangle_roles(self) -> NDArray[np.uint8]:
        """(k,) of the triangles: Role.regular or Role.singular; in the plane Role.interior."""
        if self._shapes.dimension == 2:
            return np.full(len(self.cells), Role.interior, dtype=np.uint8)
        return self._boundary["triangle_roles"]

    @cached_property
    def edges(self) -> NDArray[np.uint32]:
        """(k, 2) In space the singular edges. In the plane the edges of the boundary, regular ones
        with the inside on their left."""
        return self._rows("edges")

    @property
    def edge_roles(self) -> NDArray[np.uint8]:
        """(k,) of the edges: Role.singular; in the plane also Role.regular."""
        return self._boundary["edge_roles"]

    @cached_property
    def vertices(self) -> NDArray[np.uint32]:
        """(k,) the singular vertices, which belong to no edge of the complex."""
        return self._rows("vertices")

    @cached_property
    def rows(self) -> NDArray[np.uint32]:
        """(k,) all rows that occur in triangles of the boundary, edges and vertices."""
        return self._boundary["rows"]

    # Numbers.

    @cached_property
    def signature(self) -> Signatures:
        """Everything that is counted and measured of the alpha complex at its index, whatever was
        left out or filled of it: one row."""
        return self._shapes.signatures_at(index=[self._index])

    @cached_property
    def _measures(self) -> tuple[float, float, tuple[int, ...]]:
        return _core.measures(self._core)

    @property
    def volume(self) -> float:
        """Of its cells, length^D: in the plane the area."""
        return float(self.signature["volume"][0]) if self._is_whole else self._measures[0]

    @property
    def area(self) -> float:
        """Of its boundary, length^(D-1): in the plane the perimeter. Singular facets have two sides,
        and both count; they have none in a regularized shape."""
        if not self._is_whole:
            return self._measures[1]
        return float(self.signature["area_regular" if self._regularized else "area"][0])

    @property
    def betti(self) -> tuple[int, ...]:
        """Components, tunnels and (in space) voids of the shape."""
        if self._is_whole and not self._regularized:
            return self._shapes.betti(index=self._index)
        return self._measures[2]

    @property
    def _is_whole(self) -> bool:
        return self._parts == (None, None, None) and self._solid is None

    # What is where.

    def regions(self, joined_by: str | None = None) -> tuple[Region, ...]:
        """Its parts, the largest volume first; equal ones by area, then by the lowest row.

        Args:
            joined_by: "vertices": the components of the shape, with their singular simplices.
                "cells": its cells, those with a common vertex in one. "facets": its cells, those with
                a common facet in one. By default "vertices".
        """
        return tuple(Region(**one) for one in _core.regions(self._core, joined_by or "vertices"))

    def holes(self) -> tuple[Region, ...]:
        """The bounded components of what is around it, in the same order: in space its voids, in the
        plane its holes. Their cells are outside the shape, their rows the vertices of the shape
        around, their area that of the shape around. No Betti numbers: all are 0."""
        return tuple(Region(**one) for one in _core.holes(self._core))

    def contains(self, points: Any) -> NDArray[np.bool_]:
        """(n,) whether points are in the shape, which is closed. Exact.

        Args:
            points: (n, D), as in `AlphaShapes.enters_at`.
        """
        return _core.contains(self._core, as_points(points), self._shapes._threads)

    def locate(self, points: Any) -> Located:
        """Where points are: in which region, in which simplex, and what of the boundary is nearest.

        Args:
            points: (n, D), as in `AlphaShapes.enters_at`.
        """
        found = _core.locate(self._core, as_points(points), self._shapes._threads)
        return Located(found[0], found[1], Nearest(*found[2:]))

    def nearest(self, points: Any) -> Nearest:
        """The nearest point of the boundary to each of some points, inside or outside.

        The boundary are the regular facets and, but for a regularized shape, all that is singular.
        Computed in doubles, by a tree of boxes.

        Args:
            points: (n, D).
        """
        return Nearest(*_core.nearest(self._core, as_points(points), self._shapes._threads))

    # As objects of other packages, which must be installed, and as files.

    def to_trimesh(self) -> Any:
        """The triangles of the boundary as a trimesh.Trimesh; vertex attribute `row`.

        Raises InputError in the plane.
        """
        return _exports.to_trimesh(self)

    def to_pyvista(self) -> Any:
        """The boundary as a pyvista.PolyData with vertices, lines and triangles; point data `row`,
        cell data `role`."""
        return _exports.to_pyvista(self)

    def to_meshio(self) -> Any:
        """The boundary as a meshio.Mesh with vertices, lines and triangles; point data `row`, cell
        data `role`."""
        return _exports.to_meshio(self)

    def to_shapely(self) -> Any:
        """In the plane: the interior as a shapely.MultiPolygon with holes. Singular edges and
        vertices, which have no inside, are in `to_geojson`.

        Raises InputError in space.
        """
        return _exports.to_shapely(self)

    def to_geojson(self) -> dict[str, Any]:
        """In the plane: a GeoJSON FeatureCollection; coordinates are those of the input.

        The interior is one MultiPolygon, each singular edge a LineString, each singular vertex a
        Point; properties `role` and the input rows. Raises InputError in space.
        """
        return json.loads(self.to_bytes("geojson"))

    def to_bytes(self, format: str, *, roles: bool = False) -> bytes:
        """The boundary as the bytes of a file: ply, obj, off, stl, vtu, glb, in the plane geojson, svg.

        Args:
            roles: mark every simplex as singular or regular, where the format can.
        """
        return _core.file_bytes(self._core, format, roles)

    def plot(self, *, ax: Any = None) -> Any:
        """Draws the shape with matplotlib. Returns the axes."""
        from ._plots import plot_shape

        return plot_shape(self, ax)
