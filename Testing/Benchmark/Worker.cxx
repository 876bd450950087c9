// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Worker.h"

#include "Drawing.h"
#include "Memory.h"
#include "Scene.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace tetmarch::bench
{
namespace
{
/// Whatever else this process prints goes to standard error from now on.
class AnswerLine
{
public:
  AnswerLine()
    : Descriptor(dup(STDOUT_FILENO))
  {
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  ~AnswerLine() { close(this->Descriptor); }
  AnswerLine(const AnswerLine&) = delete;
  AnswerLine& operator=(const AnswerLine&) = delete;

  void send(const nlohmann::json& answer) const
  {
    const std::string line =
      answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    for (std::size_t done = 0; done < line.size();)
    {
      const ssize_t count = write(this->Descriptor, line.data() + done, line.size() - done);
      if (count < 0)
      {
        throw std::runtime_error("the benchmark is gone");
      }
      done += static_cast<std::size_t>(count);
    }
  }

private:
  int Descriptor;
};

nlohmann::json answerTo(const std::string& command, Drawing& drawing)
{
  const std::string word = command.substr(0, command.find(' '));
  const std::string rest = command.substr(std::min(word.size() + 1, command.size()));
  if (word == "reference")
  {
    return drawing.writeReference(rest);
  }
  if (word == "effect")
  {
    const std::size_t space = rest.find(' ');
    return drawing.drawEffect(rest.substr(0, space), std::stoi(rest.substr(space + 1)));
  }
  if (word == "parity")
  {
    return drawing.compareWithCpu(rest);
  }
  if (word == "gl")
  {
    return drawing.gl();
  }
  if (word == "probes")
  {
    return drawing.driverProbes();
  }
  return word == "errors" ? drawing.compareFirstView(rest) : drawing.drawFrame();
}

void serve(const Options& options, const AnswerLine& answers)
{
  Scene scene = makeScene(options.Worker->Shown, options.Folders);
  scene.CacheFolder = options.CacheFolder;
  forgetPeak();
  const std::int64_t before = residentBytes();
  Drawing drawing(scene, options.Worker->Mapper, options.Size);
  answers.send({ { "tetrahedra", scene.Grid->GetNumberOfCells() },
    { "points", scene.Grid->GetNumberOfPoints() }, { "environment", drawing.environment() } });

  for (std::string command; std::getline(std::cin, command);)
  {
    if (command == "figures")
    {
      nlohmann::json figures = drawing.mapperFigures();
      figures["peak_resident_bytes"] = peakResidentBytes();
      figures["dataset_resident_bytes"] = before;
      answers.send(figures);
    }
    else
    {
      answers.send(answerTo(command, drawing));
    }
  }
}
} // namespace

int runWorker(const Options& options)
{
  const AnswerLine answers;
  try
  {
    serve(options, answers);
    return 0;
  }
  catch (const std::exception& error)
  {
    answers.send({ { "error", error.what() } });
    return 1;
  }
}
} // namespace tetmarch::bench
