// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShownFunctions.h"

#include "FunctionNodes.h"

#include "vtkCommand.h"

#include <vector>

namespace
{
constexpr int NumberOfSamples = 512; // more than the chart has pixels in a dock
}

namespace tetmarch
{

ShownFunctions::ShownFunctions()
{
  this->ShownColor->AddObserver(vtkCommand::ModifiedEvent, this, &ShownFunctions::TakeColors);
  this->ShownOpacity->AddObserver(vtkCommand::ModifiedEvent, this, &ShownFunctions::TakeOpacity);
}

ShownFunctions::~ShownFunctions()
{
  this->Observe(false);
  this->Busy = true; // the functions that were shown may be told of changes yet
  this->ShownColor->RemoveObservers(vtkCommand::ModifiedEvent);
  this->ShownOpacity->RemoveObservers(vtkCommand::ModifiedEvent);
}

void ShownFunctions::Observe(bool on)
{
  if (on)
  {
    // Before others, so that they find the chart up to date.
    this->ColorObserver =
      this->Color->AddObserver(vtkCommand::ModifiedEvent, this, &ShownFunctions::ShowColors, 1.0f);
    this->OpacityObserver = this->Opacity->AddObserver(
      vtkCommand::ModifiedEvent, this, &ShownFunctions::ShowOpacity, 1.0f);
  }
  else if (this->Color)
  {
    this->Color->RemoveObserver(this->ColorObserver);
    this->Opacity->RemoveObserver(this->OpacityObserver);
  }
}

void ShownFunctions::SetFunctions(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  this->Observe(false);
  this->Color = color;
  this->Opacity = opacity;
  this->Observe(true);
  this->ShowAll();
}

void ShownFunctions::SetAxis(double low, double high)
{
  if (low != this->Low || high != this->High)
  {
    this->Low = low;
    this->High = high;
    this->ShowAll();
  }
}

void ShownFunctions::ShowAll()
{
  this->ShowColors();
  this->ShowOpacity();
}

void ShownFunctions::ShowOpacity()
{
  if (this->Busy || !this->Opacity)
  {
    return;
  }
  this->Busy = true;
  this->ShownOpacity->SetAllowDuplicateScalars(this->Opacity->GetAllowDuplicateScalars());
  auto nodes = GetNodes(this->Opacity.Get());
  for (auto& node : nodes)
  {
    node[0] = this->ToAxis(node[0]);
  }
  SetNodes(this->ShownOpacity.Get(), nodes);
  this->Busy = false;
}

void ShownFunctions::ShowColors()
{
  if (this->Busy || !this->Color)
  {
    return;
  }
  this->Busy = true;
  this->ShownColor->SetAllowDuplicateScalars(this->Color->GetAllowDuplicateScalars());
  this->ShownColor->SetColorSpace(this->Color->GetColorSpace());
  auto nodes = GetNodes(this->Color.Get());
  for (auto& node : nodes)
  {
    node[0] = this->ToAxis(node[0]);
  }
  SetNodes(this->ShownColor.Get(), nodes);
  this->SampleColors();
  this->Busy = false;
}

void ShownFunctions::TakeOpacity()
{
  if (this->Busy || !this->Opacity)
  {
    return;
  }
  this->Busy = true;
  const auto old = GetNodes(this->Opacity.Get());
  auto nodes = GetNodes(this->ShownOpacity.Get());
  for (auto& node : nodes)
  {
    const auto* const same =
      FindNode(old, node[0], [this](double value) { return this->ToAxis(value); });
    node[0] = same ? (*same)[0] : this->FromAxis(node[0]);
  }
  SetNodes(this->Opacity.Get(), nodes);
  this->Busy = false;
  if (this->Opacity->GetSize() != this->ShownOpacity->GetSize())
  {
    this->ShowOpacity(); // of two points at one value, the function has kept one
  }
}

void ShownFunctions::TakeColors()
{
  if (this->Busy || !this->Color)
  {
    return;
  }
  this->Busy = true;
  const auto old = GetNodes(this->Color.Get());
  auto nodes = GetNodes(this->ShownColor.Get());
  const bool isMore = nodes.size() > old.size();
  for (auto& node : nodes)
  {
    const auto* const same =
      FindNode(old, node[0], [this](double value) { return this->ToAxis(value); });
    node[0] = same ? (*same)[0] : this->FromAxis(node[0]);
    if (!same && isMore && !old.empty())
    {
      // A new point has the colour that was there: by a logarithmic scale, too.
      this->Color->GetColor(node[0], &node[1]);
    }
  }
  SetNodes(this->Color.Get(), nodes);
  this->SampleColors();
  this->Busy = false;
  if (this->Color->GetSize() != this->ShownColor->GetSize())
  {
    this->ShowColors(); // of two points at one value, the function has kept one
  }
}

void ShownFunctions::SampleColors()
{
  this->Samples->RemoveAllPoints();
  const int count = this->Color->GetSize();
  if (count == 0)
  {
    return;
  }
  const double low = this->Color->GetRange()[0];
  const double high = this->Color->GetRange()[1];
  if (!(low < high))
  {
    double rgb[3];
    this->Color->GetColor(low, rgb);
    this->Samples->AddRGBPoint(this->ToAxis(low), rgb[0], rgb[1], rgb[2]);
    return;
  }
  std::vector<double> table(3 * NumberOfSamples);
  for (int i = 0; i < NumberOfSamples; ++i)
  {
    // Not GetTable(): by a logarithmic scale, its entries are no even steps of the value.
    this->Color->GetColor(low + (high - low) * i / (NumberOfSamples - 1), &table[3 * i]);
  }
  this->Samples->BuildFunctionFromTable(
    this->ToAxis(low), this->ToAxis(high), NumberOfSamples, table.data());
}

} // namespace tetmarch
