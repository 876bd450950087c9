// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of images and rectilinear grids, and leaves: VTKModule/Volume/StructuredVolume.cxx, cellOf().
import {transformPoint, transpose} from "./matrices.js";

/** data: a volume of the page; number: of a cell of the lattice in the shaders. */
export function imageCellOf(data, number, point)
{
  if (data.features.includes("OCTREE"))
  {
    return number;
  }
  const cells = data.uniforms.latticeCells.values;
  const {dataPlanes} = data; // of the data in lattice coordinates, if the lattice is another one
  const place = transformPoint(transpose(data.uniforms.latticeMatrix.values), point);
  let rest = number;
  let cell = 0;
  let stride = 1;
  for (let a = 0; a < 3; ++a)
  {
    let along = rest % cells[a];
    rest = Math.floor(rest / cells[a]);
    const dataCells = dataPlanes ? dataPlanes[a].length - 1 : cells[a];
    if (dataPlanes)
    {
      along -= place[a] < dataPlanes[a][along] ? 1 : 0;
      along = Math.min(Math.max(along, 0), dataCells - 1);
    }
    cell += stride * along;
    stride *= dataCells;
  }
  return cell;
}
