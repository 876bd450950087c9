// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What several processes know of vertices that their pieces of a mesh share.
#ifndef TetMarchMeshSharedVertices_h
#define TetMarchMeshSharedVertices_h

#include "Mesh/TetMesh.h"
#include "Processes/Group.h"

namespace tetmarch
{

/** The vertices of boundary faces, ascending: all that other pieces may share are among them. */
std::vector<Id> boundaryVertices(const TetMesh& mesh);

/**
 * Collective. Tell the other processes a record of each of these vertices of this piece; vertices
 * are the same if they have the same position to the last bit. Returns for each vertex the records
 * of all processes, in their order, or none if no other process has the vertex.
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
