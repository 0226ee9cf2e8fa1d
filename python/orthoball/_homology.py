# SPDX-License-Identifier: MIT
"""Persistent homology: diagrams, and what makes their classes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import fault
from ._files import Written

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes


class Representative(NamedTuple):
    """What makes a class, in the complex of one index of its life."""

    dimension: int
    """0 of a component, 1 of a tunnel (in the plane: hole), 2 of a void."""
    birth: float
    """alpha2 from which on it lives, length^2."""
    death: float
    """alpha2 at which it is no more; infinity for never."""
    index: int
    """Of the spectrum, where it is shown."""
    alpha2: float
    """Of that index, length^2."""
    rows: NDArray[np.uint32]
    """(k,) ascending: of a component all its vertices, else those of the cycle."""
    cycle: NDArray[np.uint32]
    """(c, dimension + 1) simplices, as rows: the vertex that a component began with, a cycle of edges
    around a tunnel, the facets that enclose a void."""
    rings: tuple[NDArray[np.uint32], ...]
    """Of a cycle of edges the rings that it consists of, each the rows that it passes."""
    cells: NDArray[np.uint32]
    """(v, D + 1) of a void (in the plane: hole) the cells in it, as rows."""
    size: float
    """Of the cycle: its length, of a void its area; 0 of a component."""
    volume: float
    """Of the cells, length^D."""
    birth_simplex: NDArray[np.uint32]
    """(dimension + 1,) rows of the simplex that closed the first cycle."""
    death_simplex: NDArray[np.uint32] | None
    """(dimension + 2,) rows of the simplex that fills the last one: of a tunnel the triangle. None
    where nothing does."""


class Representatives(tuple[Representative, ...], Written):
    """What makes some classes, by dimension, then by birth."""

    _found: _core.FoundRepresentatives

    def __new__(cls, found: _core.FoundRepresentatives) -> Representatives:
        self = super().__new__(cls, (Representative(**one) for one in found.list()))
        self._found = found
        return self

    def to_bytes(self, format: str) -> bytes:
        """What `orthoball persistence --representatives` writes: "json" or "ply"."""
        return self._found.file(format)

    def __repr__(self) -> str:
        return f"<orthoball.Representatives of {len(self)} classes>"


class _Classes(Written):
    """What the diagram of one dimension and all of them have in common."""

    _format_of_ending = {"pers": "gudhi"}
    _shapes: AlphaShapes
    _pairs: _core.PersistencePairs
    _only: int | None

    def to_bytes(self, format: str, *, indices: bool = False) -> bytes:
        """What `orthoball persistence` writes: "csv", "json" or "gudhi", its lines "2 dimension birth
        death".

        Args:
            indices: births and deaths as indices of the spectrum instead of alpha2.
        """
        return self._pairs.file(self._only, format, indices)

    def figure(
        self, kind: str = "diagram", *, axis: str = "alpha", title: str | None = None
    ) -> bytes:
        """The picture that `orthoball persistence --plot` makes, as SVG.

        Args:
            kind: "diagram", a point for each class, or "barcode", a bar for each.
            axis: "alpha", "alpha2" or "index".
            title: above; by default the name of the file that was read.
        """
        text = self._shapes._picture_text(title)
        return self._pairs.figure(self._only, kind, axis, *text)

    def representatives(
        self, alpha2: float | str | None = None, *, index: int | None = None
    ) -> Representatives:
        """What makes each class that lives at one alpha2 (length^2) or index, there.

        Without any: of all classes, components where they have most vertices, tunnels half way
        through their lives, voids at their birth. Components and voids are exact; the cycle of a
        tunnel is born and dies with it, and short as far as a search goes. After Busaryev, Cabello,
        Chen, Dey and Wang, Annotating simplices with a homology basis, 2012.
        """
        return self._found(None, alpha2, index)

    def _found(
        self, number: int | None, alpha2: float | str | None, index: int | None
    ) -> Representatives:
        if alpha2 is not None or index is not None:
            index, _ = self._shapes._chosen(alpha2, None, None, index)
        threads = self._shapes._threads
        return Representatives(self._pairs.representatives(self._only, number, index, threads))


@dataclass(frozen=True, eq=False)
class Diagram(_Classes):
    """The persistent homology of one dimension over Z/2: when its classes are born and die.

    NumPy takes it as the array `alpha2`.
    """

    dimension: int
    """0 for components, 1 for tunnels (in the plane: holes), 2 for voids."""
    alpha2: NDArray[np.float64]
    """(n, 2) birth and death, length^2; infinity for never."""
    index: NDArray[np.uint32]
    """(n, 2) the same as indices of the spectrum; its size plus 1 for never."""
    births: NDArray[np.uint32]
    """(n, dimension + 1) the simplices that close the cycles, as rows."""
    deaths: NDArray[np.uint32]
    """(n, dimension + 2) the simplices that fill them, as rows; NONE where nothing does."""
    _shapes: AlphaShapes = field(repr=False)
    """The family whose it is."""
    _pairs: _core.PersistencePairs = field(repr=False)
    """Those of all dimensions."""

    @property
    def _only(self) -> int | None:  # type: ignore[override]
        return self.dimension

    def representative(
        self, number: int, alpha2: float | str | None = None, *, index: int | None = None
    ) -> Representative:
        """What makes one class, row `number` of `alpha2`; see `representatives`.

        Raises InputError where it does not live at that alpha2 or index.
        """
        if not 0 <= number < len(self):
            raise fault(
                f"there is no class {number}; classes are numbered from 0 to {len(self) - 1}"
            )
        return self._found(number, alpha2, index)[0]

    def __len__(self) -> int:
        return len(self.alpha2)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[np.float64]:
        array = self.alpha2 if dtype is None else self.alpha2.astype(dtype, copy=False)
        return array.copy() if copy else array

    def __repr__(self) -> str:
        return f"<orthoball.Diagram of dimension {self.dimension}: {len(self)} classes>"


class Diagrams(tuple[Diagram, ...], _Classes):
    """The diagrams of all dimensions 0 to D - 1."""

    _only = None

    def __new__(cls, shapes: AlphaShapes, pairs: _core.PersistencePairs) -> Diagrams:
        diagrams = (Diagram(k, *pairs.arrays(k), shapes, pairs) for k in range(shapes.dimension))
        self = super().__new__(cls, diagrams)
        self._shapes, self._pairs = shapes, pairs
        return self

    def __repr__(self) -> str:
        return f"<orthoball.Diagrams: {', '.join(str(len(one)) for one in self)} classes>"
