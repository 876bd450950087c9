// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchLastFrame
 * @brief   Statistics of the last frame of a representation for ParaView
 *
 * ParaView requests information of a representation in the client's process, but the server draws.
 * Therefore this is a separate object, which ParaView creates in the server only, so that the
 * information comes from there. Without a server there is one process for both.
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
   * Set the mapper and its statistics. Without them all figures are 0.
   */
  void Follow(vtkAbstractMapper* mapper, vtkTetMarchFrameStatistics* statistics);

  vtkTetMarchFrameStatistics* GetLastFrameStatistics() const;

  //@{
  /**
   * Forwarded to GetLastFrameStatistics(): see vtkTetMarchFrameStatistics.
   */
  vtkTetMarchStatisticsMethodsMacro();
  //@}

  /**
   * The time of the frame in seconds.
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
