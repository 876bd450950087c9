# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the colour maps that the programs know, in ParaView's format of presets: make_color_maps.py ColorMaps.json

Viridis, Plasma, Inferno, Magma and Cividis are sampled from matplotlib, whose authors gave them away (CC0). Cool to
Warm is K. Moreland's (Diverging Color Maps for Scientific Visualization, 2009): its two ends, between which the colour
space Diverging makes the rest.
"""
import json
import sys

from matplotlib import colormaps

SAMPLES = 33


def sample(name):
    points = [index / (SAMPLES - 1) for index in range(SAMPLES)]
    return [[x, *(round(channel, 6) for channel in colormaps[name](x)[:3])] for x in points]


def bytes_at(x, red, green, blue):
    return [x, *(round(channel / 255, 6) for channel in (red, green, blue))]


def make_maps():
    maps = [{"Name": name.capitalize(), "Creator": creator, "License": "CC0", "ColorSpace": "RGB",
             "NanColor": [0.5, 0.5, 0.5], "RGBPoints": sample(name)}
            for name, creator in (("viridis", "N. J. Smith, S. van der Walt, E. Firing"),
                                  ("plasma", "N. J. Smith, S. van der Walt"),
                                  ("inferno", "N. J. Smith, S. van der Walt"),
                                  ("magma", "N. J. Smith, S. van der Walt"),
                                  ("cividis", "J. R. Nunez, C. R. Anderton, R. S. Renslow"))]
    maps.append({"Name": "Cool to Warm", "Creator": "K. Moreland", "ColorSpace": "Diverging",
                 "NanColor": [1, 1, 0],
                 "RGBPoints": [bytes_at(0, 59, 76, 192), bytes_at(1, 180, 4, 38)]})
    maps.append({"Name": "Black-Body Radiation", "ColorSpace": "RGB", "NanColor": [0, 0.5, 1],
                 "RGBPoints": [bytes_at(0, 0, 0, 0), bytes_at(0.4, 230, 0, 0), bytes_at(0.8, 230, 230, 0),
                               bytes_at(1, 255, 255, 255)]})
    maps.append({"Name": "X Ray", "ColorSpace": "RGB", "NanColor": [1, 0, 0],
                 "RGBPoints": [bytes_at(0, 255, 255, 255), bytes_at(1, 0, 0, 0)]})
    return maps


def format_map(color_map):
    """One line for each field, and for each point."""
    lines = [f"    {json.dumps(key)}: {json.dumps(value)}" for key, value in color_map.items() if key != "RGBPoints"]
    points = ",\n".join("      " + ", ".join(map(str, point)) for point in color_map["RGBPoints"])
    return "  {\n" + ",\n".join(lines) + ",\n    \"RGBPoints\": [\n" + points + "\n    ]\n  }"


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as out:
        out.write("[\n" + ",\n".join(map(format_map, make_maps())) + "\n]\n")
