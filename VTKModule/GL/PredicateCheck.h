// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the arithmetic of a GL keeps the traversal of tetrahedra watertight, and in which form.
#ifndef TetMarchGLPredicateCheck_h
#define TetMarchGLPredicateCheck_h

#include <string>

class vtkOpenGLRenderWindow;

namespace tetmarch
{

/**
 * Has the GL compute thousands of cases (Variants/PredicateCases.h) by fused multiply-add, if
 * shaders may use it, and else in whole numbers: fused is set to the form whose answers are all
 * right. Draws and reads back, so keep the answer as long as the context lives. Returns an empty
 * string, or what is wrong and what to do: then rays would get lost.
 */
std::string findPredicate(vtkOpenGLRenderWindow* window, bool& fused);

} // namespace tetmarch

#endif
