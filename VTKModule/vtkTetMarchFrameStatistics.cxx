// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchFrameStatistics.h"

#include "Diagnostics/Distribution.h"
#include "Optics/AccuracyLevel.h"

#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"

#include <array>

namespace
{
constexpr std::array<const char*, 4> Names = { { "ErrorBound", "Cells", "Lookups", "TrueError" } };
}

class vtkTetMarchFrameStatistics::Internals
{
public:
  std::array<tetmarch::Distribution, Names.size()> Quantities;
  const tetmarch::Distribution None;

  const tetmarch::Distribution& operator[](int quantity) const
  {
    return quantity < 0 || quantity >= static_cast<int>(Names.size()) ? this->None
                                                                      : this->Quantities[quantity];
  }
};

vtkStandardNewMacro(vtkTetMarchFrameStatistics);

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics::vtkTetMarchFrameStatistics()
  : UsedAccuracyLevel(static_cast<int>(tetmarch::Accuracy::Default))
  , Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics::~vtkTetMarchFrameStatistics() = default;

//------------------------------------------------------------------------------
vtkIdType vtkTetMarchFrameStatistics::GetNumberOfPixels(int quantity) const
{
  return static_cast<vtkIdType>((*this->Internal)[quantity].size());
}
double vtkTetMarchFrameStatistics::GetMinimum(int quantity) const
{
  return (*this->Internal)[quantity].minimum();
}
double vtkTetMarchFrameStatistics::GetMean(int quantity) const
{
  return (*this->Internal)[quantity].mean();
}
double vtkTetMarchFrameStatistics::GetRootMeanSquare(int quantity) const
{
  return (*this->Internal)[quantity].rootMeanSquare();
}
double vtkTetMarchFrameStatistics::GetMaximum(int quantity) const
{
  return (*this->Internal)[quantity].maximum();
}
double vtkTetMarchFrameStatistics::GetPercentile(int quantity, double percent) const
{
  return (*this->Internal)[quantity].percentile(percent);
}

//------------------------------------------------------------------------------
void vtkTetMarchFrameStatistics::SetValues(int quantity, vtkFloatArray* values)
{
  if (quantity < 0 || quantity >= static_cast<int>(Names.size()))
  {
    vtkErrorMacro("There is no quantity " << quantity << "; it must be one of QuantityType.");
    return;
  }
  std::vector<float> present;
  for (vtkIdType i = 0; values && i < values->GetNumberOfValues(); ++i)
  {
    if (values->GetValue(i) >= 0.0f)
    {
      present.push_back(values->GetValue(i));
    }
  }
  this->Internal->Quantities[quantity] = tetmarch::Distribution(std::move(present));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTetMarchFrameStatistics::Clear()
{
  this->Internal->Quantities = {};
  this->Seconds = 0.0;
  this->Modified();
}

//------------------------------------------------------------------------------
const char* vtkTetMarchFrameStatistics::GetUsedAccuracyLevelAsString() const
{
  constexpr const char* names[] = { "Fast", "Default", "Accurate", "Reference", "Sampled" };
  return names[this->UsedAccuracyLevel];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchFrameStatistics::GetUsedShaderStageAsString() const
{
  return this->UsedShaderStage == 2 ? "Compute" : "Fragment";
}

//------------------------------------------------------------------------------
void vtkTetMarchFrameStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (int i = 0; i < static_cast<int>(Names.size()); ++i)
  {
    os << indent << Names[i] << ": " << this->GetNumberOfPixels(i) << " pixels, mean "
       << this->GetMean(i) << ", maximum " << this->GetMaximum(i) << "\n";
  }
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "NumberOfCrossedCells: " << this->NumberOfCrossedCells << "\n";
  os << indent << "NumberOfLookups: " << this->NumberOfLookups << "\n";
  os << indent << "NumberOfRefusedEntries: " << this->NumberOfRefusedEntries << "\n";
  os << indent << "NumberOfLostRays: " << this->NumberOfLostRays << "\n";
  os << indent << "NumberOfGuardHits: " << this->NumberOfGuardHits << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
  os << indent << "NumberOfDraws: " << this->NumberOfDraws << "\n";
  os << indent << "UsedAccuracyLevel: " << this->GetUsedAccuracyLevelAsString() << "\n";
  os << indent << "UsedErrorTolerance: " << this->UsedErrorTolerance << "\n";
  os << indent << "UsedShaderStage: " << this->GetUsedShaderStageAsString() << "\n";
  os << indent << "UsedImageSampleDistance: " << this->UsedImageSampleDistance << "\n";
  os << indent << "BudgetKept: " << (this->BudgetKept ? "Yes" : "No") << "\n";
  os << indent << "LightComplete: " << (this->LightComplete ? "Yes" : "No") << "\n";
  os << indent << "NumberOfTetrahedra: " << this->NumberOfTetrahedra << "\n";
  os << indent << "NumberOfBoundaryFaces: " << this->NumberOfBoundaryFaces << "\n";
  os << indent << "NumberOfLatticeCells: " << this->NumberOfLatticeCells << "\n";
  os << indent << "GPUMemoryBytes: " << this->GPUMemoryBytes << "\n";
  os << indent << "UploadedBytes: " << this->UploadedBytes << "\n";
  os << indent << "BlocksSeconds: " << this->BlocksSeconds << "\n";
  os << indent << "MeshSeconds: " << this->MeshSeconds << "\n";
  os << indent << "ScalarsSeconds: " << this->ScalarsSeconds << "\n";
  os << indent << "TablesSeconds: " << this->TablesSeconds << "\n";
  os << indent << "VisiblePartSeconds: " << this->VisiblePartSeconds << "\n";
  os << indent << "EntriesSeconds: " << this->EntriesSeconds << "\n";
  os << indent << "GradientsSeconds: " << this->GradientsSeconds << "\n";
  os << indent << "OpaqueShadowsSeconds: " << this->OpaqueShadowsSeconds << "\n";
  os << indent << "VertexLightSeconds: " << this->VertexLightSeconds << "\n";
  os << indent << "UploadSeconds: " << this->UploadSeconds << "\n";
  os << indent << "NumberOfVisits: " << this->NumberOfVisits << "\n";
  os << indent << "SentBytes: " << this->SentBytes << "\n";
  os << indent << "MarchSeconds: " << this->MarchSeconds << "\n";
  os << indent << "ExchangeSeconds: " << this->ExchangeSeconds << "\n";
  os << indent << "MergeSeconds: " << this->MergeSeconds << "\n";
  os << indent << "SpreadSeconds: " << this->SpreadSeconds << "\n";
  os << indent << "SharedErrorBound: " << this->SharedErrorBound << "\n";
  os << indent << "BlocksBuilds: " << this->BlocksBuilds << "\n";
  os << indent << "MeshBuilds: " << this->MeshBuilds << "\n";
  os << indent << "ScalarsBuilds: " << this->ScalarsBuilds << "\n";
  os << indent << "TablesBuilds: " << this->TablesBuilds << "\n";
  os << indent << "VisiblePartBuilds: " << this->VisiblePartBuilds << "\n";
  os << indent << "EntriesBuilds: " << this->EntriesBuilds << "\n";
  os << indent << "GradientsBuilds: " << this->GradientsBuilds << "\n";
  os << indent << "OpaqueShadowsBuilds: " << this->OpaqueShadowsBuilds << "\n";
  os << indent << "VertexLightBuilds: " << this->VertexLightBuilds << "\n";
}
