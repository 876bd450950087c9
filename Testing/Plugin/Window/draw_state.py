# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: draws a state of ParaView as large as its view: draw_state.py PLUGIN STATE.pvsm PICTURE.png"""
import sys

from paraview import simple

PLUGIN, STATE, PICTURE = sys.argv[1:]
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())
simple._DisableFirstRenderCameraReset()
simple.LoadState(STATE)
view = simple.GetActiveView()
simple.SaveScreenshot(PICTURE, view, ImageResolution=list(view.ViewSize))
