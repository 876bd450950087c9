// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume that rays march through. The stages of a frame know it by this alone, so that another
// kind of volume is another class that fills it.
#ifndef TetMarchVolumeMarchedVolume_h
#define TetMarchVolumeMarchedVolume_h

#include "Budget/ResourceLimits.h"
#include "Entries/Outlines.h"
#include "Light/EffectSource.h"
#include "Mesh/PieceOptions.h"
#include "Parallel/Progress.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/LatticeBuilder.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

struct Blending;
struct Components;
struct IntegralTable;
struct LeafPlaces;
struct ReferenceScene;

/** A data set of the type that the volume takes, and how it is read. */
struct VolumeInput
{
  vtkDataSet* Data = nullptr;
  PieceOptions Piece{};                           // of a mesh
  Interpolation Between = Interpolation::Nearest; // of the values of a lattice
  /** Not null: the cells of the data are these leaves (Leaves/LeafGrid.h). */
  std::shared_ptr<const LeafPlaces> Leaves = nullptr;
  /** Scalars of a mesh may jump between its cells; else points with different scalars are separate.
   */
  bool TakesCorners = false;
};

class MarchedVolume : public EffectSource
{
public:
  // The stages of a frame. Each returns an empty string, or what is wrong and what to do, and does
  // nothing if its input is the same as before.

  virtual std::string updateGeometry(
    const VolumeInput& input, const ResourceLimits& limits, const Progress& progress) = 0;
  virtual std::string updateScalars(const VolumeInput& input, const DrawnScalars& drawn) = 0;
  /** The part of the volume that can be seen by these functions; undrawnSeen: also scalars that are
   * not finite. Call it when any of them, or version(), has changed. */
  virtual std::string updateVisibility(const IntegralTable& first, const Components& parts,
    const Blending& blending, bool undrawnSeen) = 0;
  /** What rays need to find where they enter if there are no lists of entries. */
  virtual std::string prepareEntrySearch() = 0;
  /** Rays begin at the eye, a point of the normalised frame, and not before the volume; null:
   * before it. It comes last of the stages. */
  virtual std::string updateEye(const Vector3* /*eye*/) { return {}; }

  /** Nothing can be marched through: the data has no such cells, or progress asked to stop. */
  virtual bool isEmpty() const = 0;
  /** A ghost array hides every cell. */
  virtual bool isHidden() const = 0;
  /** By updateVisibility() nothing of the volume can be seen. False where that is not known. */
  virtual bool showsNothing() const = 0;
  /** An image or a rectilinear grid, in whose cells the scalar bends along a ray. */
  virtual bool isStructured() const = 0;
  /** It may be sampled at even distances. */
  virtual bool takesSamples() const { return false; }
  /** There are lists of entries for rays from the eye of updateEye(), by the visible part. */
  virtual bool startsAtEye() const { return false; }
  /** A ray may leave the volume and enter it again. */
  virtual bool mayReenter() const = 0;
  /** The ranges of the scalars that are drawn with the first one. */
  virtual const std::vector<ScalarRange>& extraRanges() const = 0;
  /** The share 0..1 of the volume whose scalars lie in the table's transparent ranges. */
  virtual double transparentShare(const IntegralTable& table) const = 0;
  /** The input cell that contains the point of the normalised frame, given the shader's cell index.
   */
  virtual vtkIdType cellOf(std::uint32_t marched, const Vector3& point) const = 0;

  /** The least width of a detail of the scalars, in the normalised frame; 0: any. */
  virtual double leastDetail() const = 0;
  /** The edges of its boundary, where an outline may be seen. */
  virtual std::vector<OutlineEdge> outlineEdges() const = 0;

  /** Set the bits of the key that say what rays march through. */
  virtual void setBits(VariantKey& key) const = 0;
  /** Equal as long as geometry, scalars and hidden cells are the same. The first word is that of
   * the geometry. */
  virtual Fingerprint version() const = 0;
  /** How often any of the stages has run. */
  virtual std::int64_t runs() const = 0;
  /** Add the volume to a scene of the CPU reference. */
  virtual void addTo(ReferenceScene& scene) const = 0;
};

} // namespace tetmarch

#endif
