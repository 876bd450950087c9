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
from programs import LONGEST
from views import load_plugin, open_view, show

TILE = (320, 240)
BACKGROUND = [0.2, 0.3, 0.1]
BETWEEN = [0.6, 0.1, 0.4]  # the background of the frame before each one that is kept
# What of the representation is not its default.
SCENES = {"lying": {}, "moved": {"TetMarchUseDataPartitions": 0}, "maximum": {"TetMarchBlendMode": "Maximum Intensity"}}


def has_come(screen, tile, background):
    """Whether a tile's screen shows a frame with that background. The volume leaves the screen's outer column free, and
    a frame is copied row by row: if the first and the last row are there, all are."""
    pixels = pathlib.Path(screen).read_bytes()[-4 * TILE[0] * TILE[1]:]
    column = tile * (TILE[0] - 1)
    return all(abs(pixels[4 * (row * TILE[0] + column) + channel] - 255 * background[2 - channel]) <= 1
               for row in (0, TILE[1] - 1) for channel in range(3))


def render(view, background, screens):
    """Returns when each screen shows the frame, which arrives later. Its background differs from that of the last."""
    view.Background = background
    simple.Render(view)
    last = time.monotonic() + LONGEST
    while not all(has_come(screen, tile, background) for tile, screen in enumerate(screens)):
        if time.monotonic() > last:
            raise TimeoutError(f"the frame isn't on the screens after {LONGEST} s")
        time.sleep(0.05)


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
    view.Background = BACKGROUND
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
        render(view, BETWEEN, arguments.screens)
        display.TetMarchUseDataPartitions = 1
        for key, value in properties.items():
            setattr(display, key, value)
        render(view, BACKGROUND, arguments.screens)
        for tile, screen in enumerate(arguments.screens):
            shutil.copy(screen, folder / f"{name}-{tile}.xwd")


if __name__ == "__main__":
    main()
