// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchSceneExporter
 * @brief   A web page of ParaView's view
 *
 * A vtkTetMarchWebExporter whose page lacks nothing silently: ParaView shows a warning.
 */
#ifndef vtkTetMarchSceneExporter_h
#define vtkTetMarchSceneExporter_h

#include "vtkTetMarchRepresentationModule.h" // For export macro
#include "vtkTetMarchWebExporter.h"

class VTKTETMARCHREPRESENTATION_EXPORT vtkTetMarchSceneExporter : public vtkTetMarchWebExporter
{
public:
  static vtkTetMarchSceneExporter* New();
  vtkTypeMacro(vtkTetMarchSceneExporter, vtkTetMarchWebExporter);

protected:
  vtkTetMarchSceneExporter() = default;
  ~vtkTetMarchSceneExporter() override = default;

  void WriteData() override;

private:
  vtkTetMarchSceneExporter(const vtkTetMarchSceneExporter&) = delete;
  void operator=(const vtkTetMarchSceneExporter&) = delete;
};

#endif
