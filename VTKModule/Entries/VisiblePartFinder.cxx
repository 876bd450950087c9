// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/VisiblePartFinder.h"

#include "Mesh/Orientation.h"
#include "Mesh/OutsideSigns.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <bitset>
#include <numeric>
#include <utility>

namespace tetmarch
{
namespace
{

constexpr std::size_t BitsOfWord = 32;
constexpr std::size_t TetsOfWord = BitsOfWord / 4; // of Entries
constexpr std::size_t WordsOfChunk = 512;

std::size_t wordsFor(std::size_t bits) { return (bits + BitsOfWord - 1) / BitsOfWord; }

std::size_t countOf(std::uint32_t bits) { return std::bitset<BitsOfWord>(bits).count(); }

// Where the faces of a chunk begin; none are known if there are no ends.
std::ptrdiff_t beginOf(const std::vector<std::size_t>& ends, std::size_t chunk)
{
  return chunk == 0 || ends.empty() ? 0 : static_cast<std::ptrdiff_t>(ends[chunk - 1]);
}

// Call work(begin, end) for parts of a count, in parallel.
template <typename Work>
void forPartsOf(std::size_t count, const Work& work)
{
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    { work(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

// Whether the volume of a tetrahedron determines its orientation, since none can be inverted;
// unless it is flat. Finding the signs of all takes longer than all else.
bool isOrientedByVolumes(const TetMesh& mesh)
{
  return !mesh.HasCutCells && mesh.Report.FoldedFaces == 0;
}

// A bit for each tetrahedron; empty if none is degenerate.
std::vector<std::uint32_t> degenerateTets(const TetMesh& mesh)
{
  const bool mayBe = mesh.Curvilinear && mesh.Curvilinear->joins().any();
  std::vector<std::uint32_t> words(mayBe ? wordsFor(mesh.Tets.size()) : 0);
  forPartsOf(words.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t tet = begin * BitsOfWord; tet < std::min(end * BitsOfWord, mesh.Tets.size());
           ++tet)
      {
        words[tet / BitsOfWord] |= (mesh.isDegenerate(tet) ? 1u : 0u) << (tet % BitsOfWord);
      }
    });
  return words;
}

} // namespace

bool VisiblePartFinder::isCurrent(const VisibleScalars& shown, const Fingerprint& version) const
{
  return version == this->Version && *this->Seen == SeenTets(shown);
}

void VisiblePartFinder::clear() { *this = {}; }

void VisiblePartFinder::update(
  const TetMesh& mesh, const VisibleScalars& shown, const Fingerprint& version)
{
  const Fingerprint before = std::exchange(this->Version, {});
  if (version != before)
  {
    this->begin(mesh, *shown.Scalars, !before.empty() && version.front() == before.front());
  }
  this->Seen.emplace(shown);
  this->mark(mesh, shown);
  if (this->Part.NumberOfTets > 0 && this->Part.NumberOfTets < mesh.Tets.size())
  {
    this->findEntries(mesh);
    this->findFaces(mesh);
  }
  else
  {
    this->Part.Faces.clear();
    this->Part.Links.clear();
    this->Part.CellsOfGap = 0;
    this->Chunks.clear();
  }
  this->Version = version;
}

void VisiblePartFinder::begin(const TetMesh& mesh, const MeshScalars& scalars, bool isSameMesh)
{
  std::vector<std::int8_t> signs = std::move(this->Signs);
  this->clear();
  if (isSameMesh)
  {
    this->Signs = std::move(signs);
  }
  this->Levels = levelsOf(mesh, scalars);
  this->Entries = std::vector<std::atomic<std::uint32_t>>(wordsFor(4 * mesh.Tets.size()));
  this->Part.Tets.resize(wordsFor(mesh.Tets.size()));
  this->KnownTets.resize(this->Part.Tets.size());
  this->DegenerateTets = degenerateTets(mesh);
}

void VisiblePartFinder::mark(const TetMesh& mesh, const VisibleScalars& shown)
{
  static_assert(TetsOfCluster == 2 * BitsOfWord, "a cluster has two words");
  std::vector<std::uint32_t>& words = this->Part.Tets;
  const HiddenCells& hidden = *shown.Hidden;
  std::atomic<std::size_t> visible(0);
  forPartsOf(this->Levels.OfClusters.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t count = 0;
      for (std::size_t cluster = begin; cluster < end; ++cluster)
      {
        std::uint64_t bits = this->Seen->ofCluster(mesh, *shown.Scalars, this->Levels, cluster);
        for (std::size_t word = 2 * cluster; word < std::min(2 * cluster + 2, words.size()); ++word)
        {
          words[word] = static_cast<std::uint32_t>(bits) & (hidden.empty() ? ~0u : ~hidden[word]);
          words[word] |= this->degenerateIn(word);
          count += countOf(words[word] & ~this->degenerateIn(word));
          bits >>= BitsOfWord;
        }
      }
      visible += count;
    });
  const std::size_t passed =
    std::accumulate(this->DegenerateTets.begin(), this->DegenerateTets.end(), std::size_t(0),
      [](std::size_t sum, std::uint32_t word) { return sum + countOf(word); });
  this->Part.NumberOfTets = visible > 0 ? visible + passed : 0;
}

// Only half-faces of tetrahedra whose visibility has changed, and those behind them, may change.
void VisiblePartFinder::findEntries(const TetMesh& mesh)
{
  forPartsOf(this->Part.Tets.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t word = begin; word < end; ++word)
      {
        std::size_t tet = word * BitsOfWord;
        const std::uint32_t different = this->Part.Tets[word] ^ this->KnownTets[word];
        for (std::uint32_t changed = different & ~this->degenerateIn(word); changed != 0;
             changed >>= 1, ++tet)
        {
          if ((changed & 1u) != 0)
          {
            this->findEntriesOf(mesh, tet);
          }
        }
      }
    });
  this->KnownTets = this->Part.Tets;
}

// Each bit of Entries is toggled by at most one tetrahedron.
void VisiblePartFinder::findEntriesOf(const TetMesh& mesh, std::size_t tet)
{
  const bool isVisible = hasTet(this->Part.Tets, tet);
  std::uint32_t own = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Id link = mesh.Links[4 * tet + i];
    const bool isSeenBehind = link < LinkOutside && hasTet(this->Part.Tets, link / 4);
    own |= isVisible && !isSeenBehind ? 1u << i : 0u;
    if (isSeenBehind && hasTet(this->KnownTets, link / 4))
    {
      this->toggle(link, 1u); // which stays visible
    }
  }
  const std::uint32_t before =
    this->Entries[tet / TetsOfWord].load(std::memory_order_relaxed) >> (4 * (tet % TetsOfWord));
  this->toggle(4 * tet, (before & 15u) ^ own);
}

// Toggle the bits from that of a half-face on.
void VisiblePartFinder::toggle(std::size_t halfFace, std::uint32_t bits)
{
  if (bits != 0)
  {
    this->Entries[halfFace / BitsOfWord].fetch_xor(
      bits << (halfFace % BitsOfWord), std::memory_order_relaxed);
  }
}

VisiblePartFinder::Ends VisiblePartFinder::endsOfChunks() const
{
  Ends ends((this->Entries.size() + WordsOfChunk - 1) / WordsOfChunk);
  forPartsOf(ends.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        const std::size_t last = std::min((chunk + 1) * WordsOfChunk, this->Entries.size());
        for (std::size_t word = chunk * WordsOfChunk; word < last; ++word)
        {
          ends[chunk] += countOf(this->Entries[word].load(std::memory_order_relaxed));
        }
      }
    });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  return ends;
}

int VisiblePartFinder::outsideSign(const TetMesh& mesh, Id tet)
{
  const int sign = isOrientedByVolumes(mesh) ? volumeSign(mesh, tet) : 0;
  return sign != 0 ? sign : this->allSigns(mesh)[tet];
}

const std::vector<std::int8_t>& VisiblePartFinder::allSigns(const TetMesh& mesh)
{
  if (this->Signs.empty())
  {
    this->Signs = outsideSigns(mesh);
  }
  return this->Signs;
}

void VisiblePartFinder::findFaces(const TetMesh& mesh)
{
  if (!isOrientedByVolumes(mesh) || !this->makeFaces(mesh, true))
  {
    this->allSigns(mesh);
    this->makeFaces(mesh, false);
  }
  this->Part.Links.resize(this->Part.Faces.size());
  linkVisiblePart(mesh, this->Part);
  // A line in a random direction crosses cells and faces in proportion to their surfaces: each
  // cell has four faces and two crossings.
  this->Part.CellsOfGap = 4.0 * static_cast<double>(mesh.Tets.size() - this->Part.NumberOfTets) /
                          static_cast<double>(this->Part.Faces.size());
}

// The faces of all entries; those that were there before are copied. False if a tetrahedron is
// flat, so that its volume says nothing.
bool VisiblePartFinder::makeFaces(const TetMesh& mesh, bool byVolumes)
{
  const Faces& known = this->LastFaces;
  this->LastFaces.swap(this->Part.Faces);
  const Ends knownEnds = byVolumes == this->ByVolumes ? std::move(this->Chunks) : Ends();
  this->ByVolumes = byVolumes;
  this->Chunks = this->endsOfChunks();
  this->Part.Faces.resize(this->Chunks.back());
  std::atomic<bool> isFlat(false);
  forPartsOf(this->Chunks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      auto face = this->Part.Faces.begin() + beginOf(this->Chunks, begin);
      auto next = known.begin() + beginOf(knownEnds, begin);
      const auto last = known.begin() + beginOf(knownEnds, end);
      this->visitEntries(begin, end,
        [&](Id halfFace)
        {
          next = std::find_if(next, last, [&](const auto& of) { return of[3] >= halfFace; });
          if (next != last && (*next)[3] == halfFace)
          {
            *face++ = *next;
            return;
          }
          const int sign = byVolumes ? volumeSign(mesh, halfFace / 4) : this->Signs[halfFace / 4];
          if (sign == 0)
          {
            isFlat = true;
          }
          *face++ = outwardFace(mesh, halfFace, sign);
        });
    });
  return !isFlat;
}

// Call visit(halfFace) for the entries of some chunks.
template <typename Visit>
void VisiblePartFinder::visitEntries(std::size_t begin, std::size_t end, const Visit& visit) const
{
  const std::size_t last = std::min(end * WordsOfChunk, this->Entries.size());
  for (std::size_t word = begin * WordsOfChunk; word < last; ++word)
  {
    auto halfFace = static_cast<Id>(word * BitsOfWord);
    for (std::uint32_t bits = this->Entries[word].load(std::memory_order_relaxed); bits != 0;
         bits >>= 1, ++halfFace)
    {
      if ((bits & 1u) != 0)
      {
        visit(halfFace);
      }
    }
  }
}

} // namespace tetmarch
