# SPDX-License-Identifier: MIT
"""Every alpha shape of weighted points in the plane and in space, exactly.

    shapes = orthoball.AlphaShapes(points)          # all of them, from an array or an object
    shape = shapes.shape(alpha=1.5)                 # one of them
    shape.volume, shape.triangles
    shapes.signatures["betti"]                      # numbers of all of them

`alpha2` is the parameter, a signed squared length; `alpha` its signed root, a length; `index`
counts the different shapes from 1, the spectrum's entries. Rows are those of the caller's array,
everywhere. Arrays that are given out cannot be written: results are values that do not change.
"""

from ._alpha_shapes import AlphaShapes
from ._balls import Balls, Contacts, Derivatives, MolecularSurface, Mouth, Pocket, Void
from ._candidates import AlphaCandidate, AlphaCandidates
from ._core import (
    InputError,
    LimitError,
    ParseError,
    Reading,
    __version__,
    has_linear_solver,
    input_formats,
)
from ._homology import Diagram, Diagrams, Representative, Representatives
from ._reading import read
from ._shape import Shape
from ._tables import (
    NONE,
    Filtration,
    Located,
    Nearest,
    NotableAlpha,
    OutlineCurve,
    PowerCells,
    Region,
    Role,
    ShapeEdits,
    Signatures,
    Simplices,
    Solid,
    SolidChange,
)
from ._view import View
from ._weights import ConflictError, EnforcedWeights, density_weights

__all__ = [
    "NONE",
    "AlphaCandidate",
    "AlphaCandidates",
    "AlphaShapes",
    "Balls",
    "ConflictError",
    "Contacts",
    "Derivatives",
    "Diagram",
    "Diagrams",
    "EnforcedWeights",
    "Filtration",
    "InputError",
    "LimitError",
    "Located",
    "MolecularSurface",
    "Mouth",
    "Nearest",
    "NotableAlpha",
    "OutlineCurve",
    "ParseError",
    "Pocket",
    "PowerCells",
    "Reading",
    "Region",
    "Representative",
    "Representatives",
    "Role",
    "Shape",
    "ShapeEdits",
    "Signatures",
    "Simplices",
    "Solid",
    "SolidChange",
    "View",
    "Void",
    "__version__",
    "density_weights",
    "has_linear_solver",
    "input_formats",
    "read",
]
