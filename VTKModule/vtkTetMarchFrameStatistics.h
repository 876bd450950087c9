// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchFrameStatistics
 * @brief   Errors, counts, times and memory of a mapper of TetMarch and of its last frame
 *
 * The mapper brings it up to date with each frame, and whenever it is asked for it. The mapper has
 * the methods without an argument, too: `mapper->GetMeshSeconds()` is
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
   * Quantities of the pixels whose ray met the mesh.
   * ERROR_BOUND: largest possible error of a channel (r, g, b, opacity; 0..1) of the volume's
   * picture in float, before it is blended and rounded to the bytes of the window. It has the
   * steps of the tables' integrals, 32-bit fixed-point numbers, which no tolerance makes smaller.
   * It leaves out rounding, but for that of sums and averages, and what transfer functions do
   * between the entries of their tables. See vtkTetMarchSettings::AccuracyLevelType for its
   * formula. CELLS: cells that the ray crossed (tetrahedra of an unstructured grid). Rays need not
   * cross cells of which the functions show nothing. LOOKUPS: lookups of the segment integral.
   * TRUE_ERROR: largest error of a channel against the ground truth. Measured by
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
   * The quantity over those pixels; 0 if there are none. Percent, 0..100: the least value that is
   * not below those of this share of the pixels.
   */
  double GetMinimum(int quantity) const;
  double GetMean(int quantity) const;
  double GetRootMeanSquare(int quantity) const;
  double GetMaximum(int quantity) const;
  double GetPercentile(int quantity, double percent) const;
  //@}

  //@{
  /**
   * Sums over the pixels of the last frame: rays that entered the mesh, or the part of it of which
   * something may be seen, cells crossed, and lookups of the segment integral. 0 if they were not
   * counted.
   */
  vtkGetMacro(NumberOfRays, vtkTypeInt64);
  vtkGetMacro(NumberOfCrossedCells, vtkTypeInt64);
  vtkGetMacro(NumberOfLookups, vtkTypeInt64);
  //@}

  //@{
  /**
   * Sums over the pixels of the last frame: entries that refused their ray, rays that came to a
   * face without exit (lost), and rays that the step guard stopped. All are 0 unless something is
   * wrong.
   */
  vtkGetMacro(NumberOfRefusedEntries, vtkTypeInt64);
  vtkGetMacro(NumberOfLostRays, vtkTypeInt64);
  vtkGetMacro(NumberOfGuardHits, vtkTypeInt64);
  //@}

  //@{
  /**
   * Seconds of the last frame without diagnostics, and the number of draw calls or dispatches in
   * which it was marched, up to its end or to where it was aborted; 0 if nothing was drawn.
   */
  vtkGetMacro(Seconds, double);
  vtkGetMacro(NumberOfDraws, int);
  //@}

  //@{
  /**
   * Accuracy level (vtkTetMarchSettings::AccuracyLevelType) and error tolerance of the last frame,
   * set or chosen for a budget. A tolerance of 0 is that of FAST, which promises no error. Before
   * the first frame: DEFAULT and 1/255.
   */
  vtkGetMacro(UsedAccuracyLevel, int);
  const char* GetUsedAccuracyLevelAsString() const;
  vtkGetMacro(UsedErrorTolerance, double);
  //@}

  //@{
  /**
   * The shader stage in which the last frame was marched (vtkTetMarchSettings::ShaderStageType),
   * set or chosen: FRAGMENT_STAGE or COMPUTE_STAGE. Before the first frame: FRAGMENT_STAGE.
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
   * Whether the last frame was drawn to its end and kept the budgets that are set: FrameTimeBudget
   * by its time, whatever else was done in it; ErrorBudget by the tolerance it was drawn with, and
   * with CollectDiagnostics also by the error bounds of its pixels.
   */
  vtkGetMacro(BudgetKept, bool);
  //@}

  //@{
  /**
   * Whether the last frame showed all light at vertices as it is now; if not, further frames will.
   */
  vtkGetMacro(LightComplete, bool);
  //@}

  //@{
  /**
   * Size of the mesh that was prepared for the last frame; 0 before the first.
   */
  vtkGetMacro(NumberOfTetrahedra, vtkIdType);
  vtkGetMacro(NumberOfBoundaryFaces, vtkIdType);
  //@}

  //@{
  /**
   * Cells of images or rectilinear grids that were prepared for the last frame; 0 before the first.
   * With point scalars drawn as constant cells there is one around each point.
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
   * Seconds that each stage took when it ran last: joining the blocks of composite input, mesh
   * (decomposition, links, boundary; of images and rectilinear grids their lattice), scalars,
   * transfer function tables, what of the mesh the functions show (visible part), the lists of
   * where rays may enter it (entries), gradients, shadows of opaque geometry, light at vertices,
   * upload to the GPU. Images and rectilinear grids have no visible part and no entries.
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
   * Of the last frame, if a controller has several processes draw the volume: visits of rays to the
   * piece of this process; bytes that it has sent to others; the seconds that it took to march its
   * piece, to exchange visits, to merge those of its part of the picture, and to spread the merged
   * parts, with the time of waiting for others in each of the last three but merging; and a bound
   * of the error of the worst pixel, 0..1 of a channel. Else 0.
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
   * How often each stage ran since the mapper was created. A new camera raises only the entries'
   * count, new transfer functions those of the tables, the visible part and the entries,
   * new scalars on the same mesh those of the scalars, the visible part and the entries.
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
   * For the mapper. SetValues(): values of a quantity, one a pixel, negative where the ray met
   * nothing. Clear(): forget what was measured of the pixels, and the seconds of the frame.
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
