# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes camera_table.json: what VTK's camera, renderer and trackball style make of movements of the camera.

python3 make_camera_table.py      (with VTK's modules; a display is needed, such as that of xvfb-run)
"""
import json
import pathlib

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: the window's implementation
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

SIZE = 320, 200
BOUNDS = -1.0, 3.0, 0.5, 2.5, -4.0, -1.0
START = {"position": [5.0, 4.0, 9.0], "focalPoint": [1.0, 1.0, -2.0], "viewUp": [0.1, 1.0, 0.2], "viewAngle": 30.0,
         "parallelProjection": False, "parallelScale": 2.5, "clippingRange": [0.5, 40.0]}
PARALLEL = dict(START, parallelProjection=True)
NEAR = dict(START, position=[1.0, 1.2, -1.5])  # inside of the bounds
FLAT = -1.0, 3.0, 0.5, 2.5, -2.0, -2.0
TO_CENTER = dict(START, position=[1.0, 2.0, -2.0], focalPoint=[1.0, 1.0, -2.0])  # along viewUp

MOVES = (
    [[START, BOUNDS, move] for move in (
        [], ["azimuth", 30], ["elevation", -25], ["roll", 70], ["dolly", 1.5], ["zoom", 3], ["orthogonalizeViewUp"],
        ["resetClippingRange"], ["reset"], ["drag", "rotate", [100, 60], [171, 93]],
        ["drag", "pan", [100, 60], [171, 93]], ["drag", "zoom", [100, 60], [171, 93]],
        ["drag", "roll", [100, 60], [171, 93]], ["wheel", 1], ["wheel", -1])]
    + [[PARALLEL, BOUNDS, move] for move in (
        [], ["zoom", 3], ["resetClippingRange"], ["reset"], ["drag", "pan", [100, 60], [171, 93]],
        ["drag", "zoom", [100, 60], [171, 93]], ["wheel", 1])]
    + [[NEAR, BOUNDS, ["resetClippingRange"]], [START, FLAT, ["resetClippingRange"]],
       [START, [2, 2, 3, 3, 4, 4], ["reset"]],
       [dict(PARALLEL, position=[1.0, 1.0, 9.0]), FLAT, ["resetClippingRange"]], [TO_CENTER, BOUNDS, ["reset"]]])
BUTTONS = {"rotate": "Left", "pan": "Middle", "zoom": "Right", "roll": "Left"}


def cube(bounds):
    source = vtkCubeSource()
    source.SetBounds(*bounds)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


class Scene:
    window = vtkRenderWindow()
    interactor = vtkGenericRenderWindowInteractor()

    def __init__(self, view, bounds):
        self.bounds = bounds
        self.window.OffScreenRenderingOn()
        self.window.SetSize(*SIZE)
        self.window.GetRenderers().RemoveAllItems()
        self.renderer = vtkRenderer()
        self.renderer.SetNearClippingPlaneTolerance(0.001)
        self.renderer.AddActor(cube(bounds))
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.interactor.SetRenderWindow(self.window)
        self.interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        self.interactor.Initialize()
        self.window.Render()
        for name, value in view.items():
            getattr(self.camera, "Set" + name[0].upper() + name[1:])(value)

    def drag(self, movement, start, end):
        button = BUTTONS[movement]
        self.tell(start, movement == "roll")
        getattr(self.interactor, button + "ButtonPressEvent")()
        self.tell(end, movement == "roll")
        self.interactor.MouseMoveEvent()
        getattr(self.interactor, button + "ButtonReleaseEvent")()

    def tell(self, point, control=False):
        self.interactor.SetEventInformation(*point, int(control), 0, "\0", 0, None)

    def wheel(self, notches):
        self.tell((10, 10))
        self.interactor.MouseWheelForwardEvent() if notches > 0 else self.interactor.MouseWheelBackwardEvent()

    def move(self, name, *values):
        if name in ("drag", "wheel"):
            getattr(self, name)(*values)
            self.renderer.ResetCameraClippingRange(self.bounds)  # as the page does after every movement
        elif name == "resetClippingRange":
            self.renderer.ResetCameraClippingRange(self.bounds)
        elif name == "reset":
            self.renderer.ResetCamera(self.bounds)
        else:
            getattr(self.camera, name[0].upper() + name[1:])(*values)

    def view(self):
        return {name: getattr(self.camera, "Get" + name[0].upper() + name[1:])() for name in START}


def matrix(of):
    return [of.GetElement(row, column) for row in range(4) for column in range(4)]


def row(view, bounds, move):
    scene = Scene(view, bounds)
    if move:
        scene.move(*move)
    found = scene.view()
    found["parallelProjection"] = bool(found["parallelProjection"])
    projection = scene.camera.GetProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    return {"view": view, "bounds": bounds, "move": move, "after": found,
            "viewMatrix": matrix(scene.camera.GetViewTransformMatrix()), "projectionMatrix": matrix(projection)}


def main():
    rows = [json.dumps(row(*move)) for move in MOVES]
    table = pathlib.Path(__file__).with_name("camera_table.json")
    table.write_text('{"size": %s, "rows": [\n%s\n]}\n' % (json.dumps(SIZE), ",\n".join(rows)))


if __name__ == "__main__":
    main()
