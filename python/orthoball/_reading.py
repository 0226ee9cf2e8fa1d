# SPDX-License-Identifier: MIT
"""Files, by the readers of the library."""

from __future__ import annotations

import os
from collections.abc import Sequence

from . import _core


def read(
    path: str | os.PathLike[str],
    *,
    format: str = "",
    dimension: int | None = None,
    columns: Sequence[int | str] = (),
    radius_column: int | str = "",
    weight_column: int | str = "",
    radii: str = "",
    default_radius: float | str | None = None,
    model: int | None = None,
    altloc: str = "",
    chains: Sequence[str] = (),
    hydrogens: bool = True,
    ligands: bool = True,
    waters: bool = False,
    allow_empty: bool = False,
    limited: bool = True,
) -> _core.Reading:
    """Reads weighted points from a file, as the program `orthoball` does.

    PDB, mmCIF, PQR, XYZ and extended XYZ, CSV, PLY, OFF, OBJ, LAS, GeoJSON and others, see
    `input_formats()`; text formats also as .gz. Decimal text is read exactly: "0.1" is one tenth.

    Args:
        path: the file. Its name tells the format, unless `format` does.
        dimension: 2 or 3; by default as the file suggests.
        columns: coordinate columns of a table, numbers from 1 or names.
        radius_column: column of radii r, lengths; -r is an imaginary ball of weight -r^2.
        weight_column: column of weights, signed squared lengths; instead of radii.
        radii: of atoms: "bondi", "alvarez", "protor", "none" or a file's path. By default the
            radii in a molecule's file, else "bondi".
        default_radius: of elements that the set of radii does not have, in Angstrom.
        model: number of the model that is taken; by default the first.
        altloc: the alternate location that is preferred; by default the highest occupancy.
        chains: these chains only; by default all.
        hydrogens, ligands, waters: whether to keep these atoms.
        allow_empty: a file without any site is no error.
        limited: refuse files over 1 GiB, or compressed by more than 200.

    Returns:
        A Reading, which AlphaShapes takes.

    Raises:
        ParseError: the file cannot be opened or is not what its format says, with its line.
        InputError: options that do not fit each other or the format.
        LimitError: the file is too large.
    """
    return _core.read(
        os.fspath(path),
        format=format,
        dimension=dimension,
        columns=[str(column) for column in columns],
        radius_column=str(radius_column),
        weight_column=str(weight_column),
        radii=os.fspath(radii),
        default_radius=None if default_radius is None else str(default_radius),
        model=model,
        altloc=altloc,
        chains=list(chains),
        hydrogens=hydrogens,
        ligands=ligands,
        waters=waters,
        allow_empty=allow_empty,
        limited=limited,
    )
