// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/EyeStart.h"

#include "Entries/SeenTets.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/Orientation.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// The faces of all of a mesh are its boundary faces, those of a part ascend by their half-faces.
std::size_t faceOf(const TetMesh& mesh, const VisiblePart& part, Id halfFace)
{
  if (part.NumberOfTets == mesh.Tets.size())
  {
    return mesh.Links[halfFace] - LinkOutside;
  }
  const auto face = std::lower_bound(part.Faces.begin(), part.Faces.end(), halfFace,
    [](const std::array<Id, 4>& of, Id value) { return of[3] < value; });
  return static_cast<std::size_t>(face - part.Faces.begin());
}

VisiblePart wholeOf(const TetMesh& mesh)
{
  VisiblePart part;
  part.Tets.assign((mesh.Tets.size() + 31) / 32, ~std::uint32_t(0));
  part.NumberOfTets = mesh.Tets.size();
  part.Faces = mesh.BoundaryFaces;
  linkVisiblePart(mesh, part);
  return part;
}

// around: tetrahedra of the mesh, ascending.
EyeStart startAmong(const TetMesh& mesh, const VisiblePart& part, const std::vector<Id>& around,
  const SignOfTet& signOf)
{
  EyeStart start;
  for (const Id tet : around)
  {
    for (Id halfFace = 4 * tet; hasTet(part.Tets, tet) && halfFace < 4 * tet + 4; ++halfFace)
    {
      const Id link = mesh.Links[halfFace];
      if (link >= LinkOutside || !hasTet(part.Tets, link / 4))
      {
        start.OfPart.push_back(faceOf(mesh, part, halfFace));
      }
      else if (!std::binary_search(around.begin(), around.end(), link / 4))
      {
        start.Inside.push_back(outwardFace(mesh, halfFace, signOf(tet)));
        start.Links.push_back(link);
      }
    }
  }
  return start;
}

} // namespace

void EyeStartFinder::update(const TetMesh& mesh, const VisiblePart* visible,
  const Fingerprint& version, const Vector3& eye, const SignOfTet& signOf)
{
  Fingerprint input = version;
  addAll(input, eye);
  if (input == this->Version)
  {
    return;
  }
  this->Version.clear();
  this->Found = false;
  if (const Fingerprint ofMesh{ version.front() }; ofMesh != this->BoxesVersion)
  {
    this->Boxes = TetsAtPoint(mesh);
    this->BoxesVersion = ofMesh;
  }
  if (visible)
  {
    this->Whole = {};
    this->WholeVersion.clear();
  }
  else if (version != this->WholeVersion)
  {
    this->Whole = wholeOf(mesh);
    this->WholeVersion = version;
  }
  // Rays pass the eye itself at a distance, and vertices are displaced, both by rounding.
  const std::vector<Id> around = this->Boxes.find(mesh, eye, 2 * double(HierarchyMargin));
  this->Start = startAmong(mesh, visible ? *visible : this->Whole, around, signOf);
  this->Found = this->Start.Inside.size() <= MostEyeFaces;
  this->Version = input;
}

// It may come back: the boxes stay.
void EyeStartFinder::leave()
{
  this->WholeVersion.clear();
  this->Whole = {};
  this->Version.clear();
  this->Start = {};
  this->Found = false;
}

} // namespace tetmarch
