# SPDX-License-Identifier: MIT
"""Weights made from the data: from density, and such that hold given simplices."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import as_threads, fault
from ._files import Written
from ._points import points_of
from ._tables import NONE

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes


def density_weights(
    points: Any, neighbours: int, *, threads: int | None = None
) -> NDArray[np.float64]:
    """(n,) weights from the density of points, lengths^2: large where they are sparse, small where
    they are dense, so that one alpha2, 0 at first, serves them all.

    Half the mean square distance to the nearest others; it has no scale of its own, and hides no
    point. `AlphaShapes(points, weights="density:K")` takes these weights; of a Reading, whose
    numbers are decimals, they are rounded to decimals there.

    Args:
        points: what AlphaShapes takes.
        neighbours: K, how many others, from 1; 8 to 16 for points in rows or on a lattice, 20 to 40
            for such that are scattered at random.
        threads: at most so many are used; by default one for each core.

    Raises:
        InputError: unless there are more than K positions (or no point at all).

    After Chazal, Cohen-Steiner and Mérigot, Geometric inference for probability measures, 2011.
    """
    threads = as_threads(threads)
    if isinstance(neighbours, str) or int(neighbours) != neighbours or not 0 < neighbours < 2**32:
        raise fault(f"the neighbours are {neighbours}; they are a whole number from 1")
    if isinstance(points, _core.Reading):
        weights = _core.with_density_weights(points, neighbours, threads).weights
        return np.zeros(0) if weights is None else weights
    return _core.density_weights(points_of(points), neighbours, threads)


class ConflictError(_core.InputError):
    """No weights hold some simplices together, though all but any one of them can be held."""

    simplices: list[int]
    """The numbers of these among those that were given."""

    def __init__(self, given: Sequence[Sequence[int]], conflict: list[int]):
        names = (f"{number} ({' '.join(map(str, given[number]))})" for number in conflict)
        super().__init__(
            f"no weights hold these simplices together: {', '.join(names)}; leave out one of them, "
            "or add_sites"
        )
        self.reason, self.row = "wrong_argument", None
        self.simplices = conflict


def simplices_of(given: Any, shapes: AlphaShapes) -> list[list[int]]:
    """The ascending rows of simplices: given as sequences of rows, or as a file that lists them."""
    if isinstance(given, (str, os.PathLike)):
        return _core.read_simplices(os.fspath(given), shapes._core)
    if not isinstance(given, Iterable):
        raise fault("simplices are sequences of rows, or the path of a file that lists them")
    return [_rows_of(simplex, number) for number, simplex in enumerate(given)]


def _rows_of(simplex: Any, number: int) -> list[int]:
    array = np.asarray(simplex)
    is_list = array.ndim == 1 and array.dtype.kind in "iu" and len(array) > 0
    if is_list and 0 <= array.min() and array.max() < NONE:
        return sorted(array.tolist())
    error = fault(f"simplex {number}: it is {simplex!r}; a simplex is a sequence of rows, from 0")
    error.row = number
    raise error


class EnforcedWeights(Written):
    """Points with weights that hold given simplices: made by `AlphaShapes.enforce`."""

    def __init__(self, core: _core.Enforced, threads: int | None):
        self._core, self._threads = core, threads

    def __repr__(self) -> str:
        return (
            f"<orthoball.EnforcedWeights: {len(self.changed)} of "
            f"{len(self.points) - len(self.added)} weights changed, by {self.total_change} in total, "
            f"{len(self.added)} sites added>"
        )

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """(n, D) coordinates by row: those that were given, then added sites."""
        return self._core.points

    @cached_property
    def weights(self) -> NDArray[np.float64] | None:
        """(n,) weights by row, signed squared lengths; None where there are none and none is needed."""
        return self._core.weights

    @property
    def changed(self) -> NDArray[np.uint32]:
        """(k,) ascending rows whose weight is another now."""
        return self._core.changed

    @property
    def hidden(self) -> NDArray[np.uint32]:
        """(k,) ascending rows that are hidden now and were not."""
        return self._core.hidden

    @property
    def total_change(self) -> float:
        """The sum of what all weights have changed by, length^2: the least, to about 1e-4 of it."""
        return self._core.total_change

    @property
    def added(self) -> NDArray[np.uint32]:
        """(k,) the rows of added sites, the last ones."""
        size = len(self.points)
        return np.arange(size - self._core.added, size, dtype=np.uint32)

    @property
    def parts(self) -> list[list[int]]:
        """The simplices that are held, as rows: those that were given, or what added sites make of
        them."""
        return self._core.parts

    @property
    def part_of(self) -> list[int]:
        """Of each part the number of the given simplex that it is a part of."""
        return self._core.part_of

    @cached_property
    def shapes(self) -> AlphaShapes:
        """The alpha shapes of these points with these weights, exactly as they are."""
        from ._alpha_shapes import AlphaShapes

        return AlphaShapes._of(self._core.shapes(self._threads), self._threads)

    def to_bytes(self, format: str = "csv") -> bytes:
        """The points as a table, "csv", with the columns x, y[, z] and weight or radius, as
        `orthoball enforce` writes it."""
        if format != "csv":
            raise fault(f"{format!r} is no format of points; there is csv")
        return self._core.file()
