// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ConsistentOrientation.h"

#include "Mesh/Orientation.h"
#include "Parallel/ParallelFor.h"

namespace tetmarch
{
namespace
{

class Orienter
{
public:
  Orienter(const TetMesh& mesh, std::vector<std::int8_t>& signs)
    : Mesh(mesh)
    , Signs(signs)
  {
  }

  void agree()
  {
    if (this->Mesh.HasCutCells)
    {
      this->decideCutCells();
    }
    this->askNeighboursOfFlatTets();
    this->decideFlatComponents();
  }

  std::vector<Id> findFolds() const
  {
    std::vector<Id> folds;
    for (Id t = 0; t < this->numberOfTets(); ++t)
    {
      for (Id i = 0; i < 4; ++i)
      {
        if (this->isFold(t, i))
        {
          folds.push_back(4 * t + i);
        }
      }
    }
    return folds;
  }

private:
  Id numberOfTets() const { return this->Mesh.numberOfTets(); }
  Id linkOf(Id tet, Id i) const { return this->Mesh.Links[4 * std::size_t(tet) + i]; }
  static bool leadsOutside(Id link) { return link >= LinkOutside; }

  // The sign that the tetrahedron behind face i of one with sign 1 must have.
  static int signBehind(Id i, Id link) { return -parity(i) * parity(link % 4); }

  bool isFold(Id tet, Id i) const
  {
    const Id link = this->linkOf(tet, i);
    return !leadsOutside(link) &&
           this->Signs[tet] * this->Signs[link / 4] == -this->signBehind(i, link);
  }

  void decideCutCells()
  {
    const auto sameCell = [this](Id a, Id b)
    { return this->Mesh.TetCells[a] == this->Mesh.TetCells[b]; };
    for (Id t = 0; t < this->numberOfTets(); ++t)
    {
      for (Id i = 0; i < 4; ++i)
      {
        if (this->isFold(t, i) && sameCell(t, this->linkOf(t, i) / 4))
        {
          this->decideTogether(t, sameCell);
        }
      }
    }
  }

  void askNeighboursOfFlatTets()
  {
    std::vector<Id> asked; // flat tetrahedra with a sign, whose neighbours come next
    const auto ask = [&](Id flat)
    {
      for (Id i = 0; i < 4 && this->Signs[flat] == 0; ++i)
      {
        const Id link = this->linkOf(flat, i);
        if (!leadsOutside(link) && this->Signs[link / 4] != 0)
        {
          this->Signs[flat] =
            static_cast<std::int8_t>(this->Signs[link / 4] * this->signBehind(i, link));
          asked.push_back(flat);
        }
      }
    };
    for (Id t = 0; t < this->numberOfTets(); ++t)
    {
      if (this->Signs[t] == 0)
      {
        ask(t);
      }
    }
    for (std::size_t next = 0; next < asked.size(); ++next)
    {
      for (Id i = 0; i < 4; ++i)
      {
        const Id link = this->linkOf(asked[next], i);
        if (!leadsOutside(link) && this->Signs[link / 4] == 0)
        {
          ask(link / 4);
        }
      }
    }
  }

  void decideFlatComponents()
  {
    for (Id t = 0; t < this->numberOfTets(); ++t)
    {
      if (this->Signs[t] == 0)
      {
        this->decideTogether(t, [](Id, Id) { return true; });
      }
    }
  }

  // Give consistent signs to all tetrahedra that are connected with the seed by followed links,
  // such that the sum of their volumes is positive.
  template <typename MayFollow>
  void decideTogether(Id seed, MayFollow&& mayFollow)
  {
    this->Relative.resize(this->Mesh.Tets.size(), 0);
    std::vector<Id> tets{ seed };
    this->Relative[seed] = 1;
    double volume = 0;
    for (std::size_t next = 0; next < tets.size(); ++next)
    {
      const Id tet = tets[next];
      volume += this->Relative[tet] * signedVolume(this->Mesh, tet);
      for (Id i = 0; i < 4; ++i)
      {
        const Id link = this->linkOf(tet, i);
        if (!leadsOutside(link) && this->Relative[link / 4] == 0 && mayFollow(tet, link / 4))
        {
          this->Relative[link / 4] =
            static_cast<std::int8_t>(this->Relative[tet] * this->signBehind(i, link));
          tets.push_back(link / 4);
        }
      }
    }
    for (const Id tet : tets)
    {
      this->Signs[tet] =
        static_cast<std::int8_t>(volume < 0 ? -this->Relative[tet] : this->Relative[tet]);
      this->Relative[tet] = 0;
    }
  }

  const TetMesh& Mesh;
  std::vector<std::int8_t>& Signs;
  std::vector<std::int8_t> Relative; // all 0 between two decisions
};

} // namespace

std::vector<std::int8_t> volumeSigns(const TetMesh& mesh)
{
  std::vector<std::int8_t> signs(mesh.Tets.size());
  parallelFor(0, static_cast<vtkIdType>(signs.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        signs[t] = static_cast<std::int8_t>(volumeSign(mesh, static_cast<Id>(t)));
      }
    });
  return signs;
}

std::vector<Id> agreeOnSigns(const TetMesh& mesh, std::vector<std::int8_t>& signs)
{
  Orienter orienter(mesh, signs);
  orienter.agree();
  return orienter.findFolds();
}

} // namespace tetmarch
