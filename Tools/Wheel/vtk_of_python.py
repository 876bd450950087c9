# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the VTK that the running Python has, which a wheel is built for."""
import importlib.metadata
import importlib.resources
import json
import os
import pathlib
import subprocess
import sys
from typing import NamedTuple

# A build isolated by pip doesn't see the packages of its own Python, but a process started with -I does.
QUESTION = """
import importlib.metadata, json, pathlib, sys
try:
    import vtkmodules
    from vtkmodules.vtkCommonCore import vtkVersion
except ImportError as error:
    sys.exit(str(error))
try:
    distribution = importlib.metadata.version("vtk")
except importlib.metadata.PackageNotFoundError:
    distribution = None
bundled = any(True for folder in vtkmodules.__path__ for _ in pathlib.Path(folder).glob("*vtkCommonCore-*"))
print(json.dumps({"version": vtkVersion.GetVTKVersion(), "distribution": distribution, "bundled": bundled}))
"""


class VtkOfPython(NamedTuple):
    """version: "9.1.0". distribution: the version that pip knows; None: it knows none, as of Debian 12's package.

    bundled: whether the libraries are in the Python package, as in VTK's wheels. Their headers are in another wheel,
    vtk-sdk, from VTK 9.6 on.
    """

    version: str
    distribution: str | None
    bundled: bool

    def build_requirements(self):
        """What pip installs for the build."""
        if not self.bundled:
            return []
        if tuple(int(part) for part in self.version.split(".")[:2]) < (9, 6):
            raise SystemExit(f"VTK {self.version} was installed by pip, whose packages have no headers before VTK 9.6: "
                             "update vtk, or use the VTK of your system or of conda-forge")
        return [f"vtk-sdk=={self.version}"]

    def dependency(self):
        """The line of the wheel's metadata that pins this VTK."""
        if self.distribution is None:
            return f"Requires-External: vtk (=={self.version})"
        return f"Requires-Dist: vtk=={self.distribution}"

    def cmake_prefixes(self):
        """Folders in which CMake looks for VTK besides the system's."""
        if self.bundled:
            return [str(importlib.resources.files(point.load()))
                    for point in importlib.metadata.entry_points(group="cmake.prefix")]
        return [sys.prefix]  # of conda, or of a virtual environment, which has none


def clean_environment():
    """The environment of this process, without pip's isolation."""
    return {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONNOUSERSITE")}


def vtk_of_python():
    """The VtkOfPython. Raises SystemExit, which says what to install."""
    run = subprocess.run([sys.executable, "-I", "-c", QUESTION], env=clean_environment(), capture_output=True,
                         text=True, check=False)
    if run.returncode != 0:
        raise SystemExit(f"{sys.executable} has no VTK ({run.stderr.strip()}). Install it first: on Debian "
                         "`apt-get install python3-vtk9 libvtk9-dev`, and make the environment with "
                         "`python3 -m venv --system-site-packages`")
    return VtkOfPython(**json.loads(run.stdout))
