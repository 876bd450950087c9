// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchLegend
 * @brief   What the colours of a view mode of vtkTetMarchVolumeMapper mean
 *
 * A scalar bar that takes its title, colours, scale and range from the frame that the mapper drew
 * last. Add it to the renderer of the volume: it is drawn over the volume, after it, so that it is
 * never a frame late. It draws nothing if the last frame was not one of a view mode that shows a
 * measure, or met no part of the mesh. Place, size and text properties are those of every
 * vtkScalarBarActor.
 *
 * For its text, a program has to load VTK::RenderingFreeType (vtk_module_autoinit in CMake); the
 * Python package does.
 *
 * @sa vtkTetMarchVolumeMapper::SetViewMode
 */
#ifndef vtkTetMarchLegend_h
#define vtkTetMarchLegend_h

#include "vtkRenderingTetMarchModule.h" // For export macro
#include "vtkScalarBarActor.h"
#include "vtkWeakPointer.h" // For the mapper

class vtkTetMarchVolumeMapper;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchLegend : public vtkScalarBarActor
{
public:
  static vtkTetMarchLegend* New();
  vtkTypeMacro(vtkTetMarchLegend, vtkScalarBarActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The mapper that draws the views; none by default. It is not kept alive: once it is deleted,
   * there is none.
   */
  void SetMapper(vtkTetMarchVolumeMapper* mapper);
  vtkTetMarchVolumeMapper* GetMapper() const;
  //@}

  /**
   * Whether there is anything to explain: the last frame of the mapper showed a measure.
   */
  bool IsShown() const;

  //@{
  /**
   * Draw the bar over the volumes, if it is shown; nothing of it is opaque geometry.
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

  vtkWeakPointer<vtkTetMarchVolumeMapper> Mapper;
};

#endif
