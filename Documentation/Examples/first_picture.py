# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A first picture. Only the file has to be said; each further word makes the picture more one's own."""
import vtktetmarch

flow = vtktetmarch.read("Data/golfball_small.vtu")

# Array, colours, opacity and camera are chosen.
vtktetmarch.screenshot(flow, filename="first_picture.png")

# Here they are said: the speed behind the ball, where it is slow.
figure = vtktetmarch.figure(
    flow, "speed", range=(0.3, 1.0), cmap="magma", opacity=[(0.3, 1), (0.8, 0.3), (0.93, 0.02), (0.97, 0)],
    unit_distance=0.4, background="black", size=(900, 420),
    camera={"position": (-2.5, -7.5, 3.2), "focal_point": (3.2, 0, -0.15), "view_up": (0, 0, 1), "view_angle": 25})
figure.save("wake.png")
print("{number_of_tetrahedra} tetrahedra in {seconds:.2f} s".format(**figure.statistics()))
