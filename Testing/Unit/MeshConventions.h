// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What every mesh keeps to
 */
#ifndef tetmarch_testing_MeshConventions_h
#define tetmarch_testing_MeshConventions_h

#include "Mesh/TetMesh.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tetmarch::testing
{
inline std::array<Id, 3> faceOf(const TetMesh& mesh, Id tet, int i)
{
  std::array<Id, 3> face;
  int k = 0;
  for (int j = 0; j < 4; ++j)
  {
    if (j != i)
    {
      face[k++] = mesh.Tets[tet][j];
    }
  }
  return face;
}

/// All conventions of TetMesh.h.
inline void expectConventions(const TetMesh& mesh)
{
  const Id tets = mesh.numberOfTets();
  ASSERT_EQ(mesh.Links.size(), 4 * mesh.Tets.size());
  std::size_t outside = 0;
  for (Id t = 0; t < tets; ++t)
  {
    for (int i = 0; i < 4 && !mesh.isDegenerate(t); ++i)
    {
      const Id link = mesh.Links[4 * t + i];
      if (link >= LinkOutside)
      {
        ++outside;
        const Id b = link - LinkOutside;
        ASSERT_LT(b, mesh.BoundaryFaces.size());
        auto face = mesh.BoundaryFaces[b];
        EXPECT_EQ(face[3], 4 * t + i);
        std::sort(face.begin(), face.begin() + 3);
        EXPECT_TRUE(std::equal(face.begin(), face.begin() + 3, faceOf(mesh, t, i).begin()));
      }
      else
      {
        ASSERT_LT(link, 4 * tets);
        ASSERT_NE(link / 4, t);
        EXPECT_FALSE(mesh.isDegenerate(link / 4));
        EXPECT_EQ(faceOf(mesh, link / 4, link % 4), faceOf(mesh, t, i));
        EXPECT_EQ(mesh.Links[link], 4 * t + i);
      }
    }
  }
  EXPECT_EQ(outside, mesh.BoundaryFaces.size());
}
} // namespace tetmarch::testing

#endif
