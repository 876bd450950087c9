# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras: the one that is chosen for the data, or as it is said."""
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

from .first_picture import first_picture_of

KEYS = ("position", "focal_point", "view_up", "view_angle", "parallel_scale", "zoom", "azimuth", "elevation")


def fit(camera, volume, aspect):
    """Looks obliquely at what is shown of the volume's data, wherever the volume is put in the world."""
    first_picture_of(volume).PlaceCamera(camera, aspect)
    if not volume.GetIsIdentity():
        transform = vtkTransform()
        transform.SetMatrix(volume.GetMatrix())
        camera.ApplyTransform(transform)


def place_camera(camera, wish, volume, aspect):
    """Places a vtkCamera.

    wish: "iso": obliquely, so that all that is shown just fits; a vtkCamera, which is copied; or a dict, of which what
        is missing is as by "iso": position, focal_point, view_up (three numbers each, in the world), view_angle
        (degrees), parallel_scale (half of the picture's height in the world; makes the projection parallel), azimuth,
        elevation (degrees about the focal point) and zoom (above 1: nearer).
    volume: a vtkVolume with a mapper of ours. aspect: width / height.
    """
    if isinstance(wish, vtkCamera):
        camera.DeepCopy(wish)
        return
    if wish != "iso" and not isinstance(wish, dict):
        raise TypeError(f"camera is 'iso', a dict or a vtkCamera, not {wish!r}")
    fit(camera, volume, aspect)
    wish = {} if wish == "iso" else wish
    unknown = set(wish) - set(KEYS)
    if unknown:
        raise TypeError(f"camera has no {sorted(unknown)[0]!r}; it has {', '.join(KEYS)}")
    for name, method in (("position", camera.SetPosition), ("focal_point", camera.SetFocalPoint),
                         ("view_up", camera.SetViewUp)):
        if name in wish:
            method(*wish[name])
    if "parallel_scale" in wish:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(wish["parallel_scale"])
    if "view_angle" in wish:
        camera.SetViewAngle(wish["view_angle"])
    camera.Azimuth(wish.get("azimuth", 0))
    camera.Elevation(wish.get("elevation", 0))
    camera.OrthogonalizeViewUp()
    camera.Zoom(wish.get("zoom", 1))
