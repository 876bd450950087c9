// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a frame without an error shows nothing.
#ifndef TetMarchFrameNothingVisible_h
#define TetMarchFrameNothingVisible_h

#include <string>

namespace tetmarch
{

class FrameStages;

/**
 * Why nothing of the volume of these stages is visible, wherever the camera looks, and what to do:
 * "none of the scalars is a finite number. Choose another array ...". Empty if something may be
 * visible, and of data without cells. If they stopped at a stage, since nothing was visible, that
 * stage is told.
 */
std::string whyNothingIsVisible(const FrameStages& stages);

} // namespace tetmarch

#endif
