# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Documentation/ParaView.md: window_pictures.py PROJECT PLUGIN ROOT WATCH OUTPUT

ROOT is the folder in which ParaView was unpacked, WATCH the library of WidgetWatch.cxx, OUTPUT a folder. Wants a
display of its own, as Testing/Python/with_display.py makes one.
"""
import os
import sys
import tempfile

import numpy as np
import vtkmodules.all as vtk
from paraview_window import LIGHT, SIZE, Window, command, screen, xdotool
from vtkmodules.util.numpy_support import numpy_to_vtk

PANEL = 375  # pixels of it


def save(picture, path):
    height, width, _ = picture.shape
    image = vtk.vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(picture[::-1]).reshape(-1, 3), deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.SetFileName(path)
    writer.Write()


class Pictures:
    def __init__(self, window, folder):
        self.window = window
        self.folder = folder

    def take(self, name):
        xdotool("mousemove", 2, SIZE[1] - 2)
        self.window.settle()
        save(screen()[: SIZE[1], : SIZE[0]], os.path.join(self.folder, f"paraview_{name}.png"))

    def widen_panel(self):
        x, y, width, height = self.window.find("/propertiesDock", **{"class": "QDockWidget"})["place"]
        edge = {"place": (x + width + 3, y + height // 2, PANEL - width, 1)}
        self.window.drag(edge, (0, 0), (1, 0))

    def volume(self):
        window = self.window
        window.resize(*SIZE)
        window.wait(lambda: window.seen("/propertiesPanel/Accept", enabled=True), "an opened file")
        self.widen_panel()
        window.show_as_volume("density")
        window.click(window.find("/PropertiesButtons/PropertiesButton", **{"class": "pqExpanderButton"}))
        window.reveal("/TetMarchAmbientOcclusion/CheckBox")
        self.take("volume")

    def opacity(self):
        window = self.window
        window.click(window.find("/variableToolbar/", text="Show Color Legend"))
        window.click(window.find("/variableToolbar/", text="Edit Color Map"))
        editor = window.find("/OpacityEditor/1QVTKWidget0")
        window.drag(editor, (0.5, 0.5), (0.13, 0.96))
        window.drag(editor, (0.6, 0.46), (0.35, 0.55))
        self.take("opacity")
        window.click(window.find("/colorMapEditorDock/qt_dockwidget_closebutton"))

    def light(self):
        self.window.tick("TetMarchShade")
        self.window.choose("/TetMarchShadowMethod/ComboBox", "Automatic")
        self.window.add_light(LIGHT)
        self.window.reveal("/TetMarchAmbientOcclusion/CheckBox")
        self.take("light")
        self.window.hide_light()

    def crop(self):
        self.window.tick("TetMarchUseCropping")
        self.window.drag_crop_face(0.5)
        self.take("crop")


def main():
    project, plugin, root, watch, output = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        words = command(project, plugin, root, os.path.join(project, "Data", "bonsai_small.vti"))
        window = Window(words, watch, folder)
        try:
            pictures = Pictures(window, output)
            pictures.volume()
            pictures.opacity()
            pictures.light()
            pictures.crop()
        finally:
            window.close()


if __name__ == "__main__":
    main()
