# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page that draws an image by vtk.js, with the view and the transfer functions of one of our pages."""
import base64
import json
import pathlib
import shutil
import subprocess

from vtkmodules.util.numpy_support import vtk_to_numpy

VERSION = "37.3.1"
SCRIPT = pathlib.Path(__file__).with_name("vtkjs_page.js")


def install(folder):
    """The script of vtk.js, of npm; None, with a line that says why, if it can't be had."""
    if shutil.which("npm") is None:
        print("vtk.js is left out: there is no npm (Debian's package npm has it)", flush=True)
        return None
    command = ["npm", "install", "--prefix", str(folder), "--no-save", "--ignore-scripts", "--no-audit", "--no-fund",
               f"vtk.js@{VERSION}"]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    script = folder / "node_modules/vtk.js/vtk.js"
    if done.returncode != 0 or not script.exists():
        print(f"vtk.js is left out: npm couldn't install vtk.js@{VERSION}:\n{done.stdout}", flush=True)
        return None
    return script


def scene_of(figure, functions, samples):
    """What vtkjs_page.js reads. functions: of our page, linear between points; samples: per voxel."""
    image = figure.mapper.GetInput()
    camera = figure.camera
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return {
        "size": figure.size, "background": figure.renderer.GetBackground(),
        "camera": {"position": camera.GetPosition(), "focalPoint": camera.GetFocalPoint(),
                   "viewUp": camera.GetViewUp(), "viewAngle": camera.GetViewAngle()},
        "dimensions": image.GetDimensions(), "origin": image.GetOrigin(), "spacing": image.GetSpacing(),
        "values": base64.b64encode(values.tobytes()).decode(), "functions": functions,
        "unitDistance": figure.volume.GetProperty().GetScalarOpacityUnitDistance(),
        "sampleDistance": min(image.GetSpacing()) / samples}


def write_page(path, script, scene):
    path.write_text(f"""<!DOCTYPE html><meta charset="utf-8"><title>loading</title>
<style>html, body {{ margin: 0 }} canvas {{ display: block }}</style><div></div>
<script src="{script.as_uri()}"></script><script>const scene = {json.dumps(scene)};</script>
<script>{SCRIPT.read_text()}</script>""")
