// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole images of several components.
#ifndef TetMarchReferenceComponentImage_h
#define TetMarchReferenceComponentImage_h

#include "Reference/ReferenceImage.h"

namespace tetmarch
{

/** The scene has Parts, which aren't single. */
template <typename Real>
ReferenceImage renderComponents(const ReferenceScene& scene, const AccuracyLevel& level);

} // namespace tetmarch

#endif
