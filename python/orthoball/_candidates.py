# SPDX-License-Identifier: MIT
"""Which alpha to take."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import as_float64, fault
from ._files import Written
from ._tables import NotableAlpha

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes


class AlphaCandidate(NamedTuple):
    """An alpha that may be the one to take, with the shape there. What it does not have, as one
    without an index, is None."""

    name: str
    """One word: "signature", "plateau_1", "manifold", "connected", ...; `alpha2="auto:NAME"` takes it."""
    reason: str
    """Half a sentence."""
    index: int | None
    """None where there is no such index."""
    alpha2: float | None
    """length^2."""
    alpha: float | None
    """The signed root of alpha2, a length."""
    inverse_alpha: float | None
    """1/alpha."""
    betti: tuple[int, ...] | None
    """Components, tunnels and (in space) voids."""
    volume: float | None
    """length^D."""
    area: float | None
    """length^(D-1), as of signatures."""
    stable_from: float | None
    """The alpha2 from which on the Betti numbers are these."""
    stable_to: float | None
    """The alpha2 at which they are no more; None for never."""
    stability: float | None
    """By how much the largest ball grows meanwhile: a ratio of radii, 1 or more; 2 for a stretch
    without an end."""
    found: int | None
    """In how many resamples there is one of this name; None without resamples, as what follows."""
    same_betti: int | None
    """In how many of them with these Betti numbers."""
    alpha_low: float | None
    """The lower quartile of alpha in them, a length."""
    alpha_median: float | None
    """The median."""
    alpha_high: float | None
    """The upper quartile."""


class AlphaCandidates(tuple[AlphaCandidate, ...], Written):
    """Alphas that may be the ones to take, the most stable first: see `AlphaShapes.alpha_candidates`."""

    _core: _core.Candidates
    _rows: list[dict[str, Any]]

    def __new__(cls, candidates: _core.Candidates) -> AlphaCandidates:
        rows = json.loads(candidates.file("json"))
        self = super().__new__(cls, map(_candidate, rows))
        self._core, self._rows = candidates, rows
        return self

    def to_bytes(self, format: str) -> bytes:
        """What `orthoball alpha` writes: "csv" or "json"."""
        return self._core.file(format)

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `orthoball alpha`: rank, name, index, ..., betti_0, ..."""
        import pandas

        return pandas.DataFrame(self._rows)

    def __repr__(self) -> str:
        return f"<orthoball.AlphaCandidates: {', '.join(one.name for one in self)}>"


def _candidate(row: dict[str, Any]) -> AlphaCandidate:
    betti = [row[name] for name in row if name.startswith("betti_")]
    columns = {name: row[name] for name in AlphaCandidate._fields if name != "betti"}
    return AlphaCandidate(betti=None if row["index"] is None else tuple(betti), **columns)


def named_alpha(shapes: AlphaShapes, text: str) -> NotableAlpha:
    """The alpha of "auto" or "auto:NAME"."""
    if text == "auto":
        return shapes.automatic_alpha()
    word, _, name = text.partition(":")
    names = _core.candidate_names(shapes.dimension)
    if word != "auto" or name not in names:
        raise fault(
            f'alpha2 is {text!r}; it must be a number, "auto" or "auto:NAME", NAME one of '
            f"{', '.join(names)}"
        )
    for one in shapes._candidates:
        if one.name == name and one.index is not None:
            alpha2 = one.alpha2
            if alpha2 is None:  # beyond the range of doubles
                alpha2 = float(shapes.spectrum[one.index - 1])
            alpha = math.copysign(math.sqrt(abs(alpha2)), alpha2)
            return NotableAlpha(one.name, one.reason, one.index, alpha2, alpha)
    scale = _core.scale_text(shapes._core)
    raise fault(f"alpha2 {text!r}: these points have no such alpha; {scale}")


def alphas(shapes: AlphaShapes, alpha2: Any) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Indices and alpha2 of some alpha2, of which each may be the name of one."""
    given = [alpha2] if isinstance(alpha2, str) else alpha2
    if isinstance(given, (list, tuple)) and any(isinstance(x, str) for x in given):
        chosen = [shapes._chosen(x, None, None, None) for x in given]
        return (
            np.array([index for index, _ in chosen], dtype=np.uint32),
            np.array([taken for _, taken in chosen], dtype=np.float64),
        )
    array = np.atleast_1d(as_float64(given, "alpha2")).ravel()
    return shapes._core.indices(array), array
