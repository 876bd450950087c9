# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of the representations can be undone and redone, and copied from one display to another."""
from paraview import simple
from paraview.modules.vtkRemotingMisc import vtkSMProxyClipboard
from paraview.modules.vtkRemotingServerManager import vtkSMUndoStack, vtkSMUndoStackBuilder
from state_values import ARRAY, make_scene, set_values, values_of
from views import load_plugin, make_plain, parse_arguments, picture_of, show


class Undo:
    """The stack of ParaView's window, which its menu Edit goes through."""

    def __init__(self):
        self.stack = vtkSMUndoStack()
        self.builder = vtkSMUndoStackBuilder()
        self.builder.SetUndoStack(self.stack)
        simple.servermanager.vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(self.builder)

    def change(self, display, values):
        self.stack.Clear()
        self.builder.Begin("change")
        set_values(display, values)
        self.builder.EndAndPushToStack()

    def undo(self):
        assert self.stack.Undo()
        self.send()

    def redo(self):
        assert self.stack.Redo()
        self.send()

    def send(self):
        """What a change of the stack leaves to the window to do."""
        simple.servermanager.ProxyManager().SMProxyManager.UpdateRegisteredProxies(0)


def check_undo(undo, view, display, values):
    """Each value alone, then all of them at once."""
    before, picture = values_of(display), picture_of(view)
    for change in [{name: value} for name, value in values.items()] + [values]:
        undo.change(display, change)
        changed = picture_of(view)
        undo.undo()
        assert values_of(display) == before and picture_of(view) == picture, f"undone: {list(change)}"
        undo.redo()
        assert values_of(display) == {**before, **change} and picture_of(view) == changed, f"redone: {list(change)}"
        undo.undo()
        assert picture_of(view) == picture
    assert changed != picture


def check_copy(view, display, values, source, kind):
    """To another display of the same data."""
    set_values(display, values)
    set_values(display, {"ViewMode": "Picture", "ErrorBudget": 0.0, "FrameTimeBudget": 0.0})
    copied = values_of(display)
    simple.Hide(source, view)
    empty = picture_of(view)
    simple.Show(source, view)
    other = simple.CreateView("RenderView")
    make_plain(other)
    for name in ("ViewSize", "CameraPosition", "CameraFocalPoint", "CameraViewUp"):
        setattr(other, name, getattr(view, name))
    target = show(source, other, ARRAY, kind=kind)
    assert values_of(target) != copied
    clipboard = vtkSMProxyClipboard()
    assert clipboard.Copy(display.SMProxy) and clipboard.CanPaste(target.SMProxy)
    assert clipboard.Paste(target.SMProxy)
    found = values_of(target)
    assert found == copied, {name: (copied[name], found[name]) for name in copied if copied[name] != found[name]}
    picture = picture_of(other)
    assert picture == picture_of(view) and picture != empty
    simple.Delete(other)


def main():
    load_plugin(parse_arguments(__doc__))
    undo = Undo()
    scene = make_scene()
    for (view, display, values), name, kind in zip(
            scene, ("mesh", "wavelet"), ("UnstructuredGridRepresentation", "UniformGridRepresentation")):
        check_undo(undo, view, display, values)
        check_copy(view, display, values, simple.FindSource(name), kind)
        print(f"{name}: {len(values)} properties undone, redone and copied")


main()
