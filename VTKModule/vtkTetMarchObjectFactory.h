// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchObjectFactory
 * @brief   Gives code that asks for a vtkProjectedTetrahedraMapper one that marches
 *
 * Off by default. SetReplacesProjectedTetrahedra(true), or the environment variable
 * TETMARCH_REPLACE_PROJECTED_TETRAHEDRA when this library is loaded (anything but empty or 0),
 * makes vtkProjectedTetrahedraMapper::New() return a vtkTetMarchProjectedTetrahedraMapper from then
 * on, whatever code calls it: a user's, VTK's or ParaView's. Mappers that are there stay.
 *
 * @sa vtkTetMarchProjectedTetrahedraMapper vtkObjectFactory
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
   * Whether vtkProjectedTetrahedraMapper::New() makes one that marches. Off by default.
   */
  static void SetReplacesProjectedTetrahedra(bool replaces);
  static bool GetReplacesProjectedTetrahedra();
  //@}

  /**
   * Which VTK this was built with, so that no other one takes it.
   */
  const char* GetVTKSourceVersion() override;

  /**
   * The name by which VTK's list of factories tells it from others.
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
