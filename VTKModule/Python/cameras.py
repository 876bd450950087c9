# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras: chosen for the data, by name, or specified."""
import numpy as np
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

from .camera_fit import fit_along, visible_points
from .checks import checked_number, checked_numbers, checked_positive
from .errors import VtkErrors
from .first_picture import first_picture_of

# Which way the camera looks.
DIRECTIONS = {sign + letter: tuple((-1 if sign else 1) * (letter == each) for each in "xyz")
              for letter in "xyz" for sign in ("", "-")}
KEYS = ("position", "focal_point", "view_up", "view_angle", "parallel_scale", "zoom", "azimuth", "elevation")


def fit(camera, volume, aspect):
    """Looks obliquely at the visible part of the volume's data, with any transformation of the volume."""
    with VtkErrors():
        first_picture_of(volume).PlaceCamera(camera, aspect)
    if not volume.GetIsIdentity():
        transform = vtkTransform()
        transform.SetMatrix(volume.GetMatrix())
        camera.ApplyTransform(transform)


def look_along(camera, name, volume, aspect):
    """Looks along an axis of the world, by its name in DIRECTIONS, with the visible part of the volume just in view."""
    first = first_picture_of(volume)
    points = visible_points(first.GetInputData(), first, volume.GetProperty().GetScalarOpacity())
    matrix = volume.GetMatrix()
    matrix = np.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(3)])
    fit_along(camera, DIRECTIONS[name], points @ matrix[:, :3].T + matrix[:, 3], aspect)


def place_camera(camera, wish, volume, aspect):
    """Places a vtkCamera.

    wish: "iso": obliquely, so that the visible part just fits; "x", "-x", "y", "-y", "z" or "-z": likewise, along that
        axis or against it, with z upwards, or y if it is z; a vtkCamera, which is copied; or a dict, whose missing
        entries are as with "iso": position, focal_point, view_up (three numbers each, in the world), view_angle
        (degrees), parallel_scale (half of the picture's height in the world; makes the projection parallel), azimuth,
        elevation (degrees about the focal point) and zoom (above 1: nearer).
    volume: a vtkVolume with a mapper of ours. aspect: width / height.
    """
    if isinstance(wish, vtkCamera):
        camera.DeepCopy(wish)
        return
    if isinstance(wish, str) and wish in DIRECTIONS:
        look_along(camera, wish, volume, aspect)
        return
    if not isinstance(wish, dict) and not (isinstance(wish, str) and wish == "iso"):
        error = ValueError if isinstance(wish, str) else TypeError
        raise error(f"camera is 'iso', {', '.join(map(repr, DIRECTIONS))}, a dict or a vtkCamera, not {wish!r}")
    wish = {} if isinstance(wish, str) else wish
    check_wish(wish)
    fit(camera, volume, aspect)
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


def check_wish(wish):
    """Raises an error if the dict of place_camera() is invalid."""
    unknown = set(wish) - set(KEYS)
    if unknown:
        raise TypeError(f"camera has no {sorted(unknown, key=str)[0]!r}; it has {', '.join(KEYS)}")
    for name, value in wish.items():
        what = f"camera's {name}"
        if name in ("position", "focal_point", "view_up"):
            checked_numbers(value, 3, what)
        elif name in ("azimuth", "elevation"):
            checked_number(value, what)
        elif checked_positive(value, what) >= 180 and name == "view_angle":
            raise ValueError(f"{what} is below 180 degrees, not {value!r}")
