// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorkerAnswers.h"

#include "ChildProcess.h"
#include "Failure.h"

namespace tetmarch::bench
{
nlohmann::json receiveAnswer(ChildProcess& child, double limitSeconds)
{
  nlohmann::json answer = nlohmann::json::parse(child.receive(limitSeconds));
  if (answer.contains("error"))
  {
    throw Failure(answer["error"].get<std::string>());
  }
  return answer;
}

nlohmann::json askWorker(ChildProcess& child, const std::string& command, double limitSeconds)
{
  child.send(command);
  return receiveAnswer(child, limitSeconds);
}
} // namespace tetmarch::bench
