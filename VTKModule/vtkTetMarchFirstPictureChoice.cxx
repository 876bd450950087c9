// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of an array, of transfer functions and of a unit distance.
#include "vtkTetMarchFirstPictureInternals.h"

#include "FirstPicture/ArrayChoice.h"
#include "FirstPicture/Exposure.h"
#include "FirstPicture/FirstFunctions.h"

#include <algorithm>
#include <array>
#include <optional>

namespace
{
// With fewer cells their points describe the distribution of values better.
constexpr std::size_t FewCells = 1000;
} // namespace

bool vtkTetMarchFirstPicture::ChooseArray()
{
  if (!this->CheckInput())
  {
    return false;
  }
  tetmarch::ArrayWish wish;
  wish.Name = this->ArrayName;
  if (this->ArrayAssociation != ANY)
  {
    wish.OfCells = this->ArrayAssociation == CELLS;
  }
  if (this->Component >= -1)
  {
    wish.Component = this->Component;
  }
  tetmarch::DrawnArray chosen;
  const std::string error = tetmarch::chooseArray(this->Found->Blocks, wish, chosen);
  this->Found->HasCrossings = false;
  this->Found->Chosen = error.empty() ? chosen : tetmarch::DrawnArray();
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

bool vtkTetMarchFirstPicture::CheckChosenArray()
{
  return this->CheckInput() && (this->Found->Chosen.Array || this->ChooseArray());
}

bool vtkTetMarchFirstPicture::FindCrossings()
{
  if (!this->CheckChosenArray())
  {
    return false;
  }
  Internals& found = *this->Found;
  if (!found.HasCrossings)
  {
    found.Crossings =
      tetmarch::findCrossings(found.Blocks, found.Chosen, found.Outline, found.Plane);
    found.HasCrossings = true;
  }
  return true;
}

bool vtkTetMarchFirstPicture::UsesStructuredLaw() const
{
  return this->OpacityLaw == OF_THE_DATA ? this->Found->Lattices : this->OpacityLaw == STRUCTURED;
}

bool vtkTetMarchFirstPicture::ChooseTransferFunctions()
{
  if (!this->FindCrossings())
  {
    return false;
  }
  Internals& found = *this->Found;
  std::optional<std::array<double, 2>> range;
  if (this->Range[0] < this->Range[1])
  {
    range = { { this->Range[0], this->Range[1] } };
  }
  std::vector<tetmarch::Sample> samples = tetmarch::takeSamples(found.Blocks, found.Chosen);
  if (samples.size() < FewCells)
  {
    samples = found.Crossings.samples();
  }
  const tetmarch::ValueStatistics statistics =
    tetmarch::computeStatistics(std::move(samples), range, found.Lattices);
  std::copy(statistics.Range.begin(), statistics.Range.end(), this->ChosenRange);
  this->Background = statistics.Background;
  tetmarch::makeFirstColors(statistics, found.Color);
  this->UnitDistance = tetmarch::exposeFirstOpacity(
    statistics, found.Crossings, { this->UsesStructuredLaw(), !found.Lattices }, found.Opacity);
  found.HasFunctions = true;
  return true;
}

bool vtkTetMarchFirstPicture::Choose()
{
  return this->ChooseArray() && this->ChooseTransferFunctions();
}

bool vtkTetMarchFirstPicture::ChooseUnitDistance(vtkPiecewiseFunction* opacity)
{
  if (!opacity)
  {
    vtkErrorMacro("There is no opacity function to choose a unit distance for.");
    return false;
  }
  if (!this->FindCrossings())
  {
    return false;
  }
  this->UnitDistance = tetmarch::exposedUnitDistance(
    this->Found->Crossings, tetmarch::extinctionOf(opacity, this->UsesStructuredLaw()));
  return true;
}
