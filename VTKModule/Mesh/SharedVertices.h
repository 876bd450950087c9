// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Exchange of data of vertices that pieces of several processes share.
#ifndef TetMarchMeshSharedVertices_h
#define TetMarchMeshSharedVertices_h

#include "Mesh/TetMesh.h"
#include "Processes/Group.h"

namespace tetmarch
{

/** The vertices of boundary faces, ascending; they include all that other pieces may share. */
std::vector<Id> boundaryVertices(const TetMesh& mesh);

/**
 * Collective. Send a record of each of these vertices of this piece to the other processes;
 * vertices are identified by their position to the last bit. Returns for each vertex the records of
 * all processes, in their order, or none if no other process has the vertex.
 */
std::vector<std::vector<Bytes>> shareRecords(Group& group, const TetMesh& mesh,
  const std::vector<Id>& vertices, const std::vector<Bytes>& records);

/** An array of plain numbers as bytes, and back. */
template <typename T>
Bytes bytesOf(const std::vector<T>& values)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  return Bytes(bytes, bytes + values.size() * sizeof(T));
}
template <typename T>
void appendValues(const Bytes& bytes, std::vector<T>& values)
{
  const auto* begin = reinterpret_cast<const T*>(bytes.data());
  values.insert(values.end(), begin, begin + bytes.size() / sizeof(T));
}

} // namespace tetmarch

#endif
