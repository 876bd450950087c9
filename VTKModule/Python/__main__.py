# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs an unchanged script with the mappers of TetMarch in place of VTK's: python3 -m vtktetmarch SCRIPT..."""
import os
import runpy
import sys

from .replacement import replace_smart_volume_mapper, replace_unstructured_mappers


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    script = sys.argv[1]
    if not os.path.isfile(script):
        sys.exit(f"there is no script {script!r}")
    replace_smart_volume_mapper()
    replace_unstructured_mappers()
    sys.argv = sys.argv[1:]
    sys.path[0] = os.path.dirname(os.path.abspath(script))
    runpy.run_path(script, run_name="__main__")


if __name__ == "__main__":
    main()
