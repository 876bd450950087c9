// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/Group.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr int Tag = 20190; // of our messages
// Maximum size of one call: MPI counts in int. Memory for a message is allocated in parts, as it
// arrives.
constexpr std::size_t MostBytesOfPart = std::size_t(1) << 26;
// Maximum size of data that all processes exchange for a picture.
constexpr std::size_t MostBytesOfAll = std::size_t(1) << 31;

std::size_t checkedSize(vtkTypeInt64 count, int from)
{
  if (count < 0)
  {
    throw GroupFailure("Process " + std::to_string(from) + " announced a message of " +
                       std::to_string(count) + " bytes.");
  }
  return static_cast<std::size_t>(count);
}

// The offsets of the concatenated messages of all processes, and their end.
std::vector<vtkIdType> startsOf(const std::vector<vtkIdType>& counts)
{
  std::vector<vtkIdType> starts{ 0 };
  for (std::size_t p = 0; p < counts.size(); ++p)
  {
    const std::size_t count = checkedSize(counts[p], static_cast<int>(p));
    if (count > MostBytesOfAll - static_cast<std::size_t>(starts.back()))
    {
      throw GroupFailure("The processes announced messages of more than " +
                         std::to_string(MostBytesOfAll >> 30) + " GiB to all.");
    }
    starts.push_back(starts.back() + counts[p]);
  }
  return starts;
}

} // namespace

Group::Group(vtkMultiProcessController* controller)
  : Controller(controller)
{
  if (controller)
  {
    this->Rank = controller->GetLocalProcessId();
    this->Size = controller->GetNumberOfProcesses();
  }
}

void Group::check(int succeeded, const char* what) const
{
  if (!succeeded)
  {
    throw GroupFailure("Process " + std::to_string(this->Rank) + " could not " + what +
                       ": the vtkMultiProcessController failed.");
  }
}

void Group::send(const Bytes& bytes, int to)
{
  const auto count = static_cast<vtkTypeInt64>(bytes.size());
  this->check(this->Controller->Send(&count, 1, to, Tag), "send a size");
  for (std::size_t at = 0; at < bytes.size(); at += MostBytesOfPart)
  {
    const std::size_t part = std::min(MostBytesOfPart, bytes.size() - at);
    this->check(
      this->Controller->Send(bytes.data() + at, static_cast<vtkIdType>(part), to, Tag), "send");
  }
  this->SentBytes += sizeof(count) + bytes.size();
}

Bytes Group::receive(int from)
{
  vtkTypeInt64 count = 0;
  this->check(this->Controller->Receive(&count, 1, from, Tag), "receive a size");
  const std::size_t size = checkedSize(count, from);
  Bytes bytes;
  for (std::size_t at = 0; at < size; at += MostBytesOfPart)
  {
    const std::size_t part = std::min(MostBytesOfPart, size - at);
    bytes.resize(at + part);
    this->check(
      this->Controller->Receive(bytes.data() + at, static_cast<vtkIdType>(part), from, Tag),
      "receive");
  }
  return bytes;
}

std::vector<Bytes> Group::exchange(std::vector<Bytes> outgoing)
{
  std::vector<Bytes> incoming(this->Size);
  incoming[this->Rank].swap(outgoing[this->Rank]);
  int steps = 1;
  while (steps < this->Size)
  {
    steps *= 2;
  }
  for (int step = 1; step < steps; ++step)
  {
    const int partner = this->Rank ^ step;
    if (partner >= this->Size)
    {
      continue;
    }
    // One of the two receives while the other sends.
    if (this->Rank < partner)
    {
      this->send(outgoing[partner], partner);
      incoming[partner] = this->receive(partner);
    }
    else
    {
      incoming[partner] = this->receive(partner);
      this->send(outgoing[partner], partner);
    }
    Bytes().swap(outgoing[partner]);
  }
  return incoming;
}

std::vector<Bytes> Group::tellAll(const Bytes& own)
{
  if (this->Size == 1)
  {
    return { own };
  }
  const auto count = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> counts(this->Size);
  this->check(this->Controller->AllGather(&count, counts.data(), 1), "gather sizes");
  std::vector<vtkIdType> starts = startsOf(counts);
  Bytes all(static_cast<std::size_t>(starts.back()));
  this->check(
    this->Controller->AllGatherV(own.data(), all.data(), count, counts.data(), starts.data()),
    "gather");
  this->SentBytes += (sizeof(count) + own.size()) * static_cast<std::size_t>(this->Size - 1);
  std::vector<Bytes> said(this->Size);
  for (int p = 0; p < this->Size; ++p)
  {
    said[p].assign(all.begin() + starts[p], all.begin() + starts[p + 1]);
  }
  return said;
}

std::vector<vtkMultiProcessStream> Group::tellAll(const vtkMultiProcessStream& own)
{
  Bytes bytes;
  own.GetRawData(bytes);
  std::vector<vtkMultiProcessStream> said;
  for (const Bytes& message : this->tellAll(bytes))
  {
    said.emplace_back();
    said.back().SetRawData(message);
  }
  return said;
}

void Group::keepLeast(std::vector<float>& values)
{
  if (this->Size == 1 || values.empty())
  {
    return;
  }
  const std::vector<float> own = values;
  this->check(this->Controller->AllReduce(own.data(), values.data(),
                static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP),
    "find the least values");
  this->SentBytes += sizeof(float) * own.size();
}

std::string sharedError(Group& group, const std::string& own)
{
  vtkMultiProcessStream message;
  message << own;
  std::vector<vtkMultiProcessStream> said = group.tellAll(message);
  for (int p = 0; p < group.size(); ++p)
  {
    std::string error;
    said[p] >> error;
    if (!error.empty())
    {
      return group.size() > 1 ? "Process " + std::to_string(p) + ": " + error : error;
    }
  }
  return {};
}

} // namespace tetmarch
