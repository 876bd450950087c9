// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchVolumeRepresentation
 * @brief   ParaView's volume representation of unstructured grids, drawn by vtkTetMarchVolumeMapper
 *
 * Everything but the mapper is the superclass's. The grid reaches the mapper with its cells as they
 * are: the superclass would cut them into tetrahedra, without care for neighbours. A view mode
 * brings its legend into the view, in the process that draws.
 */
#ifndef vtkTetMarchVolumeRepresentation_h
#define vtkTetMarchVolumeRepresentation_h

#include "vtkTetMarchRepresentationModule.h" // For export macro
#include "vtkUnstructuredGridVolumeRepresentation.h"

class vtkTetMarchLegend;
class vtkTetMarchVolumeMapper;

class VTKTETMARCHREPRESENTATION_EXPORT vtkTetMarchVolumeRepresentation
  : public vtkUnstructuredGridVolumeRepresentation
{
public:
  static vtkTetMarchVolumeRepresentation* New();
  vtkTypeMacro(vtkTetMarchVolumeRepresentation, vtkUnstructuredGridVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * @sa vtkTetMarchVolumeMapper
   */
  void SetOpacityLaw(int law);
  void SetDrawNanCells(bool draw);
  void SetAccuracyLevel(int level);
  void SetErrorTolerance(double tolerance);
  void SetFrameTimeBudget(double seconds);
  void SetErrorBudget(double error);
  void SetViewMode(int mode);
  void SetAutomaticViewRange(bool automatic);
  void SetViewRange(double low, double high);
  void SetGradientType(int type);
  void SetShadowMethod(int method);
  void SetOpaqueShadows(bool shadows);
  void SetVolumetricScatteringBlending(double blending);
  void SetGlobalIlluminationReach(double reach);
  void SetAmbientOcclusion(bool occlusion);
  void SetAmbientOcclusionRadius(double radius);
  void SetAmbientOcclusionDirections(int directions);
  //@}

  //@{
  /**
   * @sa vtkVolumeProperty
   */
  void SetShade(bool shade);
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  //@}

  /**
   * The legend is seen with the volume only.
   */
  void SetVisibility(bool visible) override;

protected:
  vtkTetMarchVolumeRepresentation();
  ~vtkTetMarchVolumeRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkTetMarchVolumeRepresentation(const vtkTetMarchVolumeRepresentation&) = delete;
  void operator=(const vtkTetMarchVolumeRepresentation&) = delete;

  vtkNew<vtkTetMarchVolumeMapper> TetMarchMapper;
  vtkNew<vtkTetMarchLegend> Legend;
};

#endif
