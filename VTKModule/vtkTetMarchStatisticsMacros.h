// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The figures of vtkTetMarchFrameStatistics for classes that have a GetLastFrameStatistics()
 *
 * A class has them by one line in its body:
 *
 *     vtkTetMarchStatisticsMethodsMacro();
 */
#ifndef vtkTetMarchStatisticsMacros_h
#define vtkTetMarchStatisticsMacros_h

#include "vtkTetMarchFrameStatistics.h"

/** A figure. */
#define vtkTetMarchFigureMacro(name, type)                                                         \
  type Get##name() const { return this->GetLastFrameStatistics()->Get##name(); }

/** Something that is true or not. */
#define vtkTetMarchFactMacro(name)                                                                 \
  bool Is##name() const { return this->GetLastFrameStatistics()->Get##name(); }

/** All of the figures. */
#define vtkTetMarchStatisticsMethodsMacro()                                                        \
  vtkTetMarchFigureMacro(NumberOfRays, vtkTypeInt64);                                              \
  vtkTetMarchFigureMacro(NumberOfCrossedCells, vtkTypeInt64);                                      \
  vtkTetMarchFigureMacro(NumberOfLookups, vtkTypeInt64);                                           \
  vtkTetMarchFigureMacro(NumberOfRefusedEntries, vtkTypeInt64);                                    \
  vtkTetMarchFigureMacro(NumberOfLostRays, vtkTypeInt64);                                          \
  vtkTetMarchFigureMacro(NumberOfGuardHits, vtkTypeInt64);                                         \
  vtkTetMarchFigureMacro(NumberOfDraws, int);                                                      \
  vtkTetMarchFigureMacro(UsedAccuracyLevel, int);                                                  \
  vtkTetMarchFigureMacro(UsedAccuracyLevelAsString, const char*);                                  \
  vtkTetMarchFigureMacro(UsedErrorTolerance, double);                                              \
  vtkTetMarchFigureMacro(UsedShaderStage, int);                                                    \
  vtkTetMarchFigureMacro(UsedShaderStageAsString, const char*);                                    \
  vtkTetMarchFigureMacro(UsedImageSampleDistance, double);                                         \
  vtkTetMarchFactMacro(BudgetKept);                                                                \
  vtkTetMarchFactMacro(LightComplete);                                                             \
  vtkTetMarchFigureMacro(NumberOfTetrahedra, vtkIdType);                                           \
  vtkTetMarchFigureMacro(NumberOfBoundaryFaces, vtkIdType);                                        \
  vtkTetMarchFigureMacro(NumberOfLatticeCells, vtkTypeInt64);                                      \
  vtkTetMarchFigureMacro(GPUMemoryBytes, vtkTypeInt64);                                            \
  vtkTetMarchFigureMacro(UploadedBytes, vtkTypeInt64);                                             \
  vtkTetMarchFigureMacro(BlocksSeconds, double);                                                   \
  vtkTetMarchFigureMacro(MeshSeconds, double);                                                     \
  vtkTetMarchFigureMacro(ScalarsSeconds, double);                                                  \
  vtkTetMarchFigureMacro(VisiblePartSeconds, double);                                              \
  vtkTetMarchFigureMacro(EntriesSeconds, double);                                                  \
  vtkTetMarchFigureMacro(TablesSeconds, double);                                                   \
  vtkTetMarchFigureMacro(GradientsSeconds, double);                                                \
  vtkTetMarchFigureMacro(OpaqueShadowsSeconds, double);                                            \
  vtkTetMarchFigureMacro(VertexLightSeconds, double);                                              \
  vtkTetMarchFigureMacro(UploadSeconds, double);                                                   \
  vtkTetMarchFigureMacro(NumberOfVisits, vtkTypeInt64);                                            \
  vtkTetMarchFigureMacro(SentBytes, vtkTypeInt64);                                                 \
  vtkTetMarchFigureMacro(MarchSeconds, double);                                                    \
  vtkTetMarchFigureMacro(ExchangeSeconds, double);                                                 \
  vtkTetMarchFigureMacro(MergeSeconds, double);                                                    \
  vtkTetMarchFigureMacro(SpreadSeconds, double);                                                   \
  vtkTetMarchFigureMacro(SharedErrorBound, double);                                                \
  vtkTetMarchFigureMacro(BlocksBuilds, vtkTypeInt64);                                              \
  vtkTetMarchFigureMacro(MeshBuilds, vtkTypeInt64);                                                \
  vtkTetMarchFigureMacro(ScalarsBuilds, vtkTypeInt64);                                             \
  vtkTetMarchFigureMacro(VisiblePartBuilds, vtkTypeInt64);                                         \
  vtkTetMarchFigureMacro(EntriesBuilds, vtkTypeInt64);                                             \
  vtkTetMarchFigureMacro(TablesBuilds, vtkTypeInt64);                                              \
  vtkTetMarchFigureMacro(GradientsBuilds, vtkTypeInt64);                                           \
  vtkTetMarchFigureMacro(OpaqueShadowsBuilds, vtkTypeInt64);                                       \
  vtkTetMarchFigureMacro(VertexLightBuilds, vtkTypeInt64)

#endif
