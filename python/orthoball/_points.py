# SPDX-License-Identifier: MIT
"""Objects of other packages as points, by what they look like: none of the packages is imported."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._arrays import as_column, as_float64, as_points, fault, stacked

_DENSITY = "density:"


class Sites(NamedTuple):
    """Points with weights (signed squared lengths), or radii instead, or neither."""

    points: np.ndarray
    weights: np.ndarray | None = None
    radii: np.ndarray | None = None
    is_molecule: bool = False


class _Atoms(NamedTuple):
    """What an object tells of atoms; lists may be empty."""

    points: Any
    elements: list[str]
    residues: list[str] = []
    names: list[str] = []
    radii: Any = None


def _mdanalysis(it: Any) -> _Atoms | None:
    """A Universe or an AtomGroup of MDAnalysis."""
    if not hasattr(it, "positions") and hasattr(getattr(it, "atoms", None), "positions"):
        it = it.atoms
    if not hasattr(it, "positions") or not hasattr(it, "n_atoms"):
        return None

    def column(name: str) -> list[str]:
        return [str(text) for text in getattr(it, name, [])]  # AttributeError where it is not told

    return _Atoms(
        it.positions, column("elements"), column("resnames"), column("names"),
        getattr(it, "radii", None),
    )  # fmt: skip


def _biopython(it: Any) -> _Atoms | None:
    """A Structure, Model, Chain or Residue of Biopython; the selected alternates."""
    if not hasattr(it, "get_atoms"):
        return None
    if getattr(it, "level", "") == "S":
        it = next(iter(it), it)  # the first model
    atoms = list(it.get_atoms())
    return _Atoms(
        stacked([atom.coord for atom in atoms], 3),
        [atom.element for atom in atoms],
        [atom.get_parent().get_resname() for atom in atoms],
        [atom.get_name() for atom in atoms],
    )


def _gemmi(it: Any) -> _Atoms | None:
    """A Structure (its first model), Model or Chain of gemmi; the first conformer."""
    if type(it).__module__.partition(".")[0] != "gemmi":
        return None
    if hasattr(it, "spacegroup_hm") and len(it) > 0:
        it = it[0]
    chains = [it] if hasattr(it, "first_conformer") else list(it)
    found = [
        (atom, residue)
        for chain in chains
        for residue in chain.first_conformer()
        for atom in residue.first_conformer()
    ]
    return _Atoms(
        stacked([atom.pos.tolist() for atom, _ in found], 3),
        [atom.element.name for atom, _ in found],
        [residue.name for _, residue in found],
        [atom.name for atom, _ in found],
    )


def _ase(it: Any) -> _Atoms | None:
    """Atoms of ASE."""
    if not hasattr(it, "get_chemical_symbols"):
        return None
    return _Atoms(it.get_positions(), list(it.get_chemical_symbols()))


def _geopandas(it: Any) -> np.ndarray | None:
    """A GeoSeries or GeoDataFrame of GeoPandas; its points."""
    geometry = getattr(it, "geometry", None)
    if geometry is None or not hasattr(geometry, "geom_type"):
        return None
    kinds = list(geometry.geom_type)
    for row, kind in enumerate(kinds):
        if kind != "Point":
            raise fault(f"the geometry is {kind or 'missing'}; points are needed", row)
    has_z = np.asarray(geometry.has_z, dtype=bool)
    if has_z.any() and not has_z.all():
        raise fault("the point has no z, others have", int(np.flatnonzero(~has_z)[0]))
    axes = [geometry.x, geometry.y, *([geometry.z] if has_z.any() else [])]
    return np.column_stack([np.asarray(axis, dtype=np.float64) for axis in axes])


def _pandas(it: Any) -> np.ndarray | None:
    """A DataFrame of pandas: columns x, y[, z], or lon, lat, or longitude, latitude."""
    if not hasattr(it, "columns") or not hasattr(it, "iloc"):
        return None
    by_name = {str(column).lower(): column for column in reversed(list(it.columns))}
    for names in (("x", "y", "z"), ("x", "y"), ("lon", "lat"), ("longitude", "latitude")):
        if all(name in by_name for name in names):
            columns = [as_float64(it[by_name[name]], f"column {name}") for name in names]
            return np.column_stack(columns)
    numbers = it.to_numpy()
    if numbers.dtype.kind in "iuf" and numbers.shape[1] in (2, 3):
        return numbers
    raise fault(
        f"the columns {list(it.columns)} do not tell the coordinates; name them x, y, z or select "
        "two or three of numbers"
    )


def _cloud(it: Any) -> Any | None:
    """A mesh or cloud of trimesh, Open3D or PyVista: its vertices or points."""
    for name in ("vertices", "points"):
        if hasattr(it, name) and not isinstance(it, np.ndarray):
            return np.asarray(getattr(it, name))
    return None


def _is_number_like(values: Any) -> bool:
    return not isinstance(values, str)


def _of_atoms(atoms: _Atoms, radii: Any) -> Sites:
    points = as_points(atoms.points)
    if isinstance(radii, str) and radii == "none":
        return Sites(points)
    if radii is not None and _is_number_like(radii):
        return Sites(points, radii=as_column(radii, len(points), "radii"), is_molecule=True)
    if radii is None and atoms.radii is not None:
        return Sites(points, radii=as_column(atoms.radii, len(points), "radii"), is_molecule=True)
    if len(points) > 0 and not atoms.elements:
        raise fault(
            'the elements of the atoms are not told; give radii as an array, or radii="none"'
        )
    of_elements = _core.atom_radii(atoms.elements, atoms.residues, atoms.names, radii or "bondi")
    return Sites(points, radii=of_elements, is_molecule=True)


def density_neighbours(weights: Any) -> int | None:
    """K of the text "density:K"; None for other weights."""
    if not isinstance(weights, str) or not weights.startswith(_DENSITY):
        return None
    number = weights[len(_DENSITY) :]
    if number.isascii() and number.isdigit() and 0 < int(number) < 2**32:
        return int(number)
    raise fault(
        f"{weights!r} is no way to make weights; density:K is, K neighbours from 1, such as density:8"
    )


def _atoms_of(it: Any) -> _Atoms | None:
    looks = (look(it) for look in (_mdanalysis, _biopython, _gemmi, _ase))
    return next((atoms for atoms in looks if atoms is not None), None)


def points_of(it: Any) -> np.ndarray:
    """The points of what AlphaShapes takes, whatever their weights."""
    atoms = _atoms_of(it)
    if atoms is not None:
        return as_points(atoms.points)
    looks = (look(it) for look in (_geopandas, _pandas, _cloud))
    return as_points(next((values for values in looks if values is not None), it))


def sites_of(it: Any, weights: Any = None, radii: Any = None, threads: int | None = None) -> Sites:
    """What AlphaShapes takes, as arrays; see there."""
    if weights is not None and radii is not None:
        raise fault("weights and radii are both given; a weight is a squared radius, give one")
    neighbours = density_neighbours(weights)
    if neighbours is not None:
        points = points_of(it)
        return Sites(points, weights=_core.density_weights(points, neighbours, threads))
    atoms = _atoms_of(it)
    if atoms is not None:
        if weights is None:
            return _of_atoms(atoms, radii)
        points = as_points(atoms.points)
        return Sites(points, weights=as_column(weights, len(points), "weights"))
    is_table = hasattr(it, "columns") and hasattr(it, "iloc")
    points = points_of(it)

    def column(given: Any, name: str) -> np.ndarray | None:
        if given is None:
            return None
        if isinstance(given, str):
            if not is_table:
                raise fault(
                    f"{name} is the text {given!r}, but the points are no table and no molecule"
                )
            if given not in it.columns:
                raise fault(f"there is no column {given!r}; the columns are {list(it.columns)}")
            given = it[given]
        return as_column(given, len(points), name)

    return Sites(points, column(weights, "weights"), column(radii, "radii"))
