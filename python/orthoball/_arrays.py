# SPDX-License-Identifier: MIT
"""Arrays of callers, checked and widened exactly; every error names the row."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from typing import Any

import numpy as np

from ._core import InputError

_LARGEST_INTEGER = 2**53


def fault(message: str, row: int | None = None, reason: str = "wrong_argument") -> InputError:
    """The error for a row, or for the whole where no single row is at fault."""
    error = InputError(message if row is None else f"row {row}: {message}")
    error.row = row
    error.reason = reason
    return error


def _first(flags: np.ndarray) -> int:
    return int(np.flatnonzero(flags.reshape(len(flags), -1).any(axis=1))[0])


def _array(values: Any, name: str) -> np.ndarray:
    if np.ma.is_masked(values):
        raise fault(f"{name} is masked", _first(np.ma.getmaskarray(values)))
    try:
        return np.asarray(values)
    except ValueError:  # rows of different lengths
        lengths = [np.size(row) for row in values]
        row = next(i for i, length in enumerate(lengths) if length != lengths[0])
        raise fault(
            f"{name} has {lengths[row]} numbers, row 0 has {lengths[0]}", row, "wrong_size"
        ) from None


def as_float64(values: Any, name: str) -> np.ndarray:
    """`values` as contiguous float64 of the same shape.

    Raises InputError for numbers that float64 does not hold exactly, and for what is no number.
    """
    array = _array(values, name)
    if array.size == 0 and array.dtype.kind in "fiuO":
        return np.zeros(array.shape)
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        # Without abs(), which has no answer for the smallest integer.
        beyond = (array > _LARGEST_INTEGER) | (array < -_LARGEST_INTEGER)
        if beyond.any():
            raise fault(f"{name} has an integer beyond 2^53, which no double holds", _first(beyond))
    elif array.dtype.kind not in "iuf" or array.dtype.itemsize > 8:
        row = _row_of_other_type(array)
        raise fault(
            f"{name} of type {array.dtype}; numbers must be float64, float32 or integers", row
        )
    return np.asarray(array, dtype=np.float64, order="C")


def _row_of_other_type(array: np.ndarray) -> int | None:
    """Of an array of objects or texts, the first row with one that is no number; None where all are."""
    if array.dtype.kind not in "OUS" or array.ndim == 0:
        return None
    for row, values in enumerate(array):
        try:
            for value in np.ravel(values):
                float(value)
        except (TypeError, ValueError):
            return row
    return None


def as_points(values: Any) -> np.ndarray:
    """Coordinates as contiguous float64 of shape (n, 2) or (n, 3)."""
    points = as_float64(values, "points")
    if points.ndim == 2 and points.shape[1] in (2, 3):
        return points
    raise fault(
        f"points have the shape {points.shape}; it must be (n, 2) or (n, 3)", None, "wrong_size"
    )


def as_column(values: Any, size: int, name: str) -> np.ndarray:
    """One number for each of `size` rows as contiguous float64; a single one stands for all."""
    column = as_float64(values, name)
    if column.ndim == 0:
        return np.full(size, float(column))
    if column.ndim == 2 and column.shape[1] == 1:
        column = column[:, 0]
    if column.shape != (size,):
        raise fault(
            f"{name} have the shape {column.shape}; it must be ({size},), one for each point",
            None,
            "wrong_size",
        )
    return column


def as_threads(threads: Any) -> int | None:
    """A number of threads; None for one for each core."""
    if threads is None:
        return None
    try:
        number = operator.index(threads)
    except TypeError:
        number = 0
    if not 1 <= number <= 1024:
        raise fault(f"threads is {threads!r}; it is a whole number from 1 to 1024")
    return number


def stacked(rows: Sequence[Any], width: int) -> np.ndarray:
    """Rows of numbers as (n, width), also where there are none."""
    return np.array(rows, dtype=np.float64).reshape(-1, width)
