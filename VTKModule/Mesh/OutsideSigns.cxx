// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/OutsideSigns.h"

#include "Mesh/ConsistentOrientation.h"
#include "Mesh/Orientation.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace tetmarch
{
namespace
{

class SignFinder
{
public:
  explicit SignFinder(const TetMesh& mesh)
    : Mesh(mesh)
    , Signs(volumeSigns(mesh))
  {
  }

  std::vector<std::int8_t> find()
  {
    // Nearly every mesh: the links need not be followed.
    if (!this->volumesAgree())
    {
      this->carryFromBoundary();
    }
    return std::move(this->Signs);
  }

private:
  Id linkOf(Id tet, Id i) const { return this->Mesh.Links[4 * std::size_t(tet) + i]; }

  // The sign of the tetrahedron behind face i of one with this sign.
  static std::int8_t signBehind(int sign, Id i, Id link)
  {
    return static_cast<std::int8_t>(-sign * parity(i) * parity(link % 4));
  }

  std::int8_t signInside(const std::array<Id, 4>& boundaryFace) const
  {
    const auto ifPositive = outwardFace(this->Mesh, boundaryFace[3], 1);
    // The same vertices in the same cyclic order, or in the opposite one.
    const auto at = std::find(boundaryFace.begin(), boundaryFace.begin() + 3, ifPositive[0]);
    const auto next = at + 1 == boundaryFace.begin() + 3 ? boundaryFace.begin() : at + 1;
    return *next == ifPositive[1] ? 1 : -1;
  }

  bool agrees(Id tet) const
  {
    if (this->Mesh.isDegenerate(tet))
    {
      return true;
    }
    for (Id i = 0; i < 4; ++i)
    {
      const Id link = this->linkOf(tet, i);
      const bool same =
        link >= LinkOutside
          ? this->Signs[tet] == this->signInside(this->Mesh.BoundaryFaces[link - LinkOutside])
          : this->Signs[link / 4] == this->signBehind(this->Signs[tet], i, link);
      if (!same)
      {
        return false;
      }
    }
    return this->Signs[tet] != 0;
  }

  bool volumesAgree() const
  {
    std::atomic<bool> agree(true);
    parallelFor(0, static_cast<vtkIdType>(this->Signs.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType t = first; t < last && agree; ++t)
        {
          if (!this->agrees(static_cast<Id>(t)))
          {
            agree = false;
          }
        }
      });
    return agree;
  }

  void carryFromBoundary()
  {
    std::fill(this->Signs.begin(), this->Signs.end(), std::int8_t(0));
    for (const auto& face : this->Mesh.BoundaryFaces)
    {
      this->carryFrom(face[3] / 4, this->signInside(face));
    }
    for (Id t = 0; t < this->Mesh.numberOfTets(); ++t)
    {
      this->carryFrom(t, signedVolume(this->Mesh, t) < 0 ? -1 : 1);
    }
  }

  void carryFrom(Id seed, int sign)
  {
    if (this->Signs[seed] != 0)
    {
      return;
    }
    this->Signs[seed] = static_cast<std::int8_t>(sign);
    this->Waiting.assign(1, seed);
    while (!this->Waiting.empty())
    {
      const Id tet = this->Waiting.back();
      this->Waiting.pop_back();
      for (Id i = 0; i < 4; ++i)
      {
        const Id link = this->linkOf(tet, i);
        if (link < LinkOutside && this->Signs[link / 4] == 0)
        {
          this->Signs[link / 4] = this->signBehind(this->Signs[tet], i, link);
          this->Waiting.push_back(link / 4);
        }
      }
    }
  }

  const TetMesh& Mesh;
  std::vector<std::int8_t> Signs;
  std::vector<Id> Waiting;
};

} // namespace

std::vector<std::int8_t> outsideSigns(const TetMesh& mesh) { return SignFinder(mesh).find(); }

} // namespace tetmarch
