// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole images by groups of kernels, each of which is compiled in a file of its own.
#ifndef TetMarchReferenceImageGroups_h
#define TetMarchReferenceImageGroups_h

#include "Reference/ReferenceImage.h"

namespace tetmarch
{

/** Of one scalar, without effects. */
template <typename Real>
ReferenceImage renderVolume(const ReferenceScene& scene, const AccuracyLevel& level);

/** Of one scalar, with effects. */
template <typename Real>
ReferenceImage renderLit(const ReferenceScene& scene, const AccuracyLevel& level);

/** Of several components, without effects. */
template <typename Real>
ReferenceImage renderComponents(const ReferenceScene& scene, const AccuracyLevel& level);

/** Of dependent components, with effects. */
template <typename Real>
ReferenceImage renderLitComponents(const ReferenceScene& scene, const AccuracyLevel& level);

/** By another blend mode than composite. */
template <typename Real>
ReferenceImage renderBlended(const ReferenceScene& scene, const AccuracyLevel& level);

// The same of structured volumes.

template <typename Real>
ReferenceImage renderStructured(const ReferenceScene& scene, const AccuracyLevel& level);

template <typename Real>
ReferenceImage renderLitStructured(const ReferenceScene& scene, const AccuracyLevel& level);

/** Of trilinear cells that are cut evenly, with and without effects: by a level that isn't
 * adaptive. */
template <typename Real>
ReferenceImage renderEvenStructured(const ReferenceScene& scene, const AccuracyLevel& level);

/** By samples at even distances, with and without effects. */
template <typename Real>
ReferenceImage renderSampledStructured(const ReferenceScene& scene, const AccuracyLevel& level);

template <typename Real>
ReferenceImage renderStructuredComponents(const ReferenceScene& scene, const AccuracyLevel& level);

template <typename Real>
ReferenceImage renderLitStructuredComponents(
  const ReferenceScene& scene, const AccuracyLevel& level);

template <typename Real>
ReferenceImage renderBlendedStructured(const ReferenceScene& scene, const AccuracyLevel& level);

} // namespace tetmarch

#endif
