// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BoundaryHierarchy.h"

#include "Mesh/HullFaces.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tetmarch
{
namespace
{

constexpr int MostFacesOfLeaf = 4;
constexpr int Bins = 16;
constexpr std::size_t MostFacesOfSubtree = 8192; // built by one thread
static_assert(MostHierarchyFaces <= MostFacesOfLeaf << (MostHierarchyDepth / 2 - 1),
  "medians reach leaves in half of the depth");

struct Box
{
  std::array<float, 3> Low, High;
  Box()
  {
    this->Low.fill(std::numeric_limits<float>::max());
    this->High.fill(std::numeric_limits<float>::lowest());
  }
  void add(const std::array<float, 3>& p)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], p[k]);
      this->High[k] = std::max(this->High[k], p[k]);
    }
  }
  void add(const Box& b)
  {
    this->add(b.Low);
    this->add(b.High);
  }
  float halfArea() const
  {
    const float x = this->High[0] - this->Low[0];
    const float y = this->High[1] - this->Low[1];
    const float z = this->High[2] - this->Low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

class Builder
{
public:
  explicit Builder(TetMesh& mesh)
    : Mesh(mesh)
    , Boxes(mesh.BoundaryFaces.size())
    , Order(mesh.BoundaryFaces.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), Id(0));
    for (std::size_t f = 0; f < this->Boxes.size(); ++f)
    {
      for (int i = 0; i < 3; ++i)
      {
        const Vertex& v = mesh.Vertices[mesh.BoundaryFaces[f][i]];
        this->Boxes[f].add({ { v.X, v.Y, v.Z } });
      }
    }
  }

  // Build a tree of the faces for which `first` is true, then one of the others. Returns the number
  // of nodes of the first.
  std::size_t build(const std::vector<bool>& first)
  {
    const auto middle = std::stable_partition(
      this->Order.begin(), this->Order.end(), [&first](Id f) { return first[f]; });
    const std::size_t count = middle - this->Order.begin();
    this->Mesh.Hierarchy.clear();
    this->addTree({ 0, count, 1 });
    const std::size_t nodes = this->Mesh.Hierarchy.size();
    this->addTree({ count, this->Order.size(), 1 });
    std::vector<std::array<Id, 4>> faces(this->Order.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      faces[i] = this->Mesh.BoundaryFaces[this->Order[i]];
    }
    this->Mesh.BoundaryFaces.swap(faces);
    return nodes;
  }

private:
  // Faces of a node, by their places in the order; the depth of a root is 1.
  struct Range
  {
    std::size_t First, Last;
    int Depth;
  };
  using Nodes = std::vector<HierarchyNode>;
  // A subtree, or a node above subtrees, which has the next two parts and their parts as children.
  struct Part
  {
    Range Faces;
    Nodes Built;
    bool IsSubtree;
  };

  float center(Id face, int axis) const
  {
    return 0.5f * (this->Boxes[face].Low[axis] + this->Boxes[face].High[axis]);
  }

  void addTree(const Range& range)
  {
    std::vector<Part> parts;
    this->plan(range, parts);
    parallelFor(0, static_cast<vtkIdType>(parts.size()), 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          if (parts[i].IsSubtree)
          {
            this->split(parts[i].Faces, parts[i].Built);
          }
        }
      });
    this->append(parts, 0);
  }

  void plan(const Range& range, std::vector<Part>& parts)
  {
    Part part{ range, {}, range.Last - range.First <= MostFacesOfSubtree };
    const std::size_t middle = part.IsSubtree ? 0 : this->divide(range, part.Built);
    parts.push_back(std::move(part));
    if (middle > 0)
    {
      this->plan({ range.First, middle, range.Depth + 1 }, parts);
      this->plan({ middle, range.Last, range.Depth + 1 }, parts);
    }
  }

  // Append a part and its children to the tree. Returns the number of the part behind them.
  std::size_t append(const std::vector<Part>& parts, std::size_t number)
  {
    Nodes& all = this->Mesh.Hierarchy;
    const Part& part = parts[number++];
    const std::size_t node = all.size();
    all.insert(all.end(), part.Built.begin(), part.Built.end());
    if (part.IsSubtree)
    {
      std::for_each(all.begin() + node, all.end(),
        [node](HierarchyNode& n) { n.Second += n.FirstFace < 0 ? static_cast<float>(node) : 0; });
      return number;
    }
    number = this->append(parts, number);
    all[node].Second = static_cast<float>(all.size());
    return this->append(parts, number);
  }

  // Write the node of a range of faces and its subtree.
  void split(const Range& range, Nodes& nodes)
  {
    if (range.First == range.Last)
    {
      return;
    }
    const std::size_t node = nodes.size();
    if (const std::size_t middle = this->divide(range, nodes))
    {
      this->split({ range.First, middle, range.Depth + 1 }, nodes);
      nodes[node].Second = static_cast<float>(nodes.size());
      this->split({ middle, range.Last, range.Depth + 1 }, nodes);
    }
  }

  // Write the node of a range of faces. Returns where its second child begins, 0 for a leaf. A cut
  // that leaves more than 7/8 of the faces on one side is replaced by the median, and so is each
  // cut from half of the maximum depth on: 24 levels of halves suffice for the maximum number of
  // faces.
  std::size_t divide(const Range& range, Nodes& nodes)
  {
    const auto [first, last, depth] = range;
    Box box, centers;
    for (std::size_t i = first; i < last; ++i)
    {
      const Id f = this->Order[i];
      box.add(this->Boxes[f]);
      centers.add({ { this->center(f, 0), this->center(f, 1), this->center(f, 2) } });
    }
    HierarchyNode node = makeNode(box);
    const std::size_t count = last - first;
    std::size_t middle = 0;
    if (count <= MostFacesOfLeaf)
    {
      node.FirstFace = static_cast<float>(first);
      node.Second = static_cast<float>(count);
    }
    else
    {
      int axis = 0;
      for (int k = 1; k < 3; ++k)
      {
        axis = centers.High[k] - centers.Low[k] > centers.High[axis] - centers.Low[axis] ? k : axis;
      }
      node.FirstFace = static_cast<float>(-1 - axis);
      middle = this->cut(first, last, axis, centers.Low[axis], centers.High[axis]);
      if (std::min(middle - first, last - middle) < count / 8 + 1 || depth > MostHierarchyDepth / 2)
      {
        middle = first + count / 2;
        this->placeMedian(first, middle, last, axis);
      }
    }
    nodes.push_back(node);
    return middle;
  }

  void placeMedian(std::size_t first, std::size_t middle, std::size_t last, int axis)
  {
    std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
      this->Order.begin() + last,
      [this, axis](Id a, Id b) {
        return std::make_pair(this->center(a, axis), a) < std::make_pair(this->center(b, axis), b);
      });
  }

  // Partition at the bin border with the minimum expected cost.
  std::size_t cut(std::size_t first, std::size_t last, int axis, float low, float high)
  {
    const float scale = high > low ? static_cast<float>(Bins) / (high - low) : 0.0f;
    const auto binOf = [&](Id f)
    {
      return std::min(
        std::max(static_cast<int>((this->center(f, axis) - low) * scale), 0), Bins - 1);
    };
    std::array<Box, Bins> boxes;
    std::array<int, Bins> counts{};
    for (std::size_t i = first; i < last; ++i)
    {
      const int bin = binOf(this->Order[i]);
      boxes[bin].add(this->Boxes[this->Order[i]]);
      ++counts[bin];
    }
    std::array<float, Bins> above{};
    Box box;
    int count = 0;
    for (int b = Bins - 1; b > 0; --b)
    {
      box.add(boxes[b]);
      count += counts[b];
      above[b] = static_cast<float>(count) * box.halfArea();
    }
    box = Box();
    count = 0;
    int best = 1;
    float least = std::numeric_limits<float>::max();
    for (int b = 1; b < Bins; ++b)
    {
      box.add(boxes[b - 1]);
      count += counts[b - 1];
      const float cost = static_cast<float>(count) * box.halfArea() + above[b];
      best = cost < least ? b : best;
      least = std::min(least, cost);
    }
    const auto middle = std::partition(this->Order.begin() + first, this->Order.begin() + last,
      [&](Id f) { return binOf(f) < best; });
    return middle - this->Order.begin();
  }

  static HierarchyNode makeNode(const Box& box)
  {
    HierarchyNode node;
    for (int k = 0; k < 3; ++k)
    {
      node.Center[k] = 0.5f * (box.Low[k] + box.High[k]);
      node.HalfSize[k] = 0.5f * (box.High[k] - box.Low[k]) + HierarchyMargin;
    }
    node.Second = 0;
    node.FirstFace = -1;
    return node;
  }

  TetMesh& Mesh;
  std::vector<Box> Boxes;
  std::vector<Id> Order;
};

} // namespace

void buildHierarchy(TetMesh& mesh)
{
  // Finding the faces on the hull needs a tree; the result decides how the final trees are split.
  Builder(mesh).build(std::vector<bool>(mesh.BoundaryFaces.size(), true));
  std::vector<bool> reentry = findHullFaces(mesh);
  reentry.flip();
  mesh.ReentryNodes = Builder(mesh).build(reentry);
  mesh.ReentryFaces = std::count(reentry.begin(), reentry.end(), true);
}

} // namespace tetmarch
