// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The group of processes that draw one volume, and its communication.
#ifndef TetMarchProcessesGroup_h
#define TetMarchProcessesGroup_h

#include "vtkMultiProcessStream.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace tetmarch
{

using Bytes = std::vector<unsigned char>;

/** A message failed. */
class GroupFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * All methods except const getters are collective: each process must call them in the same order.
 * They throw a GroupFailure if the controller fails. With a null controller the group has one
 * process, which sends nothing.
 */
class Group
{
public:
  Group() = default;
  explicit Group(vtkMultiProcessController* controller);

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  /** The number of bytes sent by this process to others, without those of the library. */
  std::uint64_t sentBytes() const { return this->SentBytes; }

  /** Gather a value of each process, in their order. */
  std::vector<vtkMultiProcessStream> tellAll(const vtkMultiProcessStream& own);
  /** The same for any number of bytes. */
  std::vector<Bytes> tellAll(const Bytes& own);
  /** Send a message to each process; returns the messages of all processes to this one. In each
   * step a process exchanges with the one whose rank differs in the bits of the step. */
  std::vector<Bytes> exchange(std::vector<Bytes> outgoing);
  /** The minimum of each number over all processes, which must have equally many. */
  void keepLeast(std::vector<float>& values);

private:
  void send(const Bytes& bytes, int to);
  Bytes receive(int from);
  void check(int succeeded, const char* what) const;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  int Rank = 0;
  int Size = 1;
  std::uint64_t SentBytes = 0;
};

/** The error of the first process that has one, with its rank if there are several processes; empty
 * if none has. */
std::string sharedError(Group& group, const std::string& own);

} // namespace tetmarch

#endif
