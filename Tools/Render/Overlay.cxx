// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCoordinate.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace tetmarch
{

namespace
{

void SetSize(vtkTextProperty* text, double size)
{
  text->SetFontSize(static_cast<int>(std::lround(size)));
}

/// VTK brings text to whole pixels. This is the same one, whether that is up or down.
double WithinPixel(double place) { return std::floor(place) + 0.25; }

unsigned char ToByte(double channel)
{
  return static_cast<unsigned char>(std::lround(255.0 * channel));
}

} // namespace

Overlay::Overlay(const std::array<int, 2>& pictureSize, const std::array<double, 3>& color,
  double lineWidth, vtkRenderer* renderer)
  : PictureSize(pictureSize)
  , Color(color)
  , Renderer(renderer)
{
  this->AddActor(this->Rectangles, lineWidth);
  this->AddActor(this->Lines, lineWidth);
  this->Clear();
}

void Overlay::AddActor(vtkPolyData* data, double lineWidth)
{
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  mapper->SetTransformCoordinate(coordinate);
  mapper->TransformCoordinateUseDoubleOn();
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(this->Color.data());
  actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
  this->Renderer->AddViewProp(actor);
}

void Overlay::Clear()
{
  for (const auto& text : this->Texts)
  {
    this->Renderer->RemoveViewProp(text);
  }
  this->Texts.clear();
  for (vtkPolyData* data : { this->Rectangles.Get(), this->Lines.Get() })
  {
    data->Initialize();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data->SetPoints(points);
  }
  this->Lines->SetLines(vtkNew<vtkCellArray>());
  this->Rectangles->SetPolys(vtkNew<vtkCellArray>());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  this->Rectangles->GetCellData()->SetScalars(colors);
}

vtkIdType Overlay::AddPoint(vtkPolyData* data, const Point& point)
{
  return data->GetPoints()->InsertNextPoint(
    point[0] / this->PictureSize[0], point[1] / this->PictureSize[1], 0.0);
}

void Overlay::AddLine(const Point& a, const Point& b)
{
  const vtkIdType from = this->AddPoint(this->Lines, a);
  const vtkIdType to = this->AddPoint(this->Lines, b);
  this->Lines->GetLines()->InsertNextCell({ from, to });
}

void Overlay::AddRectangle(
  const Point& low, const Point& high, const std::array<double, 3>& color, double opacity)
{
  const vtkIdType a = this->AddPoint(this->Rectangles, low);
  const vtkIdType b = this->AddPoint(this->Rectangles, { { high[0], low[1] } });
  const vtkIdType c = this->AddPoint(this->Rectangles, high);
  const vtkIdType d = this->AddPoint(this->Rectangles, { { low[0], high[1] } });
  this->Rectangles->GetPolys()->InsertNextCell({ a, b, c, d });
  const unsigned char rgba[4] = { ToByte(color[0]), ToByte(color[1]), ToByte(color[2]),
    ToByte(opacity) };
  vtkUnsignedCharArray::SafeDownCast(this->Rectangles->GetCellData()->GetScalars())
    ->InsertNextTypedTuple(rgba);
}

void Overlay::AddText(const std::string& text, double size, const Point& place, Anchors anchor)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetColor(this->Color.data());
  property->SetVerticalJustificationToCentered();
  anchor == CENTER ? property->SetJustificationToCentered() : property->SetJustificationToLeft();
  SetSize(property, size);
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(
    WithinPixel(place[0]) / this->PictureSize[0], WithinPixel(place[1]) / this->PictureSize[1]);
  this->Renderer->AddViewProp(actor);
  this->Texts.push_back(actor);
}

std::array<int, 2> Overlay::Measure(const std::string& text, double size)
{
  constexpr int dotsPerInch = 72; // of windows, unless told otherwise
  vtkNew<vtkTextProperty> property;
  SetSize(property, size);
  int box[4] = { 0, -1, 0, -1 };
  if (vtkTextRenderer* measure = vtkTextRenderer::GetInstance())
  {
    measure->GetBoundingBox(property, vtkStdString(text), box, dotsPerInch);
  }
  return { { box[1] - box[0] + 1, box[3] - box[2] + 1 } };
}

double Overlay::FindSize(const std::vector<std::string>& texts, double wished, double width)
{
  constexpr double least = 6.0;
  double size = wished;
  for (const std::string& text : texts)
  {
    while (size > least && Measure(text, size)[0] > width)
    {
      size -= 1.0;
    }
  }
  return size;
}

} // namespace tetmarch
