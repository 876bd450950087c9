// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{

Tiles::Tiles(const std::array<int, 2>& pictureSize, int largest)
  : PictureSize(pictureSize)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Counts[axis] = (pictureSize[axis] + largest - 1) / largest;
    this->TileSize[axis] = (pictureSize[axis] + this->Counts[axis] - 1) / this->Counts[axis];
  }
}

void Tiles::SetUp(vtkRenderWindow* window, vtkRenderer* renderer) const
{
  if (!this->IsOne())
  {
    window->SetTileScale(this->Counts[0], this->Counts[1]);
    renderer->SetViewport(0.0, 0.0,
      static_cast<double>(this->PictureSize[0]) / (this->Counts[0] * this->TileSize[0]),
      static_cast<double>(this->PictureSize[1]) / (this->Counts[1] * this->TileSize[1]));
  }
}

vtkSmartPointer<vtkImageData> Tiles::MakePicture(bool opacity) const
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(this->PictureSize[0], this->PictureSize[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, opacity ? 4 : 3);
  return picture;
}

void Tiles::Copy(
  vtkRenderWindow* window, const std::array<int, 2>& tile, vtkImageData* picture) const
{
  std::array<int, 2> begin;
  std::array<int, 2> count;
  for (int axis = 0; axis < 2; ++axis)
  {
    begin[axis] = tile[axis] * this->TileSize[axis];
    count[axis] = std::min(this->TileSize[axis], this->PictureSize[axis] - begin[axis]);
  }
  const int components = picture->GetNumberOfScalarComponents();
  vtkNew<vtkUnsignedCharArray> pixels;
  constexpr int backBuffer = 0;
  if (components == 4)
  {
    window->GetRGBACharPixelData(0, 0, count[0] - 1, count[1] - 1, backBuffer, pixels);
  }
  else
  {
    window->GetPixelData(0, 0, count[0] - 1, count[1] - 1, backBuffer, pixels);
  }
  const vtkIdType row = vtkIdType(count[0]) * components;
  for (int y = 0; y < count[1]; ++y)
  {
    const unsigned char* from = pixels->GetPointer(y * row);
    std::copy(from, from + row,
      static_cast<unsigned char*>(picture->GetScalarPointer(begin[0], begin[1] + y, 0)));
  }
}

vtkSmartPointer<vtkImageData> Tiles::Draw(vtkRenderWindow* window, bool opacity) const
{
  auto picture = this->MakePicture(opacity);
  const int count = this->Counts[0] * this->Counts[1];
  for (int i = 0; i < count; ++i)
  {
    const std::array<int, 2> tile = { { i % this->Counts[0], i / this->Counts[0] } };
    const double width = 1.0 / this->Counts[0];
    const double height = 1.0 / this->Counts[1];
    window->SetTileViewport(
      tile[0] * width, tile[1] * height, (tile[0] + 1) * width, (tile[1] + 1) * height);
    window->Render();
    this->Copy(window, tile, picture);
  }
  return picture;
}

vtkSmartPointer<vtkImageData> Tiles::Read(vtkRenderWindow* window, bool opacity) const
{
  auto picture = this->MakePicture(opacity);
  this->Copy(window, { { 0, 0 } }, picture);
  return picture;
}

} // namespace tetmarch
