// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTypeGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <map>
#include <random>

namespace tetmarch::testing
{
namespace
{
enum class Kind
{
  Hexahedron,
  Wedges,
  Tetrahedra,
  Star
};

// Which faces a kind wants cut along their diagonals, in the order of CubeFaces; a star takes any.
constexpr std::array<bool, 6> CutFaces[] = { { false, false, false, false, false, false },
  { false, false, false, false, true, true }, { true, true, true, true, true, true } };

class Mixer
{
public:
  Mixer(int n, unsigned seed, double warp)
    : Lattice(n, warp)
    , Generator(seed)
  {
  }

  Grid mix(const Field& field)
  {
    // Kinds first, then cells: a star must know what all its neighbours ask for.
    std::vector<Kind> kinds;
    this->Lattice.forEachCube([&](const Ids& cube) { kinds.push_back(this->choose(cube)); });
    std::size_t next = 0;
    this->Lattice.forEachCube([&](const Ids& cube) { this->addCells(kinds[next++], cube); });
    return this->Lattice.Builder.finish(field);
  }

private:
  // A face is known by its lowest and highest corners.
  static std::array<vtkIdType, 2> key(const Ids& face) { return { face[0], face[2] }; }

  Kind choose(const Ids& cube)
  {
    const auto kind = static_cast<Kind>(this->Generator() % 4);
    if (kind == Kind::Star)
    {
      return kind;
    }
    const auto& wanted = CutFaces[static_cast<int>(kind)];
    for (int f = 0; f < 6; ++f)
    {
      const auto known = this->IsCut.find(key(pick(cube, CubeFaces[f])));
      if (known != this->IsCut.end() && known->second != wanted[f])
      {
        return Kind::Star;
      }
    }
    for (int f = 0; f < 6; ++f)
    {
      this->IsCut[key(pick(cube, CubeFaces[f]))] = wanted[f];
    }
    return kind;
  }

  void addCells(Kind kind, const Ids& cube)
  {
    GridBuilder& builder = this->Lattice.Builder;
    switch (kind)
    {
      case Kind::Hexahedron:
        builder.addCell(VTK_HEXAHEDRON, pick(cube, HexCorners));
        break;
      case Kind::Wedges:
        for (const auto& wedge : CubeWedges)
        {
          builder.addCell(VTK_WEDGE, pick(cube, wedge));
        }
        break;
      case Kind::Tetrahedra:
        for (const auto& tet : KuhnTets)
        {
          builder.addCell(VTK_TETRA, pick(cube, tet));
        }
        break;
      case Kind::Star:
        this->addStar(cube);
        break;
    }
  }

  void addStar(const Ids& cube)
  {
    GridBuilder& builder = this->Lattice.Builder;
    const vtkIdType tip = builder.between(cube);
    for (const auto& corners : CubeFaces)
    {
      const Ids face = pick(cube, corners);
      // Between two stars, and on the surface, chance decides, once.
      const bool byChance = this->Generator() % 2 == 0;
      if (this->IsCut.try_emplace(key(face), byChance).first->second)
      {
        builder.addCell(VTK_TETRA, { face[0], face[2], face[1], tip });
        builder.addCell(VTK_TETRA, { face[0], face[3], face[2], tip });
      }
      else
      {
        builder.addCell(VTK_PYRAMID, { face[0], face[3], face[2], face[1], tip });
      }
    }
  }

  CubeLattice Lattice;
  std::mt19937 Generator;
  std::map<std::array<vtkIdType, 2>, bool> IsCut;
};
} // namespace

Grid mixedCells(int n, unsigned seed, double warp, const Field& field)
{
  return Mixer(n, seed, warp).mix(field);
}
} // namespace tetmarch::testing
