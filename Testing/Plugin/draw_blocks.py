# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws blocks of which each process has other ones: mpiexec -n N pvbatch draw_blocks.py --plugin ... --data FOLDER

FOLDER has a file BLOCK-PROCESS.vtu for each block of which a process has cells. Pictures and numbers of cells go there.
"""
import argparse
import json
import pathlib

from draw_parallel import ARRAY, look_from, set_functions
from paraview import servermanager, simple
from views import load_plugin, open_view, show

NAMES = ("low", "middle", "high")
# What of the blocks is seen.
SELECTORS = {"all": ["/Root"], "two": ["/Root/low", "/Root/high"], "one": ["/Root/middle"]}
KINDS = {"blocks": "vtkMultiblockDataSet", "collection": "vtkPartitionedDataSetCollection"}

READ = """
import pathlib
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

process = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
tree = self.GetOutputDataObject(0)
is_collection = tree.IsA("vtkPartitionedDataSetCollection")
(tree.SetNumberOfPartitionedDataSets if is_collection else tree.SetNumberOfBlocks)({count})
for block, name in enumerate({names}):
    file = pathlib.Path({folder!r}) / f"{{block}}-{{process}}.vtu"
    if file.exists():
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        reader.Update()
        if is_collection:
            tree.SetPartition(block, 0, reader.GetOutput())
        else:
            tree.SetBlock(block, reader.GetOutput())
    tree.GetMetaData(block).Set(vtkCompositeDataSet.NAME(), name)
"""


def draw(kind, folder):
    source = simple.ProgrammableSource(OutputDataSetType=KINDS[kind])
    source.Script = READ.format(count=len(NAMES), names=NAMES, folder=str(folder))
    source.UpdatePipeline()
    view = open_view()
    view.ViewSize = [200, 150]
    view.UseFXAA = 0
    display = show(source, view, ARRAY)
    set_functions(ARRAY)
    display.ScalarOpacityUnitDistance = 0.25
    look_from(view, [1.5, -2.2, 1.6], [0.5, 0.5, 0.45])
    for name, selectors in SELECTORS.items():
        display.BlockSelectors = selectors
        simple.SaveScreenshot(str(folder / f"{kind}-{name}.png"), view, TransparentBackground=0)
    cells = source.GetDataInformation().GetNumberOfCells()
    simple.Delete(view)
    return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("plugin", "data"):
        parser.add_argument("--" + name, required=True)
    arguments = parser.parse_args()
    load_plugin(arguments)
    folder = pathlib.Path(arguments.data)
    read = {kind: draw(kind, folder) for kind in KINDS}
    read["processes"] = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    (folder / "read.json").write_text(json.dumps(read))


main()
