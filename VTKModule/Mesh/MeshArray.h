// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array of a mesh that is stored or, of a curvilinear grid, computed.
#ifndef TetMarchMeshMeshArray_h
#define TetMarchMeshMeshArray_h

#include "Mesh/CurvilinearCells.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

namespace tetmarch
{

/** Either stored() values, or Rule::size(cells) ones: value i is Rule::at(cells, i). */
template <typename Rule>
class MeshArray
{
public:
  using Value = typename Rule::Value;

  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Value;
    using difference_type = std::ptrdiff_t;
    using pointer = const Value*;
    using reference = Value;

    Iterator(const MeshArray& array, std::size_t index)
      : Array(&array)
      , Index(index)
    {
    }
    Value operator*() const { return (*this->Array)[this->Index]; }
    Iterator& operator++()
    {
      ++this->Index;
      return *this;
    }
    bool operator==(const Iterator& other) const { return this->Index == other.Index; }
    bool operator!=(const Iterator& other) const { return this->Index != other.Index; }

  private:
    const MeshArray* Array;
    std::size_t Index;
  };

  Value operator[](std::size_t i) const
  {
    return this->Cells ? Rule::at(*this->Cells, i) : this->Stored[i];
  }
  std::size_t size() const { return this->Cells ? Rule::size(*this->Cells) : this->Stored.size(); }
  bool empty() const { return this->size() == 0; }
  Iterator begin() const { return { *this, 0 }; }
  Iterator end() const { return { *this, this->size() }; }
  Value back() const { return (*this)[this->size() - 1]; }
  bool operator==(const MeshArray& other) const
  {
    return this->size() == other.size() && std::equal(this->begin(), this->end(), other.begin());
  }

  /** Of a mesh that isn't curvilinear. */
  std::vector<Value>& stored() { return this->Stored; }
  /** From now on the values follow from these. */
  void compute(std::shared_ptr<const CurvilinearCells> cells)
  {
    this->Cells = std::move(cells);
    this->Stored = {};
  }

private:
  std::vector<Value> Stored;
  std::shared_ptr<const CurvilinearCells> Cells;
};

struct VerticesOfTets
{
  using Value = std::array<Id, 4>;
  static Value at(const CurvilinearCells& cells, std::size_t tet) { return cells.tet(tet); }
  static std::size_t size(const CurvilinearCells& cells) { return cells.numberOfTets(); }
};

struct LinksOfHalfFaces
{
  using Value = Id;
  static Id at(const CurvilinearCells& cells, std::size_t halfFace) { return cells.link(halfFace); }
  static std::size_t size(const CurvilinearCells& cells) { return 4 * cells.numberOfTets(); }
};

struct CellsOfTets
{
  using Value = Id;
  static Id at(const CurvilinearCells&, std::size_t tet)
  {
    return static_cast<Id>(tet / CurvilinearCells::TetsOfCell);
  }
  static std::size_t size(const CurvilinearCells& cells) { return cells.numberOfTets(); }
};

struct PointsOfVertices
{
  using Value = Id;
  static Id at(const CurvilinearCells&, std::size_t vertex) { return static_cast<Id>(vertex); }
  static std::size_t size(const CurvilinearCells& cells) { return cells.numberOfPoints(); }
};

} // namespace tetmarch

#endif
