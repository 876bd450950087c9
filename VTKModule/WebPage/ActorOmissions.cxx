// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/ActorOmissions.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyPath.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>

namespace tetmarch
{
namespace
{

// Volumes are told of elsewhere; the page draws bars and axes itself.
bool isNoSurface(vtkProp* prop)
{
  const char* classes[] = { "vtkVolume", "vtkScalarBarActor", "vtkAxesActor", "vtkAxisActor",
    "vtkAxisActor2D", "vtkCubeAxesActor", "vtkCubeAxesActor2D", "vtkGridAxesActor3D",
    "vtkPVGridAxes3DActor" };
  return std::any_of(
    std::begin(classes), std::end(classes), [prop](const char* name) { return prop->IsA(name); });
}

// False of an overlay that has been cleared, for one.
bool drawsAnything(vtkActor2D* actor)
{
  auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper());
  vtkPolyData* data = mapper ? mapper->GetInput() : nullptr;
  return mapper ? data && data->GetNumberOfCells() > 0 : actor->GetMapper() != nullptr;
}

struct CellCounts
{
  vtkIdType Vertices = 0;
  vtkIdType Lines = 0;
  vtkIdType Polygons = 0;

  void add(vtkDataObject* object)
  {
    if (auto* data = vtkPolyData::SafeDownCast(object))
    {
      this->Vertices += data->GetNumberOfVerts();
      this->Lines += data->GetNumberOfLines();
      this->Polygons += data->GetNumberOfPolys() + data->GetNumberOfStrips();
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
    {
      auto leaves = vtk::TakeSmartPointer(tree->NewTreeIterator());
      for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
      {
        this->add(leaves->GetCurrentDataObject());
      }
    }
  }
};

class Omissions
{
public:
  void addProp(vtkProp* prop)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (isNoSurface(prop))
    {
      return;
    }
    if (auto* flat = vtkActor2D::SafeDownCast(prop))
    {
      this->Flat = this->Flat || drawsAnything(flat);
    }
    else if (!actor)
    {
      ++this->OtherProps[prop->GetClassName()];
    }
    else if (vtkMapper* mapper = actor->GetMapper())
    {
      this->addActor(actor, mapper);
    }
  }

  void write(std::vector<std::string>& sentences) const
  {
    const std::string place = "{}";
    for (const auto& [sentence, count] : this->Actors)
    {
      std::string text = sentence;
      text.replace(
        text.find(place), place.size(), count == 1 ? "1 actor" : std::to_string(count) + " actors");
      sentences.push_back(text);
    }
    if (this->Flat)
    {
      sentences.push_back("Texts and other 2D props are not in the page: it draws a scalar bar and "
                          "axes of its own.");
    }
    for (const auto& [name, count] : this->OtherProps)
    {
      sentences.push_back("Props of the class " + name + " (" + std::to_string(count) +
                          ") are not in the page: it shows surfaces and volumes.");
    }
  }

private:
  void addActor(vtkActor* actor, vtkMapper* mapper)
  {
    auto* ofDataSet = vtkDataSetMapper::SafeDownCast(mapper);
    mapper = ofDataSet ? ofDataSet->GetPolyDataMapper() : mapper;
    if (!mapper)
    {
      this->add("Surfaces of {} are not in the page: they are known once they have been drawn; "
                "render the window first.");
    }
    else if (!drawsPolygons(mapper))
    {
      this->add(std::string("What a ") + mapper->GetClassName() +
                " draws for {} is not in the page: it shows polygons.");
    }
    else if (mapper->GetNumberOfInputConnections(0) > 0)
    {
      CellCounts cells;
      cells.add(mapper->GetInputDataObject(0, 0));
      this->addCells(actor, cells);
      this->addAppearance(actor, mapper, cells);
    }
  }

  void addCells(vtkActor* actor, const CellCounts& cells)
  {
    const int drawnAs = actor->GetProperty()->GetRepresentation();
    const bool any = cells.Vertices + cells.Lines + cells.Polygons > 0;
    this->addIf((drawnAs == VTK_POINTS && any) || cells.Vertices > 0,
      "Points of {} are not in the page: it shows triangles.");
    this->addIf(drawnAs == VTK_WIREFRAME && cells.Polygons > 0,
      "The wireframe of {} is not in the page: it shows triangles.");
    this->addIf(drawnAs != VTK_POINTS && cells.Lines > 0,
      "Lines of {} are not in the page: it shows triangles.");
  }

  void addAppearance(vtkActor* actor, vtkMapper* mapper, const CellCounts& cells)
  {
    vtkProperty* property = actor->GetProperty();
    if (property->GetRepresentation() != VTK_SURFACE || cells.Polygons == 0)
    {
      return;
    }
    this->addIf(actor->HasTranslucentPolygonalGeometry(),
      "Translucent surfaces of {} are not in the page: it shows opaque ones.");
    if (!actor->HasOpaqueGeometry())
    {
      return;
    }
    vtkPlaneCollection* planes = mapper->GetClippingPlanes();
    this->addIf(
      property->GetEdgeVisibility(), "Edges of {} are not in the page: it shows triangles.");
    this->addIf(actor->GetTexture() || property->GetNumberOfTextures() > 0,
      "Textures of {} are not in the page: it shows colours of points.");
    this->addIf(actor->GetBackfaceProperty(),
      "Properties of back faces of {} are not in the page: both sides look alike.");
    this->addIf(planes && planes->GetNumberOfItems() > 0,
      "Clipping planes of {} are not in the page: it shows the whole surface.");
    this->addIf(property->GetInterpolation() == VTK_PBR,
      "Physically based light on {} is not in the page: it has ambient, diffuse and specular "
      "light.");
  }

  void add(const std::string& sentence) { ++this->Actors[sentence]; }
  void addIf(bool condition, const char* sentence)
  {
    if (condition)
    {
      this->add(sentence);
    }
  }

  bool Flat = false;                     // some 2D prop is drawn
  std::map<std::string, int> Actors;     // counts of sentences, with {} in place of the actors
  std::map<std::string, int> OtherProps; // counts of classes
};

} // namespace

bool drawsPolygons(vtkMapper* mapper)
{
  const char* others[] = { "vtkPointGaussianMapper", "vtkOpenGLSphereMapper",
    "vtkOpenGLStickMapper" };
  const bool polygons = mapper->IsA("vtkPolyDataMapper") ||
                        mapper->IsA("vtkCompositePolyDataMapper") ||
                        mapper->IsA("vtkHierarchicalPolyDataMapper");
  return polygons && std::none_of(std::begin(others), std::end(others),
                       [mapper](const char* name) { return mapper->IsA(name); });
}

void addActorOmissions(vtkRenderer* renderer, std::vector<std::string>& omissions)
{
  Omissions found;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetVisibility() ? prop->GetNextPath() : nullptr)
    {
      vtkProp* part = path->GetLastNode()->GetViewProp();
      if (part->GetVisibility())
      {
        found.addProp(part);
      }
    }
  }
  found.write(omissions);
}

} // namespace tetmarch
