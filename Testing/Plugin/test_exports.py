# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes are exported with a volume in them: surfaces as they are, the volume where the format keeps the picture, and
in our own web page."""
import importlib.util
import json
import pathlib
import re
import tempfile
import zipfile

from messages import Messages
from paraview import simple
from state_values import make_scene
from views import REPRESENTATION, load_plugin, parse_arguments, picture_of

POINTS = 50  # of the sphere beside the volume


def points_of_gltf(path):
    return [accessor["count"] for accessor in json.loads(path.read_text())["accessors"] if accessor["type"] == "VEC3"]


def points_of_x3d(path):
    """In tuples of the coordinates."""
    parts = path.read_text().split("<Coordinate ")[1:]
    return [len(part.split('point="')[1].split('"')[0].split(",")) - 1 for part in parts]


def points_of_vrml(path):
    parts = path.read_text().split("coord DEF")[1:] or path.read_text().split("Coordinate {")[1:]
    return [part.split("[")[1].split("]")[0].count(",") for part in parts]


def points_of_pov(path):
    return [int(part.split("{")[1].split(",")[0]) for part in path.read_text().split("vertex_vectors")[1:]]


def points_of_vtkjs(path):
    with zipfile.ZipFile(path) as file:
        names = [name for name in file.namelist() if name.count("/") == 1 and name.endswith("index.json")]
        return [json.loads(file.read(name)).get("points", {}).get("size", 0) // 3 for name in names]


# The last one leaves what was hidden visible in all views, with ParaView's own volumes as well.
GEOMETRY = {"gltf": points_of_gltf, "x3d": points_of_x3d, "vrml": points_of_vrml, "pov": points_of_pov,
            "vtkjs": points_of_vtkjs}
# Pages with a picture of what can't be drawn by lines and triangles.
PAGES = ("eps", "ps", "pdf")


def has_vtkjs():
    """Debian's ParaView 6.1 lacks what makes one file of it."""
    try:
        return importlib.util.find_spec("paraview.web.vtkjs_helper") is not None
    except ImportError:
        return False


def check_geometry(views, folder, messages):
    for kind, points_of in GEOMETRY.items():
        if kind == "vtkjs" and not has_vtkjs():
            print("vtkjs: this ParaView can't export it")
            continue
        for view in views:
            path = folder / f"scene.{kind}"
            simple.ExportView(str(path), view)
            found = points_of(path)
            print(f"{kind}: surfaces of {found} points")
            assert POINTS in found, f"{kind}: the sphere is not exported"
            assert not messages.take(), kind


def check_pages(view, display, folder):
    """The volume is in them: without it the page is another one."""
    for kind in PAGES:
        pages = []
        for visible in (1, 0, 1):
            display.Visibility = visible
            path = folder / f"page.{kind}"
            simple.ExportView(str(path), view)
            lines = path.read_bytes().splitlines()
            pages.append([line for line in lines if b"Date" not in line])
        assert pages[0] == pages[2], f"{kind}: the same scene gives two pages"
        assert pages[0] != pages[1], f"{kind}: the volume is not in it"


def check_web_page(view, display, law, folder, messages):
    """The volume is in it, and the sphere; without the volume a warning says why."""
    path = folder / "page.html"
    for controls in (1, 0):
        simple.ExportView(str(path), view, Controls=controls)
        (text,) = re.findall(r'<script type="application/json" id="scene">(.*?)</script>', path.read_text(), re.DOTALL)
        scene = json.loads(text)
        (step,) = scene["steps"]
        assert [volume["law"] for volume in step["volumes"]] == [law], step["volumes"]
        assert len(step["surfaces"]) == 1, step["surfaces"]
        assert scene["camera"]["position"] == list(view.CameraPosition), scene["camera"]
        assert (scene["controls"], scene["omissions"]) == (("none", "all")[controls], []), scene["omissions"]
        assert not messages.take()
    display.SetRepresentationType("Volume")
    simple.ExportView(str(path), view)
    (said,) = messages.take()
    assert "A volume is not in the page: its mapper is a vtk" in said, said
    display.SetRepresentationType(REPRESENTATION)
    simple.ExportView(str(folder / "none" / "page.html"), view)
    (said,) = messages.take()
    assert "could not be written: No such file or directory" in said, said


def main():
    load_plugin(parse_arguments(__doc__))
    messages = Messages()
    scene = make_scene()
    for view, _, _ in scene:
        simple.Show(simple.Sphere(Center=[12.0, 0.0, 0.0], Radius=3.0), view)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for view, display, _ in scene:
            before = picture_of(view)
            check_pages(view, display, folder)
            check_web_page(view, display, "structured" if view is scene[1][0] else "unstructured", folder, messages)
            assert picture_of(view) == before, "an export leaves something behind"
        check_geometry([view for view, _, _ in scene], folder, messages)


main()
