// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TetVolume.h"

#include "Appearance/Components.h"
#include "Caching/WithinMemory.h"
#include "Mesh/Gradients.h"
#include "Mesh/VertexStarts.h"
#include "Reference/ReferenceImage.h"
#include "Variants/VariantKey.h"
#include "Volume/TransparentShare.h"

#include "vtkPointSet.h"

namespace tetmarch
{

std::string TetVolume::updateGeometry(
  const VolumeInput& input, const ResourceLimits& limits, const Progress& progress)
{
  auto* grid = vtkPointSet::SafeDownCast(input.Data);
  this->Limits = limits;
  PieceOptions piece = input.Piece;
  piece.SeparatePoints = this->SeparatePoints;
  piece.SeparateSides = !this->SidesApart.empty();
  if (!this->Meshed.isCurrent(grid, piece))
  {
    this->ScalarsInput.clear();
    this->RangesInput.clear();
    const std::string error = this->Meshed.make(grid, limits, progress, piece);
    if (!error.empty())
    {
      return error;
    }
  }
  return withinMemory(
    "the hidden cells", [&] { this->Hidden.update(grid, this->mesh(), this->meshRecord().Runs); });
}

std::vector<FiniteRange> TetVolume::rangesOf(vtkDataSet* grid, const DrawnScalars& drawn)
{
  const Fingerprint input = versionOf(drawn);
  if (input != this->RangesInput)
  {
    this->RangesInput.clear();
    this->Ranges = tetmarch::rangesOf(vtkPointSet::SafeDownCast(grid), drawn, this->mesh());
    this->RangesInput = input;
  }
  return this->Ranges;
}

std::string TetVolume::updateScalars(const VolumeInput& input, const DrawnScalars& drawn)
{
  const bool wereApart = !this->SidesApart.empty() && this->SidesApart != versionOf(drawn);
  if (wereApart)
  {
    this->SidesApart.clear();
  }
  std::string error =
    wereApart ? this->prepareAgain(input, drawn) : this->readScalars(input, drawn);
  if (error.empty() && this->Scalars.Jump && this->mesh().Curvilinear)
  {
    this->SidesApart = versionOf(drawn);
    error = this->prepareAgain(input, drawn);
    this->SidesApart = error.empty() ? this->SidesApart : Fingerprint();
  }
  const bool separate =
    this->Scalars.Jump && (!input.TakesCorners || this->Scalars.Extra.count() > 0);
  if (error.empty() && separate != this->SeparatePoints)
  {
    this->SeparatePoints = separate;
    error = this->prepareAgain(input, drawn);
    this->SeparatePoints = separate && error.empty(); // else another array would not be tried
  }
  return error;
}

std::string TetVolume::prepareAgain(const VolumeInput& input, const DrawnScalars& drawn)
{
  const std::string error = this->updateGeometry(input, this->Limits, {});
  return error.empty() ? this->readScalars(input, drawn) : error;
}

std::string TetVolume::readScalars(const VolumeInput& input, const DrawnScalars& drawn)
{
  const Fingerprint version = versionOf(drawn);
  if (version == this->ScalarsInput)
  {
    return {};
  }
  this->ScalarsInput.clear();
  const std::string shortage = withinMemory("the scalars",
    [&]
    {
      const StageRecorder recorder(this->ScalarsRecord);
      this->Scalars = {};
      this->Scalars =
        tetmarch::readScalars(vtkPointSet::SafeDownCast(input.Data), drawn, this->Meshed.mesh());
    });
  if (shortage.empty())
  {
    this->ScalarsInput = version;
    this->ScalarsVersion = { static_cast<std::uintptr_t>(this->meshRecord().Runs),
      static_cast<std::uintptr_t>(this->ScalarsRecord.Runs) };
  }
  return shortage;
}

std::string TetVolume::updateVisibility(
  const IntegralTable& first, const Components& parts, const Blending& blending, bool undrawnSeen)
{
  const VisibleScalars shown{ &this->Scalars, &first, &blending, &this->hiddenCells(),
    undrawnSeen };
  // Extremes and sums need all cells on a ray. Surfaces between constant cells are in no cell.
  const bool isKnown =
    !parts.isIndependent() &&
    (blending.isComposite() || (blending.isIsoSurface() && this->Scalars.OfCells.empty()));
  std::string shortage = withinMemory("what is visible",
    [&]
    {
      if (isKnown && this->Visible.isCurrent(shown, this->version()))
      {
        return;
      }
      const StageRecorder recorder(this->VisibleRecord);
      if (isKnown)
      {
        this->Visible.update(this->mesh(), shown, this->version());
      }
      else
      {
        this->Visible.clear();
      }
    });
  if (!shortage.empty())
  {
    this->Visible.clear();
  }
  this->EntersVisible.update(
    isWorthEntering(this->visiblePart()), staysWorthEntering(this->visiblePart()), this->version());
  return shortage;
}

std::string TetVolume::prepareEntrySearch()
{
  if (this->mesh().hasHierarchy())
  {
    return {};
  }
  std::string error;
  const std::string shortage = withinMemory("the hierarchy of the boundary",
    [&]
    {
      error = this->Meshed.addHierarchy();
      if (error.empty())
      {
        this->Visible.link(this->mesh());
      }
    });
  return shortage.empty() ? error : shortage;
}

std::string TetVolume::updateEye(const Vector3* eye)
{
  if (!eye)
  {
    this->EyeStarts.leave();
    return {};
  }
  const std::string shortage = withinMemory("where rays from the camera in the mesh begin",
    [&]
    {
      const auto signOf = [this](Id tet) { return this->Visible.outsideSign(this->mesh(), tet); };
      const bool visible = this->entersVisiblePart();
      this->EyeStarts.update(this->mesh(), visible ? &this->visiblePart() : nullptr,
        visible ? this->visibleVersion() : this->linksVersion(), *eye, signOf);
    });
  if (!shortage.empty())
  {
    this->EyeStarts.leave();
  }
  return shortage;
}

double TetVolume::transparentShare(const IntegralTable& table) const
{
  return tetmarch::transparentShare(
    this->mesh(), this->Scalars.OfCells, this->Scalars.Range, table);
}

bool TetVolume::entersVisiblePart() const
{
  return this->EntersVisible.isOn() &&
         this->visiblePart().Faces.size() + MostEyeFaces <= this->Limits.TexelsPerBuffer;
}

// Else, also if its faces are too many for a buffer, rays search their entries.
bool TetVolume::startsAtEye() const
{
  return this->EyeStarts.isFound() &&
         this->enteredPart().Faces.size() + MostEyeFaces <= this->Limits.TexelsPerBuffer;
}

void TetVolume::setBits(VariantKey& key) const
{
  key.PointScalars = this->Scalars.OfCells.empty();
  key.CornerScalars = !this->Scalars.OfCorners.empty();
  key.Curvilinear = this->mesh().Curvilinear != nullptr;
  key.JoinedSides = key.Curvilinear && this->mesh().Curvilinear->joins().any();
  key.Hierarchy = this->mayReenter();
  key.Reentered = this->mayReenter();
  key.HiddenCells = !this->hiddenCells().empty();
  key.VisiblePart = this->entersPart();
}

void TetVolume::addTo(ReferenceScene& scene) const
{
  scene.Mesh = &this->mesh();
  scene.CellScalars = this->Scalars.OfCells.empty() ? nullptr : &this->Scalars.OfCells;
  scene.CornerScalars = this->Scalars.OfCorners.empty() ? nullptr : &this->Scalars.OfCorners;
  scene.Extra = &this->Scalars.Extra;
  scene.Range = this->Scalars.Range;
  scene.Hidden = &this->hiddenCells();
}

std::vector<std::array<float, 3>> TetVolume::gradients(bool ofCells, Group* processes) const
{
  const std::vector<float>& cellScalars = this->Scalars.OfCells;
  return ofCells               ? cellGradients(this->mesh(), this->Scalars.OfCorners)
         : cellScalars.empty() ? vertexGradients(this->mesh(), processes)
                               : vertexGradients(this->mesh(), cellScalars, processes);
}

std::vector<std::array<float, 3>> TetVolume::componentGradients(Group* processes) const
{
  const ExtraScalars& extra = this->Scalars.Extra;
  return tetmarch::componentGradients(
    this->mesh(), this->Scalars.OfCells, extra.Values, extra.count(), processes);
}

std::vector<EffectSource::VertexStart> TetVolume::vertexStarts() const
{
  return tetmarch::vertexStarts(this->mesh());
}

bool TetVolume::startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const
{
  return tetmarch::startPoint(this->mesh(), vertex, start, point);
}

Fingerprint TetVolume::version() const
{
  Fingerprint version = this->ScalarsVersion;
  add(version, this->hiddenVersion());
  return version;
}

Fingerprint TetVolume::geometryVersion() const { return { this->ScalarsVersion.front() }; }

// The hierarchy renumbers boundary faces.
Fingerprint TetVolume::startsVersion() const
{
  return { this->ScalarsVersion.front(), this->mesh().hasHierarchy() ? std::uintptr_t(1) : 0 };
}

Fingerprint TetVolume::visibleVersion() const
{
  Fingerprint version = this->linksVersion();
  version.push_back(static_cast<std::uintptr_t>(this->VisibleRecord.Runs));
  return version;
}

Fingerprint TetVolume::enteredVersion() const
{
  const bool isAll = !this->entersVisiblePart() && this->startsAtEye();
  // The boundary may have been reordered since.
  Fingerprint version = isAll ? this->EyeStarts.wholeVersion() : this->visibleVersion();
  version.push_back(this->startsAtEye() ? 1 : 0);
  return version;
}

Fingerprint TetVolume::linksVersion() const
{
  return { static_cast<std::uintptr_t>(this->meshRecord().Runs),
    this->mesh().hasHierarchy() ? std::uintptr_t(1) : 0 };
}

} // namespace tetmarch
