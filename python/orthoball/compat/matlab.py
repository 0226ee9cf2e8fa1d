# SPDX-License-Identifier: MIT
"""MATLAB's `alphaShape` by orthoball: alpha is a radius, rows count from 0.

Exact where MATLAB's is rounded. A simplex whose radius is alpha belongs to the shape. Only cells make
it: singular triangles, edges and points are left out. Holes are filled before regions are
suppressed, both up to and including their thresholds. Regions count from 0, the largest first. Not here:
`nearestNeighbor`, for which `orthoball.Shape.nearest` gives the nearest points of the boundary.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._alpha_shapes import AlphaShapes
from .._arrays import fault
from .._shape import Shape
from .._tables import Region

_CRITICAL = {"all-points": "all_vertices_in_cells", "one-region": "one_region"}


class alphaShape:
    """The alpha shape of points in the plane or in space.

    Args:
        points: (n, 2) or (n, 3); or the columns x, y[, z] one by one.
        alpha: the radius, behind the points; math.inf for the convex hull. By default
            criticalAlpha("all-points").
        HoleThreshold: the largest volume (in the plane: area) of holes that are filled.
        RegionThreshold: the largest volume (in the plane: area) of regions that are suppressed.

    Raises InputError (a ValueError) as AlphaShapes does.
    """

    def __init__(
        self,
        *points: Any,
        alpha: float | None = None,
        HoleThreshold: float = 0.0,
        RegionThreshold: float = 0.0,
    ):
        columns = list(points)
        if not columns:
            raise fault("alphaShape needs points: an array, or the columns x, y[, z]")
        if np.ndim(columns[-1]) == 0 and alpha is None:
            alpha = float(columns.pop())
        if len({np.size(column) for column in columns}) != 1 and len(columns) > 1:
            sizes = ", ".join(str(np.size(column)) for column in columns)
            raise fault(f"the columns have {sizes} numbers; they must have the same")
        self.shapes = AlphaShapes(columns[0] if len(columns) == 1 else np.column_stack(columns))
        """The AlphaShapes, for everything else."""
        self._thresholds = float(HoleThreshold), float(RegionThreshold)
        self.Alpha = self.criticalAlpha("all-points") if alpha is None else float(alpha)

    @property
    def Points(self) -> NDArray[np.float64]:
        """(n, D) coordinates."""
        return self.shapes.points

    @property
    def Alpha(self) -> float:
        """The radius; it may be given anew."""
        return self._alpha

    @Alpha.setter
    def Alpha(self, alpha: float) -> None:
        if not alpha >= 0:
            raise fault(f"alpha is {alpha}; a radius is 0 or more")
        self._alpha = alpha
        self._update()

    @property
    def HoleThreshold(self) -> float:
        """The largest volume (in the plane: area) of holes that are filled; it may be given anew."""
        return self._thresholds[0]

    @HoleThreshold.setter
    def HoleThreshold(self, threshold: float) -> None:
        self._thresholds = float(threshold), self._thresholds[1]
        self._update()

    @property
    def RegionThreshold(self) -> float:
        """The largest volume (in the plane: area) of regions that are suppressed; it may be given
        anew."""
        return self._thresholds[1]

    @RegionThreshold.setter
    def RegionThreshold(self, threshold: float) -> None:
        self._thresholds = self._thresholds[0], float(threshold)
        self._update()

    def _update(self) -> None:
        self._shape = self._made(None)

    def _made(self, region: int | None) -> Shape:
        holes, regions = self._thresholds
        return self.shapes.shape(
            alpha=self._alpha,
            regularized=True,
            hole_threshold=holes or None,
            region_threshold=regions or None,
            region=None if region is None else region + 1,
        )

    @property
    def shape(self) -> Shape:
        """The Shape at Alpha."""
        return self._shape

    def alphaSpectrum(self) -> NDArray[np.float64]:
        """(k,) the radii at which cells join the shape, the largest first."""
        shapes = self.shapes
        enters = np.unique(shapes.simplices(shapes.dimension).enters)[::-1]
        # Those that give back their own index, whatever roots and squares are rounded to.
        return np.array([_radius(shapes, index) for index in enters.tolist()])

    def criticalAlpha(self, type: str) -> float:
        """The smallest radius at which the shape has all points ("all-points"), or is one region
        besides ("one-region"). 0 where there is none."""
        if type not in _CRITICAL:
            raise fault(f'the type is {type!r}; it is "all-points" or "one-region"')
        (notable,) = (n for n in self.shapes.notable_alphas() if n.name == _CRITICAL[type])
        return 0.0 if notable.index is None else _radius(self.shapes, notable.index)

    def numRegions(self) -> int:
        """How many regions there are: cells with a common vertex are in one."""
        return len(self._shape.regions())

    def _region(self, region: int | None) -> Region | None:
        if region is None:
            return None
        regions = self._shape.regions()
        if not 0 <= region < len(regions):
            raise fault(f"there is no region {region}; they are 0 to {len(regions) - 1}")
        return regions[region]

    def _of(self, region: int | None) -> Shape:
        self._region(region)  # refuses a number that is none
        return self._shape if region is None else self._made(region)

    def inShape(self, *points: ArrayLike, region: int | None = None) -> NDArray[np.bool_]:
        """Whether points are in the shape or one region: (n, D), or the columns x, y[, z] one by one,
        of any shape, which the result has."""
        shape = self._of(region)
        if len(points) == 1:
            return shape.contains(points[0])
        if not points:
            raise fault("inShape needs points: an array, or the columns x, y[, z]")
        columns = np.broadcast_arrays(*points)
        flat = np.column_stack([column.ravel() for column in columns])
        return shape.contains(flat).reshape(columns[0].shape)

    def volume(self, region: int | None = None) -> float:
        """Of the shape or one region, the largest being 0. Points in space only."""
        self._require(3, "volume", "area")
        return self._volume(region)

    def area(self, region: int | None = None) -> float:
        """Of the shape or one region, the largest being 0. Points in the plane only."""
        self._require(2, "area", "volume or surfaceArea")
        return self._volume(region)

    def surfaceArea(self, region: int | None = None) -> float:
        """Of the shape or one region. Points in space only."""
        self._require(3, "surfaceArea", "perimeter")
        return self._area(region)

    def perimeter(self, region: int | None = None) -> float:
        """Of the shape or one region. Points in the plane only."""
        self._require(2, "perimeter", "surfaceArea")
        return self._area(region)

    def alphaTriangulation(self, region: int | None = None) -> NDArray[np.uint32]:
        """(k, D + 1) the cells of the shape or of one region, as rows."""
        one = self._region(region)
        return self._shape.cells if one is None else one.cells

    def boundaryFacets(self, region: int | None = None) -> NDArray[np.uint32]:
        """(k, D) the triangles (in the plane: edges) of the boundary of the shape or of one region, as
        rows: counterclockwise seen from outside, with the inside on the left."""
        shape = self._of(region)
        return shape.triangles if self.shapes.dimension == 3 else shape.edges

    def plot(self, ax: Any = None) -> Any:
        """Draws the shape with matplotlib. Returns the axes."""
        return self._shape.plot(ax=ax)

    def _volume(self, region: int | None) -> float:
        one = self._region(region)
        return self._shape.volume if one is None else one.volume

    def _area(self, region: int | None) -> float:
        one = self._region(region)
        return self._shape.area if one is None else one.area

    def _require(self, dimension: int, name: str, instead: str) -> None:
        if self.shapes.dimension != dimension:
            where = {2: "the plane", 3: "space"}
            raise fault(f"{name} is of points in {where[dimension]}; for these there is {instead}")


def _radius(shapes: AlphaShapes, index: int) -> float:
    """The radius of an index, at least as large as needed for the shape to have that index."""
    alpha = math.sqrt(max(shapes.spectrum[index - 1], 0.0))
    while shapes.shape(alpha=alpha).index < index:
        alpha = math.nextafter(alpha, math.inf)
    return alpha
