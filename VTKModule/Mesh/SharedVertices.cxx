// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SharedVertices.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace tetmarch
{
namespace
{

/** A position, by its bits. */
using Key = std::array<std::uint32_t, 3>;

Key keyOf(const Vertex& vertex)
{
  Key key;
  const std::array<float, 3> position{ { vertex.X, vertex.Y, vertex.Z } };
  std::memcpy(key.data(), position.data(), sizeof(key));
  return key;
}

// The process that collects the records of a vertex, which need not have it. The factors are those
// of Teschner et al., "Optimized spatial hashing for collision detection", 2003.
int meetingPlace(const Key& key, int processes)
{
  std::uint32_t hash = key[0] * 73856093u ^ key[1] * 19349663u ^ key[2] * 83492791u;
  hash ^= hash >> 15;
  return static_cast<int>(hash % static_cast<std::uint32_t>(processes));
}

template <typename T>
void put(Bytes& message, const T& value)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
  message.insert(message.end(), bytes, bytes + sizeof(T));
}

void put(Bytes& message, const Bytes& record)
{
  put(message, static_cast<std::uint32_t>(record.size()));
  message.insert(message.end(), record.begin(), record.end());
}

class Reader
{
public:
  explicit Reader(const Bytes& message)
    : Message(message)
  {
  }
  bool atEnd() const { return this->At == this->Message.size(); }
  template <typename T>
  T take()
  {
    T value;
    std::memcpy(&value, this->bytes(sizeof(T)), sizeof(T));
    return value;
  }
  Bytes takeRecord()
  {
    const auto size = this->take<std::uint32_t>();
    const unsigned char* begin = this->bytes(size);
    return Bytes(begin, begin + size);
  }

private:
  const unsigned char* bytes(std::size_t count)
  {
    if (count > this->Message.size() - this->At)
    {
      throw GroupFailure("What a process told of shared vertices ends too early.");
    }
    this->At += count;
    return this->Message.data() + this->At - count;
  }

  const Bytes& Message;
  std::size_t At = 0;
};

/** A received record with its process and vertex. */
struct Arrived
{
  int From;
  std::uint32_t Number;
  Bytes Record;
};

// Each sender of a record of a shared vertex receives the records of all.
std::vector<Bytes> answer(const std::vector<Bytes>& incoming)
{
  std::map<Key, std::vector<Arrived>> met;
  for (std::size_t p = 0; p < incoming.size(); ++p)
  {
    Reader reader(incoming[p]);
    while (!reader.atEnd())
    {
      const Key key = reader.take<Key>();
      const auto number = reader.take<std::uint32_t>();
      met[key].push_back({ static_cast<int>(p), number, reader.takeRecord() });
    }
  }
  std::vector<Bytes> answers(incoming.size());
  for (const auto& [key, records] : met)
  {
    if (records.front().From == records.back().From)
    {
      continue;
    }
    for (const Arrived& asked : records)
    {
      Bytes& message = answers[asked.From];
      put(message, asked.Number);
      put(message, static_cast<std::uint32_t>(records.size()));
      for (const Arrived& arrived : records)
      {
        put(message, arrived.Record);
      }
    }
  }
  return answers;
}

} // namespace

std::vector<Id> boundaryVertices(const TetMesh& mesh)
{
  std::vector<Id> vertices;
  vertices.reserve(3 * mesh.BoundaryFaces.size());
  for (const auto& face : mesh.BoundaryFaces)
  {
    vertices.insert(vertices.end(), face.begin(), face.begin() + 3);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<std::vector<Bytes>> shareRecords(Group& group, const TetMesh& mesh,
  const std::vector<Id>& vertices, const std::vector<Bytes>& records)
{
  std::vector<Bytes> outgoing(group.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Key key = keyOf(mesh.Vertices[vertices[i]]);
    Bytes& message = outgoing[meetingPlace(key, group.size())];
    put(message, key);
    put(message, static_cast<std::uint32_t>(i));
    put(message, records[i]);
  }
  const std::vector<Bytes> answers = group.exchange(answer(group.exchange(std::move(outgoing))));
  std::vector<std::vector<Bytes>> shared(vertices.size());
  for (const Bytes& message : answers)
  {
    Reader reader(message);
    while (!reader.atEnd())
    {
      auto& ofVertex = shared.at(reader.take<std::uint32_t>());
      for (auto count = reader.take<std::uint32_t>(); count > 0; --count)
      {
        ofVertex.push_back(reader.takeRecord());
      }
    }
  }
  return shared;
}

} // namespace tetmarch
