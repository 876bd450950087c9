// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TetEffectSource.h"

#include "Mesh/Gradients.h"
#include "Mesh/VertexStarts.h"

namespace tetmarch
{

std::vector<std::array<float, 3>> TetEffectSource::gradients(bool ofCells) const
{
  return ofCells                     ? cellGradients(this->Mesh)
         : this->CellScalars.empty() ? vertexGradients(this->Mesh)
                                     : vertexGradients(this->Mesh, this->CellScalars);
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
