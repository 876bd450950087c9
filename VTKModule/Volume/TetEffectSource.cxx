// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TetEffectSource.h"

#include "Mesh/Gradients.h"
#include "Mesh/VertexStarts.h"
#include "Processes/Group.h"

namespace tetmarch
{

std::vector<std::array<float, 3>> TetEffectSource::gradients(bool ofCells) const
{
  return ofCells ? cellGradients(this->Mesh)
         : this->CellScalars.empty()
           ? vertexGradients(this->Mesh, this->Processes)
           : vertexGradients(this->Mesh, this->CellScalars, this->Processes);
}

double TetEffectSource::steepestOf(double own) const
{
  std::vector<float> least{ static_cast<float>(-own) };
  if (this->Processes)
  {
    this->Processes->keepLeast(least);
    return -double(least.front());
  }
  return own;
}

std::vector<EffectSource::VertexStart> TetEffectSource::vertexStarts() const
{
  return tetmarch::vertexStarts(this->Mesh);
}

bool TetEffectSource::startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const
{
  return tetmarch::startPoint(this->Mesh, vertex, start, point);
}

} // namespace tetmarch
