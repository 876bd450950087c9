// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchObjectFactory
 * @brief   Gives mappers of TetMarch to who asks for VTK's
 *
 * Off by default. After SetReplacesProjectedTetrahedra(true), vtkProjectedTetrahedraMapper::New()
 * returns a vtkTetMarchProjectedTetrahedraMapper to all callers: a user's code, VTK's or
 * ParaView's. The environment variable TETMARCH_REPLACE_PROJECTED_TETRAHEDRA does the same when
 * this library is loaded, unless it is empty or 0. Existing mappers stay as they are.
 *
 * SetReplacesSmartVolume(true), or TETMARCH_REPLACE_SMART_VOLUME, does that for
 * vtkSmartVolumeMapper and vtkTetMarchSmartVolumeMapper as far as VTK allows:
 * vtkObjectFactory::CreateInstance() returns ours, but vtkSmartVolumeMapper::New() asks no factory
 * in VTK 9.1 to 9.6. So code in C++ has to name our class, or call CreateInstance(). In Python,
 * vtktetmarch.replace_smart_volume_mapper() puts our class in the place of VTK's.
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
   * Version of the VTK that this was built with. VTK refuses factories of other versions.
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
