// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Coarser samples of transfer functions with the same integrals as finer ones.
#ifndef TetMarchOpticsBinAreas_h
#define TetMarchOpticsBinAreas_h

#include <array>
#include <vector>

namespace tetmarch
{

/** Colour r, g, b in 0..1 and extinction. */
using OpticalSample = std::array<double, 4>;

/** Integrals of C tau and tau over a piece of unit length on which colour C and extinction tau are
 * linear from p to q. */
std::array<double, 4> linearIntegrals(const OpticalSample& p, const OpticalSample& q);

/**
 * Every perBin-th of the fine samples, corrected such that linear interpolation between the
 * samples has the same integral of tau as that between the fine ones, and the same integral of C
 * tau as far as the colours of nearby samples allow. Bins over which the fine samples are linear
 * are not changed. A spike between two samples, which would be missed, raises both; a step keeps
 * its position. The first and the last sample are not changed, since many points of the data may
 * have exactly that value. Features between fine samples are lost. fine.size() is a multiple of
 * perBin plus 1.
 */
std::vector<OpticalSample> keepBinAreas(const std::vector<OpticalSample>& fine, int perBin);

} // namespace tetmarch

#endif
