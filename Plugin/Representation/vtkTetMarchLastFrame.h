// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchLastFrame
 * @brief   The figures of the last frame of a representation, as ParaView asks for them
 *
 * ParaView asks a representation for information in the client's own process, but with a server it
 * is the server that draws. So this is an object of its own, which ParaView makes in the server
 * only: what it asks for comes from there. Without a server there is one process for all.
 */
#ifndef vtkTetMarchLastFrame_h
#define vtkTetMarchLastFrame_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"                 // For what it follows
#include "vtkTetMarchRepresentationModule.h" // For export macro
#include "vtkTetMarchStatisticsMacros.h"     // For the figures

class vtkAbstractMapper;

class VTKTETMARCHREPRESENTATION_EXPORT vtkTetMarchLastFrame : public vtkObject
{
public:
  static vtkTetMarchLastFrame* New();
  vtkTypeMacro(vtkTetMarchLastFrame, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * From now on the figures are those of this mapper, and of its statistics. Before, they are 0.
   */
  void Follow(vtkAbstractMapper* mapper, vtkTetMarchFrameStatistics* statistics);

  vtkTetMarchFrameStatistics* GetLastFrameStatistics() const;

  //@{
  /**
   * The figure of that name of GetLastFrameStatistics(): see vtkTetMarchFrameStatistics.
   */
  vtkTetMarchStatisticsMethodsMacro();
  //@}

  /**
   * Seconds that the frame took.
   */
  double GetTimeToDraw() const;

protected:
  vtkTetMarchLastFrame();
  ~vtkTetMarchLastFrame() override;

private:
  vtkTetMarchLastFrame(const vtkTetMarchLastFrame&) = delete;
  void operator=(const vtkTetMarchLastFrame&) = delete;

  vtkSmartPointer<vtkAbstractMapper> Mapper;
  vtkSmartPointer<vtkTetMarchFrameStatistics> Statistics;
};

#endif
