// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays march through. Pipeline and its passes know a volume by this alone, so that another
// kind of volume, such as a structured grid, is another class that fills it.
#ifndef TetMarchGLMarchSource_h
#define TetMarchGLMarchSource_h

#include "Budget/ResourceLimits.h"
#include "Caching/Fingerprint.h"
#include "GL/Viewport.h"
#include "Light/EffectSource.h"
#include "Mesh/PieceOptions.h"
#include "Mesh/Progress.h"
#include "Reference/RayTrace.h"
#include "Reference/ReferenceImage.h"
#include "Scalars/DrawnScalars.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace tetmarch
{

class Group;

/** From this transparent share on, a separate loop for cells in which nothing is seen is worth its
 * cost: rays in lockstep wait for each other at its end. */
constexpr double LeastShareToPass = 0.5;
/** Down to this share it costs little. */
constexpr double LeastShareToKeepPassing = 0.25;

/** The entry points of shaders that march through the volume, or to it. */
enum class SourcePass
{
  March,
  MarchByCompute,
  Visits,
  Pick,
  VertexLight,
  VertexLightByCompute,
  BoundaryView
};

/** The file of its shader. The compiler warns of a pass that has none here. */
inline const char* fileOf(SourcePass pass)
{
  switch (pass)
  {
    case SourcePass::March:
      return "passes/march.frag.glsl";
    case SourcePass::MarchByCompute:
      return "passes/march.comp.glsl";
    case SourcePass::Visits:
      return "passes/visit.frag.glsl";
    case SourcePass::Pick:
      return "passes/pick.frag.glsl";
    case SourcePass::VertexLight:
      return "passes/vertex_light.frag.glsl";
    case SourcePass::VertexLightByCompute:
      return "passes/vertex_light.comp.glsl";
    case SourcePass::BoundaryView:
      return "passes/boundary_view.frag.glsl";
  }
  return nullptr;
}

class MarchSource
{
public:
  virtual ~MarchSource() = default;

  /** How the geometry is made from the next update on, if other processes may have the rest of the
   * volume. */
  virtual void setPiece(const PieceOptions& /*piece*/) {}
  /** These processes have the rest; nullptr: none has. See TetEffectSource::setGroup(). */
  virtual void setGroup(Group* /*group*/, std::uintptr_t /*generation*/) {}

  // The stages of a frame. Each returns an empty string, or what is wrong and what to do, and does
  // nothing if its input is the same as before.

  /** What rays march through, of a data set of the type that this source takes. */
  virtual std::string updateGeometry(
    vtkDataSet* data, const ResourceLimits& limits, const Progress& progress) = 0;
  /** The scalars that are drawn. */
  virtual std::string updateScalars(vtkDataSet* data, const DrawnScalars& drawn) = 0;
  /** What of the volume can be seen by these functions; undrawnSeen: also scalars that are not
   * finite. It tells what rays may leap over. It is called when any of them, or version(), has
   * changed. */
  virtual std::string updateVisibility(
    const IntegralTable& /*first*/, const Components&, const Blending&, bool /*undrawnSeen*/)
  {
    return {};
  }
  /** The ranges of the scalars that would be drawn, the first and further ones: of this piece. */
  virtual std::vector<FiniteRange> rangesOf(vtkDataSet* /*data*/, const DrawnScalars& /*drawn*/)
  {
    return {};
  }
  /** What rays need to find where they enter if there are no lists of that. */
  virtual std::string prepareEntrySearch() = 0;

  // What the stages that follow know of it.

  /** Nothing can be marched through: the data has no such cells, or progress asked to stop. */
  virtual bool isEmpty() const = 0;
  /** A ghost array hides every cell. */
  virtual bool isHidden() const = 0;
  /** By updateVisibility() nothing of the volume can be seen. False where that is not known. */
  virtual bool showsNothing() const = 0;
  virtual const VolumeFrame& frame() const = 0;
  /** Of the first scalar. */
  virtual const ScalarRange& range() const = 0;
  /** Of the scalars that are drawn with it. */
  virtual const std::vector<ScalarRange>& furtherRanges() const = 0;
  /** The scalar bends along a ray within a cell. */
  virtual bool scalarBends() const { return false; }
  /** The share 0..1 of the volume whose scalars lie in the table's transparent ranges. */
  virtual double transparentShare(const IntegralTable& table) const = 0;
  virtual const EffectSource& effectSource() const = 0;
  /** The cell of the data in which a point lies, of the normalised frame, in what the shaders call
   * by this number. */
  virtual vtkIdType cellOf(std::uint32_t marched, const Vector3& point) const = 0;
  /** Set the bits of the key that say how rays of the camera enter, and what they march through. */
  virtual void setBits(VariantKey& key, const View& camera) const = 0;
  /** Equal as long as geometry, scalars and hidden cells are the same. The first word is that of
   * the geometry. */
  virtual Fingerprint version() const = 0;
  /** The same of the distances at which rays sample the volume. */
  virtual Fingerprint samplesVersion() const { return {}; }
  /** How often any of the stages has run. */
  virtual std::int64_t runs() const = 0;

  // What is uploaded and bound.

  virtual std::vector<BufferSize> bufferSizes() const = 0;
  virtual bool isUploaded() const = 0;
  /** Returns an empty string, or what is wrong; what did not get there is tried again next time. */
  virtual std::string upload(vtkOpenGLRenderWindow* window) = 0;
  virtual void release(vtkWindow* window) = 0;
  virtual std::size_t bytes() const = 0;
  /** How many bytes were uploaded in all. */
  virtual std::int64_t uploadedBytes() const = 0;

  /** The file of a pass's fragment or compute shader; nullptr if the volume has no such pass. */
  virtual const char* shaderOf(SourcePass pass) const { return fileOf(pass); }
  /** Why the volume can't be sampled at even distances, and what to do; empty: it can. */
  virtual std::string describeBadSamples() const = 0;
  /** What these shaders read of the volume. */
  virtual void bind(vtkShaderProgram* program, const VariantKey& key) = 0;
  virtual void unbind() = 0;

  /** A ray may leave the volume and enter it again. */
  virtual bool mayReenter() const = 0;
  /**
   * List where the rays of the viewport's pixels may enter, for passes of a key that has
   * EntryLists, unless it is listed already. It is called before these. Returns an empty string, or
   * what is wrong.
   */
  virtual std::string listEntries(vtkOpenGLRenderWindow* window, const VariantKey& key,
    const Viewport& viewport, const View& camera) = 0;
  virtual void releaseEntries(vtkWindow* window) = 0;

  /** The CPU reference in double precision, of a scene that has everything but the volume. */
  virtual ReferenceImage renderReference(
    ReferenceScene scene, const AccuracyLevel& level) const = 0;
  /** The ray of one pixel of that picture; pixels are counted from the lower left of the frame. */
  virtual RayTrace traceRay(ReferenceScene scene, const TraceOptions& options) const = 0;
};

} // namespace tetmarch

#endif
