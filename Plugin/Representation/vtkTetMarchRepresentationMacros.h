// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Methods that the representations of TetMarch have in common, as ParaView's wrappers see
 * them
 */
#ifndef vtkTetMarchRepresentationMacros_h
#define vtkTetMarchRepresentationMacros_h

#include "vtkTetMarchSettingsMacros.h"

/** The choice of blocks by ParaView's Multi-block Inspector, for classes with a
 * tetmarch::BlockSelection called Blocks. */
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
