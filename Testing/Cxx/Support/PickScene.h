// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene in which things are picked: rays of pixels, and what selectors find
 */
#ifndef tetmarch_testing_PickScene_h
#define tetmarch_testing_PickScene_h

#include "ClosedForms.h"
#include "Scene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkProp.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace tetmarch::testing
{
/// Props, and which of their cells or points.
using Selected = std::map<vtkProp*, std::set<vtkIdType>>;
/// Flat indices of blocks, and which of their cells.
using SelectedInBlocks = std::map<int, std::set<vtkIdType>>;

class PickScene : public Scene
{
public:
  using Scene::Scene;

  /// The ray of the middle of a pixel, from the near plane on.
  struct PixelLine
  {
    Vec3 Near;
    Vec3 Direction; // unit length
    Vec3 at(double distance) const
    {
      return { this->Near[0] + distance * this->Direction[0],
        this->Near[1] + distance * this->Direction[1],
        this->Near[2] + distance * this->Direction[2] };
    }
  };

  PixelLine lineOf(int x, int y)
  {
    const Vec3 near = this->worldAt(x, y, 0.0);
    const Vec3 far = this->worldAt(x, y, 1.0);
    const Vec3 d{ far[0] - near[0], far[1] - near[1], far[2] - near[2] };
    const double length = std::hypot(d[0], d[1], d[2]);
    return { near, { d[0] / length, d[1] / length, d[2] / length } };
  }

  bool pick(int x, int y) { return this->Mapper->Pick(this->Renderer, this->Volume, x, y); }
  Vec3 pickedPosition() const
  {
    const double* p = this->Mapper->GetPickedPosition();
    return { p[0], p[1], p[2] };
  }

  /// In a rectangle, corners included.
  Selected select(unsigned int left, unsigned int bottom, unsigned int right, unsigned int top,
    int association = vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    Selected found;
    this->forEachNode(left, bottom, right, top, association,
      [&](vtkInformation* of, const std::set<vtkIdType>& ids)
      {
        auto* prop = vtkProp::SafeDownCast(of->Get(vtkSelectionNode::PROP()));
        found[prop].insert(ids.begin(), ids.end());
      });
    return found;
  }
  Selected selectAll(int association = vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    const int* size = this->Window->GetSize();
    return this->select(0, 0, size[0] - 1, size[1] - 1, association);
  }
  SelectedInBlocks selectAllInBlocks()
  {
    const int* size = this->Window->GetSize();
    SelectedInBlocks found;
    this->forEachNode(0, 0, size[0] - 1, size[1] - 1, vtkDataObject::FIELD_ASSOCIATION_CELLS,
      [&](vtkInformation* of, const std::set<vtkIdType>& ids)
      { found[of->Get(vtkSelectionNode::COMPOSITE_INDEX())].insert(ids.begin(), ids.end()); });
    return found;
  }

private:
  template <typename Take>
  void forEachNode(unsigned int left, unsigned int bottom, unsigned int right, unsigned int top,
    int association, Take&& take)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(left, bottom, right, top);
    selector->SetFieldAssociation(association);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      take(node->GetProperties(),
        std::set<vtkIdType>(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples()));
    }
  }

  Vec3 worldAt(int x, int y, double depth)
  {
    this->Renderer->SetDisplayPoint(x + 0.5, y + 0.5, depth);
    this->Renderer->DisplayToWorld();
    const double* p = this->Renderer->GetWorldPoint();
    return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }
};

struct Even
{
  static constexpr double Opacity = 0.6;
  static constexpr double UnitDistance = 0.25;
};

/// The unit cube, of the same extinction everywhere.
inline std::unique_ptr<PickScene> evenScene(vtkUnstructuredGrid* grid)
{
  auto scene = std::make_unique<PickScene>(grid);
  setPlainFunctions(scene->property(), { { 1.0, 0.8, 0.6 } }, Even::Opacity);
  scene->property()->SetScalarOpacityUnitDistance(Even::UnitDistance);
  scene->Window->Render();
  return scene;
}
} // namespace tetmarch::testing

#endif
