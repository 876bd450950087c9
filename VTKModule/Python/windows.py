# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A window on the screen, in which the mouse moves the camera."""
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor

from .forks import note_window


def show_window(renderer, size, title):
    """Returns when the window is closed. Another window may have the renderer then."""
    window = vtkRenderWindow()
    window.SetSize(*size)
    window.AddRenderer(renderer)
    note_window(window)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    window.Render()
    window.SetWindowName(title)
    interactor.Initialize()
    interactor.Start()
    window.RemoveRenderer(renderer)
    window.Finalize()
    interactor.SetRenderWindow(None)
