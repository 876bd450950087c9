// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Commands to worker processes, and their answers: see Worker.h
 */
#ifndef tetmarch_bench_WorkerAnswers_h
#define tetmarch_bench_WorkerAnswers_h

#include <nlohmann/json.hpp>

#include <string>

namespace tetmarch::bench
{
class ChildProcess;

/// The next answer. Throws Failure if it is an error, or if the process ended or took too long.
nlohmann::json receiveAnswer(ChildProcess& child, double limitSeconds);

nlohmann::json askWorker(ChildProcess& child, const std::string& command, double limitSeconds);
} // namespace tetmarch::bench

#endif
