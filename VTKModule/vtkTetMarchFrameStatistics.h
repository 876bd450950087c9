// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchFrameStatistics
 * @brief   Errors, counts, times and memory of a TetMarch mapper and of its last frame
 *
 * The mapper updates it with each frame, and when it is requested. The mapper also has the methods
 * without an argument: `mapper->GetMeshSeconds()` is
 * `mapper->GetLastFrameStatistics()->GetMeshSeconds()`.
 *
 * Error bounds, cells, lookups and the counts of rays are measured with CollectDiagnostics on and
 * in view modes that draw a measure (vtkTetMarchSettings).
 *
 * @sa vtkTetMarchVolumeMapper::GetLastFrameStatistics
 */
#ifndef vtkTetMarchFrameStatistics_h
#define vtkTetMarchFrameStatistics_h

#include "vtkObject.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For std::unique_ptr

class vtkFloatArray;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchFrameStatistics : public vtkObject
{
public:
  static vtkTetMarchFrameStatistics* New();
  vtkTypeMacro(vtkTetMarchFrameStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Quantities of the pixels whose ray meets the mesh.
   * ERROR_BOUND: largest possible error of a channel (r, g, b, opacity; 0..1) of the volume's
   * picture in float, before it is blended and rounded to the bytes of the window. It includes the
   * steps of the tables' integrals, 32-bit fixed-point numbers, which do not depend on the
   * tolerance. It excludes rounding, except that of sums and averages, and the variation of
   * transfer functions between the entries of their tables. See
   * vtkTetMarchSettings::AccuracyLevelType for its formula. CELLS: cells that the ray crossed
   * (tetrahedra of an unstructured grid). Rays may skip transparent cells. LOOKUPS: lookups of the
   * segment integral. TRUE_ERROR: largest error of a channel against the ground truth. Measured by
   * vtkTetMarchVolumeMapper::CompareWithGroundTruth() only.
   */
  enum QuantityType
  {
    ERROR_BOUND = 0,
    CELLS = 1,
    LOOKUPS = 2,
    TRUE_ERROR = 3
  };

  /**
   * Number of pixels for which the quantity was measured in the last frame; 0 if it was not
   * measured.
   */
  vtkIdType GetNumberOfPixels(int quantity) const;

  //@{
  /**
   * The quantity over these pixels; 0 if there are none. Percent, 0..100: the smallest value that
   * is not below those of this share of the pixels.
   */
  double GetMinimum(int quantity) const;
  double GetMean(int quantity) const;
  double GetRootMeanSquare(int quantity) const;
  double GetMaximum(int quantity) const;
  double GetPercentile(int quantity, double percent) const;
  //@}

  //@{
  /**
   * Sums over the pixels of the last frame: rays that entered the mesh or its visible part, cells
   * crossed, and lookups of the segment integral. 0 if they were not counted.
   */
  vtkGetMacro(NumberOfRays, vtkTypeInt64);
  vtkGetMacro(NumberOfCrossedCells, vtkTypeInt64);
  vtkGetMacro(NumberOfLookups, vtkTypeInt64);
  //@}

  //@{
  /**
   * Sums over the pixels of the last frame: entries that refused their ray, rays that reached a
   * face without exit (lost), and rays that the step guard stopped. Normally all are 0.
   */
  vtkGetMacro(NumberOfRefusedEntries, vtkTypeInt64);
  vtkGetMacro(NumberOfLostRays, vtkTypeInt64);
  vtkGetMacro(NumberOfGuardHits, vtkTypeInt64);
  //@}

  //@{
  /**
   * Seconds of the last frame without diagnostics, and the number of its draw calls or dispatches,
   * up to its end or abort; 0 if nothing was drawn.
   */
  vtkGetMacro(Seconds, double);
  vtkGetMacro(NumberOfDraws, int);
  //@}

  //@{
  /**
   * Accuracy level (vtkTetMarchSettings::AccuracyLevelType) and error tolerance of the last frame,
   * set or chosen for a budget. The tolerance is 0 at the level FAST, which guarantees no error.
   * Before the first frame: DEFAULT and 1/255.
   */
  vtkGetMacro(UsedAccuracyLevel, int);
  const char* GetUsedAccuracyLevelAsString() const;
  vtkGetMacro(UsedErrorTolerance, double);
  //@}

  //@{
  /**
   * The shader stage of the last frame (vtkTetMarchSettings::ShaderStageType), set or chosen:
   * FRAGMENT_STAGE or COMPUTE_STAGE. Before the first frame: FRAGMENT_STAGE.
   */
  vtkGetMacro(UsedShaderStage, int);
  const char* GetUsedShaderStageAsString() const;
  //@}

  //@{
  /**
   * Distance between rays in the last frame, in pixels. Default: 1.
   */
  vtkGetMacro(UsedImageSampleDistance, double);
  //@}

  //@{
  /**
   * Whether the last frame was completed and kept its budgets: FrameTimeBudget by its total time;
   * ErrorBudget by its tolerance, and with CollectDiagnostics also by the error bounds of its
   * pixels.
   */
  vtkGetMacro(BudgetKept, bool);
  //@}

  //@{
  /**
   * Whether the light at vertices was complete in the last frame; if not, further frames complete
   * it.
   */
  vtkGetMacro(LightComplete, bool);
  //@}

  //@{
  /**
   * Size of the mesh of the last frame; 0 before the first.
   */
  vtkGetMacro(NumberOfTetrahedra, vtkIdType);
  vtkGetMacro(NumberOfBoundaryFaces, vtkIdType);
  //@}

  //@{
  /**
   * Number of cells of images or rectilinear grids in the last frame; 0 before the first. With
   * point scalars drawn as constant cells there is one cell around each point.
   */
  vtkGetMacro(NumberOfLatticeCells, vtkTypeInt64);
  //@}

  //@{
  /**
   * Bytes of buffers and textures that the mapper holds on the GPU now.
   */
  vtkGetMacro(GPUMemoryBytes, vtkTypeInt64);
  //@}

  //@{
  /**
   * Bytes that the mapper has uploaded to the GPU since it was created.
   */
  vtkGetMacro(UploadedBytes, vtkTypeInt64);
  //@}

  //@{
  /**
   * Seconds of the last run of each stage: joining the blocks of composite input, mesh
   * (decomposition, links, boundary; for images and rectilinear grids their lattice), scalars,
   * transfer function tables, the visible part of the mesh, the lists of entry faces (entries),
   * gradients, shadows of opaque geometry, light at vertices, upload to the GPU. Images and
   * rectilinear grids have no visible part and no entries.
   */
  vtkGetMacro(BlocksSeconds, double);
  vtkGetMacro(MeshSeconds, double);
  vtkGetMacro(ScalarsSeconds, double);
  vtkGetMacro(TablesSeconds, double);
  vtkGetMacro(VisiblePartSeconds, double);
  vtkGetMacro(EntriesSeconds, double);
  vtkGetMacro(GradientsSeconds, double);
  vtkGetMacro(OpaqueShadowsSeconds, double);
  vtkGetMacro(VertexLightSeconds, double);
  vtkGetMacro(UploadSeconds, double);
  //@}

  //@{
  /**
   * Figures of the last frame if several processes draw the volume, else 0: visits of rays to the
   * piece of this process; bytes sent to other processes; seconds of the march of its piece, of the
   * exchange of visits, of the merge of its part of the picture, and of the distribution of the
   * merged parts, where exchange and distribution include waiting for other processes; and a bound
   * of the largest error of a pixel, 0..1 of a channel.
   */
  vtkGetMacro(NumberOfVisits, vtkTypeInt64);
  vtkGetMacro(SentBytes, vtkTypeInt64);
  vtkGetMacro(MarchSeconds, double);
  vtkGetMacro(ExchangeSeconds, double);
  vtkGetMacro(MergeSeconds, double);
  vtkGetMacro(SpreadSeconds, double);
  vtkGetMacro(SharedErrorBound, double);
  //@}

  //@{
  /**
   * Number of runs of each stage since the mapper was created. A new camera increases only the
   * count of the entries, new transfer functions those of the tables, the visible part and the
   * entries, new scalars on the same mesh those of the scalars, the visible part and the entries.
   */
  vtkGetMacro(BlocksBuilds, vtkTypeInt64);
  vtkGetMacro(MeshBuilds, vtkTypeInt64);
  vtkGetMacro(ScalarsBuilds, vtkTypeInt64);
  vtkGetMacro(TablesBuilds, vtkTypeInt64);
  vtkGetMacro(VisiblePartBuilds, vtkTypeInt64);
  vtkGetMacro(EntriesBuilds, vtkTypeInt64);
  vtkGetMacro(GradientsBuilds, vtkTypeInt64);
  vtkGetMacro(OpaqueShadowsBuilds, vtkTypeInt64);
  vtkGetMacro(VertexLightBuilds, vtkTypeInt64);
  //@}

  //@{
  /**
   * For the mapper. SetValues(): values of a quantity, one per pixel, negative where the ray met
   * nothing. Clear(): discard the quantities of the pixels and the seconds of the frame.
   */
  void SetValues(int quantity, vtkFloatArray* values);
  void Clear();
  vtkSetMacro(NumberOfRays, vtkTypeInt64);
  vtkSetMacro(NumberOfCrossedCells, vtkTypeInt64);
  vtkSetMacro(NumberOfLookups, vtkTypeInt64);
  vtkSetMacro(NumberOfRefusedEntries, vtkTypeInt64);
  vtkSetMacro(NumberOfLostRays, vtkTypeInt64);
  vtkSetMacro(NumberOfGuardHits, vtkTypeInt64);
  vtkSetMacro(Seconds, double);
  vtkSetMacro(NumberOfDraws, int);
  vtkSetClampMacro(UsedAccuracyLevel, int, 0, 4);
  vtkSetClampMacro(UsedShaderStage, int, 1, 2);
  vtkSetMacro(UsedErrorTolerance, double);
  vtkSetMacro(UsedImageSampleDistance, double);
  vtkSetMacro(BudgetKept, bool);
  vtkSetMacro(LightComplete, bool);
  vtkSetMacro(NumberOfTetrahedra, vtkIdType);
  vtkSetMacro(NumberOfBoundaryFaces, vtkIdType);
  vtkSetMacro(NumberOfLatticeCells, vtkTypeInt64);
  vtkSetMacro(GPUMemoryBytes, vtkTypeInt64);
  vtkSetMacro(UploadedBytes, vtkTypeInt64);
  vtkSetMacro(BlocksSeconds, double);
  vtkSetMacro(MeshSeconds, double);
  vtkSetMacro(ScalarsSeconds, double);
  vtkSetMacro(TablesSeconds, double);
  vtkSetMacro(VisiblePartSeconds, double);
  vtkSetMacro(EntriesSeconds, double);
  vtkSetMacro(GradientsSeconds, double);
  vtkSetMacro(OpaqueShadowsSeconds, double);
  vtkSetMacro(VertexLightSeconds, double);
  vtkSetMacro(UploadSeconds, double);
  vtkSetMacro(NumberOfVisits, vtkTypeInt64);
  vtkSetMacro(SentBytes, vtkTypeInt64);
  vtkSetMacro(MarchSeconds, double);
  vtkSetMacro(ExchangeSeconds, double);
  vtkSetMacro(MergeSeconds, double);
  vtkSetMacro(SpreadSeconds, double);
  vtkSetMacro(SharedErrorBound, double);
  vtkSetMacro(BlocksBuilds, vtkTypeInt64);
  vtkSetMacro(MeshBuilds, vtkTypeInt64);
  vtkSetMacro(ScalarsBuilds, vtkTypeInt64);
  vtkSetMacro(TablesBuilds, vtkTypeInt64);
  vtkSetMacro(VisiblePartBuilds, vtkTypeInt64);
  vtkSetMacro(EntriesBuilds, vtkTypeInt64);
  vtkSetMacro(GradientsBuilds, vtkTypeInt64);
  vtkSetMacro(OpaqueShadowsBuilds, vtkTypeInt64);
  vtkSetMacro(VertexLightBuilds, vtkTypeInt64);
  //@}

protected:
  vtkTetMarchFrameStatistics();
  ~vtkTetMarchFrameStatistics() override;

  vtkTypeInt64 NumberOfRays = 0;
  vtkTypeInt64 NumberOfCrossedCells = 0;
  vtkTypeInt64 NumberOfLookups = 0;
  vtkTypeInt64 NumberOfRefusedEntries = 0;
  vtkTypeInt64 NumberOfLostRays = 0;
  vtkTypeInt64 NumberOfGuardHits = 0;
  double Seconds = 0;
  int NumberOfDraws = 0;
  int UsedAccuracyLevel;
  int UsedShaderStage = 1;
  double UsedErrorTolerance = 1.0 / 255.0;
  double UsedImageSampleDistance = 1;
  bool BudgetKept = false;
  bool LightComplete = true;
  vtkIdType NumberOfTetrahedra = 0;
  vtkIdType NumberOfBoundaryFaces = 0;
  vtkTypeInt64 NumberOfLatticeCells = 0;
  vtkTypeInt64 GPUMemoryBytes = 0;
  vtkTypeInt64 UploadedBytes = 0;
  double BlocksSeconds = 0;
  double MeshSeconds = 0;
  double ScalarsSeconds = 0;
  double TablesSeconds = 0;
  double VisiblePartSeconds = 0;
  double EntriesSeconds = 0;
  double GradientsSeconds = 0;
  double OpaqueShadowsSeconds = 0;
  double VertexLightSeconds = 0;
  double UploadSeconds = 0;
  vtkTypeInt64 NumberOfVisits = 0;
  vtkTypeInt64 SentBytes = 0;
  double MarchSeconds = 0;
  double ExchangeSeconds = 0;
  double MergeSeconds = 0;
  double SpreadSeconds = 0;
  double SharedErrorBound = 0;
  vtkTypeInt64 BlocksBuilds = 0;
  vtkTypeInt64 MeshBuilds = 0;
  vtkTypeInt64 ScalarsBuilds = 0;
  vtkTypeInt64 TablesBuilds = 0;
  vtkTypeInt64 VisiblePartBuilds = 0;
  vtkTypeInt64 EntriesBuilds = 0;
  vtkTypeInt64 GradientsBuilds = 0;
  vtkTypeInt64 OpaqueShadowsBuilds = 0;
  vtkTypeInt64 VertexLightBuilds = 0;

private:
  vtkTetMarchFrameStatistics(const vtkTetMarchFrameStatistics&) = delete;
  void operator=(const vtkTetMarchFrameStatistics&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
