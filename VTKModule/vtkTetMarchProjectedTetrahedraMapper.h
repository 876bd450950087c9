// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchProjectedTetrahedraMapper
 * @brief   A vtkProjectedTetrahedraMapper that draws by a vtkTetMarchVolumeMapper
 *
 * For code that creates a vtkProjectedTetrahedraMapper and cannot be changed:
 * vtkTetMarchObjectFactory creates this class instead. Each Render() passes the input, the choice
 * of scalars, the clipping planes and the blend mode to the marching mapper. Accuracy, light and
 * other settings are those of GetMarchingMapper(). The visibility sort is not used.
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
   * Render the volume by the marching mapper, and copy its TimeToDraw.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * Free all GL objects of the given window's context. The next Render() creates them again.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * The later of the times of this mapper and of the marching mapper.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Whether the window uses OpenGL. Its version is checked in the first frame.
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
