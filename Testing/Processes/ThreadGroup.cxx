// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadGroup.h"

#include "vtkAbstractArray.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <tuple>

namespace tetmarch
{
namespace testing
{
namespace
{

/** The messages on their way. */
class Post
{
public:
  void send(int from, int to, int tag, Bytes message)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Waiting[{ from, to, tag }].push_back(std::move(message));
    this->Arrived.notify_all();
  }

  // False if nothing came for long.
  bool receive(int from, int to, int tag, Bytes& message)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    auto& queue = this->Waiting[{ from, to, tag }];
    if (!this->Arrived.wait_for(lock, std::chrono::seconds(1000), [&] { return !queue.empty(); }))
    {
      return false;
    }
    message = std::move(queue.front());
    queue.pop_front();
    return true;
  }

private:
  std::mutex Mutex;
  std::condition_variable Arrived;
  std::map<std::tuple<int, int, int>, std::deque<Bytes>> Waiting;
};

class ThreadCommunicator : public vtkCommunicator
{
public:
  static ThreadCommunicator* New();
  vtkTypeMacro(ThreadCommunicator, vtkCommunicator);

  void join(Post& post, int rank, int size)
  {
    this->Shared = &post;
    this->LocalProcessId = rank;
    this->MaximumNumberOfProcesses = this->NumberOfProcesses = size;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int to, int tag) override
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    const auto size = static_cast<std::size_t>(length) * vtkAbstractArray::GetDataTypeSize(type);
    this->Shared->send(this->LocalProcessId, to, tag, Bytes(bytes, bytes + size));
    return 1;
  }

  int ReceiveVoidArray(void* data, vtkIdType length, int type, int from, int tag) override
  {
    const auto width = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(type));
    Bytes message;
    if (!this->Shared->receive(from, this->LocalProcessId, tag, message) ||
        message.size() > static_cast<std::size_t>(length) * width)
    {
      return 0;
    }
    std::copy(message.begin(), message.end(), static_cast<unsigned char*>(data));
    this->Count = static_cast<vtkIdType>(message.size() / width);
    return 1;
  }

private:
  Post* Shared = nullptr;
};
vtkStandardNewMacro(ThreadCommunicator);

class ThreadController : public vtkMultiProcessController
{
public:
  static ThreadController* New();
  vtkTypeMacro(ThreadController, vtkMultiProcessController);

  void join(Post& post, int rank, int size)
  {
    vtkNew<ThreadCommunicator> communicator;
    communicator->join(post, rank, size);
    this->Communicator = communicator;
    this->Communicator->Register(this);
    this->RMICommunicator = nullptr;
  }

  void Initialize(int*, char***) override {}
  void Initialize(int*, char***, int) override {}
  void Finalize() override {}
  void Finalize(int) override {}
  void SingleMethodExecute() override {}
  void MultipleMethodExecute() override {}
  void CreateOutputWindow() override {}

protected:
  ~ThreadController() override
  {
    this->Communicator->UnRegister(this);
    this->Communicator = nullptr;
  }
};
vtkStandardNewMacro(ThreadController);

} // namespace

void runTogether(int processes, const std::function<void(Group& group)>& work)
{
  runControllers(processes,
    [&](vtkMultiProcessController* controller)
    {
      Group group(controller);
      work(group);
    });
}

void runControllers(
  int processes, const std::function<void(vtkMultiProcessController* controller)>& work)
{
  Post post;
  std::vector<std::thread> threads;
  std::vector<std::exception_ptr> thrown(processes);
  for (int rank = 0; rank < processes; ++rank)
  {
    threads.emplace_back(
      [&, rank]
      {
        try
        {
          vtkNew<ThreadController> controller;
          controller->join(post, rank, processes);
          work(controller);
        }
        catch (...)
        {
          thrown[rank] = std::current_exception();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::exception_ptr& exception : thrown)
  {
    if (exception)
    {
      std::rethrow_exception(exception);
    }
  }
}

} // namespace testing
} // namespace tetmarch
