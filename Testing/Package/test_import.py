# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Import the package and make sure that it and its library come from the tree that is under test."""
import sys

import vtktetmarch
from vtktetmarch import vtkTetMarchVolumeMapper


def libraries_in_use():
    with open("/proc/self/maps", encoding="utf-8") as maps:
        return {line.split()[-1] for line in maps if "libvtkRenderingTetMarch" in line}


root = sys.argv[1]
assert vtktetmarch.__file__.startswith(root + "/"), vtktetmarch.__file__

mapper = vtkTetMarchVolumeMapper()
assert mapper.IsA("vtkUnstructuredGridVolumeMapper")
mapper.SetOpacityLawToStructured()
assert mapper.GetOpacityLaw() == vtkTetMarchVolumeMapper.STRUCTURED

libraries = libraries_in_use()
assert len(libraries) == 1 and libraries.pop().startswith(root + "/"), libraries
