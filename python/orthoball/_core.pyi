"""
The compiled part of orthoball: its names are those of the package, see there.
"""

from collections.abc import Sequence
from typing import Annotated, Any, overload

import numpy
import numpy.typing
from numpy.typing import NDArray


class InputError(ValueError):
    """
    The caller's numbers are not what the function accepts.

    Attributes: `reason` ("not_finite", "wrong_size", "wrong_argument",
    "imaginary_ball") and `row`, the input row from 0, or None where no single row is at fault.
    """

class ParseError(ValueError):
    """
    A file is not what its format says: `FILE:LINE: what is wrong`.

    Attributes: `file` and `line`, from 1, or None where the whole file is meant.
    """

class LimitError(ValueError):
    """More of something than can be counted, or than memory allows."""

class Reading:
    """
    What a file gave: weighted points exactly as its text says them, and who they are.

    AlphaShapes takes it as it is; `points` and `weights` are for looking at.
    """

    @property
    def points(self) -> numpy.typing.NDArray[numpy.float64]:
        """Coordinates, (n, 2) or (n, 3) float64, input units; correctly rounded."""

    @property
    def weights(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Weights, signed squared lengths, (n,) float64; None where there are none.
        """

    @property
    def ball_radii(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        Signed roots of the weights, lengths, (n,) float64; None where there are none.
        """

    @property
    def decimals(self) -> int | None:
        """
        k where every number is a whole number of 10^-k exactly; None where all are doubles.
        """

    @property
    def dimension(self) -> int:
        """2 or 3."""

    @property
    def labels(self) -> dict[str, Any]:
        """
        Who a row is, by kind: "line" (from 1), "element", "atom", "residue", "residue_id",
        "chain", each with one entry a row; kinds that the format does not tell are left out.
        """

    @property
    def file(self) -> str:
        """The path as given."""

    @property
    def format(self) -> str:
        """The format it was read as, one of input_formats()."""

    @property
    def radii(self) -> str:
        """Where weights come from, in words."""

    @property
    def is_molecule(self) -> bool:
        """Whether weights are the squared radii of a molecule's atoms."""

    @property
    def notes(self) -> list[str]:
        """Choices made while reading."""

    @property
    def warnings(self) -> list[str]:
        """Things to look at."""

    def __len__(self) -> int: ...

    def __repr__(self) -> str: ...

def read(path: str, *, format: str, dimension: int | None, columns: Sequence[str], radius_column: str, weight_column: str, radii: str, default_radius: str | None, model: int | None, altloc: str, chains: Sequence[str], hydrogens: bool, ligands: bool, waters: bool, allow_empty: bool, limited: bool) -> Reading:
    """See orthoball.read."""

def atom_radii(elements: Sequence[str], residues: Sequence[str], atoms: Sequence[str], set: str) -> Annotated[NDArray[numpy.float64], dict(order='C', writable=False)]:
    """
    Radii [Å] of atoms by a named set or a file of radii, (n,); lists may be empty.
    """

def input_formats() -> list[str]:
    """Names of the formats that read() knows."""

class AlphaShapes:
    """The filtration of weighted points; see orthoball.AlphaShapes."""

    @overload
    def __init__(self, points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], weights: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)] | None, are_radii: bool, threads: int | None) -> None: ...

    @overload
    def __init__(self, reading: Reading, threads: int | None) -> None: ...

    def __repr__(self) -> str: ...

    def with_probe(self, probe: float, threads: int | None) -> AlphaShapes:
        """The shapes of the balls grown by the radius of a probe."""

    @property
    def dimension(self) -> int:
        """2 or 3."""

    @property
    def affine_dimension(self) -> int:
        """Of the sites' affine hull; -1 without sites."""

    @property
    def site_count(self) -> int:
        """Input rows."""

    @property
    def decimals(self) -> int | None:
        """As that of a Reading."""

    @property
    def points(self) -> numpy.typing.NDArray[numpy.float64]:
        """(n, D) float64, input units."""

    @property
    def weights(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """(n,) float64, length^2; None without weights."""

    @property
    def spectrum(self) -> numpy.typing.NDArray[numpy.float64]:
        """(s,) float64, length^2."""

    @property
    def hidden(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(k,) uint32 rows."""

    @property
    def duplicates(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(k, 2) uint32: row, representative."""

    def index(self, alpha2: float) -> int:
        """Number of entries of the spectrum that are <= alpha2."""

    def indices(self, alpha2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.uint32], dict(order='C', writable=False)]:
        """index() of each."""

    def chosen(self, alpha2: float | None, alpha: float | None, inverse_alpha: float | None, index: int | None) -> tuple[int, float]:
        """The index and alpha2 of the one form that is given."""

def density_weights(points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], neighbours: int, threads: int | None) -> Annotated[NDArray[numpy.float64], dict(order='C', writable=False)]:
    """Weights from density of points, (n,) float64."""

def with_density_weights(reading: Reading, neighbours: int, threads: int | None) -> Reading:
    """A reading with weights from density instead of its own."""

class Enforced:
    """See orthoball.EnforcedWeights."""

    @property
    def points(self) -> numpy.typing.NDArray[numpy.float64]:
        """(n, D) float64."""

    @property
    def weights(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """(n,) float64; None where none was needed."""

    @property
    def changed(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(k,) rows."""

    @property
    def hidden(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(k,) rows."""

    @property
    def total_change(self) -> float:
        """length^2."""

    @property
    def conflict(self) -> list[int]:
        """Numbers of simplices that exclude each other."""

    @property
    def added(self) -> int:
        """How many rows were added."""

    @property
    def parts(self) -> list[list[int]]:
        """The simplices that are held, as rows."""

    @property
    def part_of(self) -> list[int]:
        """Of each the number of the simplex that it is a part of."""

    def shapes(self, threads: int | None) -> AlphaShapes:
        """The shapes of the points."""

    def file(self) -> bytes:
        """The points as CSV."""

def enforced_weights(shapes: AlphaShapes, simplices: Sequence[Sequence[int]], alpha2: float, add_sites: bool, threads: int | None) -> Enforced:
    """Weights with which simplices are in the shape."""

def are_present(shapes: AlphaShapes, simplices: Sequence[Sequence[int]], index: int) -> numpy.typing.NDArray[numpy.bool_]:
    """Whether simplices are in a complex."""

def read_simplices(path: str, shapes: AlphaShapes) -> list[list[int]]:
    """Rows of the simplices that a file lists."""

def has_linear_solver() -> bool:
    """
    Whether the solver of linear programs, COIN-OR CLP, can be loaded, which
    `AlphaShapes.enforce` needs: the package loads it where it is installed (Debian's
    coinor-libclp1), and does not contain it.
    """

def simplices(shapes: object, dimension: int, threads: int | None) -> tuple:
    """
    Of one dimension: vertices (k, dimension + 1), enters, regular, interior (k,), all uint32.
    """

class FilterColumns:
    """A complex in filter order, as columns."""

    @property
    def dimension(self) -> numpy.typing.NDArray[numpy.uint8]:
        """(n,)"""

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(n, D + 1)"""

    @property
    def enters(self) -> numpy.typing.NDArray[numpy.uint32]:
        """(n,)"""

    def alpha2(self, threads: int | None) -> Annotated[NDArray[numpy.float64], dict(order='C', writable=False)]:
        """(n,) float64."""

    def regular(self, threads: int | None) -> Annotated[NDArray[numpy.uint32], dict(order='C', writable=False)]:
        """(n,) uint32."""

    def interior(self, threads: int | None) -> Annotated[NDArray[numpy.uint32], dict(order='C', writable=False)]:
        """(n,) uint32."""

    def file(self, format: str, threads: int | None) -> bytes:
        """As a table: csv, json (an object a line) or npz."""

def filtration(shapes: AlphaShapes, index: int, threads: int | None) -> FilterColumns:
    """The complex at an index in filter order."""

def roles(shapes: AlphaShapes, dimension: int, index: int, threads: int | None) -> Annotated[NDArray[numpy.uint8], dict(order='C', writable=False)]:
    """
    Of every simplex of a dimension, (k,) uint8: exterior, singular, regular, interior.
    """

def betti(shapes: AlphaShapes, index: int, threads: int | None) -> tuple[int, ...]:
    """Betti numbers of the complex at an index, D of them."""

class FoundRepresentatives:
    """See orthoball.Representatives."""

    def list(self) -> list:
        """A dict each."""

    def file(self, format: str) -> bytes:
        """json or ply."""

class PersistencePairs:
    """See orthoball.Diagrams."""

    def arrays(self, dimension: int) -> tuple:
        """
        Of one dimension k: alpha2 (n, 2) float64, indices (n, 2), vertices of the simplices
        that give birth (n, k + 1) and death (n, k + 2), uint32.
        """

    def file(self, dimension: int | None, format: str, indices: bool) -> bytes:
        """Those of one dimension, or all: csv, json or gudhi."""

    def figure(self, dimension: int | None, kind: str, axis: str, title: str, subtitle: str, unit: str) -> bytes:
        """The same as SVG."""

    def representatives(self, dimension: int | None, number: int | None, index: int | None, threads: int | None) -> FoundRepresentatives:
        """What makes a class, or all that live at an index."""

def persistence_pairs(shapes: AlphaShapes, all: bool, minimum_length: float, threads: int | None) -> PersistencePairs:
    """The persistence pairs of all dimensions."""

def signatures(shapes: AlphaShapes, indices: Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C', device='cpu', writable=False)] | None, threads: int | None) -> dict:
    """Columns of the signatures at some indices, or at all from 1 on."""

def ball_signatures(shapes: AlphaShapes, indices: Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C', device='cpu', writable=False)], alpha2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], threads: int | None) -> dict:
    """Columns of the unions of balls at some alpha2."""

def signature_file(shapes: AlphaShapes, indices: Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C', device='cpu', writable=False)] | None, format: str, threads: int | None) -> bytes:
    """Signatures as a table: csv, json or npz."""

def ball_signature_file(shapes: AlphaShapes, indices: Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C', device='cpu', writable=False)], alpha2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], format: str, threads: int | None) -> bytes:
    """Unions of balls as a table: csv, json or npz."""

def signature_figure(shapes: AlphaShapes, axis: str, range: tuple[float, float] | None, title: str, subtitle: str, unit: str, threads: int | None) -> bytes:
    """Signatures as SVG."""

def notable_alphas(shapes: AlphaShapes) -> list:
    """A tuple (name, reason, index or None, alpha2, alpha) for each."""

def automatic_alpha(shapes: AlphaShapes, is_molecule: bool) -> tuple:
    """The same of the one that is taken where none is named."""

class Candidates:
    """See orthoball.AlphaCandidates."""

    def file(self, format: str) -> bytes:
        """All as a table, csv or json."""

def alpha_candidates(shapes: AlphaShapes, is_molecule: bool, resamples: int, share: float, seed: int, threads: int | None) -> Candidates:
    """Alphas that may be the ones to take."""

def candidate_names(dimension: int) -> list[str]:
    """The names that candidates can have."""

def scale_text(shapes: AlphaShapes) -> str:
    """The alphas of the points in words."""

class OneShape:
    """One shape of a family; see orthoball.Shape."""

    @property
    def edits(self) -> dict:
        """Numbers and volumes of holes filled and regions left out."""

def edited(shapes: AlphaShapes, index: int, alpha2: float, regularized: bool, hole_threshold: float | None, region_threshold: float | None, region: int) -> OneShape:
    """The shape at an index, with holes filled and regions left out."""

def boundary(shape: OneShape) -> dict:
    """The arrays of a boundary, numbered by the vertices that are used."""

def cells(shape: OneShape) -> Annotated[NDArray[numpy.uint32], dict(order='C', writable=False)]:
    """The cells of a shape, (k, D + 1) uint32 rows, positively oriented."""

def polygons(shape: OneShape) -> list:
    """
    In the plane: a list of polygons, each a list of rings, each the rows of its vertices.
    """

def file_bytes(shape: OneShape, format: str, roles: bool) -> bytes:
    """A shape as the bytes of a file."""

def measures(shape: OneShape) -> tuple:
    """Volume, area and Betti numbers of a whole shape."""

class OneSolid:
    """The solid near to a shape; see orthoball.Solid."""

    @property
    def shape(self) -> OneShape:
        """The shape that it is."""

    @property
    def facts(self) -> dict:
        """What it is, and what was changed."""

    def file(self, format: str) -> bytes:
        """What was changed, as a table, csv or json."""

def manifold_solid(shape: OneShape) -> OneSolid:
    """The solid nearest to a shape whose boundary is a closed manifold."""

class UnionOfBalls:
    """The measures of a union of balls; see orthoball.Balls."""

    @property
    def index(self) -> int:
        """Of the dual complex."""

    @property
    def alpha2(self) -> float:
        """length^2."""

    @property
    def volume(self) -> float:
        """length^D."""

    @property
    def area(self) -> float:
        """length^(D-1)."""

    @property
    def mean_curvature(self) -> float:
        """length; 0 in the plane."""

    @property
    def euler(self) -> int:
        """Euler number."""

    @property
    def volumes(self) -> numpy.typing.NDArray[numpy.float64]:
        """(n,) by row."""

    @property
    def areas(self) -> numpy.typing.NDArray[numpy.float64]:
        """(n,) by row."""

    def contacts(self) -> tuple:
        """rows (k, 2) uint32, area (k,), exposed_length (k,)."""

    def derivatives(self) -> tuple:
        """area_by_radius (n,), volume_by_centre (n, D), area_by_centre (n, D)."""

def union_of_balls(shapes: AlphaShapes, index: int, alpha2: float, contacts: bool, derivatives: bool, threads: int | None) -> UnionOfBalls:
    """The union of the balls whose dual complex is at an index."""

def molecular_surface(shapes: AlphaShapes, balls: UnionOfBalls, probe: float, threads: int | None) -> dict:
    """Measures of the molecular surface, by name."""

def ball_file(shapes: AlphaShapes, balls: UnionOfBalls, reading: Reading | None, what: str, format: str) -> bytes:
    """A table of balls: csv or json."""

def voids_file(shapes: AlphaShapes, balls: UnionOfBalls, reading: Reading | None, format: str, probe: float, molecule: str, threads: int | None) -> bytes:
    """Voids of balls: csv, json, ply, pml or cxc."""

def pockets_file(shapes: AlphaShapes, balls: UnionOfBalls, reading: Reading | None, format: str, probe: float, molecule: str, threads: int | None) -> bytes:
    """Pockets of balls: csv, json, ply, pml or cxc."""

def power_cell_file(shapes: AlphaShapes, balls: UnionOfBalls | None, box: Sequence[float] | None, tolerance: float, reading: Reading | None, format: str, threads: int | None) -> bytes:
    """Power cells in balls or a box: csv, json, vtu or obj."""

def pdb_file(shapes: AlphaShapes, values: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], reading: Reading | None) -> tuple:
    """
    A PDB file with a value a row, how many values were cut, and how many labels.
    """

def voids(shapes: AlphaShapes, index: int, alpha2: float, of_shape: bool, threads: int | None) -> list:
    """Voids of the balls or of the shape, a dict each."""

def pockets(shapes: AlphaShapes, index: int, alpha2: float, threads: int | None) -> list:
    """Pockets of the balls, a dict each."""

def enters_at(shapes: AlphaShapes, points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int | None) -> Annotated[NDArray[numpy.uint32], dict(order='C', writable=False)]:
    """
    The index at which each point becomes part of the shape, (n,) uint32; the spectrum's
    size plus 1 outside the convex hull.
    """

def contains(shape: OneShape, points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int | None) -> Annotated[NDArray[numpy.bool_], dict(order='C', writable=False)]:
    """(n,) whether points are in a shape."""

def locate(shape: OneShape, points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int | None) -> tuple:
    """Regions (n,), simplices (n, D + 1), and as `nearest`."""

def nearest(shape: OneShape, points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int | None) -> tuple:
    """
    The nearest points of the boundary (n, D), their distances (n,), the rows of their
    simplices (n, D) uint32.
    """

def regions(shape: OneShape, joined_by: str) -> list:
    """The regions of a shape, a dict each."""

def holes(shape: OneShape) -> list:
    """The holes of a shape, a dict each."""

def power_cells(shapes: AlphaShapes, box: Sequence[float] | None, surfaces: bool, threads: int | None) -> dict:
    """The power cells cut by a box."""

def power_cells_in_balls(shapes: AlphaShapes, balls: UnionOfBalls, surfaces: bool, tolerance: float, threads: int | None) -> dict:
    """The power cells cut by their balls."""

def outline(shapes: AlphaShapes, index: int, alpha2: float) -> list:
    """
    Closed curves of arcs: rows (k,), and (k, 8): centre, radius, from, to, turn.
    """

def figure(shapes: AlphaShapes, index: int, alpha2: float, panels: Sequence[str], print: bool, legend: bool, title: str) -> bytes:
    """The union of disks and its dual complex as SVG."""

def page(shapes: AlphaShapes, reading: Reading | None, is_molecule: bool, viewer: bytes, index: int, alpha2: float, chosen_because: str, threads: int | None) -> bytes:
    """The viewer's page with all shapes in it."""
