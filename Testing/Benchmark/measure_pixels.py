# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames with fewer rays beside those with a ray for each pixel: measure_pixels.py FOLDER [--size WxH] [--frames N]

Draws each scene by turns with several values of PixelTolerance, and with rays two pixels apart, and writes
FOLDER/pixels.md: the share of pixels that have a ray, seconds of a frame, and differences from the full picture.
"""
import argparse
import json
import pathlib
import statistics

import numpy as np
import vtkmodules.all as vtk
from time_frames import DATA, ENOUGH_FOR_ONE_DRAW, Frames
from measured_page import row
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtktetmarch import vtkTetMarchSmartVolumeMapper

SCENES = ("golfball", "golfball, lit", "lattice1.3m", "scan", "scan, lit")
WAYS = ((0.0, 1.0), (2 / 255, 1.0), (4 / 255, 1.0), (8 / 255, 1.0), (0.0, 2.0)) # tolerance, distance in pixels


class ScanFrames(Frames):
    """The scan of the demo, in the colours and from the direction of the demo."""

    def __init__(self, lit, size):
        reader = vtk.vtkXMLImageDataReader()
        reader.SetFileName(str(DATA / "bonsai_small.vti"))
        reader.Update()
        mapper = vtkTetMarchSmartVolumeMapper()
        mapper.SetInputData(reader.GetOutput())
        mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
        mapper.CroppingOn()
        mapper.SetCroppingRegionPlanes(0, 255, 23, 255, 0, 255)
        self.show(mapper, size)
        preset = json.loads((DATA / "bonsai.json").read_text())[0]
        colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        for i in range(0, len(preset["RGBPoints"]), 4):
            colors.AddRGBPoint(*preset["RGBPoints"][i:i + 4])
        for i in range(0, len(preset["Points"]), 4):
            opacities.AddPoint(*preset["Points"][i:i + 2])
        volume_property = self.volume.GetProperty()
        volume_property.SetColor(colors)
        volume_property.SetScalarOpacity(opacities)
        volume_property.SetInterpolationTypeToLinear()
        self.camera.SetFocalPoint(112, 100, 134)
        self.camera.SetPosition(400, 330, 600)
        self.camera.SetViewUp(0, 1, 0)
        self.camera.SetViewAngle(29.5)
        self.first_position = self.camera.GetPosition()
        if lit:
            self.add_light(reader.GetOutput())
            mapper.SetShadowMethodToAtVertices()


def make_frames(scene, size):
    name, _, light = scene.partition(", ")
    return ScanFrames(light == "lit", size) if name == "scan" else Frames(name, "lit" if light == "lit" else "plain", size)


def picture_of(window):
    pixels = vtk.vtkUnsignedCharArray()
    width, height = window.GetSize()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return vtk_to_numpy(pixels).reshape(height, width, 4)[..., :3] / 255.0


def share_of_rays(frames, mapper, tolerance, distance):
    if tolerance == 0:
        return 1 / distance**2
    mapper.CollectDiagnosticsOn()
    frames.window.Render()
    mapper.CollectDiagnosticsOff()
    width, height = frames.window.GetSize()
    return mapper.GetLastFrameStatistics().GetNumberOfTracedRays() / (width * height)


def measure(scene, size, rounds):
    frames = make_frames(scene, size)
    mapper = frames.volume.GetMapper()
    mapper.AutoAdjustSampleDistancesOff()
    seconds, measured, full = {way: [] for way in WAYS}, {}, None
    for turn in range(rounds + 1):
        for way in WAYS:
            mapper.SetPixelTolerance(way[0])
            mapper.SetImageSampleDistance(way[1])
            frames.seconds(0)  # the targets change their size
            taken = frames.seconds(0)
            if turn > 0:
                seconds[way].append(taken)
                continue
            picture = picture_of(frames.window)
            full = picture if full is None else full
            difference = np.abs(picture - full)
            worst = difference.max(axis=2)
            measured[way] = (share_of_rays(frames, mapper, *way), np.sqrt((difference**2).mean()),
                             np.quantile(worst, 0.999), worst.max())
    return [(way, measured[way], statistics.median(seconds[way])) for way in WAYS]


def name_of(way):
    if way[1] > 1:
        return "rays 2 pixels apart"
    return "a ray for each pixel" if way[0] == 0 else f"tolerance {round(way[0] * 255)}/255"


def table(scene, results):
    whole = results[0][2]
    text = ""
    for way, (share, rms, most, worst), seconds in results:
        text += row([scene, name_of(way), f"{share:.3f}", f"{seconds:.3f}", f"{whole / seconds:.1f}", f"{rms:.1e}",
                     f"{most:.3f}", f"{worst:.3f}"])
        scene = ""
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--size", default="1024x1024")
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--scenes", nargs="+", default=SCENES, choices=SCENES)
    options = parser.parse_args()
    size = [int(n) for n in options.size.split("x")]
    options.folder.mkdir(parents=True, exist_ok=True)
    text = row(["scene", "picture", "rays a pixel", "seconds", "times as fast", "RMS", "99.9 %", "max"])
    text += "|---|---|" + "---:|" * 6 + "\n"
    for scene in options.scenes:
        text += table(scene, measure(scene, size, options.frames))
    (options.folder / "pixels.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
