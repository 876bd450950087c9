// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchFrameStatistics.h"

#include "Diagnostics/Distribution.h"

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
  : Internal(new Internals)
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
#include "Mapper/PrintedStatistics.inc"
}
