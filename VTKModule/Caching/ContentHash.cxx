// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Caching/ContentHash.h"

#include "Parallel/ParallelFor.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace tetmarch
{
namespace
{

// Odd, with bits that look random: the primes of XXH64 (Collet, xxhash.com).
constexpr std::uint64_t Primes[] = { 0x9e3779b185ebca87u, 0xc2b2ae3d27d4eb4fu, 0x165667b19e3779f9u,
  0x85ebca77c2b2ae63u, 0x27d4eb2f165667c5u };

// Maximum number of pieces of an array and minimum number of stripes per piece. The pieces depend
// on the size of the array only.
constexpr std::size_t MostPieces = 256;
constexpr std::size_t LeastStripes = 2048;

// Four words, each of which goes into a lane of both hashes, so that a processor has eight
// multiplications in flight.
constexpr std::size_t StripeWords = 4;
using Stripe = std::array<std::uint64_t, StripeWords>;

std::uint64_t rotated(std::uint64_t x, int by) { return x << by | x >> (64 - by); }

// Each bit of the result depends on all of the argument.
std::uint64_t mixed(std::uint64_t x)
{
  x = (x ^ x >> 33) * Primes[1];
  x = (x ^ x >> 29) * Primes[2];
  return x ^ x >> 32;
}

class Hasher
{
public:
  // Bijective in the stripe and in the state, so that a single difference is never lost.
  void add(const Stripe& stripe)
  {
    for (std::size_t i = 0; i < StripeWords; ++i)
    {
      this->First[i] = rotated(this->First[i] ^ stripe[i], 27) * Primes[0];
      this->Second[i] = rotated(this->Second[i] ^ stripe[i], 38) * Primes[1];
    }
  }

  ContentHash finish() const { return { { merged(this->First), merged(this->Second) } }; }

private:
  static std::uint64_t merged(const Stripe& lanes)
  {
    std::uint64_t hash = Primes[4];
    for (const std::uint64_t lane : lanes)
    {
      hash = rotated(hash ^ mixed(lane), 27) * Primes[0] + Primes[3];
    }
    return mixed(hash);
  }

  Stripe First{ { Primes[0], Primes[1], Primes[2], Primes[3] } };
  Stripe Second{ { Primes[4], Primes[3], Primes[2], Primes[1] } };
};

// The bits of values in contiguous memory.
class Memory
{
public:
  explicit Memory(vtkDataArray* array)
    : Bytes(static_cast<const char*>(array->GetVoidPointer(0)))
    , Size(static_cast<std::size_t>(array->GetNumberOfValues()) *
           static_cast<std::size_t>(array->GetDataTypeSize()))
  {
  }
  std::size_t size() const { return this->Size; }
  void read(std::size_t from, std::size_t size, Stripe& stripe) const
  {
    std::memcpy(stripe.data(), this->Bytes + from, size);
  }

private:
  const char* Bytes;
  std::size_t Size;
};

// Values that are not in contiguous memory, or are computed, as doubles.
class Values
{
public:
  explicit Values(vtkDataArray* array)
    : Array(array)
    , Components(static_cast<std::size_t>(array->GetNumberOfComponents()))
  {
  }
  std::size_t size() const
  {
    return sizeof(double) * static_cast<std::size_t>(this->Array->GetNumberOfValues());
  }
  void read(std::size_t from, std::size_t size, Stripe& stripe) const
  {
    for (std::size_t i = 0; i < size / sizeof(double); ++i)
    {
      const std::size_t value = from / sizeof(double) + i;
      const double x = this->Array->GetComponent(static_cast<vtkIdType>(value / this->Components),
        static_cast<int>(value % this->Components));
      std::memcpy(&stripe[i], &x, sizeof(x));
    }
  }

private:
  vtkDataArray* Array;
  std::size_t Components;
};

template <typename Source>
ContentHash hashOf(const Source& source, Hasher hasher)
{
  const std::size_t stripes = (source.size() + sizeof(Stripe) - 1) / sizeof(Stripe);
  const std::size_t perPiece = std::max(LeastStripes, (stripes + MostPieces - 1) / MostPieces);
  const std::size_t pieces = (stripes + perPiece - 1) / perPiece;
  std::array<ContentHash, MostPieces> hashes;
  parallelFor(0, static_cast<vtkIdType>(pieces), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto piece = static_cast<std::size_t>(first); piece < static_cast<std::size_t>(last);
           ++piece)
      {
        Hasher ofPiece;
        std::size_t at = piece * perPiece * sizeof(Stripe);
        const std::size_t end = std::min(at + perPiece * sizeof(Stripe), source.size());
        Stripe stripe{};
        for (; at + sizeof(Stripe) <= end; at += sizeof(Stripe))
        {
          source.read(at, sizeof(Stripe), stripe);
          ofPiece.add(stripe);
        }
        if (at < end)
        {
          stripe = {};
          source.read(at, end - at, stripe);
          ofPiece.add(stripe);
        }
        hashes[piece] = ofPiece.finish();
      }
    });
  for (std::size_t piece = 0; piece < pieces; ++piece)
  {
    hasher.add({ { hashes[piece][0], hashes[piece][1], 0, 0 } });
  }
  return hasher.finish();
}

} // namespace

ContentHash contentHashOf(vtkDataArray* array)
{
  if (!array)
  {
    return {};
  }
  const bool lies = array->HasStandardMemoryLayout() && array->GetDataTypeSize() > 0;
  Hasher hasher;
  hasher.add({ { static_cast<std::uint64_t>(array->GetDataType()),
    static_cast<std::uint64_t>(array->GetNumberOfTuples()),
    static_cast<std::uint64_t>(array->GetNumberOfComponents()), lies ? 1u : 0u } });
  return lies ? hashOf(Memory(array), hasher) : hashOf(Values(array), hasher);
}

} // namespace tetmarch
