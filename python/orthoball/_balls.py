# SPDX-License-Identifier: MIT
"""Unions of balls."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._tables import OutlineCurve, PowerCells

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes


class Contacts(NamedTuple):
    """Pairs of balls that touch: the common facets of their power cells inside the union."""

    rows: NDArray[np.uint32]
    """(k, 2) ascending rows."""
    area: NDArray[np.float64]
    """(k,) of the facet, length^2; in the plane its length."""
    exposed_length: NDArray[np.float64]
    """(k,) length of their circle on the surface; in the plane the number of their points there."""


class Derivatives(NamedTuple):
    """How volume and area change with single balls. That of the volume by a radius is the area."""

    area_by_radius: NDArray[np.float64]
    """(n,) length^(D-2)."""
    volume_by_centre: NDArray[np.float64]
    """(n, D) length^(D-1)."""
    area_by_centre: NDArray[np.float64]
    """(n, D) length^(D-2)."""


class MolecularSurface(NamedTuple):
    """The solvent-excluded body and its surface: what a probe that rolls on the balls cannot reach."""

    probe: float
    """Its radius, a length."""
    volume: float
    """Of the body, length^3."""
    area: float
    """The sum of the three below, length^2."""
    convex_area: float
    """Where the probe touches one ball."""
    toroidal_area: float
    """Where it rolls on two."""
    concave_area: float
    """Where it rests on three."""


class Void(NamedTuple):
    """A bounded component of the complement; in the plane a hole."""

    volume: float
    """length^D."""
    area: float
    """length^(D-1)."""
    rows: NDArray[np.uint32]
    """(k,) the balls around it, ascending."""
    areas: NDArray[np.float64]
    """(k,) how much of their surface is in it."""
    cells: NDArray[np.uint32]
    """(c, D + 1) the cells of the triangulation that it lies in, as rows."""
    born: int
    """Index of the spectrum at which it closes."""
    dies: int
    """Index at which it is filled."""
    born_alpha2: float
    """length^2."""
    dies_alpha2: float
    """length^2."""
    largest_ball_centre: NDArray[np.float64]
    """(D,) of the largest ball found inside."""
    largest_ball_radius: float
    """0 where none was found."""


class Mouth(NamedTuple):
    """Where a pocket opens to the outside."""

    area: float
    """Outside the balls, length^(D-1)."""
    rim: NDArray[np.uint32]
    """(k,) the balls at its corners, ascending rows."""
    facets: NDArray[np.uint32]
    """(f, D) its facets, as rows."""


class Pocket(NamedTuple):
    """A part of the space outside that widens before it comes to the outside: by the number of its
    mouths a void (none), a pocket (one) or a channel (more)."""

    volume: float
    """length^D; with mouths it includes parts of balls that reach through them."""
    area: float
    """length^(D-1)."""
    rows: NDArray[np.uint32]
    """(k,) the balls around it, ascending."""
    areas: NDArray[np.float64]
    """(k,) how much of their surface is in it."""
    cells: NDArray[np.uint32]
    """(c, D + 1) the cells of the triangulation that it lies in, as rows."""
    mouths: tuple[Mouth, ...]
    """The largest first."""
    depth: float | None
    """How much balls must grow to fill it after its mouths have closed, length^2; None without
    mouths."""


class Balls:
    """The union of balls of squared radius weight + alpha2: made by `AlphaShapes.balls`.

    Measures are closed forms, by Edelsbrunner, The union of balls and its dual shape, Discrete &
    Computational Geometry 13, 1995; in the plane `volume` is the area and `area` the perimeter.
    """

    def __init__(self, shapes: AlphaShapes, alpha2: float, probe: float):
        self._shapes, self._alpha2, self._probe = shapes, alpha2, probe
        self._union = self._measured(False, False)

    def _measured(self, contacts: bool, derivatives: bool) -> _core.UnionOfBalls:
        core = self._shapes._core
        index = core.index(self._alpha2)
        return _core.union_of_balls(
            core, index, self._alpha2, contacts, derivatives, self._shapes._threads
        )

    def __repr__(self) -> str:
        return (
            f"<orthoball.Balls: {self.shapes.site_count} balls at alpha2 {self.alpha2}, probe "
            f"{self.probe}: volume {self.volume}, area {self.area}>"
        )

    @property
    def shapes(self) -> AlphaShapes:
        """The alpha shapes of the balls, grown by the probe."""
        return self._shapes

    @property
    def alpha2(self) -> float:
        """length^2."""
        return self._alpha2

    @property
    def probe(self) -> float:
        """Radius of the probe, a length."""
        return self._probe

    @property
    def index(self) -> int:
        """Index of the spectrum of `shapes` whose complex is dual to the union."""
        return self._union.index

    @property
    def volume(self) -> float:
        """length^D."""
        return self._union.volume

    @property
    def area(self) -> float:
        """Of the surface, voids included, length^(D-1)."""
        return self._union.area

    @property
    def mean_curvature(self) -> float | None:
        """Integral over the surface of the mean of the principal curvatures, a length; None in the
        plane."""
        return self._union.mean_curvature if self._shapes.dimension == 3 else None

    @property
    def euler(self) -> int:
        """Euler number of the union."""
        return self._union.euler

    @property
    def volumes(self) -> NDArray[np.float64]:
        """(n,) what the power cell of each ball holds of the union; they add up to the volume. A view."""
        return self._union.volumes

    @property
    def areas(self) -> NDArray[np.float64]:
        """(n,) what is on the surface of each ball; they add up to the area. A view."""
        return self._union.areas

    @property
    def betti(self) -> tuple[int, ...]:
        """Components, tunnels and (in space) voids of the union."""
        return self._shapes.betti(index=self.index)

    @cached_property
    def contacts(self) -> Contacts:
        """Pairs of balls that touch, by rows."""
        return Contacts(*self._measured(True, False).contacts())

    @cached_property
    def derivatives(self) -> Derivatives:
        """How volume and area change with every radius and centre."""
        return Derivatives(*self._measured(False, True).derivatives())

    @cached_property
    def voids(self) -> tuple[Void, ...]:
        """The largest first. As many as the last Betti number says."""
        return tuple(Void(**found) for found in self._free(_core.voids, False))

    @cached_property
    def pockets(self) -> tuple[Pocket, ...]:
        """Voids, pockets and channels, the largest first; by Edelsbrunner, Facello and Liang, 1998."""
        return tuple(
            Pocket(**{**found, "mouths": tuple(Mouth(**mouth) for mouth in found["mouths"])})
            for found in self._free(_core.pockets)
        )

    def _free(self, find: Any, *options: Any) -> Any:
        return find(self._shapes._core, self.index, self._alpha2, *options, self._shapes._threads)

    def power_cells(self, *, surfaces: bool = False, tolerance: float = 0.02) -> PowerCells:
        """The power cells of the balls that are not empty, cut by their balls: what each has of the
        union.

        Args:
            surfaces: also corners and facets of every cell.
            tolerance: the largest distance of such a surface from the sphere, by its radius.
        """
        union = self._measured(True, False)
        return PowerCells(
            **_core.power_cells_in_balls(
                self._shapes._core, union, surfaces, tolerance, self._shapes._threads
            )
        )

    def outline(self) -> tuple[OutlineCurve, ...]:
        """In the plane: the outline of the disks as closed curves, outer ones counterclockwise, around
        holes clockwise.

        Raises InputError in space.
        """
        curves = _core.outline(self._shapes._core, self.index, self._alpha2)
        return tuple(OutlineCurve(*curve) for curve in curves)

    def figure(
        self,
        *panels: str,
        style: str = "colour",
        legend: bool = True,
        title: str = "",
    ) -> bytes:
        """In the plane: the disks and their union, its parts and the dual complex as SVG, circles as
        exact arcs.

        Args:
            panels: some of "disks", "cells", "complex", from left to right; by default all.
            style: "colour" or "print", in black, white and grey.
            legend: title, captions and legend around the panels.
            title: above.

        Raises InputError in space.
        """
        if style not in ("colour", "print"):
            raise _core.InputError(f'the style is {style!r}; it is "colour" or "print"')
        wanted = list(panels or ("disks", "cells", "complex"))
        return _core.figure(
            self._shapes._core,
            self.index,
            self._alpha2,
            wanted,
            style == "print",
            legend,
            title,
        )

    @cached_property
    def molecular_surface(self) -> MolecularSurface:
        """The molecular (solvent-excluded) surface under the probe, after Connolly, 1983. With a
        probe of 0 that of the union.

        Raises InputError in the plane.
        """
        measures = _core.molecular_surface(
            self._shapes._core, self._union, self._probe, self._shapes._threads
        )
        return MolecularSurface(**measures)
