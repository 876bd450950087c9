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

/** vtkConvexPointSet::Triangulate returns local point indices, not ids of the grid as other cells
 * do. */
constexpr bool ConvexPointSetsCountLocally = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0);

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)

/** One value per cell, or null. From 9.6 on the array may compute its values. */
inline vtkDataArray* cellTypesOf(vtkUnstructuredGrid* grid) { return grid->GetCellTypesArray(); }
inline const char* nameOfCellType(int type) { return vtkCellTypes::GetClassNameFromTypeId(type); }

/** The array types in which vtkCellArray stores its offsets and connectivity. */
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

/** For each polyhedron its number of faces, then for each face its number of points and the points;
 * and for each cell the begin of its stream, or -1. Null without polyhedra. */
using FaceArray = vtkIdTypeArray;
inline FaceArray* facesOf(vtkUnstructuredGrid* grid) { return grid->GetFaces(); }
inline FaceArray* faceLocationsOf(vtkUnstructuredGrid* grid) { return grid->GetFaceLocations(); }

#else

/** The points of each face; and for each cell the indices of its faces. Null without polyhedra. */
using FaceArray = vtkCellArray;
inline FaceArray* facesOf(vtkUnstructuredGrid* grid) { return grid->GetPolyhedronFaces(); }
inline FaceArray* faceLocationsOf(vtkUnstructuredGrid* grid)
{
  return grid->GetPolyhedronFaceLocations();
}

#endif

} // namespace tetmarch

#endif
