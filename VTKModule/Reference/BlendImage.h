// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole images of the other blend modes than composite.
#ifndef TetMarchReferenceBlendImage_h
#define TetMarchReferenceBlendImage_h

#include "Reference/ReferenceImage.h"

namespace tetmarch
{

/** The scene has a Blend, which isn't composite. */
template <typename Real>
ReferenceImage renderBlended(const ReferenceScene& scene, const AccuracyLevel& level);

} // namespace tetmarch

#endif
