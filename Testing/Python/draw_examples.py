# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the examples for Python side by side, for the page about them.

    draw_examples.py PICTURE.png
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SHOWN = ("first_picture.py", "wake.png"), ("accuracy.py", "accuracy.png"), ("light.py", "light.png"), \
    ("time_series.py", "dye_04.png"), ("clipping.py", "clipping.png"), ("picking.py", "picking.png")
BACKGROUND = (0.03, 0.035, 0.05)


def filling(picture, ratio):
    """The middle of a picture, height / width = ratio."""
    height, width = picture.shape[:2]
    rows, columns = min(height, round(width * ratio)), min(width, round(height / ratio))
    top, left = (height - rows) // 2, (width - columns) // 2
    return picture[top:top + rows, left:left + columns]


def main(path):
    figure, places = plt.subplots(2, 3, figsize=(12, 5.2), facecolor=BACKGROUND)
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(PROJECT / "Data", pathlib.Path(folder) / "Data")
        for place, (example, picture) in zip(places.flat, SHOWN):
            subprocess.run([sys.executable, PROJECT / "Documentation" / "Examples" / example], cwd=folder, check=True)
            pixels = plt.imread(pathlib.Path(folder) / picture)
            place.imshow(filling(pixels, 0.56) if example == "light.py" else pixels)
            place.set_title(example, color="0.85", fontsize=10)
            place.axis("off")
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=0.94, wspace=0.02, hspace=0.12)
    figure.savefig(path, dpi=90, facecolor=BACKGROUND)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
