// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The processes that draw one volume together, and what they can tell each other.
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

/** A message did not get through. */
class GroupFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * All its methods but the plain questions are collective: each process calls them in the same
 * order, or the others wait for it. They throw a GroupFailure if the controller fails. By a null
 * controller the group has one process, which tells nobody anything.
 */
class Group
{
public:
  Group() = default;
  explicit Group(vtkMultiProcessController* controller);

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  /** How many bytes this process has sent to others, without those of the library. */
  std::uint64_t sentBytes() const { return this->SentBytes; }

  /** What each process says, in their order. */
  std::vector<vtkMultiProcessStream> tellAll(const vtkMultiProcessStream& own);
  /** The same of bytes, which may be many. */
  std::vector<Bytes> tellAll(const Bytes& own);
  /** Send to each process what is meant for it; returns what each process has sent to this one. In
   * each step a process speaks with one other: with that whose number differs in the bits of the
   * step. */
  std::vector<Bytes> exchange(std::vector<Bytes> outgoing);
  /** The least of each number of all processes. They have equally many. */
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

/** The error of the first process that has one, with its number if there are several; empty if none
 * has. */
std::string sharedError(Group& group, const std::string& own);

} // namespace tetmarch

#endif
