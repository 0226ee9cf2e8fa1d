# SPDX-License-Identifier: MIT
"""Shapes as objects of other packages, each imported where it is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import fault

if TYPE_CHECKING:
    from ._shape import Shape


def _require_dimension(shape: Shape, dimension: int, what: str) -> None:
    if shape.shapes.dimension != dimension:
        where = {2: "the plane", 3: "space"}
        raise fault(
            f"the points are in {where[5 - dimension]}; {what} is of points in {where[dimension]}"
        )


def to_trimesh(shape: Shape) -> Any:
    """See Shape.to_trimesh."""
    import trimesh

    _require_dimension(shape, 3, "a trimesh")
    mesh = shape._boundary
    return trimesh.Trimesh(
        vertices=mesh["coordinates"],
        faces=mesh["triangles"],
        vertex_attributes={"row": np.array(mesh["rows"])},
        process=False,
    )


def _blocks(shape: Shape) -> list[tuple[str, np.ndarray, np.ndarray]]:
    """(name in meshio, simplices as numbers of the mesh, roles) by dimension."""
    mesh = shape._boundary
    vertices = np.array(mesh["vertices"])[:, None]
    singular = np.ones(len(vertices), dtype=np.uint8)
    return [
        ("vertex", vertices, singular),
        ("line", mesh["edges"], mesh["edge_roles"]),
        ("triangle", mesh["triangles"], mesh["triangle_roles"]),
    ]


def to_pyvista(shape: Shape) -> Any:
    """See Shape.to_pyvista."""
    import pyvista

    def padded(cells: np.ndarray) -> np.ndarray | None:
        """Every cell after the number of its vertices; None for none."""
        if len(cells) == 0:
            return None
        return np.insert(cells.astype(np.int64), 0, cells.shape[1], axis=1).ravel()

    blocks = {name: (cells, roles) for name, cells, roles in _blocks(shape)}
    result = pyvista.PolyData(
        np.array(shape._boundary["coordinates"]),
        verts=padded(blocks["vertex"][0]),
        lines=padded(blocks["line"][0]),
        faces=padded(blocks["triangle"][0]),
    )
    if result.n_points > 0:
        result.point_data["row"] = np.array(shape._boundary["rows"])
        result.cell_data["role"] = np.concatenate([roles for _, roles in blocks.values()])
    return result


def to_meshio(shape: Shape) -> Any:
    """See Shape.to_meshio."""
    import meshio

    blocks = [block for block in _blocks(shape) if len(block[1]) > 0]
    return meshio.Mesh(
        np.array(shape._boundary["coordinates"]),
        [(name, np.array(cells)) for name, cells, _ in blocks],
        point_data={"row": np.array(shape._boundary["rows"])},
        cell_data={"role": [np.array(roles) for _, _, roles in blocks]},
    )


def to_shapely(shape: Shape) -> Any:
    """See Shape.to_shapely."""
    import shapely

    _require_dimension(shape, 2, "a polygon")
    points = shape.shapes.points
    polygons = [
        shapely.Polygon(points[rings[0]], [points[hole] for hole in rings[1:]])
        for rings in _core.polygons(shape._core)
    ]
    return shapely.MultiPolygon(polygons)
