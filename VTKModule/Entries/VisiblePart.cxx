// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/VisiblePart.h"

#include "Mesh/Orientation.h"
#include "Mesh/OutsideSigns.h"
#include "Parallel/ParallelFor.h"
#include "Scalars/SeenScalars.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tetmarch
{
namespace
{

constexpr std::size_t BitsOfWord = 32;
constexpr std::size_t TetsOfChunk = 4096;

vtkIdType chunksOf(std::size_t count, std::size_t size)
{
  return static_cast<vtkIdType>((count + size - 1) / size);
}

bool bitOf(const std::vector<std::uint32_t>& bits, std::size_t i)
{
  return (bits[i / BitsOfWord] >> (i % BitsOfWord) & 1u) != 0;
}

// Whether a tetrahedron may be visible.
class SeenTets
{
public:
  SeenTets(const TetMesh& mesh, const VisibleScalars& shown)
    : Mesh(mesh)
    , Shown(shown)
    , Seen(*shown.Table, shown.Scalars->Range)
  {
  }

  bool operator()(std::size_t tet) const
  {
    const HiddenCells& hidden = *this->Shown.Hidden;
    if (!hidden.empty() && bitOf(hidden, tet))
    {
      return false;
    }
    const std::vector<float>& ofCells = this->Shown.Scalars->OfCells;
    float low = 0;
    float high = 0;
    if (!ofCells.empty())
    {
      low = high = ofCells[tet];
    }
    else
    {
      const auto& ids = this->Mesh.Tets[tet];
      const auto& vertices = this->Mesh.Vertices;
      std::tie(low, high) = std::minmax({ vertices[ids[0]].Scalar, vertices[ids[1]].Scalar,
        vertices[ids[2]].Scalar, vertices[ids[3]].Scalar });
    }
    // A tetrahedron with a scalar that is not finite is drawn in the NaN colour or not at all.
    return high >= UndrawnScalar ? this->Shown.UndrawnSeen : this->isBetween(low, high);
  }

private:
  bool isBetween(float low, float high) const
  {
    return this->Shown.Blend->isIsoSurface() ? isAnyBetween(this->Shown.Blend->IsoValues, low, high)
                                             : this->Seen.between(low, high);
  }

  const TetMesh& Mesh;
  const VisibleScalars& Shown;
  SeenScalars Seen;
};

class PartMaker
{
public:
  explicit PartMaker(const TetMesh& mesh)
    : Mesh(mesh)
    , Tets(mesh.Tets.size())
  {
  }

  VisiblePart make(const VisibleScalars& shown)
  {
    this->mark(SeenTets(this->Mesh, shown));
    if (this->Part.NumberOfTets > 0 && this->Part.NumberOfTets < this->Tets)
    {
      this->findFaces();
    }
    return std::move(this->Part);
  }

private:
  void mark(const SeenTets& isSeen)
  {
    this->Part.Tets.resize(static_cast<std::size_t>(chunksOf(this->Tets, BitsOfWord)));
    parallelFor(0, static_cast<vtkIdType>(this->Part.Tets.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType word = begin; word < end; ++word)
        {
          const std::size_t first = static_cast<std::size_t>(word) * BitsOfWord;
          const std::size_t last = std::min(first + BitsOfWord, this->Tets);
          std::uint32_t bits = 0;
          for (std::size_t tet = first; tet < last; ++tet)
          {
            bits |= isSeen(tet) ? 1u << (tet - first) : 0u;
          }
          this->Part.Tets[word] = bits;
        }
      });
    for (std::uint32_t bits : this->Part.Tets)
    {
      for (; bits != 0; bits &= bits - 1)
      {
        ++this->Part.NumberOfTets;
      }
    }
  }

  // A half-face of a visible tetrahedron, with none behind it.
  bool isEntry(std::size_t halfFace) const
  {
    const Id link = this->Mesh.Links[halfFace];
    return link >= LinkOutside || !bitOf(this->Part.Tets, link / 4);
  }

  template <typename Visit>
  void visitEntries(std::size_t chunk, const Visit& visit) const
  {
    const std::size_t first = chunk * TetsOfChunk;
    for (std::size_t tet = first; tet < std::min(first + TetsOfChunk, this->Tets); ++tet)
    {
      if (bitOf(this->Part.Tets, tet))
      {
        for (std::size_t halfFace = 4 * tet; halfFace < 4 * tet + 4; ++halfFace)
        {
          if (this->isEntry(halfFace))
          {
            visit(static_cast<Id>(halfFace));
          }
        }
      }
    }
  }

  template <typename Work>
  void forChunks(const Work& work) const
  {
    parallelFor(0, chunksOf(this->Tets, TetsOfChunk),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          work(static_cast<std::size_t>(chunk));
        }
      });
  }

  // First the half-faces, chunk by chunk; then their faces.
  void findFaces()
  {
    std::vector<std::size_t> ends(static_cast<std::size_t>(chunksOf(this->Tets, TetsOfChunk)));
    this->forChunks(
      [&](std::size_t chunk) { this->visitEntries(chunk, [&](Id) { ++ends[chunk]; }); });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Id> halfFaces(ends.back());
    this->forChunks(
      [&](std::size_t chunk)
      {
        std::size_t at = chunk == 0 ? 0 : ends[chunk - 1];
        this->visitEntries(chunk, [&](Id halfFace) { halfFaces[at++] = halfFace; });
      });
    this->findSigns(halfFaces);
    this->Part.Faces.resize(halfFaces.size());
    parallelFor(0, static_cast<vtkIdType>(halfFaces.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Part.Faces[i] = this->faceOf(halfFaces[i]);
        }
      });
    linkVisiblePart(this->Mesh, this->Part);
    // A line in a random direction crosses cells and faces in proportion to their surfaces: each
    // cell has four faces and two crossings.
    this->Part.CellsOfGap = 4.0 * static_cast<double>(this->Tets - this->Part.NumberOfTets) /
                            static_cast<double>(halfFaces.size());
  }

  // If no tetrahedron can be flat or inverted, its volume determines its orientation; computing the
  // signs of all would dominate the time.
  void findSigns(const std::vector<Id>& halfFaces)
  {
    if (this->Mesh.HasCutCells || this->Mesh.Report.FoldedFaces > 0 ||
        std::any_of(halfFaces.begin(), halfFaces.end(),
          [this](Id halfFace) { return volumeSign(this->Mesh, halfFace / 4) == 0; }))
    {
      this->Signs = outsideSigns(this->Mesh);
    }
  }

  std::array<Id, 4> faceOf(Id halfFace) const
  {
    return outwardFace(this->Mesh, halfFace,
      this->Signs.empty() ? volumeSign(this->Mesh, halfFace / 4) : this->Signs[halfFace / 4]);
  }

  const TetMesh& Mesh;
  std::size_t Tets;
  VisiblePart Part;
  std::vector<std::int8_t> Signs; // outsideSigns(); empty: those of volumes
};

} // namespace

VisiblePart findVisiblePart(const TetMesh& mesh, const VisibleScalars& shown)
{
  return PartMaker(mesh).make(shown);
}

void linkVisiblePart(const TetMesh& mesh, VisiblePart& part)
{
  part.Links.resize(part.Faces.size());
  parallelFor(0, static_cast<vtkIdType>(part.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        part.Links[i] = mesh.Links[part.Faces[i][3]];
      }
    });
}

} // namespace tetmarch
