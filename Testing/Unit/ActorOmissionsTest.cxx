// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Each visible prop that is not in a page is named in a sentence of its own.
#include "WebPage/SceneSurfaces.h"

#include "OpaqueProps.h"
#include "Shot.h"

#include "vtkActor2D.h"
#include "vtkDataSetMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkVolume.h"

#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// How an actor or its renderer differs from one that is shown, and what is said about it.
struct Case
{
  std::function<void(vtkRenderer*, vtkActor*)> Change;
  std::vector<std::string> Sentences;
};

vtkSmartPointer<vtkPolyData> unitPlate()
{
  return plate({ { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } });
}

vtkSmartPointer<vtkPolyData> plateWithLine()
{
  const auto data = unitPlate();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkActor2D> addFlat(vtkRenderer* renderer, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer->AddViewProp(actor);
  return actor;
}

class OtherProp : public vtkProp
{
public:
  static OtherProp* New();
  vtkTypeMacro(OtherProp, vtkProp);
};
vtkStandardNewMacro(OtherProp);

TEST(ActorOmissions, AreSentences)
{
  const auto hidden = [](vtkRenderer* r, vtkProp* prop)
  {
    prop->VisibilityOff();
    r->AddViewProp(prop);
  };
  const Case cases[] = {
    { [](vtkRenderer*, vtkActor*) {}, {} },
    { [](vtkRenderer*, vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); },
      { "The wireframe of 1 actor is not in the page: it shows triangles." } },
    { [](vtkRenderer*, vtkActor* a) { a->GetProperty()->SetRepresentationToPoints(); },
      { "Points of 1 actor are not in the page: it shows triangles." } },
    { [](vtkRenderer*, vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); },
      { "Edges of 1 actor are not in the page: it shows triangles." } },
    { [](vtkRenderer*, vtkActor* a) { a->GetProperty()->SetOpacity(0.5); },
      { "Translucent surfaces of 1 actor are not in the page: it shows opaque ones." } },
    { [](vtkRenderer*, vtkActor* a) { a->SetBackfaceProperty(vtkNew<vtkProperty>()); },
      { "Properties of back faces of 1 actor are not in the page: both sides look alike." } },
    { [](vtkRenderer*, vtkActor* a) { a->GetMapper()->AddClippingPlane(vtkNew<vtkPlane>()); },
      { "Clipping planes of 1 actor are not in the page: it shows the whole surface." } },
    { [](vtkRenderer*, vtkActor* a) { a->GetProperty()->SetInterpolationToPBR(); },
      { "Physically based light on 1 actor is not in the page: it has ambient, diffuse and "
        "specular light." } },
    { [](vtkRenderer* r, vtkActor*)
      {
        r->AddActor(actorOf(plateWithLine()));
        r->AddActor(actorOf(plateWithLine()));
      },
      { "Lines of 2 actors are not in the page: it shows triangles." } },
    { [](vtkRenderer* r, vtkActor*)
      {
        vtkNew<vtkDataSetMapper> mapper;
        mapper->SetInputData(unitPlate());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        r->AddActor(actor);
      },
      { "Surfaces of 1 actor are not in the page: they are known once they have been drawn; "
        "render the window first." } },
    { [&](vtkRenderer* r, vtkActor*) { addFlat(r, unitPlate()); },
      { "Texts and other 2D props are not in the page: it draws a scalar bar and axes of its "
        "own." } },
    { [&](vtkRenderer* r, vtkActor*) { addFlat(r, vtkNew<vtkPolyData>()); }, {} },
    { [&](vtkRenderer* r, vtkActor*) { hidden(r, addFlat(r, unitPlate())); }, {} },
    { [](vtkRenderer* r, vtkActor*) { r->AddViewProp(vtkNew<OtherProp>()); },
      { "Props of the class OtherProp (1) are not in the page: it shows surfaces and volumes." } },
    { [](vtkRenderer* r, vtkActor*) { r->AddVolume(vtkNew<vtkVolume>()); }, {} },
  };
  for (const Case& one : cases)
  {
    vtkNew<WindowlessRenderer> renderer;
    const auto actor = actorOf(unitPlate());
    renderer->AddActor(actor);
    one.Change(renderer, actor);
    std::vector<std::string> said;
    opaqueSurfaces(renderer, said);
    EXPECT_EQ(said, one.Sentences);
  }
}
} // namespace
