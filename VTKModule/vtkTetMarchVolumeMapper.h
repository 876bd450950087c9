// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchVolumeMapper
 * @brief   Volume rendering of unstructured grids by marching rays from tetrahedron to tetrahedron
 *
 * It replaces vtkProjectedTetrahedraMapper and vtkUnstructuredGridVolumeRayCastMapper. In a GLSL
 * shader, each ray enters the mesh or its visible part through a boundary face and follows the
 * links between faces from cell to cell. Cells are not sorted, and the data are not resampled. All
 * linear 3D cells are drawn (tetrahedron, hexahedron, voxel, wedge, pyramid, pentagonal and
 * hexagonal prism, polyhedron), and curved ones by linear pieces, or within a GeometryTolerance.
 * Other cells are left out with a warning that counts them.
 *
 * Inside a tetrahedron the scalar is linear. Extinction and colour come from the functions of
 * component 0 of the vtkVolumeProperty: scalar opacity, scalar opacity unit distance, and colour or
 * gray. The emission-absorption integral of each ray segment is evaluated by integral tables, and
 * segments are split until the pixel keeps its error tolerance. Shading and gradient opacity of the
 * property are supported; its interpolation type has no effect.
 *
 * Settings (accuracy, budgets, light, views, picks, distances between rays) are in
 * vtkTetMarchSettings. Errors, counts, times and memory are in vtkTetMarchFrameStatistics. The
 * mapper has the methods of both.
 *
 * The scalars are those of points or cells, of any numeric type, chosen by ScalarMode and
 * ArrayAccessMode as in every vtkAbstractMapper. VectorMode determines the drawn components of an
 * array. Rays skip cells with a scalar that is not finite, unless DrawNanCells is on.
 *
 * Rays also skip hidden cells: those whose vtkGhostType of the cell data has HIDDENCELL,
 * DUPLICATECELL or REFINEDCELL, and those with a point whose vtkGhostType of the point data has
 * HIDDENPOINT. Hidden cells count for the range of the scalars, for gradients and for the boundary.
 * An array of that name is ignored unless it is of unsigned char and has a value for each cell or
 * point. New ghost types do not rebuild the mesh.
 *
 * The input is a vtkUnstructuredGrid, a curvilinear grid (vtkStructuredGrid,
 * vtkExplicitStructuredGrid), a vtkHyperTreeGrid, a vtkCellGrid (VTK 9.5 and later), or a tree of
 * blocks (vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
 * vtkOverlappingAMR, vtkNonOverlappingAMR; by SetInputConnection() or SetInputDataObject()). Of an
 * adaptive mesh the finest cells are drawn; those of a vtkHyperTreeGrid are its leaves, numbered in
 * their order. If they are not in blocks of another tree, have values of cells and differ in width
 * by powers of two, rays march through an octree of them, without tetrahedra. Of a vtkCellGrid the
 * cells in three dimensions are drawn, type by type in the order of their names; its nodal fields
 * are arrays of points or of cells, as one asks. Blocks are joined into one grid, so that rays
 * continue from one block to the next. They may be any data sets with 3D cells, also images and
 * rectilinear grids, whose cells are decomposed into tetrahedra. Points of different blocks are
 * identified by global point ids if all blocks have them, else by equal coordinates to the last
 * bit. If such points have different scalars, each block keeps its own, unless its point is a
 * duplicate by vtkGhostType. Blocks without the chosen array are left out with a warning that names
 * them. The joined grid is updated when blocks have changed, and takes memory in addition to them.
 * GetInput() is null for other input than a vtkUnstructuredGrid; GetDataObjectInput() is not.
 *
 * The stages (mesh, scalars, transfer function tables, camera) run again only when their input has
 * changed; Get...Builds() counts the runs. A mesh in new arrays is compared by the values of its
 * points and cells, so that for a time series on one mesh only the scalars are prepared again. If
 * only points of tetrahedra move, their links are kept.
 *
 * Errors (no GL 3.2 context, ids out of range, a mesh that is larger than the GL can hold, ...) are
 * reported once through vtkErrorMacro, and the frame lacks this volume. A mesh that could not be
 * prepared is not tried again until the grid or a limit changes.
 *
 * @sa vtkTetMarchSettings vtkTetMarchFrameStatistics vtkProjectedTetrahedraMapper
 * vtkUnstructuredGridVolumeRayCastMapper vtkVolumeProperty
 */
#ifndef vtkTetMarchVolumeMapper_h
#define vtkTetMarchVolumeMapper_h

#include "vtkMath.h"                     // For vtkMath::Nan
#include "vtkRenderingTetMarchModule.h"  // For export macro
#include "vtkSmartPointer.h"             // For vtkSmartPointer
#include "vtkTetMarchSettingsMacros.h"   // For methods of the settings
#include "vtkTetMarchStatisticsMacros.h" // For methods of the statistics
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolumeMapper.h" // For VTK_CROP_SUBVOLUME

#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string

class vtkFloatArray;
class vtkLookupTable;
class vtkMultiProcessController;
class vtkOpenGLRenderWindow;
class vtkPointSet;
class vtkTable;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchVolumeMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkTetMarchVolumeMapper* New();
  vtkTypeMacro(vtkTetMarchVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Render the volume into the renderer's viewport. Called by vtkVolume. With
   * vtkRenderer::UseDepthPeelingForVolumes, vtkDualDepthPeelingPass calls it several times per
   * frame for the parts of the picture between translucent surfaces. Then there are no diagnostics,
   * and view modes that show a measure or the boundary draw the picture. If the renderer has a
   * selector, the cells that it reads are drawn: see PickOpacityThreshold.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  //@{
  /**
   * Bounding box of the points of the input; for composite input, of all blocks except surfaces
   * (vtkPolyData). With a Controller of several processes, that of all their cells at the last
   * ShareBounds() or Render(); null before.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  using Superclass::GetBounds;
  //@}

  //@{
  /**
   * The processes that have pieces of the volume, none by default. With a controller of several
   * processes the frame shows the whole volume in each of them, exactly as one process would draw
   * it, for any shape of the pieces: they may interlock, lie within each other or be empty. Each
   * process marches its own cells; the colour and transmittance of each visit of a ray to a piece
   * are exchanged, sorted by depth and composited. Opaque geometry of any process hides the volume
   * behind it. The volume writes a depth just before the far plane where there is no opaque
   * geometry, so that compositors of whole frames by depth (vtkCompositedSynchronizedRenderers,
   * IceT) use these pixels.
   *
   * Render() is collective then: all processes call it in the same order, with windows of the same
   * size and the same camera, property and settings, and each has an input, which may have no cells
   * and no arrays. Accuracy and distances between rays are those of process 0, where budgets choose
   * them. Points that pieces share have the same coordinates; if some pieces have floats and others
   * doubles, all are rounded to float. Cells that vtkGhostType marks as DUPLICATECELL are left out.
   * Process 0 reports an error of any process, and names the process; no process draws the volume.
   *
   * Faces with more than three corners are cut through the corner with the smallest coordinates, x
   * first, also with a controller of one process; without a controller through that with the
   * smallest id. Those of curvilinear grids are always cut by ids, which have the order of i, j, k
   * in each piece.
   *
   * Gradients at points that pieces share are those of all pieces. Shadows and ambient occlusion
   * are computed within the piece of each process. View modes other than the picture, and depth
   * peeling, are errors; CollectDiagnostics, picks and traces use the piece of one process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  //@}

  //@{
  /**
   * The maximum memory of each process for the visits of rays, in bytes, at least 100 000. Pictures
   * with more visits are drawn in bands of rows. Default: 2^30.
   */
  vtkSetClampMacro(MaxVisitMemoryInBytes, vtkTypeInt64, 100000, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaxVisitMemoryInBytes, vtkTypeInt64);
  //@}

  //@{
  /** Collective: exchange the bounds of the volume, for GetBounds() before the first frame, as
   * vtkRenderer::ResetCamera() needs it. */
  void ShareBounds();
  /** Set the bounds of the whole volume; not collective. */
  void SetWholeBounds(const double bounds[6]);
  //@}

  /**
   * Prepare the tetrahedra of the input and their links before the first frame; for a large grid
   * this takes most of the time of that frame. It needs no window, and may run in any thread as
   * long as no other thread uses the mapper or changes its input. ProgressEvent is invoked, and an
   * observer stops it by SetAbortExecute(1). Returns whether there is something to draw: false with
   * an error if it failed, without one if it was stopped or the input has no cells.
   */
  bool PrepareMesh();

  /**
   * Free all GL objects of the given window's context. The next Render() creates them again.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // Groups begin with two slashes: after three, VTK 9.1 tells Python of their first method only.
  //@{
  /**
   * The settings: accuracy, budgets, light, views, picks, distances between rays. Each mapper
   * initially has its own; several mappers can share one object. Setting null creates new settings
   * with default values. A change of the settings modifies the mapper.
   */
  void SetSettings(vtkTetMarchSettings* settings);
  vtkTetMarchSettings* GetSettings() const;
  //@}

  //@{
  /**
   * Forwarded to GetSettings(): see vtkTetMarchSettings.
   */
  vtkTetMarchSettingsMethodsMacro();
  //@}

  /**
   * Current errors, counts, times and memory. The object stays the same; each frame and each call
   * of this method updates it.
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
   * Deprecated names of ViewMode and of GetNumberOfLookups(): the boundary was called shell, and
   * lookups evaluations.
   */
  enum DeprecatedViewModeType
  {
    VIEW_SHELL_FACES = VIEW_BOUNDARY_FACES,
    VIEW_SHELL_COORDINATES = VIEW_BOUNDARY_COORDINATES
  };
  void SetViewModeToShellFaces() { this->SetViewModeToBoundaryFaces(); }
  void SetViewModeToShellCoordinates() { this->SetViewModeToBoundaryCoordinates(); }
  vtkTypeInt64 GetNumberOfEvaluations() const { return this->GetNumberOfLookups(); }
  //@}

  //@{
  /**
   * Blend mode of the scalars along a ray (SetBlendMode(); the numbers are those of
   * vtkVolumeMapper::BlendModes). vtkGPUVolumeRayCastMapper computes it from samples; here it is
   * exact in each cell.
   * COMPOSITE_BLEND: emission and absorption, the default.
   * MAXIMUM_INTENSITY_BLEND, MINIMUM_INTENSITY_BLEND: the maximum or minimum scalar, with its
   * colour and the opacity of the opacity function, independent of the unit distance.
   * AVERAGE_INTENSITY_BLEND: the mean of opacity(s) s' over the part of the ray whose scalar s lies
   * in AverageIPScalarRange, as an opaque gray; nothing if there is no such part. Here
   * s' = (s - min) / (max - min) for the range of the array.
   * ADDITIVE_BLEND: the integral of opacity(s) s' over the ray, with lengths in scalar opacity unit
   * distances, as an opaque gray of at most 1; nothing if the ray meets no cell.
   * ISOSURFACE_BLEND: the surfaces of the values of vtkVolumeProperty::GetIsoSurfaceValues(), at
   * most 32, each with its colour and opacity, composited front to back. Scalars of points cross a
   * value inside a cell, those of cells at the face between two cells.
   *
   * Any other mode, such as vtkVolumeMapper::SLICE_BLEND, and more values are errors, and nothing
   * is drawn. Opaque geometry and the clipping range end rays in all modes, and cells whose scalar
   * is not finite count for nothing. ShadeOn() lights the volume and the surfaces. Gradient
   * opacity, shadows, scattering, ambient occlusion and OpacityLaw apply to COMPOSITE_BLEND only.
   * VIEW_ILLUMINATION and VIEW_GRADIENTS show the volume or the surfaces; in the other modes the
   * picture is drawn. All modes except COMPOSITE_BLEND are exact at each AccuracyLevel, apart from
   * rounding, the early end of rays behind surfaces, and the variation of the opacity function
   * between the entries of its table.
   */
  enum BlendModes
  {
    COMPOSITE_BLEND = 0,
    MAXIMUM_INTENSITY_BLEND = 1,
    MINIMUM_INTENSITY_BLEND = 2,
    AVERAGE_INTENSITY_BLEND = 3,
    ADDITIVE_BLEND = 4,
    ISOSURFACE_BLEND = 5
  };
  void SetBlendModeToMinimumIntensity() { this->SetBlendMode(MINIMUM_INTENSITY_BLEND); }
  void SetBlendModeToAverageIntensity() { this->SetBlendMode(AVERAGE_INTENSITY_BLEND); }
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToIsoSurface() { this->SetBlendMode(ISOSURFACE_BLEND); }
  const char* GetBlendModeAsString() const;
  //@}

  //@{
  /**
   * Range of the scalars that AVERAGE_INTENSITY_BLEND includes, ends included. Default: all,
   * VTK_FLOAT_MIN to VTK_FLOAT_MAX. A new range does not compile a shader.
   */
  vtkSetVector2Macro(AverageIPScalarRange, double);
  vtkGetVector2Macro(AverageIPScalarRange, double);
  //@}

  //@{
  /**
   * The drawn components of an array with several components. Names and numbers are those of
   * vtkSmartVolumeMapper; ALL_COMPONENTS is an addition. The transfer functions apply to the
   * result.
   * MAGNITUDE: the Euclidean norm of all components; not finite if one of them isn't.
   * COMPONENT: the component VectorComponent, from 0 (the default) to the number of components - 1.
   * A component that the array doesn't have is an error.
   * DISABLED, the default: determined by the colour function of component 0, as ParaView sets it:
   * the magnitude if its vector mode is vtkScalarsToColors::MAGNITUDE, else its vector component,
   * the first one by default. With a gray function: the first component. With
   * vtkVolumeProperty::IndependentComponentsOff(): all components, as below.
   * ALL_COMPONENTS: all of them together.
   * A single component is always drawn unchanged, with its sign.
   *
   * Components are independent, or dependent with vtkVolumeProperty::IndependentComponentsOff():
   * - 2 to 4 independent components fill the same space. Each has its own colour function, opacity
   *   function and scalar opacity unit distance (the methods of vtkVolumeProperty with an index;
   *   VTK's default functions range from 0 to 1024). Extinctions are added, and so are emissions,
   *   colour times extinction, as in vtkUnstructuredGridLinearRayIntegrator. SetComponentWeight(),
   *   0..1, is a factor of both; changing it requires no new tables. vtkGPUVolumeRayCastMapper has
   *   the same emission, but less absorption where components overlap.
   * - Of 2 dependent components the first gives the colour, the second the opacity.
   * - Of 4 dependent components three are red, green and blue, 0..255 in arrays of integers, else
   *   0..1, clamped. The fourth gives the opacity by the opacity function, in its own units: 0..255
   *   in arrays of unsigned char. vtkProjectedTetrahedraMapper uses it as the opacity, which
   *   corresponds to an opacity function from 0 at 0 to 1 at 255.
   *
   * Other numbers of components are errors. If one component is not finite, all count as not finite
   * (DrawNanCells). Several components need COMPOSITE_BLEND; other blend modes are errors. Light
   * and gradient opacity of dependent components use the gradient of the one that gives the
   * opacity; vtkGPUVolumeRayCastMapper uses the first one, and the last of 4 from VTK 9.4 on.
   * Independent components of meshes have no light: ShadeOn(), gradient opacity, VIEW_ILLUMINATION
   * and VIEW_GRADIENTS are errors. Those of a vtkTetMarchSmartVolumeMapper are lit by the gradient
   * of each, without shadows, and with the reflection of component 0. Picks use all components;
   * PickedScalar is the first of independent ones, and of dependent ones the one that gives the
   * opacity.
   */
  enum VectorModeType
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1,
    ALL_COMPONENTS = 2
  };
  vtkSetClampMacro(VectorMode, int, DISABLED, ALL_COMPONENTS);
  vtkGetMacro(VectorMode, int);
  void SetVectorModeToDisabled() { this->SetVectorMode(DISABLED); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  void SetVectorModeToAllComponents() { this->SetVectorMode(ALL_COMPONENTS); }
  const char* GetVectorModeAsString() const;
  vtkSetClampMacro(VectorComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(VectorComponent, int);
  //@}

  //@{
  /**
   * Cropping, with the names and the meaning of vtkVolumeMapper: two planes across each axis, in
   * the coordinates of the input's points, divide the volume into 27 regions. CroppingRegionFlags
   * has a bit for each region that is kept, x fastest, the lowest bit for the region below the
   * first planes. Off by default, with the planes 0, 1, 0, 1, 0, 1 and the flags
   * VTK_CROP_SUBVOLUME, the region in the middle. A region includes its lower planes. Cells are cut
   * where a plane crosses them. If a second plane isn't above the first one, or the flags are 0,
   * nothing is drawn, which is a warning. A plane that is NaN is an error.
   *
   * Clipping planes (AddClippingPlane(), SetClippingPlanes(); in world coordinates) cut cells
   * likewise. The side that the normal points to is kept. More than 32 planes are an error, and so
   * is a plane that isn't finite or whose normal is 0.
   *
   * Moving planes repeats no stage. The clipped part is not drawn, but still attenuates the light
   * on the rest, except that of headlights, which only the visible part attenuates. Views of the
   * boundary show all of it.
   */
  vtkSetClampMacro(Cropping, vtkTypeBool, 0, 1);
  vtkGetMacro(Cropping, vtkTypeBool);
  vtkBooleanMacro(Cropping, vtkTypeBool);
  vtkSetVector6Macro(CroppingRegionPlanes, double);
  vtkGetVectorMacro(CroppingRegionPlanes, double, 6);
  vtkSetClampMacro(CroppingRegionFlags, int, 0x0, 0x7ffffff);
  vtkGetMacro(CroppingRegionFlags, int);
  void SetCroppingRegionFlagsToSubVolume() { this->SetCroppingRegionFlags(VTK_CROP_SUBVOLUME); }
  void SetCroppingRegionFlagsToFence() { this->SetCroppingRegionFlags(VTK_CROP_FENCE); }
  void SetCroppingRegionFlagsToInvertedFence()
  {
    this->SetCroppingRegionFlags(VTK_CROP_INVERTED_FENCE);
  }
  void SetCroppingRegionFlagsToCross() { this->SetCroppingRegionFlags(VTK_CROP_CROSS); }
  void SetCroppingRegionFlagsToInvertedCross()
  {
    this->SetCroppingRegionFlags(VTK_CROP_INVERTED_CROSS);
  }
  //@}

  //@{
  /**
   * Pick at the centre of the pixel (x, y), counted from the lower left of the window: see
   * PickOpacityThreshold. This is a selection of that pixel by a vtkHardwareSelector, which renders
   * the window a few times without showing it. If the window has not rendered yet, a frame is drawn
   * first. Returns whether the volume is hit, before all other props that can be picked.
   *
   * If so, PickedPosition is the point in world coordinates, PickedScalar the scalar there (or of
   * the cell) in units of the data, PickedCellId the cell of the input, and PickedBlock the flat
   * index of its block, for composite input. The point is exact to a few float roundings of the
   * ray's length in its tetrahedron and of the size of the mesh. If not, they are NaN, NaN and -1.
   * PickedBlock is then 0, as it is if the input has no blocks.
   */
  bool Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y);
  vtkGetVector3Macro(PickedPosition, double);
  vtkGetMacro(PickedScalar, double);
  vtkGetMacro(PickedCellId, vtkIdType);
  vtkGetMacro(PickedBlock, unsigned int);
  //@}

  /**
   * The colours of view modes that show a measure: 256, from dark blue to pale yellow. They can be
   * changed. Each frame in such a mode sets the range and scale (linear or log10).
   */
  vtkLookupTable* GetViewLookupTable();

  //@{
  /**
   * RenderGroundTruth(): the picture of the last frame, computed on the CPU in double precision
   * with tables of up to 262144 entries. Errors are measured against it. `pixels` is filled as by
   * GetDiagnosticPixels(); `volume` is the one that was drawn; `tolerance`, the error allowed per
   * pixel in units of the full intensity, is greater than 0 and at most 1: a tolerance of 5e-5
   * takes a fraction of the time. Light and gradients are those of every point of a ray; their
   * error is estimated, and kept to 1/4096 or, if greater, `tolerance`.
   * CompareWithGroundTruth(): compute the same for
   * vtkTetMarchFrameStatistics::TRUE_ERROR of the last frame, which needs CollectDiagnostics on.
   * Both are slow: they invoke ProgressEvent, and an observer stops them by SetAbortExecute(1).
   * They return false if they were stopped, and, with an error, if there is no such frame.
   */
  bool RenderGroundTruth(vtkVolume* volume, vtkFloatArray* pixels, double tolerance = 1e-6);
  bool CompareWithGroundTruth(vtkVolume* volume);
  //@}

  //@{
  /**
   * Deprecated names of RenderGroundTruth() and CompareWithGroundTruth().
   */
  bool RenderReference(vtkVolume* volume, vtkFloatArray* pixels)
  {
    return this->RenderGroundTruth(volume, pixels);
  }
  bool CompareWithReference(vtkVolume* volume) { return this->CompareWithGroundTruth(volume); }
  //@}

  enum TraceArithmeticType
  {
    TRACE_FLOAT = 0,       // the arithmetic of the GPU, at the accuracy of the last frame
    TRACE_DOUBLE = 1,      // double precision, at the same accuracy
    TRACE_GROUND_TRUTH = 2 // as RenderGroundTruth()
  };
  /**
   * The ray of the last frame through a pixel (x, y), counted as in Pick(), marched again on the
   * CPU to find the cause of a wrong colour. Returns false, with an error, if there is no frame
   * with one ray per pixel, or the pixel is outside of it.
   *
   * `cells` gets a row for each tetrahedron on the ray, front to back. Its columns are CellId of
   * the input, or of its block, and Block, both as in Pick(); Tetrahedron; Enter and Leave, the
   * intersections with its faces, and Begin and End of the part within the ray's range, in world
   * units from the near plane; ScalarEnter and ScalarLeave, in units of the data (one number per
   * component; NaN if not finite); Opacity of that cell alone (NaN in blend modes without one);
   * Lookups of the segment integral in it; Color, premultiplied red, green, blue and opacity, and
   * ErrorBound, of a ray that ends behind it; EntersMesh, 1 if the ray enters through a boundary
   * face; and Outcome: "gathered", or the reason why the cell contributes nothing: "transparent",
   * "not finite", "hidden", "cropped", "out of range" (before the ray's begin, behind its end) or
   * "empty" (no length, inverted, or already integrated).
   *
   * Its field data describe the whole ray: Color, ErrorBound and Opaque (1 if it ended because it
   * was opaque) of the pixel; Origin on the near plane and Direction, in the world; Range of the
   * integration; ThicknessPerLength, in scalar opacity unit distances; and Lookups, RefusedEntries,
   * LostRays and GuardHits, the last three normally 0.
   */
  bool TraceRay(vtkVolume* volume, int x, int y, int arithmetic, vtkTable* cells);

  /**
   * The picture of the last frame with CollectDiagnostics on, before blending over the background:
   * one tuple per pixel of the viewport, rows from the bottom, premultiplied r, g, b and opacity in
   * 0..1, in float. Empty if there is none.
   */
  void GetDiagnosticPixels(vtkFloatArray* pixels) const;

protected:
  vtkTetMarchVolumeMapper();
  ~vtkTetMarchVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  double AverageIPScalarRange[2] = { VTK_FLOAT_MIN, VTK_FLOAT_MAX };
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  vtkTypeBool Cropping = 0;
  double CroppingRegionPlanes[6] = { 0, 1, 0, 1, 0, 1 };
  int CroppingRegionFlags = VTK_CROP_SUBVOLUME;
  double PickedPosition[3] = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
  double PickedScalar = vtkMath::Nan();
  vtkIdType PickedCellId = -1;
  unsigned int PickedBlock = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkTypeInt64 MaxVisitMemoryInBytes = vtkTypeInt64(1) << 30;

private:
  vtkTetMarchVolumeMapper(const vtkTetMarchVolumeMapper&) = delete;
  void operator=(const vtkTetMarchVolumeMapper&) = delete;

  class Internals;

  vtkDataSet* FindGrid(std::string& error, const std::function<bool(double)>& progress = {});
  std::string RenderInput(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  std::string RenderGrid(vtkDataSet* grid, std::string found, vtkOpenGLRenderWindow* window,
    vtkRenderer* renderer, vtkVolume* volume);
  double* GetOwnBounds();
  bool Report(const std::string& error); // whether there is none

  std::unique_ptr<Internals> Internal;
};

#endif
