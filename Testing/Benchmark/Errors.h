// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far pictures are from the true one
 */
#ifndef tetmarch_bench_Errors_h
#define tetmarch_bench_Errors_h

#include "FloatPicture.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tetmarch::bench
{
/// Premultiplied RGBA as it is in memory: from process to process on one machine.
void writePicture(const std::string& file, const testing::Image& picture);
/// Of the size of the other. Throws Failure if it isn't.
testing::Image readReference(const std::string& file, const testing::Image& other);

/**
 * Differences of channels (r, g, b; 0..1) on black and on white ground, where opacity shows, over
 * the pixels that the reference or the picture covers: "rms" over channels, "p999" (no more than
 * one pixel in a thousand has a channel that is off by more), "max".
 */
nlohmann::json errorsOf(const FloatPictures& pictures, const testing::Image& reference);

/// The same on black ground alone.
nlohmann::json errorsOnBlack(const testing::Image& picture, const testing::Image& reference);
} // namespace tetmarch::bench

#endif
