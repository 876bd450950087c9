# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a volume on the tiles of a pvserver, and leaves the screens of its processes:

pvpython draw_tiles.py --plugin ... --data F.pvtu --server PORT --screens FILE... --folder FOLDER

Without a server the picture of one process, of the size of all tiles, goes to FOLDER/one.png.
"""
import argparse
import pathlib
import shutil
import time

from draw_parallel import ARRAY, look_from, set_functions
from paraview import simple
from views import load_plugin, open_view, show

TILE = (320, 240)
# What of the representation is not its default.
SCENES = {"lying": {}, "moved": {"TetMarchUseDataPartitions": 0}, "maximum": {"TetMarchBlendMode": "Maximum Intensity"}}


def is_drawn(files):
    """Whether a screen is more than its background: what was drawn gets there some time after."""
    return all(len(set(pathlib.Path(file).read_bytes()[-4 * TILE[0] * TILE[1]:])) > 20 for file in files)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("plugin", "data", "folder"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--server", type=int)
    parser.add_argument("--screens", nargs="*", default=[])
    arguments = parser.parse_args()
    load_plugin(arguments, arguments.server)
    folder = pathlib.Path(arguments.folder)
    reader = simple.XMLPartitionedUnstructuredGridReader(FileName=[arguments.data])
    view = open_view()
    view.UseFXAA = 0
    view.Background = [0.2, 0.3, 0.1]
    layout = simple.CreateLayout("tiles")
    simple.AssignViewToLayout(view=view, layout=layout, hint=0)
    display = show(reader, view, ARRAY)
    set_functions(ARRAY)
    display.ScalarOpacityUnitDistance = 0.25
    look_from(view, [1.5, -2.2, 1.6], [0.5, 0.5, 0.45])
    if not arguments.server:
        view.ViewSize = [2 * TILE[0], TILE[1]]
        simple.SaveScreenshot(str(folder / "one.png"), view, TransparentBackground=0)
        return
    layout.SMProxy.ShowViewsOnTileDisplay()
    for name, properties in SCENES.items():
        display.TetMarchUseDataPartitions = 1
        for key, value in properties.items():
            setattr(display, key, value)
        simple.Render(view)
        begun = time.monotonic()
        while time.monotonic() < begun + 5 and not is_drawn(arguments.screens):
            time.sleep(0.1)
        time.sleep(0.5)
        for tile, screen in enumerate(arguments.screens):
            shutil.copy(screen, folder / f"{name}-{tile}.xwd")


if __name__ == "__main__":
    main()
