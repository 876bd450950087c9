// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridDamage.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tetmarch::testing
{
namespace
{
template <typename T>
void damage(ByteReader& reader, std::vector<T>& values)
{
  const int how = reader.byte() % 3;
  const int where = reader.word();
  const vtkIdType value = reader.id();
  if (how == 0)
  {
    values.resize(std::min<std::size_t>(where, values.size()));
  }
  else if (how == 1)
  {
    values.push_back(static_cast<T>(value));
  }
  else if (!values.empty())
  {
    values[where % values.size()] = static_cast<T>(value);
  }
}

void damage(ByteReader& reader, const std::vector<Ids*>& arrays)
{
  damage(reader, *arrays[arrays.size() > 1 ? reader.byte() % arrays.size() : 0]);
}
} // namespace

void damage(ByteReader& reader, RawGrid& raw)
{
  for (int count = reader.byte() % 8; count > 0; --count)
  {
    switch (reader.byte() % 6)
    {
      case 0:
        damage(reader, raw.Offsets);
        break;
      case 1:
        damage(reader, raw.Connectivity);
        break;
      case 2:
        damage(reader, raw.Types);
        break;
      case 3:
        damage(reader, raw.Faces.locationArrays());
        break;
      case 4:
        damage(reader, raw.Faces.faceArrays());
        break;
      default:
        raw.HasFaces = !raw.HasFaces;
    }
  }
}
} // namespace tetmarch::testing
