// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The nodes of either kind of function as arrays of numbers, and back with as few changes as there
 * are: who listens to a function should not be told of a half of it.
 */
#ifndef tetmarch_FunctionNodes_h
#define tetmarch_FunctionNodes_h

#include "FunctionSnapshot.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

namespace tetmarch
{

inline auto GetNodes(vtkColorTransferFunction* function)
{
  std::vector<FunctionSnapshot::ColorNode> nodes(function->GetSize());
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, nodes[i].data());
  }
  return nodes;
}

inline auto GetNodes(vtkPiecewiseFunction* function)
{
  std::vector<FunctionSnapshot::OpacityNode> nodes(function->GetSize());
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, nodes[i].data());
  }
  return nodes;
}

inline void AddNode(vtkColorTransferFunction* function, const FunctionSnapshot::ColorNode& node)
{
  function->AddRGBPoint(node[0], node[1], node[2], node[3], node[4], node[5]);
}

inline void AddNode(vtkPiecewiseFunction* function, const FunctionSnapshot::OpacityNode& node)
{
  function->AddPoint(node[0], node[1], node[2], node[3]);
}

/// The node whose value is shown at a place; null if there is none.
template <typename Nodes, typename ToAxis>
const typename Nodes::value_type* FindNode(const Nodes& nodes, double place, ToAxis toAxis)
{
  const auto found = std::find_if(
    nodes.begin(), nodes.end(), [&](const auto& node) { return toAxis(node[0]) == place; });
  return found == nodes.end() ? nullptr : &*found;
}

/// Gives a function these nodes. If one was moved, added or removed, listeners are told once.
template <typename Function, typename Nodes>
void SetNodes(Function* function, const Nodes& nodes)
{
  const auto old = GetNodes(function);
  if (old == nodes)
  {
    return;
  }
  const auto first = std::mismatch(old.begin(), old.end(), nodes.begin(), nodes.end());
  const auto at = first.second - nodes.begin();
  if (old.size() == nodes.size() && std::equal(first.first + 1, old.end(), first.second + 1))
  {
    auto node = nodes[at];
    function->SetNodeValue(static_cast<int>(at), node.data());
  }
  else if (old.size() + 1 == nodes.size() && std::equal(first.first, old.end(), first.second + 1))
  {
    AddNode(function, nodes[at]);
  }
  else if (old.size() == nodes.size() + 1 && std::equal(first.first + 1, old.end(), first.second))
  {
    function->RemovePoint(old[at][0]);
  }
  if (GetNodes(function) != nodes)
  {
    function->RemoveAllPoints();
    for (const auto& node : nodes)
    {
      AddNode(function, node);
    }
  }
}

} // namespace tetmarch

#endif
