// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Differences between versions of VTK in unstructured grids.
#ifndef TetMarchInputGridVersions_h
#define TetMarchInputGridVersions_h

#include "vtkArrayDispatch.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)
#include "vtkCellTypes.h"
#else
#include "vtkArrayDispatchDataSetArrayList.h"
#include "vtkCellTypeUtilities.h"
#endif

/** Whether the faces of polyhedra are streams of numbers, as up to VTK 9.3, or lists of polygons.
 */
#define TETMARCH_FACES_ARE_STREAMS (VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0))

#if TETMARCH_FACES_ARE_STREAMS
class vtkIdTypeArray;
#else
class vtkCellArray;
#endif

namespace tetmarch
{

/** vtkConvexPointSet::Triangulate returns numbers of the cell's points, not of the grid's as other
 * cells do. */
constexpr bool ConvexPointSetsCountLocally = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0);

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)

/** One value a cell, or null. From 9.6 on it may be an array that stores none. */
inline vtkDataArray* cellTypesOf(vtkUnstructuredGrid* grid) { return grid->GetCellTypesArray(); }
inline const char* nameOfCellType(int type) { return vtkCellTypes::GetClassNameFromTypeId(type); }

/** The types of array in which vtkCellArray keeps its offsets and its connectivity. */
using OffsetArrays =
  vtkTypeList::Create<vtkAOSDataArrayTemplate<vtkTypeInt32>, vtkAOSDataArrayTemplate<vtkTypeInt64>>;
using ConnectivityArrays = OffsetArrays;

#else

inline vtkDataArray* cellTypesOf(vtkUnstructuredGrid* grid) { return grid->GetCellTypes(); }
inline const char* nameOfCellType(int type)
{
  return vtkCellTypeUtilities::GetClassNameFromTypeId(type);
}
using OffsetArrays = vtkArrayDispatch::OffsetsArrays;
using ConnectivityArrays = vtkArrayDispatch::ConnectivityArrays;

#endif

#if TETMARCH_FACES_ARE_STREAMS

/** For each polyhedron its number of faces, then for each of them its number of points, and these;
 * and for each cell where its stream begins, or -1. Null without polyhedra. */
using FaceArray = vtkIdTypeArray;
inline FaceArray* facesOf(vtkUnstructuredGrid* grid) { return grid->GetFaces(); }
inline FaceArray* faceLocationsOf(vtkUnstructuredGrid* grid) { return grid->GetFaceLocations(); }

#else

/** The points of each face; and for each cell the numbers of its faces. Null without polyhedra. */
using FaceArray = vtkCellArray;
inline FaceArray* facesOf(vtkUnstructuredGrid* grid) { return grid->GetPolyhedronFaces(); }
inline FaceArray* faceLocationsOf(vtkUnstructuredGrid* grid)
{
  return grid->GetPolyhedronFaceLocations();
}

#endif

} // namespace tetmarch

#endif
