# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the error is: each pixel's bound of its error, in the wake of the ball, with a legend."""
import vtktetmarch

figure = vtktetmarch.figure(
    "Data/golfball_small.vtu", "vorticity_mag", range=(0.5, 9), size=(480, 360), background="#05070d",
    cmap=["#173a6e", "#2f8fc4", "#bfe6d6", "#ffd166", "#ef6f3c"], opacity=[(0.6, 0), (2, 0.12), (5, 0.5), (9, 1)],
    unit_distance=0.09, view_mode="error_bound",
    camera={"position": (-1.3, -3.0, 2.0), "focal_point": (1.65, 0.0, -0.2), "view_up": (0, 0, 1), "view_angle": 48})
legend = vtktetmarch.vtkTetMarchLegend()
legend.SetMapper(figure.mapper)
figure.add(legend).save("error_view.png")
