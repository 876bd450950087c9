// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole images of dependent components with effects of light.
#ifndef TetMarchReferenceLitComponentImage_h
#define TetMarchReferenceLitComponentImage_h

#include "Reference/ReferenceImage.h"

namespace tetmarch
{

/** The scene has Parts, which are dependent, and Effects. */
template <typename Real>
ReferenceImage renderLitComponents(const ReferenceScene& scene, const AccuracyLevel& level);

} // namespace tetmarch

#endif
