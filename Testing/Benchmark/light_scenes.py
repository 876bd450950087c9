# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in which the accuracy of light is measured: a volume, a light at the upper left, and an opaque bar."""
import contextlib
import time

import numpy as np
import vtkmodules.all as vtk
from light_effects import WAYS, settings_of
from measure_pixels import make_frames
from picture_window import float_picture
from vtkmodules.util.numpy_support import vtk_to_numpy
from wire_frames import WireFrames

SCENES = ("golfball", "lattice162k", "scan", "wire")
TOWARDS_LIGHT = np.array([-0.7, 0.6, 0.4])  # right, up, towards the camera
ASIDE = np.array([0.1, 0.0, 0.0])
BAR_DISTANCE, BAR_LENGTH, BAR_WIDTH = 0.9, 1.6, 0.06  # of half the height of what the camera sees
STEEP = 0.1  # change of the scalar from voxel to voxel, as a share of its range, from which gradient opacity is 1
LEAST_GRADIENT_OPACITY = 0.3
DEMO_VIEW = {"position": (0.95, -4.4, 1.5), "focal point": (1.75, 0.0, -0.02)}  # of the golf ball


class LightScene:
    """Pictures have one size; frames that are timed have another, since some take long."""

    def __init__(self, name, picture_size, size):
        self.picture_size, self.size = picture_size, size
        self.frames = WireFrames(size) if name == "wire" else make_frames(name, size)
        self.window, self.renderer = self.frames.window, self.frames.renderer
        self.camera, self.volume = self.frames.camera, self.frames.volume
        self.mapper = self.volume.GetMapper()
        self.mapper.AutoAdjustSampleDistancesOff()
        self.data = self.mapper.GetInputDataObject(0, 0)
        self.kind = "image" if self.data.IsA("vtkImageData") else "mesh"
        if name == "golfball":
            self.camera.SetPosition(DEMO_VIEW["position"])
            self.camera.SetFocalPoint(DEMO_VIEW["focal point"])
        self.renderer.SetBackground(0, 0, 0)
        self.errors = []
        self.light = self.add_light()
        self.bar = self.add_bar()
        self.rival = self.add_rival() if self.kind == "image" else None
        self.gradient_opacity = vtk.vtkPiecewiseFunction()
        for mapper in (self.mapper, self.rival and self.rival.GetMapper()):
            if mapper:
                mapper.AddObserver("ErrorEvent", self.remember_error)
        self.renderer.ResetCameraClippingRange()

    def remember_error(self, _caller, _event, text="unknown error"):
        self.errors.append(text)

    remember_error.CallDataType = vtk.VTK_STRING

    def axes(self):
        """Right, up and towards the camera."""
        towards = np.subtract(self.camera.GetPosition(), self.camera.GetFocalPoint())
        towards /= np.linalg.norm(towards)
        right = np.cross(self.camera.GetViewUp(), towards)
        right /= np.linalg.norm(right)
        return np.stack([right, np.cross(towards, right), towards])

    def half_height(self):
        return self.camera.GetDistance() * np.tan(0.5 * np.radians(self.camera.GetViewAngle()))

    def place_light(self, aside=0.0):
        offset = 10 * self.half_height() * (TOWARDS_LIGHT + aside * ASIDE) @ self.axes()
        self.light.SetPosition(self.camera.GetFocalPoint() + offset)

    def add_light(self):
        self.light = vtk.vtkLight()
        self.light.SetLightTypeToSceneLight()
        self.light.SetFocalPoint(self.camera.GetFocalPoint())
        self.place_light()
        self.renderer.AddLight(self.light)
        return self.light

    def add_bar(self):
        """Across the light, as far towards the camera as that allows; black: the picture has the volume alone."""
        light = TOWARDS_LIGHT / np.linalg.norm(TOWARDS_LIGHT)
        along = np.array([0.0, 0.0, 1.0]) - light[2] * light
        along /= np.linalg.norm(along)
        half = self.half_height()
        center = self.camera.GetFocalPoint() + BAR_DISTANCE * half * light @ self.axes()
        offset = 0.5 * BAR_LENGTH * half * along @ self.axes()
        line = vtk.vtkLineSource()
        line.SetPoint1(center - offset)
        line.SetPoint2(center + offset)
        tube = vtk.vtkTubeFilter()
        tube.SetInputConnection(line.GetOutputPort())
        tube.SetRadius(0.5 * BAR_WIDTH * half)
        tube.SetNumberOfSides(24)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(tube.GetOutputPort())
        bar = vtk.vtkActor()
        bar.SetMapper(mapper)
        bar.GetProperty().SetColor(0, 0, 0)
        bar.GetProperty().LightingOff()
        self.renderer.AddActor(bar)
        return bar

    def add_rival(self):
        """VTK's mapper, of the same values in float: it scales bytes by 256/255."""
        cast = vtk.vtkImageCast()
        cast.SetInputData(self.data)
        cast.SetOutputScalarTypeToFloat()
        mapper = vtk.vtkOpenGLGPUVolumeRayCastMapper()
        mapper.SetInputConnection(cast.GetOutputPort())
        mapper.AutoAdjustSampleDistancesOff()
        mapper.LockSampleDistanceToInputSpacingOff()
        mapper.SetImageSampleDistance(1.0)
        mapper.UseJitteringOff()
        mapper.SetCropping(self.mapper.GetCropping())
        mapper.SetCroppingRegionPlanes(self.mapper.GetCroppingRegionPlanes())
        rival = vtk.vtkVolume()
        rival.SetMapper(mapper)
        rival.SetProperty(self.volume.GetProperty())
        self.renderer.AddVolume(rival)
        return rival

    def voxel(self):
        return np.mean(self.data.GetSpacing()) if self.kind == "image" else 0.0

    def steep_gradient(self, samples):
        """Of the scalar in units of length; for VTK's mapper, per voxel."""
        low, high = self.mapper.GetInput().GetScalarRange() if self.kind == "image" else self.range_of_functions()
        if samples:
            return STEEP * (high - low)
        return STEEP * (high - low) / (self.voxel() or 0.03 * self.half_height())

    def range_of_functions(self):
        """Of the values that the functions tell apart: the golf ball's largest are at its wall."""
        return self.volume.GetProperty().GetScalarOpacity().GetRange()

    def apply(self, effect, way):
        for name, value in settings_of(effect, way).items():
            getattr(self.mapper, "Set" + name)(value)
        samples = WAYS[way].samples
        self.bar.SetVisibility(effect.bar)
        self.volume.SetVisibility(not samples)
        if self.rival:
            self.rival.SetVisibility(bool(samples))
        if samples:
            self.rival.GetMapper().SetSampleDistance(self.voxel() / samples)
        self.apply_to_property(effect, samples)
        self.place_light()

    def apply_to_property(self, effect, samples):
        appearance = self.volume.GetProperty()
        appearance.SetShade(bool(effect.material))
        if effect.material:
            ambient, diffuse, specular = effect.material
            appearance.SetAmbient(ambient)
            appearance.SetDiffuse(diffuse)
            appearance.SetSpecular(specular)
            appearance.SetSpecularPower(20.0)
        appearance.SetDisableGradientOpacity(not effect.gradient_opacity)
        if effect.gradient_opacity:
            self.gradient_opacity.RemoveAllPoints()
            self.gradient_opacity.AddPoint(0.0, LEAST_GRADIENT_OPACITY)
            self.gradient_opacity.AddPoint(self.steep_gradient(samples), 1.0)
            appearance.SetGradientOpacity(self.gradient_opacity)

    def seconds(self):
        """From the call of Render() until the GL has finished."""
        begin = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        taken = time.perf_counter() - begin
        self.fail_on_error()
        return taken

    def seconds_after_the_light_moved(self):
        self.place_light(1.0)
        self.seconds()
        self.place_light()
        return self.seconds()

    def fail_on_error(self):
        if self.errors:
            raise RuntimeError(self.errors[0].strip())

    @contextlib.contextmanager
    def every(self, stride):
        """The window has the rays of one pixel of stride x stride of the picture."""
        size = tuple(n // stride for n in self.picture_size)
        shift = (stride - 1) // 2 + 0.5 - 0.5 * stride
        self.window.SetSize(*size)
        self.camera.SetWindowCenter(*(2 * shift / n for n in self.picture_size))
        self.seconds()
        yield size
        self.camera.SetWindowCenter(0, 0)
        self.window.SetSize(*self.size)

    def picture(self, stride=1):
        """Red, green and blue in float, of the volume on black."""
        with self.every(stride) as size:
            values = float_picture(self.window, self.renderer, size)
            self.fail_on_error()
        return values[..., :3].astype(np.float64)

    def ground_truth(self, tolerance, stride=1):
        """In double precision; with opacity."""
        values = vtk.vtkFloatArray()
        with self.every(stride) as (width, height):
            if not self.mapper.RenderGroundTruth(self.volume, values, tolerance):
                raise RuntimeError(f"there is no ground truth: {self.errors}")
        return vtk_to_numpy(values).reshape(height, width, 4).copy()
