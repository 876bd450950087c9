# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks whether a window can be opened: VTK's windows for X abort the process if not."""
import ctypes
import ctypes.util
import os

from vtkmodules.vtkRenderingCore import vtkRenderWindow

HELP = "start a server (`Xvfb :1 &`, then DISPLAY=:1), or put `xvfb-run -a` before the command"

connections = {}  # by the name of the display; None: there is none


def check_display():
    """Raises RuntimeError with the remedy if VTK's window needs an X server and there is none."""
    name = os.environ.get("DISPLAY")
    if name and connections.get(name) is None:
        connections[name] = connection_to(name)  # before VTK: from 9.4 on it tries one of its own, and closes that
    if not vtkRenderWindow().IsA("vtkXOpenGLRenderWindow"):
        return
    if not name:
        raise RuntimeError(f"VTK needs a display to draw, and DISPLAY isn't set: {HELP}")
    if connections[name] is None:
        raise RuntimeError(f"VTK needs a display to draw, and there is none at DISPLAY={name}: {HELP}")


def connection_to(name):
    """Opens a connection to an X server, for as long as the process runs; None if there is none.

    A server such as that of xvfb-run resets itself once its last client has gone, and refuses others meanwhile: a
    window that is opened after another one was closed would end the process. Without Xlib there is nothing to try.
    """
    library = ctypes.util.find_library("X11")
    if library is None:
        return 0
    x11 = ctypes.CDLL(library)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    return x11.XOpenDisplay(name.encode())
