// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchTessellator
 * @brief   Cuts curved cells into tetrahedra, as small as a tolerance asks for
 *
 * Quadratic, Lagrange and Bezier cells of a vtkUnstructuredGrid become tetrahedra whose edges keep
 * two tolerances: the distance from the cell's own shape, and the difference from the scalars by
 * its own shape functions. vtkTetMarchVolumeMapper does the same with GeometryTolerance; without it
 * it draws linear pieces between the points of a cell, whatever they miss.
 *
 * The output is watertight where the input is: an edge is halved in all cells that have it. In
 * cells with points of their own (discontinuous Galerkin) neighbours are cut by themselves, which
 * may open gaps as wide as the tolerance. Linear cells and polyhedra are passed on, cells of less
 * than three dimensions are left out. Arrays of points are interpolated by the shape functions of
 * the cells (integers rounded; ghost arrays, global ids and pedigree ids are not passed on), those
 * of cells are copied, and the array "vtkOriginalCellIds" of cells names the cell of the input.
 *
 * The scalars are those of the points that SetInputArrayToProcess(0, 0, 0,
 * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) names, by default the active ones. Each of their
 * components keeps the tolerance. Without scalars of points the shape alone counts.
 *
 * Edges are compared at a quarter, a half and three quarters of each. For quadratic functions in
 * cells with straight edges this is a bound: edges keep the tolerance, points within a tetrahedron
 * 1.5 times the tolerance. Else it is an estimate.
 *
 * vtkTessellatorFilter is similar, but compares the middles of edges alone, and takes no
 * triquadratic, Lagrange and Bezier cells.
 *
 * M.-C. Rivara, Algorithms for refining triangular grids suitable for adaptive and multigrid
 * techniques, 1984 (bisection by the longest edge).
 */
#ifndef vtkTetMarchTessellator_h
#define vtkTetMarchTessellator_h

#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchTessellator : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkTetMarchTessellator* New();
  vtkTypeMacro(vtkTetMarchTessellator, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /** The greatest distance between an edge and the curve that it stands for, as a part of the
   * diagonal of the bounding box: 1e-6 to 1. The default 5e-4 is a fourth of a pixel of a picture
   * of 500 x 500. */
  vtkSetClampMacro(GeometryTolerance, double, 1e-6, 1.0);
  vtkGetMacro(GeometryTolerance, double);
  //@}

  //@{
  /** The greatest difference from the scalars, as a part of their range: 1e-6 to 1. */
  vtkSetClampMacro(ScalarTolerance, double, 1e-6, 1.0);
  vtkGetMacro(ScalarTolerance, double);
  //@}

protected:
  vtkTetMarchTessellator();
  ~vtkTetMarchTessellator() override = default;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetMarchTessellator(const vtkTetMarchTessellator&) = delete;
  void operator=(const vtkTetMarchTessellator&) = delete;

  double GeometryTolerance = 5e-4;
  double ScalarTolerance = 2e-3;
};

#endif
