# SPDX-License-Identifier: MIT
"""The one object that everything else is asked of."""

from __future__ import annotations

import os
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import as_float64, as_points, as_threads, fault
from ._balls import Balls, Void
from ._candidates import AlphaCandidates, alphas, named_alpha
from ._files import ending_of, write_whole
from ._homology import Diagrams
from ._points import density_neighbours, sites_of
from ._shape import Shape
from ._tables import Filtration, NotableAlpha, PowerCells, Signatures, Simplices
from ._view import View, is_notebook
from ._weights import ConflictError, EnforcedWeights, simplices_of


class AlphaShapes:
    """All alpha shapes of weighted points in the plane or in space.

    Exact: the triangulation, which simplex enters when, and which values are equal are decided on
    the numbers as they are given; alpha2 are the doubles nearest to the exact values. The shapes
    depend on the set of points alone, not on their order or the number of threads. Any number of
    points is right, also none, equal ones and such that lie in a plane or on a line.

    Once built, an object does not change, and any number of threads may use it. It is not pickled:
    send its points to another process, where the same shapes are built of them.

    Args:
        points: an array of shape (n, 2) or (n, 3): float64, float32 or integers of at most 2^53. Or
            a Reading of `orthoball.read`; or an object of another package: a Universe or AtomGroup
            of MDAnalysis, a Structure of Biopython or gemmi, Atoms of ASE, a mesh or cloud of
            trimesh, Open3D or PyVista, a DataFrame of pandas with columns x, y[, z], or points of
            GeoPandas.
        weights: one signed squared length a point; of a DataFrame also a column's name. Or
            "density:K": from the distances to the K nearest others, see `density_weights`; then those
            of a Reading or of atoms do not count.
        radii: instead of weights one radius r a point (or one for all), standing for the weight r^2,
            -r^2 where r is negative; of a DataFrame also a column's name. Atoms of an object have
            the radii of the set "bondi" unless another is named ("alvarez", "protor", "none", or a
            file of radii) or an array given. Numbers take the place of those of a Reading, whose sets
            are chosen by `read`.
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
        threads = as_threads(threads)
        self._threads = threads
        self._reading = None
        neighbours = density_neighbours(weights)
        is_reading = isinstance(points, _core.Reading)
        if is_reading and isinstance(radii, str):
            raise fault(f"radii {radii!r} of a Reading are chosen by read(path, radii={radii!r})")
        if is_reading and radii is None and (weights is None or neighbours is not None):
            if neighbours is not None:
                points = _core.with_density_weights(points, neighbours, threads)
            self._core = _core.AlphaShapes(points, threads)
            self._is_molecule = points.is_molecule
            self._reading = points
            return
        sites = sites_of(points.points if is_reading else points, weights, radii, threads)
        column = sites.weights if sites.radii is None else sites.radii
        self._core = _core.AlphaShapes(sites.points, column, sites.radii is not None, threads)
        has_radii = is_reading and radii is not None
        self._is_molecule = sites.is_molecule or (has_radii and points.is_molecule)

    @classmethod
    def _of(
        cls,
        core: _core.AlphaShapes,
        threads: int | None,
        is_molecule: bool = False,
        reading: _core.Reading | None = None,
    ) -> AlphaShapes:
        self = object.__new__(cls)
        self._core, self._threads = core, threads
        self._is_molecule, self._reading = is_molecule, reading
        return self

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
        if isinstance(alpha2, str):
            return self._chosen(alpha2, None, None, None)[0]
        if np.ndim(alpha2) == 0:
            return self._core.index(float(alpha2))  # type: ignore[arg-type]
        array = as_float64(alpha2, "alpha2")
        return self._core.indices(array.ravel()).reshape(array.shape)

    def simplices(self, dimension: int) -> Simplices:
        """All simplices of a dimension 0 to D of the regular (weighted Delaunay) triangulation."""
        return Simplices(*_core.simplices(self._core, dimension, self._threads))

    def filtration(
        self, *, alpha2: float | str | None = None, index: int | None = None
    ) -> Filtration:
        """All simplices in the exact order of their appearance, or those up to one alpha2."""
        if alpha2 is None and index is None:
            index = len(self.spectrum)
        at, _ = self._chosen(alpha2, None, None, index)
        return Filtration(_core.filtration(self._core, at, self._threads), self._threads)

    def role(
        self,
        dimension: int,
        *,
        alpha2: float | str | None = None,
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
        return self._signatures(None)

    def signatures_at(
        self, alpha2: ArrayLike | None = None, *, index: ArrayLike | None = None
    ) -> Signatures:
        """The same at some alpha2 (length^2, or "auto", "auto:NAME") or indices (0 to s), in their order.

        `alpha2` and `alpha` of the result are those of the indices.
        """
        if (alpha2 is None) == (index is None):
            raise fault("give either alpha2 or index")
        indices = alphas(self, alpha2)[0] if index is None else index
        wanted = as_float64(indices, "index").ravel()
        if ((wanted < 0) | (wanted > len(self.spectrum)) | (wanted != np.floor(wanted))).any():
            raise fault(f"an index is a whole number from 0 to {len(self.spectrum)}")
        return self._signatures(wanted.astype(np.uint32))

    def _signatures(self, indices: NDArray[np.uint32] | None) -> Signatures:
        core, threads = self._core, self._threads  # without self, which keeps the result

        def file(format: str) -> bytes:
            return _core.signature_file(core, indices, format, threads)

        return Signatures(_core.signatures(core, indices, threads), file)

    def ball_signatures(self, alpha2: ArrayLike) -> Signatures:
        """Volume, area, Betti and Euler numbers of the unions of balls at some alpha2, length^2."""
        core, threads, taken = self._core, self._threads, alphas(self, alpha2)

        def file(format: str) -> bytes:
            return _core.ball_signature_file(core, *taken, format, threads)

        return Signatures(_core.ball_signatures(core, *taken, threads), file)

    def betti(
        self,
        alpha2: float | str | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> tuple[int, ...]:
        """The numbers of components, tunnels and (in space) voids of one shape, and of the union of
        balls there. Exact. By Delfinado and Edelsbrunner, 1995."""
        at, _ = self._chosen(alpha2, alpha, inverse_alpha, index)
        return _core.betti(self._core, at, self._threads)

    def persistence(
        self, dimension: int | None = None, *, all: bool = False, minimum_length: float = 0.0
    ) -> Any:
        """The persistent homology over Z/2: a Diagram of one dimension 0 to D - 1, or the Diagrams of
        all. Exact. By Edelsbrunner, Letscher and Zomorodian, 2002.

        Args:
            all: also classes that are born and die at one index.
            minimum_length: only classes that live so long, death less birth, length^2.
        """
        if dimension is not None and not 0 <= dimension < self.dimension:
            raise fault(
                f"there are no classes of dimension {dimension}; they are 0 to {self.dimension - 1}"
            )
        if not minimum_length >= 0.0:
            raise fault(f"minimum_length is {minimum_length}; a length of lives is 0 or more")
        pairs = _core.persistence_pairs(self._core, all, minimum_length, self._threads)
        diagrams = Diagrams(self, pairs)
        return diagrams if dimension is None else diagrams[dimension]

    def notable_alphas(self) -> list[NotableAlpha]:
        """The indices that stand out, always the same names in the same order."""
        return [NotableAlpha(*notable) for notable in _core.notable_alphas(self._core)]

    def automatic_alpha(self) -> NotableAlpha:
        """What is taken where no alpha is named: "dual_complex", alpha2 = 0, for molecules; "solid"
        for points without weights; "connected" otherwise and where nothing is solid."""
        return NotableAlpha(*_core.automatic_alpha(self._core, self._is_molecule))

    def alpha_candidates(
        self, *, resamples: int = 0, share: float = 0.8, seed: int = 1
    ) -> AlphaCandidates:
        """The alphas that are worth a look, the most stable first, each with a reason, the shape there
        and the stretch on which its Betti numbers stay: the notable ones, the longest-lived Betti
        numbers ("signature"), plateaus of the volume, the widest gap of the spectrum, the first closed
        manifold, of molecules 0 and the radius of a water molecule.

        `alpha2="auto:NAME"` takes one by its name wherever an alpha2 is asked for.

        Args:
            resamples: find all again in so many random parts of the points: as many times the work of
                building.
            share: of the points in each of them, up to 1.
            seed: of these parts, which depend on it and on the set of points alone.
        """
        if not 0 <= resamples < 2**32 or not 0 <= seed < 2**64:
            raise fault("resamples and seed are whole numbers from 0 on")
        found = _core.alpha_candidates(
            self._core, self._is_molecule, resamples, float(share), seed, self._threads
        )
        return AlphaCandidates(found)

    # Weights.

    def enforce(
        self, simplices: Any, alpha2: float | str = 0.0, *, add_sites: bool = False
    ) -> EnforcedWeights:
        """Weights, changed as little as possible, with which given simplices are in the shape at one
        alpha2, be it as faces of larger ones. Verified exactly.

        Args:
            simplices: edges, triangles or tetrahedra, each as the rows of its corners; or the path of
                a file that lists them as `orthoball enforce` takes it.
            alpha2: length^2.
            add_sites: where simplices exclude each other, cut them by sites that are added on them,
                as few as are found to do.

        Raises:
            ConflictError: (an InputError) no weights hold some of them together, which it names.
            InputError: corners that are no rows or do not span a simplex; names the simplex.
            LimitError: where the solver of linear programs is not installed: `has_linear_solver`.

        The aim is that of Akkiraju and others, Alpha Shapes: Definition and Software, 1995.
        """
        lists = simplices_of(simplices, self)
        _, taken = self._chosen(alpha2, None, None, None)
        found = _core.enforced_weights(self._core, lists, taken, add_sites, self._threads)
        if found.conflict:
            raise ConflictError(lists, found.conflict)
        return EnforcedWeights(found, self._threads)

    def are_present(
        self,
        simplices: Any,
        alpha2: float | str | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> NDArray[np.bool_]:
        """(k,) whether one alpha complex has some simplices, be it as faces of larger ones. Exact.

        Args:
            simplices: as in `enforce`. A duplicate stands for the row that it is equal to.
        """
        at, _ = self._chosen(alpha2, alpha, inverse_alpha, index)
        return _core.are_present(self._core, simplices_of(simplices, self), at)

    # One of them.

    def shape(
        self,
        alpha2: float | str | None = None,
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
            alpha2: signed squared length; or "auto:NAME", one of `alpha_candidates`, or "auto".
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
        given = ("auto" if alpha2 is None else alpha2, None, None, None)
        if (alpha, inverse_alpha, index) != (None, None, None):
            given = (alpha2, alpha, inverse_alpha, index)
        at, taken = self._chosen(*given)
        return Shape(self, at, taken, regularized, hole_threshold, region_threshold, region)

    def voids(
        self,
        alpha2: float | str | None = None,
        *,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> tuple[Void, ...]:
        """The voids (in the plane: holes) of one alpha shape, the largest first, each with its life.
        They are those of the union of balls there, `balls(...).voids`, but larger; `areas` are 0, and
        so is the largest ball."""
        at, taken = self._chosen(alpha2, alpha, inverse_alpha, index)
        found = _core.voids(self._core, at, taken, True, self._threads)
        return tuple(Void(**one) for one in found)

    def balls(self, alpha2: float | str = 0.0, probe: float = 0.0) -> Balls:
        """The union of the balls of squared radius weight + alpha2.

        Args:
            alpha2: signed squared length, by which all squared radii grow; or "auto", "auto:NAME", of
                the balls grown by the probe.
            probe: radius of a probe, a length: every radius r becomes r + probe before anything else,
                which changes who is whose neighbour; points without weights become balls of it.

        Raises:
            InputError: for a probe below 0, and with a probe for a weight below 0, naming the row.
        """
        grown = self if probe == 0 else self._with_probe(float(probe))
        at, taken = grown._chosen(alpha2, None, None, None)
        return Balls(grown, at, taken, float(probe))

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

    def write_power_cells(self, path: str | os.PathLike[str], box: ArrayLike | None = None) -> None:
        """Writes the power cells cut by a box to a file: .csv, .json (volumes, areas, neighbours), .vtu
        or .obj (polyhedra, in the plane polygons). The file appears whole or not at all.

        Args:
            box: as in `power_cells`.
        """
        corners = None if box is None else as_float64(box, "box").ravel().tolist()
        content = _core.power_cell_file(
            self._core, None, corners, 0.02, self._reading, ending_of(path), self._threads
        )
        write_whole(path, content)

    def _with_probe(self, probe: float) -> AlphaShapes:
        core = self._core.with_probe(probe, self._threads)
        return AlphaShapes._of(core, self._threads, self._is_molecule, self._reading)

    def _chosen(
        self,
        alpha2: float | str | None,
        alpha: float | None,
        inverse_alpha: float | None,
        index: int | None,
    ) -> tuple[int, float]:
        """The index and alpha2 of the one form that is given."""
        if isinstance(alpha2, str):
            if (alpha, inverse_alpha, index) == (None, None, None):
                notable = named_alpha(self, alpha2)
                return notable.index or 0, notable.alpha2
            alpha2 = 0.0  # to be refused
        return self._core.chosen(alpha2, alpha, inverse_alpha, index)

    def _named_alpha(
        self,
        alpha2: float | str | None,
        alpha: float | None = None,
        inverse_alpha: float | None = None,
        index: int | None = None,
    ) -> NotableAlpha | None:
        """The alpha that is taken by its name, or because none is given; None where one is given."""
        if (alpha, inverse_alpha, index) != (None, None, None):
            return None
        if isinstance(alpha2, str):
            return named_alpha(self, alpha2)
        return self.automatic_alpha() if alpha2 is None else None

    @cached_property
    def _candidates(self) -> AlphaCandidates:
        return self.alpha_candidates()

    def _picture_text(self, title: str | None) -> tuple[str, str, str]:
        """Title, subtitle and unit of pictures."""
        reading, count = self._reading, self.site_count
        of_file = os.path.basename(reading.file) if reading is not None else ""
        radii = "given" if reading is None else reading.radii
        weights = "none" if self.weights is None else radii
        return (
            of_file if title is None else title,
            f"{count} site{'' if count == 1 else 's'}, weights: {weights}",
            "Å" if self._is_molecule else "",
        )

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

    def signature_figure(
        self,
        *,
        axis: str = "alpha",
        range: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> bytes:
        """The picture that `orthoball signatures --plot` makes, as SVG: Betti numbers, volume, area by
        role and, in space, length, with the notable alphas.

        Args:
            axis: "alpha", "alpha2" or "index" along the horizontal axis.
            range: its ends; by default around the changes of the topology.
            title: above; by default the name of the file that was read.
        """
        text = self._picture_text(title)
        return _core.signature_figure(self._core, axis, range, *text, self._threads)

    def view(
        self,
        alpha2: float | str | None = None,
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

    def plot_shape(self, alpha2: float | str | None = None, *, ax: Any = None, **forms: Any) -> Any:
        """Draws one shape with matplotlib; takes what `shape` takes. Returns the axes."""
        return self.shape(alpha2, **forms).plot(ax=ax)
