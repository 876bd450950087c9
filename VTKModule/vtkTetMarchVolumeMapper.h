// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchVolumeMapper
 * @brief   Volume rendering of unstructured grids by marching rays from tetrahedron to tetrahedron
 *
 * Put it where vtkProjectedTetrahedraMapper or vtkUnstructuredGridVolumeRayCastMapper stood. Each
 * ray enters the mesh through its rasterised boundary and steps from cell to cell by links between
 * faces, in a GLSL shader; nothing is sorted and nothing is resampled. Cells of every linear 3D
 * type are taken (tetrahedron, hexahedron, voxel, wedge, pyramid, pentagonal and hexagonal prism,
 * polyhedron), the quadratic ones by linear pieces; other cells are skipped with a warning that
 * counts them.
 *
 * Inside a tetrahedron the scalar is linear. Extinction and colour come from the
 * vtkVolumeProperty's scalar opacity, scalar opacity unit distance and colour (or gray) transfer
 * function of component 0; the emission-absorption integral of each ray segment is taken from local
 * integral tables and split until the pixel keeps its error tolerance. Shading and gradient opacity
 * come on top where the property asks for them; its interpolation type is not used.
 *
 * Point and cell scalars are taken, by ScalarMode and ArrayAccessMode as in every
 * vtkAbstractMapper, of every numeric type. Of an array with several components one is drawn, or
 * the magnitude (VectorMode). Cells that touch a scalar that is not finite are passed through and
 * not drawn, unless DrawNanCells is on.
 *
 * Cells whose vtkGhostType (of the cell data) says HIDDENCELL, DUPLICATECELL or REFINEDCELL, and
 * cells with a point that is a HIDDENPOINT by that of the point data, are passed through and absorb
 * no light. They count for the range of the scalars and for gradients, and the shell stays that of
 * all cells. An array of that name that is not of unsigned char, or hasn't a value for each, is
 * ignored. Another vtkGhostType leaves the mesh alone.
 *
 * Input is a vtkUnstructuredGrid or a tree of blocks (vtkMultiBlockDataSet, vtkPartitionedDataSet,
 * vtkPartitionedDataSetCollection; by SetInputConnection or SetInputDataObject). Blocks, whatever
 * data sets with 3D cells they are, are joined into one grid, so that rays go on from one to the
 * other: points of different blocks are one if they have the same global id, where all blocks have
 * global point ids, or else the same coordinates to the last bit. Points that meet with different
 * scalars have that of the first block in which they are no duplicates by vtkGhostType. Blocks
 * without the chosen array are left out with a warning that names them. The joined grid is made
 * when blocks have changed and takes memory beside them; GetInput() is null for composite input,
 * GetDataObjectInput() is not.
 *
 * The stages (mesh, scalars, transfer-function tables, camera) are redone only when their own input
 * changed; the Get...Builds() counters tell. A mesh is compared by the values of its points and
 * cells if it comes in other arrays, so that of a time series on one mesh only scalars are redone;
 * where the points of tetrahedra move, links between these are kept.
 *
 * Errors (no GL 3.2 context, ids out of range, mesh larger than the GL can hold, ...) are reported
 * once through vtkErrorMacro and leave the frame without this volume. A mesh that could not be
 * prepared is not tried again before the grid or a limit changes.
 *
 * @sa vtkProjectedTetrahedraMapper vtkUnstructuredGridVolumeRayCastMapper vtkVolumeProperty
 */
#ifndef vtkTetMarchVolumeMapper_h
#define vtkTetMarchVolumeMapper_h

#include "vtkMath.h"                    // For vtkMath::Nan
#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolumeMapper.h" // For VTK_CROP_SUBVOLUME

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkDataArray;
class vtkFloatArray;
class vtkLookupTable;
class vtkTable;
class vtkTetMarchFrameStatistics;
class vtkUnstructuredGrid;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchVolumeMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkTetMarchVolumeMapper* New();
  vtkTypeMacro(vtkTetMarchVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Render the volume into the renderer's viewport. Called by vtkVolume; several times a frame by
   * vtkDualDepthPeelingPass (vtkRenderer::UseDepthPeelingForVolumes), for parts of the picture that
   * lie between translucent surfaces. Then no diagnostics are collected, and VIEW_PICTURE takes the
   * place of the view modes that draw a measure or the shell. If the renderer has a selector, what
   * is drawn is what that reads: see PickOpacityThreshold.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  //@{
  /**
   * The box of the input's points; of composite input, of those of all blocks but surfaces
   * (vtkPolyData).
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  using Superclass::GetBounds;
  //@}

  /**
   * Free every GL object of the given window's context. The next Render() makes them anew.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // Groups begin with two slashes: after three, VTK 9.1 tells Python of their first method only.
  //@{
  /**
   * How the extinction coefficient (per unit of world length) follows from the opacity alpha of the
   * transfer function and d = vtkVolumeProperty::GetScalarOpacityUnitDistance():
   * UNSTRUCTURED: alpha / d, as VTK's unstructured grid mappers do (the default);
   * STRUCTURED: -ln(1 - alpha) / d, as vtkGPUVolumeRayCastMapper does, so that a slab of thickness
   * d has opacity alpha; alpha above 1 - 2^-24 is taken as 1 - 2^-24.
   */
  enum OpacityLawType
  {
    UNSTRUCTURED = 0,
    STRUCTURED = 1
  };
  vtkSetClampMacro(OpacityLaw, int, UNSTRUCTURED, STRUCTURED);
  vtkGetMacro(OpacityLaw, int);
  void SetOpacityLawToUnstructured() { this->SetOpacityLaw(UNSTRUCTURED); }
  void SetOpacityLawToStructured() { this->SetOpacityLaw(STRUCTURED); }
  //@}

  //@{
  /**
   * What is shown of the scalars along a ray (SetBlendMode(); the numbers are those of
   * vtkVolumeMapper::BlendModes). These are the exact limits, cell by cell, of what
   * vtkGPUVolumeRayCastMapper finds in samples:
   * COMPOSITE_BLEND: emission and absorption, the default.
   * MAXIMUM_INTENSITY_BLEND, MINIMUM_INTENSITY_BLEND: the greatest or least scalar, in its colour
   * and with its opacity as the opacity function has it: the unit distance plays no part.
   * AVERAGE_INTENSITY_BLEND: with s' = (s - min) / (max - min) of the range of the array, the mean
   * of opacity(s) s' over the part of the ray whose scalar lies in AverageIPScalarRange, as an
   * opaque gray; nothing where there is no such part.
   * ADDITIVE_BLEND: the integral of opacity(s) s' over the ray, in scalar opacity unit distances,
   * as an opaque gray of at most 1; nothing where the ray meets nothing.
   * ISOSURFACE_BLEND: the surfaces of the values of vtkVolumeProperty::GetIsoSurfaceValues(), at
   * most 32, each with its colour and opacity, composited front to back. Scalars of points cross a
   * value inside a cell, those of cells at the face between two cells.
   *
   * Any other mode, such as vtkVolumeMapper::SLICE_BLEND, and more values are errors, and nothing
   * is drawn. Only what opaque geometry and the clipping range leave of a ray counts, and cells
   * whose scalar is not finite count for nothing. ShadeOn() lights the volume and the surfaces;
   * gradient opacity, shadows, scattering, ambient occlusion and OpacityLaw are for COMPOSITE_BLEND
   * alone. The illumination and the gradients (ViewMode) are those of the volume or the surfaces;
   * in the modes that show scalars the picture is drawn instead. But for rounding, the early end of
   * rays behind surfaces, and what the opacity function does between the entries of its table,
   * these modes are exact at each AccuracyLevel.
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
   * What is drawn of an array with several components, with the names and numbers of
   * vtkSmartVolumeMapper, but for the last. The transfer functions apply to it.
   * MAGNITUDE: the length of the vector of all components; not finite if one of them isn't.
   * COMPONENT: component VectorComponent, 0 (the default) to the number of components - 1;
   * rendering one that the array doesn't have is an error.
   * DISABLED, the default: as component 0's colour function says, so that ParaView's "Magnitude",
   * "X", ... are followed: the magnitude with vtkScalarsToColors::MAGNITUDE, else its
   * VectorComponent, which by default is the first. It is the first, too, with a gray function.
   * With vtkVolumeProperty::IndependentComponentsOff() it is all components, as below.
   * ALL_COMPONENTS: all of them together.
   * A single component is always drawn as it is, its sign included.
   *
   * All components are independent, or dependent with
   * vtkVolumeProperty::IndependentComponentsOff():
   * - 2 to 4 independent ones fill the same space, each with the colour function, opacity function
   *   and scalar opacity unit distance of its number (vtkVolumeProperty's functions that take an
   *   index; VTK's default functions reach from 0 to 1024). Extinctions add, and so do emissions,
   *   colour times extinction, as in vtkUnstructuredGridLinearRayIntegrator; SetComponentWeight(),
   *   0..1, is a factor of both, and changing it makes no table anew. vtkGPUVolumeRayCastMapper
   *   emits the same, but where components meet it absorbs less than it emits.
   * - Of 2 dependent ones the first gives the colour, the second the opacity.
   * - Of 4 dependent ones three are red, green and blue: 0..255 in arrays of integers, else 0..1,
   *   clamped to that. The fourth gives the opacity, by the opacity function and so in its own
   *   units, 0..255 in arrays of unsigned char. vtkProjectedTetrahedraMapper takes it for the
   *   opacity itself, as an opacity function from 0 at 0 to 1 at 255 does here.
   *
   * Other numbers of components are errors. Where one component is not finite, all count as not
   * finite (DrawNanCells). Several components are drawn with COMPOSITE_BLEND alone: another
   * BlendMode is an error then. Light and gradient opacity go by the gradient of the dependent
   * component that gives the opacity; vtkGPUVolumeRayCastMapper takes that of the first one, and
   * from VTK 9.4 on of 4 that of the last one. Independent components are drawn without light:
   * ShadeOn(), a gradient opacity, VIEW_ILLUMINATION and VIEW_GRADIENTS are errors with them. Picks
   * go by all components; PickedScalar is the first of independent ones, and of dependent ones that
   * which gives the opacity.
   *
   * On a software renderer a frame of 4 dependent components takes 1.1 to 1.4 times as long as one
   * of a single scalar, of 2 dependent ones 1.6 to 2, of 2 independent ones 3 to 4, of 3 about 4 to
   * 7 and of 4 about 5 to 10 times. In the light of a sun, one of 2 dependent components takes 1.1
   * to 1.3 times as long as one of a single scalar in that light, of 4 as long.
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
   * Scalars of the data that AVERAGE_INTENSITY_BLEND takes, ends included; by default all:
   * VTK_FLOAT_MIN to VTK_FLOAT_MAX. Another range compiles no shader.
   */
  vtkSetVector2Macro(AverageIPScalarRange, double);
  vtkGetVector2Macro(AverageIPScalarRange, double);
  //@}

  //@{
  /**
   * Whether cells (of the tetrahedra that they are cut into, those) that touch a scalar that is not
   * finite, NaN or infinite, are drawn: evenly in vtkColorTransferFunction::GetNanColor() of
   * component 0, with the extinction that follows from GetNanOpacity() as from any opacity. Having
   * no gradient, they are drawn without light and whatever the gradient opacity is, but they cast
   * shadows. A gray function has no such colour. Off by default: they are passed through.
   */
  vtkSetMacro(DrawNanCells, bool);
  vtkGetMacro(DrawNanCells, bool);
  vtkBooleanMacro(DrawNanCells, bool);
  //@}

  //@{
  /**
   * How exactly the emission-absorption integral is taken along each ray. Optical depth is exact at
   * each level, however narrow a peak of the opacity function is: it comes from integrals of the
   * transfer functions (Engel, Kraus and Ertl 2001, "High-quality pre-integrated volume
   * rendering"). What is lost is the order of colours within a piece of a ray: a piece of optical
   * depth D in which the colour varies by V in all is off by V (1 - phi + phi ln(phi)) at most,
   * where phi = (1 - exp(-D)) / D; for thin pieces V D^2 / 8.
   *
   * FAST: a tetrahedron is one piece, and a ray ends at a transmittance of 1/512. Nothing is
   * promised; wrong where colours change in cells that are thick to the eye.
   * DEFAULT: pieces are split until a pixel keeps ErrorTolerance, the end of its ray included.
   * ACCURATE: the same with a tolerance of 1/4096, or ErrorTolerance if that is less.
   * REFERENCE: the same with 1e-5, about what float can tell.
   *
   * What light adds (gradients and light are interpolated between vertices, their change along a
   * cell is taken for linear) is not part of the tolerance; the error bound tells of it.
   *
   * The tolerance is of the picture in float, before the window rounds it (to 1/510 at most in 8
   * bits) and but for what transfer functions do between the entries of their tables. FAST has
   * tables of 1024 entries, the others of up to 65536, as many as the functions and the tolerance
   * ask for. On a software renderer, DEFAULT takes about as long as FAST, ACCURATE 1 to 1.4 times
   * as long, REFERENCE 1.5 to 5 times.
   */
  enum AccuracyLevelType
  {
    FAST = 0,
    DEFAULT = 1,
    ACCURATE = 2,
    REFERENCE = 3
  };
  vtkSetClampMacro(AccuracyLevel, int, FAST, REFERENCE);
  vtkGetMacro(AccuracyLevel, int);
  void SetAccuracyLevelToFast() { this->SetAccuracyLevel(FAST); }
  void SetAccuracyLevelToDefault() { this->SetAccuracyLevel(DEFAULT); }
  void SetAccuracyLevelToAccurate() { this->SetAccuracyLevel(ACCURATE); }
  void SetAccuracyLevelToReference() { this->SetAccuracyLevel(REFERENCE); }
  const char* GetAccuracyLevelAsString() const;
  //@}

  //@{
  /**
   * How much each channel (r, g, b, opacity; 0..1) of a pixel may be off by, 1e-6..1. Another value
   * compiles no shader. Default: 1/255.
   */
  vtkSetClampMacro(ErrorTolerance, double, 1e-6, 1.0);
  vtkGetMacro(ErrorTolerance, double);
  //@}

  //@{
  /**
   * Seconds that a frame may take (GetTimeToDraw(), without diagnostics); 0, the default: no
   * budget. With one, AccuracyLevel and ErrorTolerance are not used: each frame is drawn with the
   * best level that keeps the budget by what past frames took. From cheapest to best these are
   * FAST, DEFAULT with a tolerance of 1/32, DEFAULT with 1/255, ACCURATE and REFERENCE. It begins
   * with FAST, which also is used where no level keeps the budget.
   *
   * A better level is tried for a frame, after the one in which its shader is compiled or its
   * tables are made: at once if the present level takes at most half of the budget, else after it
   * has kept the budget for eight frames. How long that frame takes is not known before. REFERENCE
   * often takes 3 times as long as ACCURATE, the others up to 1.4 times as long as the one before.
   * A level that broke the budget is tried again when frames have become clearly faster, or data,
   * transfer functions, the unit distance or the size of the picture have changed. Frames are drawn
   * when somebody asks for them: choosing takes as many.
   */
  vtkSetClampMacro(FrameTimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FrameTimeBudget, double);
  //@}

  //@{
  /**
   * How far rays are apart, in pixels of the window, as in vtkGPUVolumeRayCastMapper and
   * vtkUnstructuredGridVolumeRayCastMapper; the picture is interpolated between them.
   *
   * AutoAdjustSampleDistances, on by default: as far as it takes to keep the render time that VTK
   * gives the volume (vtkRenderWindow::SetDesiredUpdateRate(), which interactors raise while the
   * mouse is down), by what the last frame took, within MinimumImageSampleDistance (default 1) and
   * MaximumImageSampleDistance (default 10). At rest there is time for all rays. Off:
   * ImageSampleDistance, default 1. All of them 1..100.
   *
   * Between translucent surfaces, with CollectDiagnostics and in view modes that draw a measure or
   * the shell there always is a ray a pixel. Frames with fewer don't count for FrameTimeBudget.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  vtkSetClampMacro(ImageSampleDistance, double, 1.0, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  vtkSetClampMacro(MinimumImageSampleDistance, double, 1.0, 100.0);
  vtkGetMacro(MinimumImageSampleDistance, double);
  vtkSetClampMacro(MaximumImageSampleDistance, double, 1.0, 100.0);
  vtkGetMacro(MaximumImageSampleDistance, double);
  /** That of the last frame. */
  double GetUsedImageSampleDistance() const;
  //@}

  //@{
  /**
   * How much each channel of a pixel may be off by, 0..1; 0, the default: no budget. With one,
   * AccuracyLevel and ErrorTolerance are not used: frames are drawn with the cheapest level that
   * promises it, DEFAULT with that tolerance (below 1e-6: with 1e-6, which does not keep it). With
   * FrameTimeBudget, too, that is the least that is drawn, however long it takes, and a better
   * level is used as far as time allows.
   */
  vtkSetClampMacro(ErrorBudget, double, 0.0, 1.0);
  vtkGetMacro(ErrorBudget, double);
  //@}

  //@{
  /**
   * The level and the tolerance that the last frame was drawn with, with a budget or without; a
   * tolerance of 0 is that of FAST, which promises nothing. Before the first frame DEFAULT and
   * 1/255.
   */
  int GetUsedAccuracyLevel() const;
  const char* GetUsedAccuracyLevelAsString() const;
  double GetUsedErrorTolerance() const;
  //@}

  /**
   * Whether the last frame was drawn to its end and kept the budgets that are set: by the time that
   * it took, whatever else was done in it, and by the tolerance that it was drawn with; with
   * CollectDiagnostics on, also by the bound of the error of its pixels.
   */
  bool IsBudgetKept() const;

  //@{
  /**
   * About how long a single draw call may take, in seconds; 0: no limit. A frame that takes longer,
   * by what the last one of the same size took, is drawn in tiles. Between two of them
   * vtkRenderWindow::CheckAbortStatus() is asked and progress is reported; a frame that is aborted
   * ends there, and the next one is drawn anew. The picture is the same to the last bit, whatever
   * the limit; a tile costs about a millisecond on a software renderer. Default: 0.25, a little
   * more than the 0.2 between two checks of a window.
   */
  vtkSetClampMacro(MaxDrawTimeInSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaxDrawTimeInSeconds, double);
  //@}

  //@{
  /**
   * Most bytes that the mesh, its scalars and the tables may take on the GPU; textures of the size
   * of the picture come on top (up to 28 bytes a pixel, 48 more with CollectDiagnostics or a view
   * mode), and what light needs (8 bytes a vertex for gradients, 24 more for shadows or occlusion,
   * 1 for shadows of opaque geometry). 0, the default: no limit but the GL's. A larger mesh is
   * refused with an error before anything of it is allocated there, and, if its cells alone tell,
   * before it is prepared.
   */
  vtkSetClampMacro(MaxMemoryInBytes, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaxMemoryInBytes, vtkIdType);
  //@}

  //@{
  /**
   * What is drawn. VIEW_PICTURE: the volume, the default.
   * Three modes draw a measure of each pixel in colours, opaque, and leave pixels whose ray met
   * nothing as they are; vtkTetMarchLegend says what the colours mean.
   * VIEW_ERROR_BOUND: how far each channel of the picture may be off, 0..1, on a logarithmic scale;
   * VIEW_CELLS: tetrahedra that the ray crossed; VIEW_LOOKUPS: lookups of the segment integral.
   * The numbers are those of vtkTetMarchFrameStatistics, which come with each such frame whether or
   * not CollectDiagnostics is on. The frame takes a march that counts instead of one that does not.
   * Two modes draw the volume otherwise: VIEW_ILLUMINATION the light without the volume's own
   * colour, VIEW_GRADIENTS the directions of gradients as colours.
   * Two modes draw the shell of the mesh, opaque, where it is seen before opaque geometry:
   * VIEW_BOUNDARY_FACES the boundary faces by which rays enter, each in a colour that is random but
   * always the same; VIEW_BOUNDARY_COORDINATES where in that face, as barycentric coordinates in
   * red, green and blue. Where the near plane lies in the mesh, that is the face behind it by which
   * the ray has entered the part that it begins in. Nothing is marched, so there are no
   * diagnostics.
   */
  enum ViewModeType
  {
    VIEW_PICTURE = 0,
    VIEW_ERROR_BOUND = 1,
    VIEW_CELLS = 2,
    VIEW_LOOKUPS = 3,
    VIEW_ILLUMINATION = 4,
    VIEW_GRADIENTS = 5,
    VIEW_BOUNDARY_FACES = 6,
    VIEW_BOUNDARY_COORDINATES = 7,
    VIEW_SHELL_FACES = VIEW_BOUNDARY_FACES,            // deprecated
    VIEW_SHELL_COORDINATES = VIEW_BOUNDARY_COORDINATES // deprecated
  };
  vtkSetClampMacro(ViewMode, int, VIEW_PICTURE, VIEW_BOUNDARY_COORDINATES);
  vtkGetMacro(ViewMode, int);
  void SetViewModeToPicture() { this->SetViewMode(VIEW_PICTURE); }
  void SetViewModeToErrorBound() { this->SetViewMode(VIEW_ERROR_BOUND); }
  void SetViewModeToCells() { this->SetViewMode(VIEW_CELLS); }
  void SetViewModeToLookups() { this->SetViewMode(VIEW_LOOKUPS); }
  void SetViewModeToIllumination() { this->SetViewMode(VIEW_ILLUMINATION); }
  void SetViewModeToGradients() { this->SetViewMode(VIEW_GRADIENTS); }
  void SetViewModeToBoundaryFaces() { this->SetViewMode(VIEW_BOUNDARY_FACES); }
  void SetViewModeToBoundaryCoordinates() { this->SetViewMode(VIEW_BOUNDARY_COORDINATES); }
  /** Deprecated: SetViewModeToBoundaryFaces(). */
  void SetViewModeToShellFaces() { this->SetViewModeToBoundaryFaces(); }
  /** Deprecated: SetViewModeToBoundaryCoordinates(). */
  void SetViewModeToShellCoordinates() { this->SetViewModeToBoundaryCoordinates(); }
  const char* GetViewModeAsString() const;
  //@}

  //@{
  /**
   * Which values have the first and the last colour in a view mode; those beyond have the same.
   * Automatic, the default: round numbers about the values of each frame, four decades of errors,
   * counts from 0. Otherwise ViewRange (default: 1e-6, 1), so that pictures can be compared: two
   * finite numbers, the first below the second and for VIEW_ERROR_BOUND above 0, else rendering is
   * an error.
   */
  vtkSetMacro(AutomaticViewRange, bool);
  vtkGetMacro(AutomaticViewRange, bool);
  vtkBooleanMacro(AutomaticViewRange, bool);
  vtkSetVector2Macro(ViewRange, double);
  vtkGetVector2Macro(ViewRange, double);
  //@}

  /**
   * The colours of the view modes, 256 from dark blue to pale yellow; others can be set. Range and
   * scale (linear or log10) are those of the last frame in a view mode, which sets them.
   */
  vtkLookupTable* GetViewLookupTable();

  //@{
  /**
   * Light. With vtkVolumeProperty::ShadeOn(), the renderer's lights (headlights, camera and scene
   * lights; directional, point and spot lights) shine on the surfaces of constant scalar, with the
   * property's ambient, diffuse, specular and specular power (Phong 1975), on both sides if
   * vtkRenderer::GetTwoSidedLighting(). Unlike vtkGPUVolumeRayCastMapper's, the ambient part is
   * ambient times the volume's colour whatever the lights are. The property's gradient opacity (of
   * scalar units per unit of length of the data's coordinates) is a factor of the extinction, lit
   * or not. Where there is nothing to light or no light, nothing of this is computed.
   *
   * Gradients are those of the vertices, by least squares over their edges, interpolated, the
   * default; or, for point scalars, exactly those of each cell, which look faceted.
   */
  enum GradientTypes
  {
    VERTEX_GRADIENTS = 0,
    CELL_GRADIENTS = 1
  };
  vtkSetClampMacro(GradientType, int, VERTEX_GRADIENTS, CELL_GRADIENTS);
  vtkGetMacro(GradientType, int);
  void SetGradientTypeToVertex() { this->SetGradientType(VERTEX_GRADIENTS); }
  void SetGradientTypeToCell() { this->SetGradientType(CELL_GRADIENTS); }
  const char* GetGradientTypeAsString() const;
  //@}

  //@{
  /**
   * Shadows that the volume casts in itself, if it is shaded: how much of each light comes through
   * it, but for lights whose vtkLight::GetShadowAttenuation() is 0.
   * SHADOWS_OFF: all light comes, the default.
   * SHADOWS_AT_VERTICES: rays are marched from each vertex towards each light when light, mesh,
   * scalars or transfer functions changed; what comes is interpolated in the cells.
   * SHADOWS_ALONG_RAYS: rays are marched from points along each ray of the picture, in every frame.
   * SHADOWS_AUTOMATIC: at vertices, unless these are more than all points along rays would be.
   * Headlights need no rays: what is between a point and the eye is known. At most three other
   * lights cast shadows, the first ones.
   */
  enum ShadowMethods
  {
    SHADOWS_OFF = 0,
    SHADOWS_AUTOMATIC = 1,
    SHADOWS_AT_VERTICES = 2,
    SHADOWS_ALONG_RAYS = 3
  };
  vtkSetClampMacro(ShadowMethod, int, SHADOWS_OFF, SHADOWS_ALONG_RAYS);
  vtkGetMacro(ShadowMethod, int);
  void SetShadowMethodToOff() { this->SetShadowMethod(SHADOWS_OFF); }
  void SetShadowMethodToAutomatic() { this->SetShadowMethod(SHADOWS_AUTOMATIC); }
  void SetShadowMethodToAtVertices() { this->SetShadowMethod(SHADOWS_AT_VERTICES); }
  void SetShadowMethodToAlongRays() { this->SetShadowMethod(SHADOWS_ALONG_RAYS); }
  const char* GetShadowMethodAsString() const;
  //@}

  //@{
  /**
   * Whether opaque geometry of the renderer casts shadows into the volume, too, where lights other
   * than headlights cast any (ShadowMethod, VolumetricScatteringBlending) and as far as
   * GlobalIlluminationReach says, at 1 however far. Off by default.
   *
   * Geometry is the polygons and triangle strips of actors that are visible, opaque and drawn as
   * surfaces, alone or in assemblies; lines, points, translucent surfaces and mappers' clipping
   * planes are left out. Rays are cast by the CPU, from each vertex to each of the lights, when
   * geometry, the volume's place or a light has changed; a moved actor keeps its search tree. What
   * they find is interpolated in the cells, with SHADOWS_ALONG_RAYS as well: the edge of a shadow
   * is as sharp as the cells are small, and what is narrower than a cell may cast none.
   */
  vtkSetMacro(OpaqueShadows, bool);
  vtkGetMacro(OpaqueShadows, bool);
  vtkBooleanMacro(OpaqueShadows, bool);
  //@}

  //@{
  /**
   * The scattering look of vtkGPUVolumeRayCastMapper from VTK 9.2 on, with its names and ranges, if
   * the volume is shaded. VolumetricScatteringBlending, 0..2, default 0: 0 lights surfaces only; up
   * to 1 light is scattered where the volume has no clear surface, from there to 2 more and more
   * everywhere, without regard to surfaces. Above 0 the volume casts shadows (with ShadowMethod at
   * SHADOWS_OFF as if it were SHADOWS_AUTOMATIC), on its surfaces as well.
   *
   * GlobalIlluminationReach, 0..1: how far light is followed for shadows, from nowhere to through
   * all of the volume: d (1 - (1 - reach)^0.33), d being the diagonal of its bounding box. The
   * default is 1; in VTK it is 0, which there means nearly nothing. Shadows of headlights have no
   * such limit.
   */
  vtkSetClampMacro(VolumetricScatteringBlending, float, 0.0f, 2.0f);
  vtkGetMacro(VolumetricScatteringBlending, float);
  vtkSetClampMacro(GlobalIlluminationReach, float, 0.0f, 1.0f);
  vtkGetMacro(GlobalIlluminationReach, float);
  //@}

  //@{
  /**
   * Ambient occlusion, if the volume is shaded and its property's ambient is above 0: at each
   * vertex, how much ambient light comes through the volume from AmbientOcclusionDirections
   * (1..256, default 16) directions, the same for all, over AmbientOcclusionRadius, a share (0..1,
   * default 0.1) of the diagonal of its bounding box. Off by default. Marched once, like
   * SHADOWS_AT_VERTICES.
   */
  vtkSetMacro(AmbientOcclusion, bool);
  vtkGetMacro(AmbientOcclusion, bool);
  vtkBooleanMacro(AmbientOcclusion, bool);
  vtkSetClampMacro(AmbientOcclusionRadius, double, 0.0, 1.0);
  vtkGetMacro(AmbientOcclusionRadius, double);
  vtkSetClampMacro(AmbientOcclusionDirections, int, 1, 256);
  vtkGetMacro(AmbientOcclusionDirections, int);
  //@}

  //@{
  /**
   * Seconds that light at vertices may take of a frame while the user interacts (the window's
   * desired update rate is 1 or more), so that a light can be moved without waiting; default 0.1.
   * Until all of it is made anew, over several frames, that of before is shown, or none is kept off
   * if there was none. A still frame waits for all of it, as do all frames with 0.
   */
  vtkSetClampMacro(LightTimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LightTimeBudget, double);
  //@}

  //@{
  /**
   * Picking. A ray hits the volume, or its isosurfaces, where the opacity that it has gathered
   * reaches PickOpacityThreshold, 0..1: 0 is the first point at which anything is seen, 1 one
   * behind which a float has nothing left to see. The default, 0.5, is a point before and behind
   * which as much is seen; what is fainter in all is not hit. Of a maximum or a minimum the first
   * point is hit that has it (within 1e-6 of the scalars' range), if the opacity there is the
   * threshold; of an average or a sum the point up to which that share of it has been gathered.
   * What is clipped, cropped or hidden gathers nothing. Where opaque geometry comes first, nothing
   * of the volume is hit, nor before the near plane.
   *
   * A vtkHardwareSelector for cells then tells the volume's prop and the cells of the input around
   * those points, one a pixel of its area; of composite input, the blocks by their flat indices and
   * the cells of these. In that, rays end at translucent surfaces as well. One for points finds
   * nothing of the volume.
   */
  vtkSetClampMacro(PickOpacityThreshold, double, 0.0, 1.0);
  vtkGetMacro(PickOpacityThreshold, double);
  //@}

  //@{
  /**
   * Look what is hit in the middle of a pixel (x, y), counted from the lower left of the window; as
   * by a selector of that pixel, which renders the window a few times, but shows none of it. If the
   * window has not rendered yet, a frame is drawn before. Returns whether the volume is hit, before
   * all other props that can be picked.
   *
   * If so, PickedPosition is the point, in world coordinates; PickedScalar the scalar there, or of
   * the cell, in units of the data; and PickedCellId the cell of the input, or, of composite input,
   * of the block whose flat index is PickedBlock. The point is exact to a few roundings of float,
   * of the ray's way through a tetrahedron and of the mesh's size. If not, they are NaN and -1; the
   * block is 0 then, and where there are none.
   */
  bool Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y);
  vtkGetVector3Macro(PickedPosition, double);
  vtkGetMacro(PickedScalar, double);
  vtkGetMacro(PickedCellId, vtkIdType);
  vtkGetMacro(PickedBlock, unsigned int);
  //@}

  /**
   * Whether the last frame showed all light as it is now; if not, further frames will.
   */
  bool IsLightComplete() const;

  //@{
  /**
   * Cropping, with the names and the meaning that it has in vtkVolumeMapper: two planes across each
   * axis, in the coordinates of the input's points, divide the volume into 27 regions, and
   * CroppingRegionFlags has a bit for each that is left, x fastest, from the lowest bit on, for
   * those below the first planes. Off by default; planes 0, 1, 0, 1, 0, 1; flags
   * VTK_CROP_SUBVOLUME, the region in the middle. A region begins at its lower planes, and cells
   * are cut where a plane goes through them. Nothing is drawn, without an error, while a second
   * plane isn't above the first one, or the flags are 0; a plane that is NaN is an error.
   *
   * Clipping planes (AddClippingPlane(), SetClippingPlanes(); in world coordinates) cut cells
   * likewise; what is on the side that the normal points to is left. Up to 32 can be used, more are
   * an error, and so is one whose normal is 0 or that isn't finite.
   *
   * Planes can be moved from frame to frame: nothing is redone. A box of regions is cut as fast as
   * by clipping planes, others take up to twice as long. What is cut away isn't seen but is still
   * there: it keeps light off the rest as before (but for that of headlights, which comes as far as
   * one sees), and views of the shell show all of it.
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

  /**
   * In how many draw calls the last frame was marched, up to where it ended if it was aborted; 0 if
   * nothing was drawn.
   */
  int GetNumberOfDraws() const;

  //@{
  /**
   * Figures of the mesh as it was prepared for the last frame; 0 before the first.
   */
  vtkIdType GetNumberOfTetrahedra() const;
  vtkIdType GetNumberOfBoundaryFaces() const;
  //@}

  /**
   * Bytes of the buffers and textures that this mapper holds on the GPU.
   */
  vtkTypeInt64 GetGPUMemoryBytes() const;

  //@{
  /**
   * Seconds that each stage took when it last ran: joining the blocks of composite input, mesh
   * (decomposition, links, boundary), scalars, transfer-function tables, gradients, shadows of
   * opaque geometry, light at vertices, upload to the GPU.
   */
  double GetBlocksSeconds() const;
  double GetMeshSeconds() const;
  double GetScalarsSeconds() const;
  double GetTablesSeconds() const;
  double GetGradientsSeconds() const;
  double GetOpaqueShadowsSeconds() const;
  double GetVertexLightSeconds() const;
  double GetUploadSeconds() const;
  //@}

  //@{
  /**
   * How often each stage ran since the mapper was created. A camera move raises none of them, an
   * edit of the transfer functions only the tables, new scalars on the same mesh only the scalars.
   */
  vtkTypeInt64 GetBlocksBuilds() const;
  vtkTypeInt64 GetMeshBuilds() const;
  vtkTypeInt64 GetScalarsBuilds() const;
  vtkTypeInt64 GetTablesBuilds() const;
  vtkTypeInt64 GetGradientsBuilds() const;
  vtkTypeInt64 GetOpaqueShadowsBuilds() const;
  vtkTypeInt64 GetVertexLightBuilds() const;
  vtkTypeInt64 GetUploadedBytes() const;
  //@}

  //@{
  /**
   * When on, each frame is marched a second time by a diagnostic variant of the shader that counts,
   * and the sums are read back. Costs more than a frame; off by default.
   */
  vtkSetMacro(CollectDiagnostics, bool);
  vtkGetMacro(CollectDiagnostics, bool);
  vtkBooleanMacro(CollectDiagnostics, bool);
  //@}

  //@{
  /**
   * Sums over the pixels of the last frame with CollectDiagnostics on, or with a view mode: rays
   * that entered the mesh,
   * cells crossed, lookups of the segment integral, rays that enter another face than the
   * rasteriser named, so that a search had to find it (a few in ten thousand), rays that came to a
   * face without exit (lost) and rays stopped by the step guard. The last two are 0 unless
   * something is wrong.
   */
  vtkTypeInt64 GetNumberOfRays() const;
  vtkTypeInt64 GetNumberOfCrossedCells() const;
  vtkTypeInt64 GetNumberOfLookups() const;
  /** Deprecated: GetNumberOfLookups(). */
  vtkTypeInt64 GetNumberOfEvaluations() const { return this->GetNumberOfLookups(); }
  vtkTypeInt64 GetNumberOfRefusedEntries() const;
  vtkTypeInt64 GetNumberOfLostRays() const;
  vtkTypeInt64 GetNumberOfGuardHits() const;
  //@}

  /**
   * What the pixels of the last frame cost and by how much they may be off, if CollectDiagnostics
   * was on or ViewMode was one that draws a measure; empty otherwise, and where the shell was
   * drawn. The object stays the same from frame to frame.
   */
  vtkTetMarchFrameStatistics* GetLastFrameStatistics();

  //@{
  /**
   * The picture of the last frame by the CPU in double precision, with a tolerance of 1e-6 and
   * tables of up to 262144 entries: the yardstick of all our figures of accuracy. As
   * GetDiagnosticPixels(); `volume` is the one that was drawn. Takes seconds to minutes.
   * CompareWithGroundTruth() makes it, too, and adds vtkTetMarchFrameStatistics::TRUE_ERROR to the
   * last frame's statistics; that wants CollectDiagnostics on. Both return false, with an error, if
   * there is no such frame.
   */
  bool RenderGroundTruth(vtkVolume* volume, vtkFloatArray* pixels);
  bool CompareWithGroundTruth(vtkVolume* volume);
  /** Deprecated: RenderGroundTruth(). */
  bool RenderReference(vtkVolume* volume, vtkFloatArray* pixels)
  {
    return this->RenderGroundTruth(volume, pixels);
  }
  /** Deprecated: CompareWithGroundTruth(). */
  bool CompareWithReference(vtkVolume* volume) { return this->CompareWithGroundTruth(volume); }
  //@}

  enum TraceArithmeticType
  {
    TRACE_FLOAT = 0,       // the arithmetic of the GPU, at the accuracy of the last frame
    TRACE_DOUBLE = 1,      // double precision, at the same accuracy
    TRACE_GROUND_TRUTH = 2 // as RenderGroundTruth()
  };
  /**
   * The ray of the last frame through a pixel (x, y), counted as in Pick(), marched once more on
   * the CPU: where to look when a pixel has a wrong colour. Returns false, with an error, if there
   * is no frame with a ray a pixel, or the pixel is outside of it.
   *
   * `cells` gets a row for each tetrahedron that the ray passes, front to back. Its columns are
   * CellId of the input, or of its block, and Block, both as in Pick(); Tetrahedron; Enter and
   * Leave, where the ray crosses its faces, and Begin and End of the part of that within the ray's
   * range, in world units from the near plane; ScalarEnter and ScalarLeave, in units of the data
   * (of several components as many; NaN if not finite); Opacity of that cell alone (NaN in blend
   * modes without one); Lookups of the segment integral in it; Color, premultiplied red, green,
   * blue and opacity, and ErrorBound, of a ray that ends behind it; EntersMesh, 1 if the ray comes
   * in by a boundary face; and Outcome: "gathered", or why nothing was: "transparent", "not
   * finite", "hidden", "cropped", "out of range" (before the ray's begin, behind its end) or
   * "empty" (no length, inverted, or passed already).
   *
   * Its field data has what holds for all of the ray: Color, ErrorBound and Opaque (1 if it ended
   * because too little came through) of the pixel; Origin on the near plane and Direction, in the
   * world; Range, between which something is gathered; ThicknessPerLength, in scalar opacity unit
   * distances; and Lookups, RefusedEntries, LostRays and GuardHits, the last three 0 unless
   * something is wrong.
   */
  bool TraceRay(vtkVolume* volume, int x, int y, int arithmetic, vtkTable* cells);

  /**
   * The picture of the last frame with CollectDiagnostics on, before it was blended over the
   * background: one tuple a pixel of the viewport, rows from the bottom, premultiplied r, g, b and
   * opacity in 0..1, in float. Empty if there is none.
   */
  void GetDiagnosticPixels(vtkFloatArray* pixels) const;

protected:
  vtkTetMarchVolumeMapper();
  ~vtkTetMarchVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  double AverageIPScalarRange[2] = { VTK_FLOAT_MIN, VTK_FLOAT_MAX };
  int OpacityLaw = UNSTRUCTURED;
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  bool DrawNanCells = false;
  int AccuracyLevel = DEFAULT;
  double ErrorTolerance = 1.0 / 255.0;
  double FrameTimeBudget = 0;
  double ErrorBudget = 0;
  double MaxDrawTimeInSeconds = 0.25;
  int ViewMode = VIEW_PICTURE;
  bool AutomaticViewRange = true;
  double ViewRange[2] = { 1e-6, 1.0 };
  vtkIdType MaxMemoryInBytes = 0;
  bool CollectDiagnostics = false;
  int GradientType = VERTEX_GRADIENTS;
  int ShadowMethod = SHADOWS_OFF;
  bool OpaqueShadows = false;
  float VolumetricScatteringBlending = 0;
  float GlobalIlluminationReach = 1;
  bool AmbientOcclusion = false;
  double AmbientOcclusionRadius = 0.1;
  int AmbientOcclusionDirections = 16;
  double LightTimeBudget = 0.1;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1;
  double MinimumImageSampleDistance = 1;
  double MaximumImageSampleDistance = 10;
  vtkTypeBool Cropping = 0;
  double CroppingRegionPlanes[6] = { 0, 1, 0, 1, 0, 1 };
  int CroppingRegionFlags = VTK_CROP_SUBVOLUME;
  double PickOpacityThreshold = 0.5;
  double PickedPosition[3] = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
  double PickedScalar = vtkMath::Nan();
  vtkIdType PickedCellId = -1;
  unsigned int PickedBlock = 0;

private:
  vtkTetMarchVolumeMapper(const vtkTetMarchVolumeMapper&) = delete;
  void operator=(const vtkTetMarchVolumeMapper&) = delete;

  vtkUnstructuredGrid* FindGrid();
  vtkDataArray* FindScalars(vtkUnstructuredGrid* grid, int& cellFlag);
  void ReportError(const std::string& error);
  void ReportMesh();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
