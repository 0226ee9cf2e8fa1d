# SPDX-License-Identifier: MIT
"""The one object that everything else is asked of."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import as_float64, as_points
from ._balls import Balls
from ._points import sites_of
from ._shape import Shape
from ._tables import Diagram, Filtration, NotableAlpha, PowerCells, Signatures, Simplices
from ._view import View, is_notebook


class AlphaShapes:
    """All alpha shapes of weighted points in the plane or in space.

    Exact: the triangulation, which simplex enters when, and which values are equal are decided on
    the numbers as they are given; alpha2 are the doubles nearest to the exact values. The shapes
    depend on the set of points alone, not on their order or the number of threads. Any number of
    points is right, also none, equal ones and such that lie in a plane or on a line.

    Once built, an object does not change, and any number of threads may use it.

    Args:
        points: an array of shape (n, 2) or (n, 3): float64, float32 or integers of at most 2^53. Or
            a Reading of `orthoball.read`; or an object of another package: a Universe or AtomGroup
            of MDAnalysis, a Structure of Biopython or gemmi, Atoms of ASE, a mesh or cloud of
            trimesh, Open3D or PyVista, a DataFrame of pandas with columns x, y[, z], or points of
            GeoPandas.
        weights: one signed squared length a point; of a DataFrame also a column's name.
        radii: instead of weights one radius r a point (or one for all), standing for the weight r^2,
            -r^2 where r is negative; of a DataFrame also a column's name. Atoms of an object have
            the radii of the set "bondi" unless another is named ("alvarez", "protor", "none", or a
            file of radii) or an array given.
        threads: at most so many are used; by default one for each core. Building releases the GIL.

    Raises:
        InputError: (a ValueError) for NaN and infinity, a wrong shape or type, an element without
            radius; names the row.
        LimitError: (a ValueError) for more than memory can hold.

    The method is that of Edelsbrunner and Mücke, Three-dimensional alpha shapes, ACM Transactions on
    Graphics 13, 1994.
    """

    def __init__(
        self,
        points: Any,
        weights: ArrayLike | str | None = None,
        *,
        radii: ArrayLike | str | None = None,
        threads: int | None = None,
    ):
        self._threads = threads
        self._reading = None
        if isinstance(points, _core.Reading) and weights is None and radii is None:
            self._core = _core.AlphaShapes(points, threads)
            self._is_molecule = points.is_molecule
            self._reading = points
            return
        if isinstance(points, _core.Reading):
            points = points.points
        sites = sites_of(points, weights, radii)
        column = sites.weights if sites.radii is None else sites.radii
        self._core = _core.AlphaShapes(sites.points, column, sites.radii is not None, threads)
        self._is_molecule = sites.is_molecule

    def __repr__(self) -> str:
        return repr(self._core)

    # What was given.

    @property
    def dimension(self) -> int:
        """2 for points in the plane, 3 for points in space."""
        return self._core.dimension

    @property
    def affine_dimension(self) -> int:
        """That of the sites' affine hull: less than `dimension` where all lie in a plane or on a
        line; -1 without points."""
        return self._core.affine_dimension

    @property
    def site_count(self) -> int:
        """How many points were given."""
        return self._core.site_count

    @property
    def decimals(self) -> int | None:
        """k where every number is a whole number of 10^-k exactly, as a file's text says; else None."""
        return self._core.decimals

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """(n, D) coordinates by row."""
        return self._core.points

    @cached_property
    def weights(self) -> NDArray[np.float64] | None:
        """(n,) weights by row, signed squared lengths; None where there are none."""
        return self._core.weights

    @property
    def hidden(self) -> NDArray[np.uint32]:
        """(k,) ascending rows whose power cell is empty: balls so far inside others that they change
        nothing. A view."""
        return self._core.hidden

    @property
    def duplicates(self) -> NDArray[np.uint32]:
        """(k, 2) rows that are equal to an earlier one, and that one. A view."""
        return self._core.duplicates

    # The family.

    @property
    def spectrum(self) -> NDArray[np.float64]:
        """(s,) the distinct alpha2 at which the shape changes, length^2, never decreasing; that of
        index i is spectrum[i - 1]. A view.

        Two entries may share a double: the exact values differ.
        """
        return self._core.spectrum

    def index(self, alpha2: ArrayLike) -> Any:
        """How many entries of the spectrum are <= alpha2: the index of the shape there, 0 to s.

        Closed: every alpha2 of the spectrum gives its own index, of equal labels the last. An array
        gives an array (uint32) of its shape.
        """
        if np.ndim(alpha2) == 0:
            return self._core.index(float(alpha2))  # type: ignore[arg-type]
        array = as_float64(alpha2, "alpha2")
        return self._core.indices(array.ravel()).reshape(array.shape)

    def simplices(self, dimension: int) -> Simplices:
        """All simplices of a dimension 0 to D of the regular (weighted Delaunay) triangulation."""
        return Simplices(*_core.simplices(self._core, dimension, self._threads))

    def filtration(self, *, alpha2: float | None = None, index: int | None = None) -> Filtration:
        """All simplices in the exact order of their appearance, or those up to one alpha2."""
        if alpha2 is None and index is None:
            index = len(self.spectrum)
        at, _ = self._chosen(alpha2, None, None, index)
        return Filtration(_core.filtration(self._core, at, self._threads), self._threads)

    def role(
        self,
        dimension: int,
        *,
        alpha2: float | None = None,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> NDArray[np.uint8]:
        """(k,) what every simplex of a dimension is in one shape, in the order of `simplices`: the
        numbers of Role."""
        at, _ = self._chosen(alpha2, alpha, inverse_alpha, index)
        return _core.roles(self._core, dimension, at, self._threads)

    def enters_at(self, points: Any) -> NDArray[np.uint32]:
        """(n,) the index from which on each of some points is in the shape, vertices or not; the
        spectrum's size plus 1 for points outside the convex hull. Exact.

        Args:
            points: (n, D), taken as the numbers they are. Where the sites are decimals of a file, as
                the shortest decimals that are these numbers, so that 0.1 is one tenth, if all of
                them together are whole numbers of at most 2^53 in units of some 10^-k.

        Raises InputError for points of another dimension, and as AlphaShapes does.
        """
        return _core.enters_at(self._core, as_points(points), self._threads)

    @cached_property
    def signatures(self) -> Signatures:
        """Volume, areas, length, Betti numbers and counts at every index from 1 to s.

        Found when first asked for, then kept: about 170 bytes an index. See `signatures_at` for some
        indices only.
        """
        return Signatures(_core.signatures(self._core, None, self._threads))

    def signatures_at(
        self, alpha2: ArrayLike | None = None, *, index: ArrayLike | None = None
    ) -> Signatures:
        """The same at some alpha2 (length^2) or indices (0 to s), in their order.

        `alpha2` and `alpha` of the result are those of the indices.
        """
        indices = (
            self.index(np.atleast_1d(as_float64(alpha2, "alpha2"))) if index is None else index
        )
        wanted = as_float64(indices, "index").ravel()
        if ((wanted < 0) | (wanted > len(self.spectrum)) | (wanted != np.floor(wanted))).any():
            raise _core.InputError(f"an index is a whole number from 0 to {len(self.spectrum)}")
        return Signatures(_core.signatures(self._core, wanted.astype(np.uint32), self._threads))

    def ball_signatures(self, alpha2: ArrayLike) -> Signatures:
        """Volume, area, Betti and Euler numbers of the unions of balls at some alpha2, length^2."""
        array = np.atleast_1d(as_float64(alpha2, "alpha2")).ravel()
        return Signatures(_core.ball_signatures(self._core, array, self._threads))

    def betti(
        self,
        alpha2: float | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> tuple[int, ...]:
        """The numbers of components, tunnels and (in space) voids of one shape, and of the union of
        balls there. Exact. By Delfinado and Edelsbrunner, 1995."""
        at, _ = self._chosen(alpha2, alpha, inverse_alpha, index)
        return _core.betti(self._core, at, self._threads)

    def persistence(self, dimension: int | None = None, *, all: bool = False) -> Any:
        """The persistent homology over Z/2: a Diagram of one dimension 0 to D - 1, or the list of all.

        Args:
            all: also classes that are born and die at one index.
        """
        if dimension is not None and not 0 <= dimension < self.dimension:
            raise _core.InputError(
                f"there are no classes of dimension {dimension}; they are 0 to {self.dimension - 1}"
            )
        pairs = _core.persistence(self._core, all, self._threads)
        diagrams = [Diagram(k, *arrays) for k, arrays in enumerate(pairs)]
        return diagrams if dimension is None else diagrams[dimension]

    def notable_alphas(self) -> list[NotableAlpha]:
        """The indices that stand out, always the same names in the same order."""
        return [NotableAlpha(*notable) for notable in _core.notable_alphas(self._core)]

    def automatic_alpha(self) -> NotableAlpha:
        """What is taken where no alpha is named: "dual_complex", alpha2 = 0, for molecules; "solid"
        for points without weights; "connected" otherwise and where nothing is solid."""
        return NotableAlpha(*_core.automatic_alpha(self._core, self._is_molecule))

    # One of them.

    def shape(
        self,
        alpha2: float | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
        regularized: bool = False,
        hole_threshold: float | None = None,
        region_threshold: float | None = None,
        region: int | None = None,
    ) -> Shape:
        """One alpha shape.

        Args:
            alpha2: signed squared length.
            alpha: instead its signed root, a length.
            inverse_alpha: instead 1/alpha, as some packages call alpha.
            index: instead an index of the spectrum, 0 (the empty shape) to s.
            regularized: without singular simplices, the solid part only.
            hole_threshold: holes of at most this volume (length^D) are filled: bounded components
                of what is around the shape.
            region_threshold: then regions of at most this volume are left out: components.
            region: then only the region with this number is kept, 1 being the largest.

        Without any of the four forms that of `automatic_alpha`.
        """
        given = (alpha2, alpha, inverse_alpha, index)
        if all(form is None for form in given):
            notable = self.automatic_alpha()
            at, taken = notable.index or 0, notable.alpha2
        else:
            at, taken = self._chosen(*given)
        return Shape(self, at, taken, regularized, hole_threshold, region_threshold, region)

    def balls(self, alpha2: float = 0.0, probe: float = 0.0) -> Balls:
        """The union of the balls of squared radius weight + alpha2.

        Args:
            alpha2: signed squared length, by which all squared radii grow.
            probe: radius of a probe, a length: every radius r becomes r + probe before anything else,
                which changes who is whose neighbour; points without weights become balls of it.

        Raises:
            InputError: for a probe below 0, and with a probe for a weight below 0, naming the row.
        """
        grown = self if probe == 0 else self._with_probe(float(probe))
        return Balls(grown, float(alpha2), float(probe))

    def power_cells(self, box: ArrayLike | None = None, *, surfaces: bool = False) -> PowerCells:
        """The power (weighted Voronoi) cells of the points, cut by a box.

        Args:
            box: (2, D) its lower and its upper corner, lengths; by default the box around the balls,
                a tenth larger.
            surfaces: also corners and facets of every cell.

        By Aurenhammer, Power diagrams, SIAM Journal on Computing 16, 1987.
        """
        corners = None if box is None else as_float64(box, "box").ravel().tolist()
        return PowerCells(**_core.power_cells(self._core, corners, surfaces, self._threads))

    def _with_probe(self, probe: float) -> AlphaShapes:
        grown = object.__new__(AlphaShapes)
        grown._threads, grown._is_molecule = self._threads, self._is_molecule
        grown._reading = self._reading
        grown._core = self._core.with_probe(probe, self._threads)
        return grown

    def _chosen(
        self,
        alpha2: float | None,
        alpha: float | None,
        inverse_alpha: float | None,
        index: int | None,
    ) -> tuple[int, float]:
        """The index and alpha2 of the one form that is given."""
        return self._core.chosen(alpha2, alpha, inverse_alpha, index)

    # Pictures.

    def plot_signatures(self, *columns: str, axis: str = "alpha", ax: Any = None) -> Any:
        """Draws columns of the signatures with matplotlib, as the steps they are.

        Args:
            columns: "volume", "area", "betti", ...; by default the Betti numbers.
            axis: "alpha", "alpha2" or "index" along the horizontal axis.
            ax: the axes drawn into; by default new ones.

        Returns:
            The matplotlib axes.
        """
        from ._plots import plot_signatures

        return plot_signatures(self, columns or ("betti",), axis, ax)

    def view(
        self,
        alpha2: float | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
        open: bool | None = None,
    ) -> View:
        """All shapes in the viewer: inline in a notebook, elsewhere in a browser. The page is what
        `orthoball view` writes for the same file.

        Args:
            alpha2: which shape is shown first; or one of the other forms, as in `shape`. By default
                that of `automatic_alpha`.
            open: whether a browser is opened; by default outside of notebooks.

        Raises RuntimeError where the package was built without the viewer.
        """
        view = View(self, (alpha2, alpha, inverse_alpha, index))
        if open or (open is None and not is_notebook()):
            view.open()
        return view

    def plot_shape(self, alpha2: float | None = None, *, ax: Any = None, **forms: Any) -> Any:
        """Draws one shape with matplotlib; takes what `shape` takes. Returns the axes."""
        return self.shape(alpha2, **forms).plot(ax=ax)
