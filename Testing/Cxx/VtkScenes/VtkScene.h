// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the scenes of VTK's own tests are made of here, and VTK's mappers to draw them, too
 *
 * VTK's tests read data files and compare with images. Ours make data of the same kind from
 * sources, and compare with the reference in double precision and with VTK's mapper in the same
 * window: Testing/VtkScenes.md.
 */
#ifndef tetmarch_testing_VtkScene_h
#define tetmarch_testing_VtkScene_h

#include "BlendedFrame.h"

#include "vtkImageData.h"

class vtkAbstractVolumeMapper;
class vtkDataSet;
class vtkGPUVolumeRayCastMapper;

namespace tetmarch::testing
{
/// vtkRTAnalyticSource on (2 half + 1)^3 points of spacing 1 about the origin, with waves five
/// times as long as by default: on so few points those are noise, which cubes and tetrahedra
/// interpolate each in their way.
vtkSmartPointer<vtkImageData> makeWavelet(int half = 10);
/// In the place of VTK's vase and other files of bytes: 255 on a sphere of two thirds of the
/// image's half, falling as a Gaussian of a quarter of it; so many points along each edge, of
/// spacing 1 from the origin on.
vtkSmartPointer<vtkImageData> makeShell(int points = 21);

/// The cells cut by vtkDataSetTriangleFilter, with the active scalars.
Grid tetrahedraOf(vtkDataSet* data);

/// 1 - (1 - opacity)^(length / unit distance) as image mappers have it; colours from a dark blue
/// over red and green to white; opacity from 0 at low to the greatest at high.
void setFunctions(vtkVolumeProperty* property, double low, double high, double greatest);

/// vtkGPUVolumeRayCastMapper with steps of a fixed length.
vtkSmartPointer<vtkGPUVolumeRayCastMapper> makeImageMapper(vtkImageData* image, double step);

/// Where vtkGPUVolumeRayCastMapper must be told that a plane is for it to cut at a point: VTK 9.1
/// looks for planes in its texture, which is larger than the image by half a voxel on each side;
/// from 9.4 on for those of the cropping box only.
Vec3 forImageMapper(vtkImageData* image, const Vec3& point);

/// The frame with another mapper in the place of the scene's own.
Image byMapper(Scene& scene, vtkAbstractVolumeMapper* mapper);

/// That our frame and the one by another mapper differ by so little, RMS in 1/255, over the pixels
/// in which either shows a volume; and what is shown is worth five times as much. Prints the
/// figures.
void expectLike(
  Scene& scene, vtkAbstractVolumeMapper* rival, double mostRms, const std::string& what = {});
/// The same of frames, and the one without volumes.
void expectLike(const Image& ours, const Image& rivals, const Image& back, double mostRms,
  const std::string& what = {});

/// The last frame of one of several mappers against the same in double precision: RMS at most
/// 0.3/255, one pixel in 100 off by more than 2/255. Prints the figures.
void expectReference(vtkTetMarchVolumeMapper* mapper, vtkVolume* volume, int width, int height);
} // namespace tetmarch::testing

#endif
