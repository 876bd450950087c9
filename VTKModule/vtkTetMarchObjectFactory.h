// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchObjectFactory
 * @brief   Creates mappers of TetMarch in place of VTK's
 *
 * Off by default. After SetReplacesProjectedTetrahedra(true), vtkProjectedTetrahedraMapper::New()
 * returns a vtkTetMarchProjectedTetrahedraMapper to all callers, in user code, VTK and ParaView.
 * The environment variable TETMARCH_REPLACE_PROJECTED_TETRAHEDRA has the same effect when this
 * library is loaded, unless it is empty or 0. Existing mappers are not changed.
 *
 * SetReplacesSmartVolume(true), or TETMARCH_REPLACE_SMART_VOLUME, replaces vtkSmartVolumeMapper by
 * vtkTetMarchSmartVolumeMapper as far as VTK allows: vtkObjectFactory::CreateInstance() returns our
 * class, but vtkSmartVolumeMapper::New() uses no factory in VTK 9.1 to 9.6. So C++ code must use
 * our class by name, or call CreateInstance(). In Python, vtktetmarch.replace_smart_volume_mapper()
 * replaces VTK's class.
 *
 * @sa vtkTetMarchProjectedTetrahedraMapper vtkTetMarchSmartVolumeMapper vtkObjectFactory
 */
#ifndef vtkTetMarchObjectFactory_h
#define vtkTetMarchObjectFactory_h

#include "vtkObjectFactory.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchObjectFactory : public vtkObjectFactory
{
public:
  static vtkTetMarchObjectFactory* New();
  vtkTypeMacro(vtkTetMarchObjectFactory, vtkObjectFactory);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether vtkProjectedTetrahedraMapper::New() returns a vtkTetMarchProjectedTetrahedraMapper. Off
   * by default.
   */
  static void SetReplacesProjectedTetrahedra(bool wanted);
  static bool GetReplacesProjectedTetrahedra();
  //@}

  //@{
  /**
   * Whether vtkObjectFactory::CreateInstance("vtkSmartVolumeMapper") returns a
   * vtkTetMarchSmartVolumeMapper. Off by default.
   */
  static void SetReplacesSmartVolume(bool wanted);
  static bool GetReplacesSmartVolume();
  //@}

  /**
   * The version of VTK with which this was built. VTK refuses factories of other versions.
   */
  const char* GetVTKSourceVersion() override;

  /**
   * The name of this factory in VTK's list of factories.
   */
  const char* GetDescription() override;

protected:
  vtkTetMarchObjectFactory();
  ~vtkTetMarchObjectFactory() override;

private:
  vtkTetMarchObjectFactory(const vtkTetMarchObjectFactory&) = delete;
  void operator=(const vtkTetMarchObjectFactory&) = delete;
};

#endif
