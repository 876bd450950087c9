# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python exceptions for errors that VTK reports as text."""
import re
import warnings

from vtkmodules.vtkCommonCore import vtkLogger, vtkObject, vtkOutputWindow, vtkStringOutputWindow


def plain(text):
    """A message of VTK without the place in VTK's source and the object's address."""
    return re.sub(r"\s+", " ", re.split(r"\(0x[0-9a-f]+\): |\(nullptr\): |^(?:ERROR|(?:Generic )?Warning): In .*?\n",
                                        text.strip())[-1]).strip()


class VtkErrors:
    """Collects the errors of VTK's objects within a `with` block, including those of internal objects.

    This works whether VTK displays them or not (vtkObject.GlobalWarningDisplayOff()), and for `observed` even if it has
    other observers of errors. texts: the errors, without places in source files, each once. warnings: likewise; if
    there are no errors, they become Python's warnings.
    """

    def __init__(self, observed=None):
        self.texts = []
        self.warnings = []
        self._observed = observed
        self._observers = []

    def __enter__(self):
        self._before = vtkOutputWindow.GetInstance()
        self._window = vtkStringOutputWindow()
        for event, texts in (("ErrorEvent", self.texts), ("WarningEvent", self.warnings)):
            self._window.AddObserver(event, self._keeper(texts))
            if self._observed is not None:
                self._observers.append(self._observed.AddObserver(event, self._keeper(texts)))
        vtkOutputWindow.SetInstance(self._window)
        self._displayed = vtkObject.GetGlobalWarningDisplay()
        vtkObject.GlobalWarningDisplayOn()
        self._verbosity = vtkLogger.ConvertToVerbosity(int(vtkLogger.GetCurrentVerbosityCutoff()))
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, *_):
        vtkObject.SetGlobalWarningDisplay(self._displayed)
        vtkOutputWindow.SetInstance(self._before)
        for observer in self._observers:
            self._observed.RemoveObserver(observer)
        vtkLogger.SetStderrVerbosity(self._verbosity)
        for text in () if self.texts else self.warnings:
            warnings.warn(text, RuntimeWarning, stacklevel=3)
        return False

    @staticmethod
    def _keeper(texts):
        def keep(_object, _event, text):
            shown = plain(text)
            follows = texts and re.search(r"vtk\w*Pipeline \(0x", text)  # a pipeline's message about a previous failure
            if shown not in texts and not follows:
                texts.append(shown)

        keep.CallDataType = "string0"
        return keep

    def __bool__(self):
        return bool(self.texts)

    def __str__(self):
        return "; ".join(self.texts)
