// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Common methods of the representations, in a form that ParaView's wrappers can parse
 */
#ifndef vtkTetMarchRepresentationMacros_h
#define vtkTetMarchRepresentationMacros_h

#include "vtkTetMarchSettingsMacros.h"

/** The selection of blocks by ParaView's Multi-block Inspector, for classes with a
 * tetmarch::BlockSelection named Blocks. */
#define vtkTetMarchBlocksMethodsMacro()                                                            \
  void SetActiveAssembly(const char* name)                                                         \
  {                                                                                                \
    this->Blocks.Assembly = name ? name : "";                                                      \
    this->MarkModified();                                                                          \
  }                                                                                                \
  void AddBlockSelector(const char* selector)                                                      \
  {                                                                                                \
    this->Blocks.Selectors.insert(selector);                                                       \
    this->MarkModified();                                                                          \
  }                                                                                                \
  void RemoveAllBlockSelectors()                                                                   \
  {                                                                                                \
    this->Blocks.Selectors.clear();                                                                \
    this->MarkModified();                                                                          \
  }

#endif
