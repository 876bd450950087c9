// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchSmartVolumeMapper
 * @brief   Volume rendering of images and rectilinear grids by marching rays from cell to cell
 *
 * It is a vtkSmartVolumeMapper and can replace one. While that samples each ray, this mapper
 * integrates the field in each cell, with the tolerance, the light, the views and the picks of
 * vtkTetMarchVolumeMapper. Settings are in vtkTetMarchSettings and statistics in
 * vtkTetMarchFrameStatistics; the mapper has the methods of both. The default opacity law is
 * vtkTetMarchSettings::STRUCTURED, that of vtkSmartVolumeMapper.
 *
 * The input is a vtkImageData (or vtkUniformGrid) or a vtkRectilinearGrid, with scalars of points
 * or cells of any numeric type. vtkVolumeProperty::SetInterpolationTypeToLinear() makes cells
 * trilinear; nearest, VTK's default, makes them constant. The scalars keep their precision, a
 * rectilinear grid its coordinates, and an image its direction matrix. Blanked cells and ghosts are
 * left out.
 *
 * The input may also be a tree of blocks (vtkMultiBlockDataSet, vtkPartitionedDataSet,
 * vtkPartitionedDataSetCollection; by SetInputConnection() or SetInputDataObject()) of such data.
 * Blocks are not joined: each is drawn over those behind it. Adjacent blocks look like one if they
 * share points. Overlapping blocks are not mixed: the one whose centre is farther away is drawn
 * first. Several blocks are drawn with composite blending and as isosurfaces only. They have no
 * diagnostics, no views of measures and no traces, and a pick uses the opacity within one block.
 * Between translucent surfaces (vtkRenderer::UseDepthPeelingForVolumes) several blocks are an
 * error. Blocks without the chosen array are left out, with a warning, and so are blocks of other
 * types, such as unstructured grids; a tree with only these is an error. vtkTetMarchVolumeMapper
 * draws a mixed tree as a whole, with its images decomposed into tetrahedra, or the other blocks in
 * a separate volume.
 *
 * Properties of vtkSmartVolumeMapper:
 * - RequestedRenderMode: this mapper draws in the modes default and GPU, and
 *   GetLastUsedRenderMode() is then GPURenderMode. vtkSmartVolumeMapper draws in all others.
 * - Also drawn by vtkSmartVolumeMapper: SLICE_BLEND; transfer functions in 2D; masks;
 *   ComputeNormalFromOpacity (VTK 9.2) of a shaded volume; several independent components with
 *   gradient opacity, shadows, scattering or ambient occlusion, with different reflections, or
 *   without composite blending. One warning states the reason. VTK draws no blocks, so these are
 *   errors for a tree.
 * - VectorMode: DISABLED draws all components, independent or dependent according to
 *   vtkVolumeProperty::GetIndependentComponents(); MAGNITUDE; COMPONENT draws VectorComponent with
 *   the functions and the unit distance of component 0, and all components if they are dependent.
 *   The property is not changed. See vtkTetMarchVolumeMapper::VectorModeType.
 * - FinalColorWindow and FinalColorLevel map the colours of the picture, as in VTK. Error bounds,
 *   diagnostics and the ground truth refer to the colours before this, and, with a PixelTolerance,
 *   to those of a ray for each pixel.
 * - InteractiveAdjustSampleDistances (on by default): frames at InteractiveUpdateRate or above may
 *   have fewer rays, others use ImageSampleDistance. Off: AutoAdjustSampleDistances determines
 *   this.
 * - MaxMemoryInBytes: see vtkTetMarchSettings; 0, the default here, means no limit.
 *   MaxMemoryFraction is a factor of it.
 * - VolumetricScatteringBlending, GlobalIlluminationReach (VTK 9.2): see vtkTetMarchSettings. The
 *   default of the reach is 1, not 0.
 * - SampleDistance, LockSampleDistanceToInputSpacing and UseJittering have an effect at the
 *   accuracy level SAMPLED only: other levels use no samples.
 * - InterpolationMode and LowResMode (VTK 9.3) have no effect: the volume is never resampled. They
 *   apply where vtkSmartVolumeMapper draws, including the pictures of CreateCanonicalView().
 *
 * VolumeMapperRenderStartEvent and VolumeMapperRenderEndEvent are invoked before and after each
 * frame. Errors are reported once, and the frame lacks the volume.
 *
 * @sa vtkTetMarchVolumeMapper vtkTetMarchSettings vtkTetMarchFrameStatistics vtkSmartVolumeMapper
 */
#ifndef vtkTetMarchSmartVolumeMapper_h
#define vtkTetMarchSmartVolumeMapper_h

#include "vtkMath.h"                    // For vtkMath::Nan
#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkSmartVolumeMapper.h"
#include "vtkTetMarchSettingsMacros.h"   // For methods of the settings
#include "vtkTetMarchStatisticsMacros.h" // For methods of the statistics
#include "vtkVersionMacros.h"            // For what VTK has from which version on

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkDataSet;
class vtkFloatArray;
class vtkLookupTable;
class vtkOpenGLRenderWindow;
class vtkTable;
class vtkVolumeProperty;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchSmartVolumeMapper : public vtkSmartVolumeMapper
{
public:
  static vtkTetMarchSmartVolumeMapper* New();
  vtkTypeMacro(vtkTetMarchSmartVolumeMapper, vtkSmartVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Render the volume into the renderer's viewport. Called by vtkVolume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  //@{
  /**
   * Bounding box of the input; for a tree, of all blocks except surfaces (vtkPolyData).
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  using Superclass::GetBounds;
  //@}

  /**
   * Free all GL objects of the given window's context. The next Render() creates them again.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // Groups begin with two slashes: after three, VTK 9.1 tells Python of their first method only.
  //@{
  /**
   * The settings: accuracy, budgets, light, views, picks, distances between rays. Each mapper
   * initially has its own; several mappers can share one object, also with a
   * vtkTetMarchVolumeMapper. Setting null creates new settings with default values and the opacity
   * law STRUCTURED. A change of the settings modifies the mapper.
   */
  void SetSettings(vtkTetMarchSettings* settings);
  vtkTetMarchSettings* GetSettings() const;
  //@}

  //@{
  /**
   * Forwarded to GetSettings(): see vtkTetMarchSettings.
   */
  vtkTetMarchOwnSettingsMethodsMacro();
  //@}

  //@{
  /**
   * Settings that vtkSmartVolumeMapper has, too, some of them from VTK 9.2 on: they are forwarded
   * to GetSettings() in either class.
   */
  void SetAutoAdjustSampleDistances(vtkTypeBool adjusts) override;
  vtkTypeBool GetAutoAdjustSampleDistances() VTK_TETMARCH_FUTURE_CONST override;
  void AutoAdjustSampleDistancesOn() override;
  void AutoAdjustSampleDistancesOff() override;
  void SetMaxMemoryInBytes(vtkIdType bytes) override;
  vtkIdType GetMaxMemoryInBytes() VTK_TETMARCH_FUTURE_CONST override;
  virtual vtkIdType GetMaxMemoryInBytesMinValue();
  virtual vtkIdType GetMaxMemoryInBytesMaxValue();
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  vtkTetMarchForwardClampedMacro(VolumetricScatteringBlending, float);
  vtkTetMarchForwardClampedMacro(GlobalIlluminationReach, float);
#else
  void SetVolumetricScatteringBlending(float blending) override;
  float GetVolumetricScatteringBlending() VTK_TETMARCH_FUTURE_CONST override;
  void SetGlobalIlluminationReach(float reach) override;
  float GetGlobalIlluminationReach() VTK_TETMARCH_FUTURE_CONST override;
#endif
  //@}

  //@{
  /**
   * Samples along rays, at the accuracy level SAMPLED with composite blending; SetSampleDistance()
   * is that of vtkSmartVolumeMapper. Their positions are those of vtkGPUVolumeRayCastMapper: the
   * first sample is one step behind the begin of the ray at the side of the volume's box, the
   * clipping plane or the near plane or, with UseJittering (off by default), a fraction of a step,
   * which differs from pixel to pixel and is the same in each frame. Without jitter a ray has at
   * least one sample.
   *
   * The step, in units of the data, is the smallest spacing times the distance between rays in
   * frames for which distances are adjusted (AutoAdjustSampleDistances,
   * InteractiveAdjustSampleDistances). Otherwise it is SampleDistance, unless that is negative, the
   * default, or LockSampleDistanceToInputSpacing is on (off by default; on in vtkSmartVolumeMapper,
   * where SampleDistance therefore has no effect). Then it is that of vtkSmartVolumeMapper: half of
   * the mean spacing, and less below a million cells
   * (vtkVolumeMapper::SpacingAdjustedSampleDistance()). A step of less than a millionth of the
   * volume's diagonal is an error.
   *
   * Each sample is interpolated in float, classified and composited with the opacity 1 -
   * exp(-extinction step); light uses the gradient there. There is no error bound: ERROR_BOUND is
   * 1, and VIEW_ERROR_BOUND is an error. RenderGroundTruth() returns the exact picture, and
   * CompareWithGroundTruth() the error of the samples. Picks and light at nodes are as exact as at
   * other levels.
   */
  vtkSetClampMacro(LockSampleDistanceToInputSpacing, vtkTypeBool, 0, 1);
  vtkGetMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
  vtkBooleanMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
  vtkSetClampMacro(UseJittering, vtkTypeBool, 0, 1);
  vtkGetMacro(UseJittering, vtkTypeBool);
  vtkBooleanMacro(UseJittering, vtkTypeBool);
#endif
  //@}

  /**
   * Current errors, counts, times and memory. The object stays the same; each frame and each call
   * of this method updates it. Times and memory are summed over blocks.
   */
  vtkTetMarchFrameStatistics* GetLastFrameStatistics() const;

  //@{
  /**
   * Deprecated aliases, which go with version 0.4: forwarded to GetLastFrameStatistics(), see
   * vtkTetMarchFrameStatistics. IsBudgetKept() is its GetBudgetKept(), IsLightComplete() its
   * GetLightComplete().
   */
  vtkTetMarchStatisticsMethodsMacro();
  //@}

  //@{
  /**
   * Pick at the centre of the pixel (x, y), counted from the lower left of the window: see
   * vtkTetMarchVolumeMapper::Pick(). PickedBlock is the flat index of the cell's block, and 0 if
   * the input is not a tree.
   */
  bool Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y);
  vtkGetVector3Macro(PickedPosition, double);
  vtkGetMacro(PickedScalar, double);
  vtkGetMacro(PickedCellId, vtkIdType);
  vtkGetMacro(PickedBlock, unsigned int);
  //@}

  /**
   * The colours of view modes that draw a measure: see vtkTetMarchVolumeMapper.
   */
  vtkLookupTable* GetViewLookupTable();

  //@{
  /**
   * The picture of the last frame in double precision, and the true errors of that frame: see
   * vtkTetMarchVolumeMapper::RenderGroundTruth().
   */
  bool RenderGroundTruth(vtkVolume* volume, vtkFloatArray* pixels, double tolerance = 1e-6);
  bool CompareWithGroundTruth(vtkVolume* volume);
  //@}

  enum TraceArithmeticType
  {
    TRACE_FLOAT = 0,       // the arithmetic of the GPU, at the accuracy of the last frame
    TRACE_DOUBLE = 1,      // double precision, at the same accuracy
    TRACE_GROUND_TRUTH = 2 // as RenderGroundTruth()
  };
  /**
   * The ray of the last frame through a pixel, marched again on the CPU: see
   * vtkTetMarchVolumeMapper::TraceRay().
   */
  bool TraceRay(vtkVolume* volume, int x, int y, int arithmetic, vtkTable* cells);

  /**
   * The picture of the last frame with CollectDiagnostics on: see
   * vtkTetMarchVolumeMapper::GetDiagnosticPixels().
   */
  void GetDiagnosticPixels(vtkFloatArray* pixels) const;

protected:
  vtkTetMarchSmartVolumeMapper();
  ~vtkTetMarchSmartVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  double PickedPosition[3] = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
  double PickedScalar = vtkMath::Nan();
  vtkIdType PickedCellId = -1;
  unsigned int PickedBlock = 0;
  vtkTypeBool LockSampleDistanceToInputSpacing = 0;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
  vtkTypeBool UseJittering = 0;
#endif

private:
  vtkTetMarchSmartVolumeMapper(const vtkTetMarchSmartVolumeMapper&) = delete;
  void operator=(const vtkTetMarchSmartVolumeMapper&) = delete;

  class Internals;

  // The reason why vtkSmartVolumeMapper must draw; empty if there is none.
  std::string FindReasonForVTK(vtkVolume* volume);
  std::string FindReasonOfComponents(vtkVolumeProperty* property);
  // In units of the data. rayDistance: in pixels if distances are adjusted, else 0.
  double FindSampleDistance(vtkDataSet* data, double rayDistance);
  void RenderByVTK(vtkRenderer* renderer, vtkVolume* volume, const std::string& reason);
  void March(vtkRenderer* renderer, vtkVolume* volume, const std::string& error);
  std::string DrawBlocks(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  bool Report(const std::string& error); // whether there is none

  std::unique_ptr<Internals> Internal;
};

#endif
