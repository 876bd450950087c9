# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs that a wheel has."""
import os
import sys


def render():
    """Becomes tetmarch-render, with the arguments of this process."""
    program = os.path.join(os.path.dirname(__file__), "bin", "tetmarch-render")
    if not os.path.exists(program):
        sys.exit(f"{program} is missing: install vtktetmarch again")
    os.execv(program, [program, *sys.argv[1:]])
