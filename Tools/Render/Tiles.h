// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture that is larger than its window, tile by tile.
 */
#ifndef tetmarch_Tiles_h
#define tetmarch_Tiles_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkCamera;
class vtkRenderer;
class vtkRenderWindow;

namespace tetmarch
{

/**
 * All tiles are equally large, and along each side of the picture there is a power of two of them:
 * by other shares VTK would round 2D actors to the pixel beside theirs. Together they are the
 * picture, or larger at its right and its top. The renderer's viewport is the picture, so 2D actors
 * stand where they would stand in a window as large as the picture. A transformation of the camera,
 * behind its projection, does the same for all else, so every ray is the one of that window.
 */
class Tiles
{
public:
  /// With a maximum number of pixels along each side of a tile.
  Tiles(const std::array<int, 2>& pictureSize, int largest);

  /// Of the window.
  const std::array<int, 2>& GetTileSize() const { return this->TileSize; }

  bool IsOne() const { return this->Counts == std::array<int, 2>{ { 1, 1 } }; }

  /// Before anything is drawn into the window, which must have the size of a tile.
  void SetUp(vtkRenderWindow* window, vtkRenderer* renderer) const;

  /// Draws all tiles and puts them together: red, green, blue, or with opacity behind that.
  vtkSmartPointer<vtkImageData> Draw(
    vtkRenderWindow* window, vtkRenderer* renderer, bool opacity) const;

  /// The picture of the only tile, as it was drawn last.
  vtkSmartPointer<vtkImageData> Read(vtkRenderWindow* window, bool opacity) const;

private:
  /// What of a tile is picture, in pixels of the picture.
  struct Part
  {
    std::array<int, 2> Begin;
    std::array<int, 2> Count;
  };

  Part GetPart(const std::array<int, 2>& tile) const;
  void LookAt(const Part& part, vtkCamera* camera) const;
  vtkSmartPointer<vtkImageData> MakePicture(bool opacity) const;
  void Copy(vtkRenderWindow* window, const Part& part, vtkImageData* picture) const;

  std::array<int, 2> PictureSize;
  std::array<int, 2> Counts;
  std::array<int, 2> TileSize;
};

} // namespace tetmarch

#endif
