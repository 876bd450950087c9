// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchSettings
 * @brief   How a mapper of TetMarch draws: accuracy, budgets, light, views, picks, ray distances
 *
 * Each mapper has settings of its own (vtkTetMarchVolumeMapper::GetSettings(),
 * vtkTetMarchSmartVolumeMapper::GetSettings()) and has all of their methods, too:
 * `mapper->SetErrorTolerance(x)` is `mapper->GetSettings()->SetErrorTolerance(x)`. Several mappers
 * can share one object (SetSettings()). A change modifies all of them.
 *
 * Which data is drawn, and which part of it, belongs to the mapper: its arrays, components,
 * blend mode, cropping and clipping planes.
 *
 * @sa vtkTetMarchVolumeMapper vtkTetMarchSmartVolumeMapper
 */
#ifndef vtkTetMarchSettings_h
#define vtkTetMarchSettings_h

#include "vtkObject.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchSettings : public vtkObject
{
public:
  static vtkTetMarchSettings* New();
  vtkTypeMacro(vtkTetMarchSettings, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // Groups begin with two slashes: after three, VTK 9.1 tells Python of their first method only.
  //@{
  /**
   * How the extinction coefficient follows from the opacity alpha of the transfer function and the
   * unit distance d of vtkVolumeProperty::GetScalarOpacityUnitDistance():
   * UNSTRUCTURED: alpha / d, as in VTK's mappers of unstructured grids; d is a length in the world.
   * The default, but for the own settings of a vtkTetMarchSmartVolumeMapper.
   * STRUCTURED: -ln(1 - alpha) / d, as in vtkGPUVolumeRayCastMapper: a slab of thickness d has the
   * opacity alpha. An alpha above 1 - 2^-24 is taken as 1 - 2^-24. d is a length in the data's own
   * coordinates: the scale of a vtkVolume makes it neither denser nor thinner.
   * What d is a length of holds for each blend mode, the formulas for COMPOSITE_BLEND only.
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
  const char* GetOpacityLawAsString() const;
  //@}

  //@{
  /**
   * Whether cells that touch a scalar that is not finite (NaN or infinite) are drawn. If a cell was
   * cut into tetrahedra, each of these counts alone. Such cells have the constant colour
   * vtkColorTransferFunction::GetNanColor() of component 0; GetNanOpacity() gives their extinction
   * as any opacity does. They have no gradient: they are drawn without light and without gradient
   * opacity, but they cast shadows. A gray function has no such colour. Off by default: rays pass
   * through these cells.
   */
  vtkSetMacro(DrawNanCells, bool);
  vtkGetMacro(DrawNanCells, bool);
  vtkBooleanMacro(DrawNanCells, bool);
  //@}

  //@{
  /**
   * How exactly the emission-absorption integral is evaluated along each ray. Optical depth is
   * exact at each level, however narrow a peak of the opacity function is: it is taken from
   * integrals of the transfer functions (Engel, Kraus and Ertl 2001, "High-quality pre-integrated
   * volume rendering using hardware-accelerated pixel shading"). The error comes from the order of
   * colours within a segment. In a segment of optical depth D whose colour varies by V in all, the
   * colour is off by V (1 - phi + phi ln(phi)) at most, where phi = (1 - exp(-D)) / D. For small D
   * this is V D^2 / 8.
   *
   * FAST: each cell is one segment, and a ray ends at a transmittance of 1/512. No error is
   * promised: colours are wrong where they change within cells of large optical depth. Cells of
   * images and rectilinear grids in which the scalar bends are cut evenly into up to eight segments
   * instead; their optical depth is nearly exact.
   * DEFAULT: segments are split until the pixel keeps ErrorTolerance. The end of the ray at a low
   * transmittance is part of that error.
   * ACCURATE: as DEFAULT, with a tolerance of 1/4096, or ErrorTolerance if that is less.
   * REFERENCE: as DEFAULT, with a tolerance of 1e-5, which is near the precision of float.
   * SAMPLED: nothing is integrated. Images and rectilinear grids are sampled at even distances
   * along each ray, for the look of vtkGPUVolumeRayCastMapper; the distance and jitter are those of
   * the vtkTetMarchSmartVolumeMapper. No error is promised or bounded. Blend modes other than
   * composite, picks and light kept at nodes stay as exact as at other levels. Unstructured grids
   * have no samples: for them this level is an error.
   *
   * The tolerance does not cover light: gradients and light are interpolated between vertices, and
   * their change along a cell is taken as linear. The error bound
   * (vtkTetMarchFrameStatistics::ERROR_BOUND) covers it.
   *
   * The tolerance holds for the picture in float. Two errors come on top: the window rounds (by up
   * to 1/510 with 8 bits), and transfer functions are linear between the entries of their tables.
   * FAST has tables of 1024 entries, the others of up to 65536: as many as the functions and the
   * tolerance need.
   */
  enum AccuracyLevelType
  {
    FAST = 0,
    DEFAULT = 1,
    ACCURATE = 2,
    REFERENCE = 3,
    SAMPLED = 4
  };
  vtkSetClampMacro(AccuracyLevel, int, FAST, SAMPLED);
  vtkGetMacro(AccuracyLevel, int);
  void SetAccuracyLevelToFast() { this->SetAccuracyLevel(FAST); }
  void SetAccuracyLevelToDefault() { this->SetAccuracyLevel(DEFAULT); }
  void SetAccuracyLevelToAccurate() { this->SetAccuracyLevel(ACCURATE); }
  void SetAccuracyLevelToReference() { this->SetAccuracyLevel(REFERENCE); }
  void SetAccuracyLevelToSampled() { this->SetAccuracyLevel(SAMPLED); }
  const char* GetAccuracyLevelAsString() const;
  //@}

  //@{
  /**
   * Largest error of each channel (r, g, b, opacity; 0..1) of a pixel, 1e-6..1. Default: 1/255. A
   * new value does not compile a shader.
   */
  vtkSetClampMacro(ErrorTolerance, double, 1e-6, 1.0);
  vtkGetMacro(ErrorTolerance, double);
  //@}

  //@{
  /**
   * Seconds that a frame may take (the mapper's GetTimeToDraw(), without diagnostics). 0, the
   * default: no budget. With a budget, AccuracyLevel and ErrorTolerance have no effect: each frame
   * is drawn with the best level that keeps the budget, judged by the times of past frames. From
   * cheapest to best the levels are FAST, DEFAULT with a tolerance of 1/32, DEFAULT with 1/255,
   * ACCURATE and REFERENCE. The first frame is drawn with FAST, and so are frames for which no
   * level keeps the budget.
   *
   * A better level is tried for one frame: at once if the present level takes at most half of the
   * budget, else after eight frames that kept it. The frame before compiles its shader and makes
   * its tables. The time of the trial is not known in advance, so that frame may break the budget.
   * A level that broke the budget is tried again when frames have become clearly faster, or when
   * data, transfer functions, the unit distance or the size of the picture have changed. The mapper
   * renders no frames by itself: the choice advances with the frames that the application renders.
   */
  vtkSetClampMacro(FrameTimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FrameTimeBudget, double);
  //@}

  //@{
  /**
   * Largest error of each channel of a pixel, 0..1. 0, the default: no budget. With a budget,
   * AccuracyLevel and ErrorTolerance have no effect: frames are drawn with the cheapest level that
   * promises this error, which is DEFAULT with this tolerance (1e-6 for budgets below 1e-6, which
   * are not kept). Together with FrameTimeBudget, that level is drawn however long it takes, and a
   * better one where the time budget allows it.
   */
  vtkSetClampMacro(ErrorBudget, double, 0.0, 1.0);
  vtkGetMacro(ErrorBudget, double);
  //@}

  //@{
  /**
   * Distance between rays in pixels of the window, 1..100, with the names of
   * vtkGPUVolumeRayCastMapper and vtkUnstructuredGridVolumeRayCastMapper. The picture is
   * interpolated between the rays.
   *
   * With AutoAdjustSampleDistances, on by default, the mapper chooses the distance so that the
   * frame keeps the render time that VTK allocates to the volume
   * (vtkRenderWindow::SetDesiredUpdateRate(), which interactors raise while the mouse is down). It
   * goes by the time of the last frame, from MinimumImageSampleDistance (default 1) to
   * MaximumImageSampleDistance (default 10). At rest, which is below one frame a second, it is
   * MinimumImageSampleDistance, however long a frame takes. When off, the distance is
   * ImageSampleDistance (default 1).
   *
   * There is one ray a pixel between translucent surfaces, with CollectDiagnostics, and in view
   * modes that draw a measure or the boundary. Frames with fewer rays don't count for
   * FrameTimeBudget.
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
  //@}

  //@{
  /**
   * Approximate limit of the time of one draw call, in seconds. 0: no limit. Default: 0.25, a
   * little more than the 0.2 between two abort checks of a window. A frame that may take longer,
   * judged by those before, is drawn in tiles of up to twice the limit. Between two tiles,
   * vtkRenderWindow::CheckAbortStatus() is called and progress is reported. A frame that is aborted
   * ends there; the next one is drawn from the start. The limit does not change the picture.
   */
  vtkSetClampMacro(MaxDrawTimeInSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaxDrawTimeInSeconds, double);
  //@}

  //@{
  /**
   * The shader stage in which rays are marched. The picture is the same. Pictures that
   * vtkDualDepthPeelingPass peels, picks and views of boundary faces are always made by fragments.
   * AUTOMATIC_STAGE, the default: compute on GPUs for data centres of which few units take
   * fragments, as the NVIDIA H100 and its successors (by GL_RENDERER), if they have OpenGL 4.3;
   * else fragments. FRAGMENT_STAGE: each ray is a fragment. COMPUTE_STAGE: each ray is an
   * invocation of a compute shader; an error where there is no OpenGL 4.3. It takes 16 bytes a
   * pixel for the picture, which is then blended over that of the window.
   */
  enum ShaderStageType
  {
    AUTOMATIC_STAGE = 0,
    FRAGMENT_STAGE = 1,
    COMPUTE_STAGE = 2
  };
  vtkSetClampMacro(ShaderStage, int, AUTOMATIC_STAGE, COMPUTE_STAGE);
  vtkGetMacro(ShaderStage, int);
  void SetShaderStageToAutomatic() { this->SetShaderStage(AUTOMATIC_STAGE); }
  void SetShaderStageToFragment() { this->SetShaderStage(FRAGMENT_STAGE); }
  void SetShaderStageToCompute() { this->SetShaderStage(COMPUTE_STAGE); }
  const char* GetShaderStageAsString() const;
  //@}

  //@{
  /**
   * Most bytes that the mesh, its scalars and the tables may take on the GPU. 0, the default: no
   * limit but the GL's. A larger mesh is refused with an error before memory for it is allocated
   * there, and before it is prepared if its number of cells alone is too large.
   *
   * The limit leaves out textures of the size of the picture (up to 28 bytes a pixel, 48 more with
   * CollectDiagnostics or a view mode) and what light needs (8 bytes a vertex for gradients, 24 for
   * shadows or occlusion, 1 for shadows of opaque geometry).
   */
  vtkSetClampMacro(MaxMemoryInBytes, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaxMemoryInBytes, vtkIdType);
  //@}

  //@{
  /**
   * What is drawn. VIEW_PICTURE, the default: the volume.
   *
   * Three modes draw a measure of each pixel in opaque colours. Pixels whose ray meets no cell keep
   * the background. vtkTetMarchLegend explains the colours, and the numbers are those of
   * vtkTetMarchFrameStatistics, with or without CollectDiagnostics.
   * VIEW_ERROR_BOUND: largest possible error of a channel of the picture, 0..1, logarithmic.
   * VIEW_CELLS: number of cells that the ray crossed (tetrahedra of an unstructured grid).
   * VIEW_LOOKUPS: number of lookups of the segment integral.
   *
   * Two modes draw the volume differently. VIEW_ILLUMINATION: the light without the colour of the
   * volume. VIEW_GRADIENTS: the directions of gradients as colours.
   *
   * Two modes draw the boundary of the mesh, opaque, where no opaque geometry hides it. No ray is
   * marched, and there are no diagnostics. VIEW_BOUNDARY_FACES: the boundary faces by which rays
   * enter, each in a random colour that is the same in all frames. VIEW_BOUNDARY_COORDINATES: the
   * barycentric coordinates of the entry point in its face, as red, green and blue. If a ray begins
   * within the mesh, at the near plane, its face is the last one before that plane by which the ray
   * entered. Images and rectilinear grids have no such faces: there these two modes are an error.
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
    VIEW_BOUNDARY_COORDINATES = 7
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
  const char* GetViewModeAsString() const;
  //@}

  //@{
  /**
   * The values of the first and the last colour in a view mode that draws a measure. Values beyond
   * have the same colours. AutomaticViewRange, on by default: round numbers about the values of
   * each frame, four decades of errors, counts from 0. When off: ViewRange (default: 1e-6, 1), for
   * pictures that are to be compared. Rendering is an error unless these are two finite numbers,
   * the first below the second, and above 0 for VIEW_ERROR_BOUND.
   */
  vtkSetMacro(AutomaticViewRange, bool);
  vtkGetMacro(AutomaticViewRange, bool);
  vtkBooleanMacro(AutomaticViewRange, bool);
  vtkSetVector2Macro(ViewRange, double);
  vtkGetVector2Macro(ViewRange, double);
  //@}

  //@{
  /**
   * The gradients that light and gradient opacity go by. VERTEX_GRADIENTS, the default: gradients
   * of the vertices, by least squares over their edges, interpolated in the cells.
   * CELL_GRADIENTS: for point scalars, the exact gradient of each cell, which looks faceted.
   *
   * With vtkVolumeProperty::ShadeOn(), the renderer's lights (headlights, camera lights and scene
   * lights; directional, point and spot lights) illuminate the surfaces of constant scalar with the
   * ambient, diffuse and specular coefficients and the specular power of the property (Phong 1975),
   * on both sides if vtkRenderer::GetTwoSidedLighting(). The ambient part is the ambient
   * coefficient times the colour of the volume, whatever the lights are; in this it differs from
   * vtkGPUVolumeRayCastMapper. The gradient opacity of the property (over the scalar's change per
   * unit of length in data coordinates) is a factor of the extinction, with and without shading.
   * Gradients and light are computed only if something needs them.
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
   * Shadows that a shaded volume casts into itself: the transmittance of the volume towards each
   * light. Lights whose vtkLight::GetShadowAttenuation() is 0 cast none.
   * SHADOWS_OFF, the default: no shadows.
   * SHADOWS_AT_VERTICES: rays are marched from each vertex to each light, when light, mesh, scalars
   * or transfer functions have changed. The transmittance is interpolated in the cells.
   * SHADOWS_ALONG_RAYS: rays are marched from points along each ray of the picture, in each frame.
   * SHADOWS_AUTOMATIC: the one of these two that has fewer points.
   *
   * Shadows of headlights need no rays: they go by the transmittance between the point and the eye.
   * Of the other lights, the first three cast shadows.
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
   * Whether opaque geometry of the renderer casts shadows into the volume, for lights other than
   * headlights that cast any (ShadowMethod, VolumetricScatteringBlending). Shadows reach as far as
   * GlobalIlluminationReach says; at 1 there is no limit. Off by default.
   *
   * Geometry means the polygons and triangle strips of actors that are visible, opaque and drawn as
   * surfaces, alone or in assemblies. Lines, points, translucent surfaces and clipping planes of
   * their mappers are ignored. The CPU casts rays from each vertex to each light when geometry, the
   * place of the volume or a light has changed. The result is interpolated in the cells, with
   * SHADOWS_ALONG_RAYS as well: the edge of a shadow is as wide as a cell, and geometry that is
   * narrower than a cell may cast no shadow.
   */
  vtkSetMacro(OpaqueShadows, bool);
  vtkGetMacro(OpaqueShadows, bool);
  vtkBooleanMacro(OpaqueShadows, bool);
  //@}

  //@{
  /**
   * Scattering in a shaded volume, with the name and the range of vtkGPUVolumeRayCastMapper from
   * VTK 9.2 on, 0..2, default 0. At 0 light is reflected by surfaces only. From 0 to 1 it is also
   * scattered where the volume has no clear surface; from 1 to 2 more and more everywhere. Above 0
   * the volume casts shadows, as if ShadowMethod were SHADOWS_AUTOMATIC where it is SHADOWS_OFF.
   */
  vtkSetClampMacro(VolumetricScatteringBlending, float, 0.0f, 2.0f);
  vtkGetMacro(VolumetricScatteringBlending, float);
  //@}

  //@{
  /**
   * How far rays for shadows are marched, 0..1, with the name of vtkGPUVolumeRayCastMapper: the
   * length d (1 - (1 - reach)^0.33), where d is the diagonal of the volume's bounding box. Default:
   * 1, the whole volume; VTK's default of 0 gives nearly no shadows there. Shadows of headlights
   * have no limit.
   */
  vtkSetClampMacro(GlobalIlluminationReach, float, 0.0f, 1.0f);
  vtkGetMacro(GlobalIlluminationReach, float);
  //@}

  //@{
  /**
   * Ambient occlusion of a shaded volume whose ambient coefficient is above 0. For each vertex it
   * is the mean transmittance in AmbientOcclusionDirections directions (1..256, default 16; the
   * same for all vertices) over the length AmbientOcclusionRadius, a share (0..1, default 0.1) of
   * the diagonal of the volume's bounding box. Off by default. The rays are marched when those of
   * SHADOWS_AT_VERTICES are.
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
   * Seconds of a frame that light at vertices may take while the user interacts (the desired update
   * rate of the window is 1 or more). Default: 0.1. New light is computed over as many frames as
   * that takes, and these frames show the old light, or no shadows if there is no old light. Frames
   * without interaction, and all frames if this is 0, wait for the new light.
   */
  vtkSetClampMacro(LightTimeBudget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LightTimeBudget, double);
  //@}

  //@{
  /**
   * Opacity at which a pick hits the volume or its isosurfaces, 0..1: the hit is the point at which
   * the ray has gathered this opacity. 0: the first visible point. 1: the point behind which float
   * has no transmittance left. Default: 0.5. A ray that gathers less hits nothing.
   *
   * Of a maximum or minimum intensity, the hit is the first point that has it (within 1e-6 of the
   * scalar range), if its opacity reaches the threshold. Of an average or a sum, it is the point up
   * to which this share has been gathered. What is clipped, cropped or hidden gathers no opacity.
   * Opaque geometry in front of the point hides it, and points before the near plane are not hit.
   *
   * A vtkHardwareSelector for cells reports, for each pixel of its area, the volume's prop and the
   * cell of the input around the hit; for composite input also the flat index of its block. For a
   * selector, rays end at translucent surfaces as well. A selector for points finds nothing of the
   * volume.
   */
  vtkSetClampMacro(PickOpacityThreshold, double, 0.0, 1.0);
  vtkGetMacro(PickOpacityThreshold, double);
  //@}

  //@{
  /**
   * Whether each frame is marched a second time by a variant of the shader that counts, for
   * vtkTetMarchFrameStatistics. Off by default.
   */
  vtkSetMacro(CollectDiagnostics, bool);
  vtkGetMacro(CollectDiagnostics, bool);
  vtkBooleanMacro(CollectDiagnostics, bool);
  //@}

protected:
  vtkTetMarchSettings();
  ~vtkTetMarchSettings() override;

  int OpacityLaw = UNSTRUCTURED;
  bool DrawNanCells = false;
  int AccuracyLevel = DEFAULT;
  double ErrorTolerance = 1.0 / 255.0;
  double FrameTimeBudget = 0;
  double ErrorBudget = 0;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1;
  double MinimumImageSampleDistance = 1;
  double MaximumImageSampleDistance = 10;
  double MaxDrawTimeInSeconds = 0.25;
  int ShaderStage = AUTOMATIC_STAGE;
  vtkIdType MaxMemoryInBytes = 0;
  int ViewMode = VIEW_PICTURE;
  bool AutomaticViewRange = true;
  double ViewRange[2] = { 1e-6, 1.0 };
  int GradientType = VERTEX_GRADIENTS;
  int ShadowMethod = SHADOWS_OFF;
  bool OpaqueShadows = false;
  float VolumetricScatteringBlending = 0;
  float GlobalIlluminationReach = 1;
  bool AmbientOcclusion = false;
  double AmbientOcclusionRadius = 0.1;
  int AmbientOcclusionDirections = 16;
  double LightTimeBudget = 0.1;
  double PickOpacityThreshold = 0.5;
  bool CollectDiagnostics = false;

private:
  vtkTetMarchSettings(const vtkTetMarchSettings&) = delete;
  void operator=(const vtkTetMarchSettings&) = delete;
};

#endif
