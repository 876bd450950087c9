# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras: chosen for the data, by name, or specified."""
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

from .checks import checked_number, checked_numbers, checked_positive
from .errors import VtkErrors
from .first_picture import first_picture_of

# Which way the camera looks.
DIRECTIONS = {sign + letter: tuple((-1 if sign else 1) * (letter == each) for each in "xyz")
              for letter in "xyz" for sign in ("", "-")}
KEYS = ("position", "focal_point", "view_up", "view_angle", "parallel_scale", "zoom", "azimuth", "elevation")


def look_obliquely(camera, first, volume, aspect):
    """As vtkTetMarchFirstPicture.PlaceCamera(), with any transformation of the volume."""
    first.PlaceCamera(camera, aspect)
    transform = vtkTransform()
    transform.SetMatrix(volume.GetMatrix())
    camera.ApplyTransform(transform)


def look_along(camera, direction):
    """Looks along an axis of the world, with z upwards, or y if it is z."""
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*(-part for part in direction))
    camera.SetViewUp((0, 1, 0) if direction[2] else (0, 0, 1))


def place_camera(camera, wish, volume, aspect, bar=0.0, room=1.0):
    """Places a vtkCamera.

    wish: "iso": obliquely, so that the visible part just fits; "x", "-x", "y", "-y", "z" or "-z": likewise, along that
        axis or against it, with z upwards, or y if it is z; a vtkCamera, which is copied; or a dict, whose missing
        entries are as with "iso": position, focal_point, view_up (three numbers each, in the world), view_angle
        (degrees), parallel_scale (half of the picture's height in the world; makes the projection parallel), azimuth,
        elevation (degrees about the focal point) and zoom (above 1: nearer).
    volume: a vtkVolume with a mapper of ours. aspect: width / height. bar: share of the width, at the right, that is
        kept free. room: the share of the rest that the volume's box fills, if it is below 1.
    """
    if isinstance(wish, vtkCamera):
        camera.DeepCopy(wish)
        return
    direction = DIRECTIONS.get(wish) if isinstance(wish, str) else None
    if not isinstance(wish, dict) and direction is None and not (isinstance(wish, str) and wish == "iso"):
        error = ValueError if isinstance(wish, str) else TypeError
        raise error(f"camera is 'iso', {', '.join(map(repr, DIRECTIONS))}, a dict or a vtkCamera, not {wish!r}")
    wish = wish if isinstance(wish, dict) else {}
    check_wish(wish)
    aspect *= 1 - bar
    first = first_picture_of(volume)
    with VtkErrors() as errors:
        if direction is None:
            look_obliquely(camera, first, volume, aspect)
        else:
            look_along(camera, direction)
        if room < 1:
            first.FitCameraToBox(camera, volume.GetBounds(), aspect, room)
        else:
            first.FitCamera(camera, volume, aspect)
    if errors:
        raise ValueError(str(errors))
    camera.SetWindowCenter(0 if "position" in wish else bar, 0)
    apply_wish(camera, wish)


def apply_wish(camera, wish):
    """Changes a camera by the dict of place_camera()."""
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


def view_of(camera):
    """What place_camera() sets, to find out whether someone else moved the camera."""
    return (camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp(), camera.GetViewAngle(),
            camera.GetParallelScale(), camera.GetParallelProjection(), camera.GetWindowCenter())


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
