// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests whether a ray hits any of many triangles.
#ifndef TetMarchLightTriangleHierarchy_h
#define TetMarchLightTriangleHierarchy_h

#include "Geometry/Vector3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** A thread-safe bounding volume hierarchy. VTK 9.1's vtkModifiedBSPTree and vtkOBBTree are not
 * thread-safe, and vtkStaticCellLocator accesses a flag of every cell for each ray. */
class TriangleHierarchy
{
public:
  /** Triangles consist of indices of points, which must be finite. */
  TriangleHierarchy(
    std::vector<Vector3> points, std::vector<std::array<std::uint32_t, 3>> triangles);

  /**
   * Whether origin + t direction, 0 < t < end, hits a triangle from either side. No ray passes
   * between triangles that share an edge (Woop, Benthin and Wald 2013, "Watertight ray/triangle
   * intersection"). False for numbers that aren't finite.
   */
  bool isHit(const Vector3& origin, const Vector3& direction, double end) const;

  /** The tree in single precision, for a shader. Its coordinates are about center(), in units of
   * radius(). */
  struct Packed
  {
    std::vector<std::array<float, 4>> Texels; // see Shaders/light/opaque_surface_buffers.glsl
    std::size_t Leaves = 0;
    std::size_t TrianglesOfLeaf = 0;
  };
  Packed packed() const;
  const Vector3& center() const { return this->Center; }
  double radius() const { return this->Radius; }
  bool empty() const { return this->Triangles.empty(); }

private:
  struct Box
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
  };
  struct Ray;

  void moveToUnitBox();
  void sort();
  void sortNode(std::size_t level, std::size_t node,
    const std::vector<std::array<float, 3>>& centers, std::vector<std::uint32_t>& order) const;
  void fitBoxes();
  Box boxOf(std::size_t leaf) const;
  std::size_t begin(std::size_t level, std::size_t node) const
  {
    return this->Triangles.size() * node >> level;
  }
  bool isHit(const Ray& ray, const std::array<std::uint32_t, 3>& triangle) const;

  std::vector<Vector3> Points; // about Center, in units of Radius
  std::vector<std::array<std::uint32_t, 3>> Triangles;
  Vector3 Center{ { 0, 0, 0 } };
  double Radius = 1;
  std::size_t Levels = 0; // below the root
  std::vector<Box> Boxes; // of nodes from 1: the children of n are 2 n and 2 n + 1
};

} // namespace tetmarch

#endif
