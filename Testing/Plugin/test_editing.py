# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of the representations can be undone and redone, and copied from one display to another."""
from messages import Messages
from paraview import simple
from paraview.modules.vtkRemotingMisc import vtkSMProxyClipboard
from paraview.modules.vtkRemotingServerManager import vtkSMUndoStack, vtkSMUndoStackBuilder
from state_values import ARRAY, COMMON, make_scene, set_values, values_of
from views import REPRESENTATION, load_plugin, make_plain, parse_arguments, picture_of, show


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


def check_undo_of_representation(undo, view, display):
    picture = picture_of(view)
    undo.stack.Clear()
    undo.builder.Begin("representation")
    display.SetRepresentationType("Surface")
    undo.builder.EndAndPushToStack()
    surface = picture_of(view)
    assert surface != picture
    undo.undo()
    assert display.Representation == REPRESENTATION and picture_of(view) == picture
    undo.redo()
    assert display.Representation == "Surface" and picture_of(view) == surface
    undo.undo()
    assert picture_of(view) == picture


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


def check_copy_between_kinds(mesh, wavelet):
    """What both have, from a mesh to an image. A level that only images have is said to be one."""
    messages = Messages()
    (mesh_view, mesh_display, values), (view, display, _) = mesh, wavelet
    settled = {"ViewMode": "Picture", "ErrorBudget": 0.0, "FrameTimeBudget": 0.0}
    set_values(mesh_display, {**values, **settled, "Specular": 0.125, "AccuracyLevel": "Reference"})
    clipboard = vtkSMProxyClipboard()
    assert clipboard.Copy(mesh_display.SMProxy) and clipboard.Paste(display.SMProxy)
    found, copied = values_of(display), values_of(mesh_display)
    both = set(found) & set(copied)
    assert both >= set(COMMON) and all(found[name] == copied[name] for name in both)
    assert len(set(picture_of(view))) > 100 and not messages.take()

    set_values(display, {"AccuracyLevel": "Sampled"})
    assert clipboard.Copy(display.SMProxy) and clipboard.Paste(mesh_display.SMProxy)
    for frame in range(2):
        picture_of(mesh_view)
        said = messages.take()
        assert len(said) == (1 if frame == 0 else 0), said
        assert frame or "Sampled, which is for images and rectilinear grids alone" in said[0], said
    mesh_display.TetMarchAccuracyLevel = "Default"
    assert len(set(picture_of(mesh_view))) > 100 and not messages.take()


def main():
    load_plugin(parse_arguments(__doc__))
    undo = Undo()
    scene = make_scene()
    for (view, display, values), name, kind in zip(
            scene, ("mesh", "wavelet"), ("UnstructuredGridRepresentation", "UniformGridRepresentation")):
        check_undo(undo, view, display, values)
        check_undo_of_representation(undo, view, display)
        check_copy(view, display, values, simple.FindSource(name), kind)
        print(f"{name}: {len(values)} properties undone, redone and copied")
    check_copy_between_kinds(*scene)


main()
