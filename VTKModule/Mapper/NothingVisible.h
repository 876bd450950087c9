// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a frame without an error shows nothing.
#ifndef TetMarchMapperNothingVisible_h
#define TetMarchMapperNothingVisible_h

#include <string>

namespace tetmarch
{

class Pipeline;

/**
 * Why nothing of the volume that a pipeline has prepared is visible, wherever the camera looks, and
 * what to do: "none of the scalars is a finite number. Choose another array ...". Empty if
 * something may be visible, and of data without cells. Of a preparation that stopped at a stage,
 * since nothing was visible, that stage is what is told.
 */
std::string whyNothingIsVisible(const Pipeline& pipeline);

} // namespace tetmarch

#endif
