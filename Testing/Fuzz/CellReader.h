// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cells of all types, as bytes describe them
 */
#ifndef tetmarch_testing_CellReader_h
#define tetmarch_testing_CellReader_h

#include "Input/CellKind.h"

#include "ByteReader.h"
#include "CellTypeCode.h"
#include "RawGrid.h"

#include <algorithm>
#include <vector>

namespace tetmarch::testing
{
/// Appends the cells that the bytes describe to the arrays of a grid.
class CellReader
{
public:
  CellReader(ByteReader& reader, RawGrid& raw)
    : In(reader)
    , Raw(raw)
    , NumberOfPoints(std::max(static_cast<int>(raw.Points.size() / 3), 1))
  {
  }

  void read()
  {
    this->Raw.Offsets = { 0 };
    for (int cells = this->In.byte(); cells > 0 && !this->In.isAtEnd(); --cells)
    {
      const int type = typeOfCode(this->In.byte());
      this->Raw.Types.push_back(static_cast<unsigned char>(type));
      if (type == VTK_POLYHEDRON)
      {
        this->readPolyhedron();
      }
      else
      {
        this->Raw.Faces.addNone();
        this->readPoints(type);
      }
      this->Raw.Offsets.push_back(static_cast<vtkIdType>(this->Raw.Connectivity.size()));
    }
  }

private:
  vtkIdType point() { return this->In.byte() % this->NumberOfPoints; }

  void readPoints(int type)
  {
    const CellKind& kind = cellKinds()[type];
    const bool fixed = kind.LeastPoints == kind.MostPoints;
    const vtkIdType count = fixed ? kind.LeastPoints : this->In.byte() % 65;
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Raw.Connectivity.push_back(this->point());
    }
  }

  void readPolyhedron()
  {
    this->Raw.HasFaces = true;
    Ids all;
    std::vector<Ids> faces(this->In.byte() % 32);
    for (Ids& face : faces)
    {
      face.resize(this->In.byte() % 16);
      for (vtkIdType& point : face)
      {
        point = this->point();
        all.push_back(point);
      }
    }
    this->Raw.Faces.add(faces);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    this->Raw.Connectivity.insert(this->Raw.Connectivity.end(), all.begin(), all.end());
  }

  ByteReader& In;
  RawGrid& Raw;
  int NumberOfPoints;
};
} // namespace tetmarch::testing

#endif
