// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchLegend
 * @brief   Scalar bar for the view modes that draw a measure
 *
 * Its title, colours, scale and range are those of the last frame of a vtkTetMarchVolumeMapper or a
 * vtkTetMarchSmartVolumeMapper. Add the legend to the renderer of the volume. It is drawn after the
 * volume, and so shows the same frame. It draws nothing if the last frame drew no measure, or if no
 * ray met a cell. Position, size and text properties are those of vtkScalarBarActor.
 *
 * Its text needs VTK::RenderingFreeType: a C++ program must list it in vtk_module_autoinit(); the
 * Python package loads it.
 *
 * @sa vtkTetMarchSettings::SetViewMode
 */
#ifndef vtkTetMarchLegend_h
#define vtkTetMarchLegend_h

#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkScalarBarActor.h"
#include "vtkWeakPointer.h" // For the mapper

class vtkAbstractVolumeMapper;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchLegend : public vtkScalarBarActor
{
public:
  static vtkTetMarchLegend* New();
  vtkTypeMacro(vtkTetMarchLegend, vtkScalarBarActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The mapper that draws the view, of one of these two classes; null by default. For other classes
   * there is no legend. The legend holds a weak reference.
   */
  void SetMapper(vtkAbstractVolumeMapper* mapper);
  vtkAbstractVolumeMapper* GetMapper() const;
  //@}

  /**
   * Whether the legend is drawn: the last frame of the mapper drew a measure.
   */
  bool IsShown() const;

  //@{
  /**
   * Draw the bar over the volumes if IsShown(). It has no opaque geometry.
   */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  vtkTypeBool HasOpaqueGeometry() override;
  //@}

protected:
  vtkTetMarchLegend();
  ~vtkTetMarchLegend() override;

private:
  vtkTetMarchLegend(const vtkTetMarchLegend&) = delete;
  void operator=(const vtkTetMarchLegend&) = delete;

  vtkWeakPointer<vtkAbstractVolumeMapper> Mapper;
};

#endif
