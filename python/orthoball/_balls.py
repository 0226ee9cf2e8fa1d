# SPDX-License-Identifier: MIT
"""Unions of balls."""

from __future__ import annotations

import json
import os
import warnings
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import as_column, fault
from ._files import ending_of, write_whole
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

    def __init__(self, shapes: AlphaShapes, index: int, alpha2: float, probe: float):
        self._shapes, self._index, self._alpha2, self._probe = shapes, index, alpha2, probe
        self._union = self._measured(False, False)

    def _measured(self, contacts: bool, derivatives: bool) -> _core.UnionOfBalls:
        core = self._shapes._core
        return _core.union_of_balls(
            core, self._index, self._alpha2, contacts, derivatives, self._shapes._threads
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
            tolerance: the largest distance of such a surface from the sphere, by its radius; from
                0.0001 to 0.5.
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
            raise fault(f'the style is {style!r}; it is "colour" or "print"')
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

    def to_bytes(self, what: str, format: str, *, tolerance: float = 0.02) -> bytes:
        """What `orthoball measure` and `orthoball pockets` write.

        Args:
            what: "per_atom", "per_residue", "contacts", "residue_contacts", "derivatives": tables;
                "voids", "pockets"; "cells", the power cells in their balls.
            format: "csv" or "json"; of voids and pockets also "ply", their boundaries, and of
                molecules in space "pml" or "cxc", a script in which PyMOL or ChimeraX shows them; of
                cells also "vtu" or "obj".
            tolerance: of cells in "vtu" and "obj", as in `power_cells`.

        Names of chains, residues and atoms are those of the Reading that the shapes are of. Raises
        InputError for another name or format, and for tables of residues where none are named.
        """
        return self._file(what, format, None, tolerance)

    def write(self, what: str, path: str | os.PathLike[str], *, tolerance: float = 0.02) -> None:
        """Writes what `to_bytes` gives to a file, the format told by its name. The file appears whole
        or not at all."""
        write_whole(path, self._file(what, ending_of(path), os.fspath(path), tolerance))

    def to_pandas(self, what: str = "per_atom") -> Any:
        """One of the tables of `to_bytes` as a pandas DataFrame."""
        import pandas

        return pandas.DataFrame(json.loads(self.to_bytes(what, "json")))

    def pdb(self, values: ArrayLike | None = None) -> bytes:
        """The atoms as a PDB file, a row a record, with a value of each in the column of the B-factor.

        Args:
            values: (n,); by default the areas.

        Warns of values beyond -99.99 to 999.99, for which the nearest stand, and of names that are
        cut. Raises LimitError for coordinates that its columns do not hold.
        """
        shapes = self._shapes
        column = self.areas if values is None else as_column(values, shapes.site_count, "values")
        content, cut_values, cut_labels = _core.pdb_file(shapes._core, column, shapes._reading)
        if cut_values:
            warnings.warn(f"{cut_values} values beyond what a B-factor can be", stacklevel=2)
        if cut_labels:
            warnings.warn(f"{cut_labels} names longer than their columns", stacklevel=2)
        return content

    def write_pdb(self, path: str | os.PathLike[str], values: ArrayLike | None = None) -> None:
        """Writes what `pdb` gives to a file, which appears whole or not at all."""
        write_whole(path, self.pdb(values))

    def _file(self, what: str, format: str, path: str | None, tolerance: float) -> bytes:
        shapes = self._shapes
        core, reading, threads = shapes._core, shapes._reading, shapes._threads
        if what in _TABLES:
            union = self._measured(what.endswith("contacts"), what == "derivatives")
            return _core.ball_file(core, union, reading, what, format)
        if what == "cells":
            union = self._measured(True, False)
            return _core.power_cell_file(core, union, None, tolerance, reading, format, threads)
        if what not in ("voids", "pockets"):
            raise fault(
                f"{what!r} is no table; there are {', '.join(_TABLES)}, voids, pockets, cells"
            )
        write = _core.voids_file if what == "voids" else _core.pockets_file
        molecule = _molecule(reading, path) if format in ("pml", "cxc") else ""
        return write(core, self._union, reading, format, self._probe, molecule, threads)

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


_TABLES = ("per_atom", "per_residue", "contacts", "residue_contacts", "derivatives")


def _molecule(reading: _core.Reading | None, script: str | None) -> str:
    """The file of a molecule, from the folder of a script."""
    if (
        reading is None
        or reading.format not in ("pdb", "cif", "pqr", "xyz")
        or reading.dimension != 3
    ):
        raise fault(
            "a viewer opens the input itself, which must be a PDB, mmCIF, PQR or XYZ file that was read; "
            '"ply" shows those of any points'
        )
    if script is None or os.path.isabs(reading.file):
        return reading.file
    return os.path.relpath(reading.file, os.path.dirname(os.path.abspath(script)))
