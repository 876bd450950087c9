// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes of VTK's tests of volume mappers for images, for any vtkSmartVolumeMapper
 */
#ifndef tetmarch_testing_ImageScene_h
#define tetmarch_testing_ImageScene_h

#include "Grids.h"
#include "Images.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"

#include <functional>
#include <string>
#include <vector>

namespace tetmarch::testing
{
/// What a scene is arranged of. The mapper has its data already.
struct ImageStage
{
  vtkSmartVolumeMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
  vtkVolumeProperty* Property = nullptr;
  vtkRenderer* Renderer = nullptr;
};

/// How far a picture by VTK 9.1's GPU mapper, in steps of a tenth of a voxel and into floats, may
/// be apart from the truth: RMS in 1/255, over the pixels in which something is seen.
struct RivalError
{
  double Most = 1.0;
  const char* Because = ""; ///< if it is more than 1
};

/// Of a scene that VTK 9.1 refuses.
constexpr double NoPicture = 0.0;

struct ImageScene
{
  /// That of VTK's test, without what all of them begin with; then which of several it is.
  std::string Name;
  std::function<vtkSmartPointer<vtkDataSet>()> MakeData;
  /// Functions, interpolation, place and the mapper's settings.
  std::function<void(ImageStage&)> Arrange;
  RivalError Rival;
  /// The camera; nothing for the usual view from aslant onto all of it.
  std::function<void(ImageStage&)> Look = {};
  /// Light and gradient opacity are not in the ground truth.
  bool HasTruth = true;
  /// Why vtkTetMarchSmartVolumeMapper doesn't march it; empty if it does.
  const char* NotMarched = "";
  /// Above 0, vtkTetMarchVolumeMapper draws the image, too, cut into tetrahedra: the greatest
  /// difference from VTK's picture of the image, RMS in 1/255. Tetrahedra are interpolated
  /// linearly, so that it is not 0. Infinity: the pictures are not compared.
  double Tetrahedra = 0.0;
};

/// Functions, settings and the camera, which is made anew.
void arrange(const ImageScene& scene, ImageStage& stage);
/// For `arrange`.
void addPlane(ImageStage& stage, const Vec3& origin, const Vec3& normal);

/// All: those of the next four.
std::vector<ImageScene> imageScenes();
/// What data are like, and where: ImageScenesData.cxx.
std::vector<ImageScene> imageDataScenes();
/// Blend modes, cuts, cameras: ImageScenesModes.cxx.
std::vector<ImageScene> imageModeScenes();
/// Places of the camera, of the volume and of planes: ImageScenesCamera.cxx.
std::vector<ImageScene> imageCameraScenes();
/// Vectors and components, types of numbers: ImageScenesArrays.cxx.
std::vector<ImageScene> imageArrayScenes();

/// vtkSmartVolumeMapper by its GPU mapper with steps of that length, in units of the data (a plain
/// one takes half the spacing, whatever it is told), with the range of averages passed on, and
/// planes where they are meant to be.
vtkSmartPointer<vtkSmartVolumeMapper> makeFineSmartMapper(double step);
/// A tenth of the least distance of points.
double tenthOfAVoxel(vtkDataSet* data);

/// A window with a scene in it.
class ImageSceneWindow
{
public:
  static constexpr int Width = 101;
  static constexpr int Height = 100;

  ImageSceneWindow(const ImageScene& scene, vtkSmartVolumeMapper* mapper);
  ImageSceneWindow(const ImageSceneWindow&) = delete;
  ImageSceneWindow& operator=(const ImageSceneWindow&) = delete;

  ImageStage& stage() { return this->Stage; }
  vtkDataSet* data() { return this->Data; }
  /// On black.
  Image drawInFloat();

private:
  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  ImageStage Stage;
};
} // namespace tetmarch::testing

#endif
