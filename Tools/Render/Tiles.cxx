// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{

namespace
{
/// The period in pixels of the noise of samples and shadows, which continues from tile to tile.
constexpr int NoisePeriod = 64;
} // namespace

Tiles::Tiles(const std::array<int, 2>& pictureSize, int largest)
  : PictureSize(pictureSize)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    int count = 1;
    while (count * largest < pictureSize[axis])
    {
      count *= 2;
    }
    this->Counts[axis] = count;
    const int size = (pictureSize[axis] + count - 1) / count;
    const int withNoise = (size + NoisePeriod - 1) / NoisePeriod * NoisePeriod;
    this->TileSize[axis] = count > 1 && withNoise <= largest ? withNoise : size;
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

Tiles::Part Tiles::GetPart(const std::array<int, 2>& tile) const
{
  Part part;
  for (int axis = 0; axis < 2; ++axis)
  {
    part.Begin[axis] = tile[axis] * this->TileSize[axis];
    part.Count[axis] = std::min(this->TileSize[axis], this->PictureSize[axis] - part.Begin[axis]);
  }
  return part;
}

// In the coordinates behind the projection the renderer has the part reach from -1 to 1 upwards,
// and as far across as the part's aspect says. There, and in this order: make the part the whole
// picture, as the camera's window centre shifts it; stretch the picture until the part fills it.
void Tiles::LookAt(const Part& part, vtkCamera* camera) const
{
  const double* shift = camera->GetWindowCenter();
  const double heights = static_cast<double>(this->PictureSize[1]) / part.Count[1];
  vtkNew<vtkTransform> transform;
  transform->PostMultiply();
  transform->Translate(shift[0], shift[1], 0.0);
  transform->Scale(static_cast<double>(part.Count[0]) / this->PictureSize[0] * heights, 1.0, 1.0);
  transform->Translate(-shift[0], -shift[1], 0.0);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = this->PictureSize[axis];
    const double middle = (2.0 * part.Begin[axis] + part.Count[axis]) / size - 1.0;
    const double stretch = size / part.Count[axis];
    transform->Translate(axis == 0 ? -middle : 0.0, axis == 1 ? -middle : 0.0, 0.0);
    transform->Scale(axis == 0 ? stretch : 1.0, axis == 1 ? stretch : 1.0, 1.0);
  }
  camera->SetUserTransform(transform);
}

void Tiles::Copy(vtkRenderWindow* window, const Part& part, vtkImageData* picture) const
{
  const auto& [begin, count] = part;
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

vtkSmartPointer<vtkImageData> Tiles::Draw(
  vtkRenderWindow* window, vtkRenderer* renderer, bool opacity) const
{
  auto picture = this->MakePicture(opacity);
  const double width = 1.0 / this->Counts[0];
  const double height = 1.0 / this->Counts[1];
  for (int y = 0; y * this->TileSize[1] < this->PictureSize[1]; ++y)
  {
    for (int x = 0; x * this->TileSize[0] < this->PictureSize[0]; ++x)
    {
      const Part part = this->GetPart({ { x, y } });
      this->LookAt(part, renderer->GetActiveCamera());
      window->SetTileViewport(x * width, y * height, (x + 1) * width, (y + 1) * height);
      window->Render();
      this->Copy(window, part, picture);
    }
  }
  renderer->GetActiveCamera()->SetUserTransform(nullptr);
  return picture;
}

vtkSmartPointer<vtkImageData> Tiles::Read(vtkRenderWindow* window, bool opacity) const
{
  auto picture = this->MakePicture(opacity);
  this->Copy(window, this->GetPart({ { 0, 0 } }), picture);
  return picture;
}

} // namespace tetmarch
