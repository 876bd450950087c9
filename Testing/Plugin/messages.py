# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What comes to ParaView's window of messages."""
from paraview.vtk.vtkCommonCore import VTK_STRING, vtkOutputWindow


class Messages:
    """Errors and warnings since the last look."""

    def __init__(self):
        self.said = []

        def hear(_window, _event, text):
            self.said.append(text)

        hear.CallDataType = VTK_STRING
        for event in ("ErrorEvent", "WarningEvent"):
            vtkOutputWindow.GetInstance().AddObserver(event, hear)

    def take(self):
        taken, self.said = self.said, []
        return taken
