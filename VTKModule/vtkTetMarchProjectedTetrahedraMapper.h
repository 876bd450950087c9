// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchProjectedTetrahedraMapper
 * @brief   A vtkProjectedTetrahedraMapper that is none: vtkTetMarchVolumeMapper draws
 *
 * For code that creates a vtkProjectedTetrahedraMapper and is not to be changed;
 * vtkTetMarchObjectFactory puts it in that one's place. What was set of scalars, clipping planes
 * and blend mode is what the marching mapper gets in each Render(); its own properties, such as
 * accuracy and light, are set at GetMarchingMapper(). The visibility sort has no use.
 *
 * @sa vtkTetMarchObjectFactory vtkTetMarchVolumeMapper
 */
#ifndef vtkTetMarchProjectedTetrahedraMapper_h
#define vtkTetMarchProjectedTetrahedraMapper_h

#include "vtkNew.h" // For vtkNew
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

class vtkTetMarchVolumeMapper;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchProjectedTetrahedraMapper
  : public vtkProjectedTetrahedraMapper
{
public:
  static vtkTetMarchProjectedTetrahedraMapper* New();
  vtkTypeMacro(vtkTetMarchProjectedTetrahedraMapper, vtkProjectedTetrahedraMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Render the volume as vtkTetMarchVolumeMapper does, and take over the time that it took.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * Free every GL object of the given window's context. The next Render() makes them anew.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Also that of the marching mapper, whose properties change what is drawn.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Whether the window draws by OpenGL; whether its version will do is known in the first frame.
   */
  bool IsSupported(vtkRenderWindow* window) override;

  /**
   * The mapper that draws. Its input, scalars, clipping planes and blend mode are those of this
   * one.
   */
  vtkTetMarchVolumeMapper* GetMarchingMapper();

protected:
  vtkTetMarchProjectedTetrahedraMapper();
  ~vtkTetMarchProjectedTetrahedraMapper() override;

private:
  vtkTetMarchProjectedTetrahedraMapper(const vtkTetMarchProjectedTetrahedraMapper&) = delete;
  void operator=(const vtkTetMarchProjectedTetrahedraMapper&) = delete;

  void ForwardEvent(vtkObject* from, unsigned long event, void* data);

  vtkNew<vtkTetMarchVolumeMapper> Marching;
};

#endif
