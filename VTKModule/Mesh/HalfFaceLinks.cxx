// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HalfFaceLinks.h"

#include "Mesh/ConsistentOrientation.h"
#include "Mesh/FaceMatching.h"
#include "Mesh/Orientation.h"

#include <algorithm>
#include <iterator>

namespace tetmarch
{
namespace
{

void sortAndUnite(std::vector<Id>& tets)
{
  std::sort(tets.begin(), tets.end());
  tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
}

void dropDuplicates(FaceMatching& found, TetMesh& mesh)
{
  std::vector<std::array<Id, 4>>& tets = mesh.Tets.stored();
  std::vector<Id>& cells = mesh.TetCells.stored();
  sortAndUnite(found.Duplicates);
  sortAndUnite(found.Cancelled);
  std::vector<Id> dropped;
  std::set_union(found.Duplicates.begin(), found.Duplicates.end(), found.Cancelled.begin(),
    found.Cancelled.end(), std::back_inserter(dropped));
  mesh.Report.DuplicateTetrahedra +=
    static_cast<vtkIdType>(dropped.size() - found.Cancelled.size());
  std::size_t next = 0;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    if (next < dropped.size() && dropped[next] == t)
    {
      ++next;
      continue;
    }
    tets[kept] = tets[t];
    cells[kept] = cells[t];
    ++kept;
  }
  tets.resize(kept);
  cells.resize(kept);
}

void unlinkFolds(FaceMatching& found, TetMesh& mesh)
{
  const std::vector<Id> folds = agreeOnSigns(mesh, found.Signs);
  for (const Id halfFace : folds)
  {
    mesh.Links.stored()[halfFace] = Unlinked;
    found.Boundary.emplace_back(mesh.Tets[halfFace / 4][halfFace % 4 == 0 ? 1 : 0], halfFace);
  }
  mesh.Report.FoldedFaces = static_cast<vtkIdType>(folds.size() / 2);
}

} // namespace

bool linkHalfFaces(const Progress& progress, TetMesh& mesh)
{
  FaceMatching found;
  for (;;)
  {
    if (!matchFaces(progress, mesh, found))
    {
      return false;
    }
    if (found.Duplicates.empty())
    {
      break;
    }
    dropDuplicates(found, mesh);
  }
  mesh.Report.NonManifoldFaces = found.NonManifoldFaces;
  if (!found.Agree)
  {
    unlinkFolds(found, mesh);
  }
  mesh.LinksFollowCells = !mesh.HasCutCells && !found.ManyOwners && mesh.Report.FoldedFaces == 0;

  std::sort(found.Boundary.begin(), found.Boundary.end());
  mesh.BoundaryFaces.clear();
  mesh.BoundaryFaces.reserve(found.Boundary.size());
  for (const auto& face : found.Boundary)
  {
    mesh.BoundaryFaces.push_back(outwardFace(mesh, face.second, found.Signs[face.second / 4]));
  }
  return true;
}

void linkBoundary(TetMesh& mesh)
{
  const std::vector<std::array<Id, 4>>& faces = mesh.BoundaryFaces;
  if (mesh.Curvilinear)
  {
    CurvilinearCells cells = *mesh.Curvilinear;
    std::vector<Id> order = cells.order();
    for (std::size_t b = 0; b < faces.size(); ++b)
    {
      order[cells.boundaryNumber(faces[b][3])] = static_cast<Id>(b);
    }
    cells.setOrder(std::move(order));
    mesh.computeCells(std::move(cells));
    return;
  }
  for (std::size_t b = 0; b < faces.size(); ++b)
  {
    mesh.Links.stored()[faces[b][3]] = LinkOutside + static_cast<Id>(b);
  }
}

} // namespace tetmarch
