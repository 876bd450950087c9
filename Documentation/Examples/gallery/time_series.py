# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A time series: four moments of a vortex ring that rolls up, side by side, on the wedges of one mesh."""
import numpy as np
import vtktetmarch
