// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchObjectFactory
 * @brief   Replaces vtkProjectedTetrahedraMapper by vtkTetMarchProjectedTetrahedraMapper
 *
 * Off by default. After SetReplacesProjectedTetrahedra(true), vtkProjectedTetrahedraMapper::New()
 * returns a vtkTetMarchProjectedTetrahedraMapper to all callers: a user's code, VTK's or
 * ParaView's. The environment variable TETMARCH_REPLACE_PROJECTED_TETRAHEDRA does the same when
 * this library is loaded, unless it is empty or 0. Existing mappers stay as they are.
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
   * Whether vtkProjectedTetrahedraMapper::New() returns a vtkTetMarchProjectedTetrahedraMapper. Off
   * by default.
   */
  static void SetReplacesProjectedTetrahedra(bool replaces);
  static bool GetReplacesProjectedTetrahedra();
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
