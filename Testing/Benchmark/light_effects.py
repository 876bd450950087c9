# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The effects of light whose accuracy is measured, and the ways to draw each: settings of the mapper by name."""
import dataclasses

from vtktetmarch import vtkTetMarchSettings as Settings

STEP = 1 / 255
DEFAULTS = {"AccuracyLevel": Settings.DEFAULT, "GradientType": Settings.VERTEX_GRADIENTS,
            "ShadowMethod": Settings.SHADOWS_OFF, "OpaqueShadows": False, "AmbientOcclusion": False,
            "LightTolerance": 0.0, "VolumetricScatteringBlending": 0.0}


@dataclasses.dataclass(frozen=True)
class Way:
    settings: dict
    samples: int = 0  # a voxel, of vtkGPUVolumeRayCastMapper; 0: drawn by TetMarch
    only: str = ""  # the kind of data that has it: "mesh" or "image"


AT_VERTICES = "at vertices"
TOLERANCES = {f"tolerance {n}/255": n * STEP for n in (8, 4, 2, 1)}
WAYS = {
    AT_VERTICES: Way({}),
    "at vertices, accurate": Way({"AccuracyLevel": Settings.ACCURATE}),
    "cell gradients": Way({"GradientType": Settings.CELL_GRADIENTS}, only="mesh"),
    "along rays": Way({"ShadowMethod": Settings.SHADOWS_ALONG_RAYS}),
    **{name: Way({"LightTolerance": value}) for name, value in TOLERANCES.items()},
    "VTK, 1 sample": Way({}, samples=1, only="image"),
    "VTK, 4 samples": Way({}, samples=4, only="image"),
}


@dataclasses.dataclass(frozen=True)
class Effect:
    words: str
    ways: tuple
    settings: dict
    material: tuple = (0.3, 0.7, 0.0)  # ambient, diffuse and specular coefficients; empty: not shaded
    bar: bool = False  # whether an opaque bar stands between the light and the volume
    gradient_opacity: bool = False
    coarser: int = 1  # pixels between two of the ground truth, times --stride: for effects whose truth takes long


AT_POINTS = (AT_VERTICES, "at vertices, accurate")
ON_SURFACES = (*AT_POINTS, "cell gradients")
BY_VTK = ("VTK, 1 sample", "VTK, 4 samples")
IN_SHADOW = (*AT_POINTS, "along rays", *TOLERANCES)
SHADOWS = {"ShadowMethod": Settings.SHADOWS_AT_VERTICES}
UNLIT = Effect("no light", (AT_VERTICES,), {}, material=())
EFFECTS = {
    "shading": Effect("one light, diffuse surfaces", (*ON_SURFACES, *TOLERANCES, *BY_VTK), {},
                      material=(0.0, 0.9, 0.0)),
    "highlights": Effect("one light, specular surfaces", (*ON_SURFACES, *TOLERANCES), {},
                         material=(0.2, 0.4, 0.6)),
    "shadows": Effect("one light with shadows", IN_SHADOW, SHADOWS),
    "scattering": Effect("one light with shadows, scattering 2: no surfaces", IN_SHADOW,
                         {**SHADOWS, "VolumetricScatteringBlending": 2.0}),
    "occlusion": Effect("one light, ambient occlusion", (*AT_POINTS, *list(TOLERANCES)[::2]),
                        {"AmbientOcclusion": True}, material=(0.7, 0.3, 0.0), coarser=2),
    "opaque-shadows": Effect("one light with shadows, also of an opaque bar", (AT_VERTICES, "along rays", *TOLERANCES),
                             {**SHADOWS, "OpaqueShadows": True}, bar=True),
    "gradient-opacity": Effect("gradient opacity, no light", (*ON_SURFACES, *BY_VTK), {}, material=(),
                               gradient_opacity=True),
}


def ways_of(effect, kind):
    """Names, for data of a kind."""
    return [name for name in effect.ways if WAYS[name].only in ("", kind)]


def settings_of(effect, way):
    return {**DEFAULTS, **effect.settings, **WAYS[way].settings}


def keeps_light(effect, way):
    """Whether points of the volume keep light, which is computed when the light moves."""
    settings = settings_of(effect, way)
    shadows = settings["ShadowMethod"] == Settings.SHADOWS_AT_VERTICES
    return (shadows or settings["AmbientOcclusion"]) and not settings["LightTolerance"]
