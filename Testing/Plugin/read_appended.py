# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For AppendedDataTest.py: prints ParaView's version, and how many cells it reads after the plugin was loaded
twice."""
from paraview import simple
from views import load_plugin, parse_arguments

arguments = parse_arguments(__doc__, "data")
for _ in range(2):
    load_plugin(arguments)
reader = simple.OpenDataFile(arguments.data)
reader.UpdatePipeline()
print(f"ParaView {simple.GetParaViewVersion().major}")
print(f"{reader.GetDataInformation().GetNumberOfCells()} cells")
