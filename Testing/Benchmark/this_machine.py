# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What reports of measurements by Python say of the machine: the words of tetmarch-bench."""
import datetime
import os
import pathlib
import platform
import re

from vtkmodules.vtkCommonCore import vtkVersion

ROOT = pathlib.Path(__file__).resolve().parents[2]


def cpu_name():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")),
                platform.processor())


def version():
    return re.search(r"TetMarch VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def driver_of(window):
    """As it calls itself, after a first frame."""
    for line in window.ReportCapabilities().splitlines():
        if line.startswith("OpenGL renderer string:"):
            return line.partition(":")[2].strip()
    return "unknown"


def report_of(window):
    """The beginning of a report, of a window that has drawn."""
    return {"date": datetime.date.today().isoformat(), "tetmarch_version": version(),
            "environment": {"vtk_version": vtkVersion.GetVTKVersion(),
                            "gl": {"renderer": driver_of(window), "backend": window.GetClassName()}},
            "cpu": cpu_name(), "cpu_threads": os.cpu_count(), "load": os.getloadavg()[0], "size": window.GetSize()}
