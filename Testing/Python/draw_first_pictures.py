# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the first pictures of data of eight kinds side by side, for the page about them.

    draw_first_pictures.py PICTURE.png
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import first_data  # noqa: E402
from FirstPictureTest import Shot, chosen_for  # noqa: E402

SHOWN = ((first_data.flow, "tetrahedra"), (first_data.hexahedra_with_cell_scalars, "hexahedra, values of cells"),
         (first_data.blocks, "three blocks"), (first_data.quadratic_cells, "quadratic tetrahedra"),
         (first_data.thin_plate, "a thin plate, askew"), (first_data.curvilinear, "curvilinear grid"),
         (first_data.integers_with_air, "image: a shell in air"), (first_data.values_over_many_sizes, "values from 4e-6 to 1"))
BACKGROUND = (0.08, 0.09, 0.12)


def main(path):
    figure, places = plt.subplots(2, 4, figsize=(12, 5), facecolor=BACKGROUND)
    for place, (make, title) in zip(places.flat, SHOWN):
        data = make()
        shot = Shot(data, chosen_for(data))
        shot.renderer.SetBackground(BACKGROUND)
        place.imshow(shot.pixels()[::-1])
        place.set_title(title, color="0.85", fontsize=10)
        place.axis("off")
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=0.93, wspace=0.02, hspace=0.12)
    figure.savefig(path, dpi=100, facecolor=BACKGROUND)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
