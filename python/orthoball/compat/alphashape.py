# SPDX-License-Identifier: MIT
"""The functions of the package `alphashape` by orthoball: alpha is 1/radius.

What differs: polygons keep their holes, which alphashape fills; a simplex whose radius is 1/alpha
belongs to the shape, where alphashape leaves it out; a shape is what is solid, so points on a line
have an empty one, where alphashape has the line; alpha is one number, where alphashape also takes a
function of simplices, of which no alpha shape comes; points of more than three dimensions are
refused. shapely must be installed for points in the plane, trimesh for points in space.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .._alpha_shapes import AlphaShapes
from .._shape import Shape


def _shapes_of(points: Any) -> AlphaShapes:
    """Also of a MultiPoint of shapely."""
    if hasattr(points, "geoms"):
        points = np.array([point.coords[0] for point in points.geoms]).reshape(
            len(points.geoms), -1
        )
    return AlphaShapes(points)


def _polygon(shape: Shape) -> Any:
    import shapely

    region = shape.to_shapely()
    if region.is_empty:
        return shapely.GeometryCollection()
    return region.geoms[0] if len(region.geoms) == 1 else region


def alphashape(points: Any, alpha: float | None = None) -> Any:
    """The alpha shape as a shapely geometry (plane) or a trimesh.Trimesh (space).

    Args:
        points: (n, 2) or (n, 3), or a MultiPoint of shapely, or what AlphaShapes takes. A GeoDataFrame
            gives a GeoDataFrame.
        alpha: 1/radius; 0 or less for the convex hull; None for `optimizealpha(points)`.

    Returns:
        In the plane the solid part: a Polygon, MultiPolygon, or an empty GeometryCollection.
    """
    if callable(alpha):
        raise TypeError(
            "alpha is a function of simplices; it must be one number, for shapes are those of one alpha"
        )
    shapes = _shapes_of(points)
    if alpha is None:
        alpha = _optimal(shapes)
    if alpha <= 0:
        shape = shapes.shape(index=len(shapes.spectrum), regularized=True)
    else:
        shape = shapes.shape(inverse_alpha=float(alpha), regularized=True)
    if shapes.dimension == 3:
        return shape.to_trimesh()
    if hasattr(points, "set_geometry"):
        return type(points)(geometry=[_polygon(shape)], crs=points.crs)
    return _polygon(shape)


def optimizealpha(
    points: Any,
    max_iterations: int = 10000,
    lower: float = 0.0,
    upper: float = math.inf,
    silent: bool = False,
) -> float:
    """The largest alpha = 1/radius whose shape is one solid piece with every point.

    Found without search: it is the notable alpha "solid". `max_iterations` and `silent` have no
    meaning here.

    Args:
        lower, upper: 0 is returned where the result is below lower, upper where it is above.

    Returns:
        1/radius; 0, which stands for the convex hull, where no shape is solid.
    """
    alpha = _optimal(_shapes_of(points))
    return 0.0 if alpha < lower else min(alpha, upper)


def _optimal(shapes: AlphaShapes) -> float:
    (solid,) = (notable for notable in shapes.notable_alphas() if notable.name == "solid")
    if solid.index is None or solid.alpha2 <= 0:
        return 0.0
    alpha = 1.0 / solid.alpha
    # Rounding may have made it too large for its own shape.
    while shapes.shape(inverse_alpha=alpha).index < solid.index:
        alpha = math.nextafter(alpha, 0.0)
    return alpha
