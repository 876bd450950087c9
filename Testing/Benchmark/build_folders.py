# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python with the package of a build folder, and with a display, which windows of VTK before 9.4 want."""
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def environment_of(build):
    """What Python finds vtktetmarch of a build folder by."""
    package = build / "lib/python3/dist-packages"
    if not (package / "vtktetmarch").is_dir():
        sys.exit(f"There is no {package / 'vtktetmarch'}: build vtkRenderingTetMarchPython there")
    return {**os.environ, "PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}


def run_again_with_display():
    """If there is no display, runs this program with an X server of its own instead."""
    if not os.environ.get("DISPLAY"):
        command = [sys.executable, HERE.parent / "Python/with_display.py", sys.executable, *sys.argv]
        sys.exit(subprocess.call(command))
