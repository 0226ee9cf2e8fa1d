# SPDX-License-Identifier: MIT
"""`gudhi.AlphaComplex` by orthoball: exact values at every precision, and a real SimplexTree.

Filtration values are alpha2, the squares of radii, as gudhi's are. gudhi must be installed for
`create_simplex_tree`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._alpha_shapes import AlphaShapes

_relative_precision = 1e-5


class AlphaComplex:
    """The alpha complex of points in the plane or in space.

    Args:
        points: (n, 2) or (n, 3); anything that `orthoball.AlphaShapes` takes.
        weights: (n,) squared lengths, or None.
        precision: "fast", "safe" or "exact", which are one here: order and values are exact, values
            then rounded to the nearest double.

    Raises InputError (a ValueError) as AlphaShapes does; for points of more than three dimensions
    use gudhi's own.
    """

    def __init__(self, points: Any = (), weights: ArrayLike | None = None, precision: str = "safe"):
        if precision not in ("fast", "safe", "exact"):
            raise ValueError(f'the precision is {precision!r}; it is "fast", "safe" or "exact"')
        if isinstance(points, (list, tuple)) and len(points) == 0:
            points = np.zeros((0, 3))
        self.shapes = AlphaShapes(points, weights)
        """The AlphaShapes, for everything else."""

    @staticmethod
    def set_float_relative_precision(precision: float) -> None:
        """Sets what `get_float_relative_precision` tells, 0 < precision < 1, and nothing else: values
        are the doubles nearest to the exact ones, whatever it is.

        Raises ValueError for other numbers, as gudhi's does.
        """
        global _relative_precision
        if not 0 < precision < 1:
            raise ValueError(f"the relative precision is {precision}; it is between 0 and 1")
        _relative_precision = float(precision)

    @staticmethod
    def get_float_relative_precision() -> float:
        """1e-5, as gudhi's, unless it was set. The values' own is 2^-53."""
        return _relative_precision

    def create_simplex_tree(
        self,
        max_alpha_square: float = np.inf,
        default_filtration_value: bool = False,
        output_squared_values: bool = True,
    ) -> Any:
        """A gudhi.SimplexTree; vertex k is row k. Hidden and duplicate points are not in it.

        Args:
            max_alpha_square: simplices beyond it are left out.
            default_filtration_value: NaN for all values.
            output_squared_values: False for alpha, the signed roots, instead of alpha2.
        """
        import gudhi

        filtration = self.shapes.filtration(alpha2=max_alpha_square)
        values = filtration.alpha2
        if not output_squared_values:
            values = np.copysign(np.sqrt(np.abs(values)), values)
        tree = gudhi.SimplexTree()
        for k in range(self.shapes.dimension + 1):
            of_dimension = filtration.dimension == k
            tree.insert_batch(
                np.asfortranarray(filtration.vertices[of_dimension, : k + 1].T.astype(np.int32)),
                values[of_dimension],
            )
        if default_filtration_value:
            tree.reset_filtration(np.nan)
        return tree

    def get_point(self, vertex: int) -> list[float]:
        """The coordinates of a vertex of the tree."""
        return self.shapes.points[vertex].tolist()
