# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of cell types, and their numbers of points."""
from vtkmodules import vtkCommonDataModel as model

from .checks import checked_integer

# Name: (VTK's number, points of a cell; 0: any number). The names are meshio's, if it has one.
CELL_TYPES = {
    "tetra": (model.VTK_TETRA, 4),
    "voxel": (model.VTK_VOXEL, 8),
    "hexahedron": (model.VTK_HEXAHEDRON, 8),
    "wedge": (model.VTK_WEDGE, 6),
    "pyramid": (model.VTK_PYRAMID, 5),
    "penta_prism": (model.VTK_PENTAGONAL_PRISM, 10),
    "hexa_prism": (model.VTK_HEXAGONAL_PRISM, 12),
    "tetra10": (model.VTK_QUADRATIC_TETRA, 10),
    "hexahedron20": (model.VTK_QUADRATIC_HEXAHEDRON, 20),
    "hexahedron24": (model.VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24),
    "hexahedron27": (model.VTK_TRIQUADRATIC_HEXAHEDRON, 27),
    "wedge12": (model.VTK_QUADRATIC_LINEAR_WEDGE, 12),
    "wedge15": (model.VTK_QUADRATIC_WEDGE, 15),
    "wedge18": (model.VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18),
    "pyramid13": (model.VTK_QUADRATIC_PYRAMID, 13),
    "VTK_LAGRANGE_TETRAHEDRON": (model.VTK_LAGRANGE_TETRAHEDRON, 0),
    "VTK_LAGRANGE_HEXAHEDRON": (model.VTK_LAGRANGE_HEXAHEDRON, 0),
    "VTK_LAGRANGE_WEDGE": (model.VTK_LAGRANGE_WEDGE, 0),
    "VTK_BEZIER_TETRAHEDRON": (model.VTK_BEZIER_TETRAHEDRON, 0),
    "VTK_BEZIER_HEXAHEDRON": (model.VTK_BEZIER_HEXAHEDRON, 0),
    "VTK_BEZIER_WEDGE": (model.VTK_BEZIER_WEDGE, 0),
}
POINTS = dict(CELL_TYPES.values())


def cell_type_number(cell_type):
    """VTK's number of a type, given its name or number."""
    if isinstance(cell_type, str):
        if cell_type not in CELL_TYPES:
            raise ValueError(f"each of cell_types is a name or a number of VTK's, not {cell_type!r}; there are "
                             f"{', '.join(CELL_TYPES)}")
        return CELL_TYPES[cell_type][0]
    number = checked_integer(cell_type, "each of cell_types, unless it is a name,")
    if number == model.VTK_POLYHEDRON:
        raise ValueError("polyhedra have faces, which from_arrays() doesn't take: use "
                         "vtkUnstructuredGrid.InsertNextCell()")
    if not 0 < number <= 255:
        raise ValueError(f"each of cell_types is a name or a number of VTK's, 1 to 255, not {cell_type!r}")
    return number
