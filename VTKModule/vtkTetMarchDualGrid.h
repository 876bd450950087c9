// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchDualGrid
 * @brief   Cells between the centres of the leaves of an adaptive mesh
 *
 * The input is a vtkOverlappingAMR, a vtkNonOverlappingAMR or a vtkHyperTreeGrid with values of
 * cells, in three dimensions. vtkTetMarchVolumeMapper draws such values as constant in each leaf;
 * of the output, a vtkUnstructuredGrid with the same values at points, it draws a continuous
 * function. Between the centres of leaves it is linear in tetrahedra, whatever the levels of
 * neighbours are; where these differ by at most one, a linear function is reproduced to rounding.
 * In the outer halves of leaves at the border of the mesh, or of masked and blanked leaves, values
 * are constant across the border. The cells fill the leaves that are drawn without gaps and
 * overlaps.
 *
 * Where eight leaves of equal size meet, the cell is a hexahedron; elsewhere it is divided into
 * pyramids and tetrahedra by points at the corner, on edges and in faces of leaves (about 40 cells
 * for each corner where levels differ). Their values are weighted means of the leaves around them.
 * All numeric arrays that each block has are passed on, integers rounded; others and ghost arrays
 * are not. Active scalars stay active. The first points are the centres of leaves.
 *
 * Unlike the output of vtkHyperTreeGridToDualGrid, centres of leaves keep their places at the
 * border, and cells don't fold.
 *
 * An input that can't be converted gives one error and an empty output: trees of one or two
 * dimensions, a lattice of more than 2^30 cells along an axis, blocks between the cells of the
 * finest level. In several processes each piece has a border of its own.
 *
 * G. Weber et al., Extraction of Crack-free Isosurfaces from Adaptive Mesh Refinement Data, 2001.
 */
#ifndef vtkTetMarchDualGrid_h
#define vtkTetMarchDualGrid_h

#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchDualGrid : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkTetMarchDualGrid* New();
  vtkTypeMacro(vtkTetMarchDualGrid, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTetMarchDualGrid() = default;
  ~vtkTetMarchDualGrid() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetMarchDualGrid(const vtkTetMarchDualGrid&) = delete;
  void operator=(const vtkTetMarchDualGrid&) = delete;
};

#endif
