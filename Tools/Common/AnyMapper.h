// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A common interface of the mapper for unstructured grids and that for images and rectilinear
 * grids. Methods of common superclasses, settings and statistics are accessed directly; the others
 * are declared here.
 */
#ifndef tetmarch_AnyMapper_h
#define tetmarch_AnyMapper_h

#include <array>
#include <memory>
#include <optional>
#include <string>

class vtkAbstractVolumeMapper;
class vtkDataObject;
class vtkFloatArray;
class vtkRenderer;
class vtkTable;
class vtkTetMarchFrameStatistics;
class vtkTetMarchSettings;
class vtkVolume;

namespace tetmarch
{

/// As vtkTetMarchVolumeMapper::TraceArithmeticType.
enum class TraceIn
{
  FLOAT = 0,
  DOUBLE = 1,
  GROUND_TRUTH = 2
};

/// The picked point of a pixel.
struct PickedPoint
{
  std::array<double, 3> Position; // in the world
  double Scalar;
  long long Cell;
  unsigned int Block; // flat index of the block that has this cell; 0 if there are no blocks
};

class AnyMapper
{
public:
  virtual ~AnyMapper() = default;

  virtual vtkAbstractVolumeMapper* GetMapper() = 0;
  virtual void SetSettings(vtkTetMarchSettings* settings) = 0;
  virtual vtkTetMarchSettings* GetSettings() = 0;
  virtual vtkTetMarchFrameStatistics* GetStatistics() = 0;

  virtual void SetInput(vtkDataObject* data) = 0;
  /// association: as vtkTetMarchFirstPicture::Associations.
  void SelectArray(int association, const std::string& name);
  /// Prepares the mesh before the first frame, in any thread; images and rectilinear grids need
  /// none. False: stopped or failed.
  virtual bool PrepareMesh() = 0;
  /// -1: the magnitude.
  virtual void SetComponent(int component) = 0;
  /// As vtkVolumeMapper::BlendModes.
  virtual void SetBlendMode(int mode) = 0;
  virtual void SetCropping(const double planes[6], int flags) = 0;
  virtual void SetCroppingOff() = 0;
  /// For images and rectilinear grids; the mapper chooses the distance if it is negative.
  virtual void SetSamples(double distance, bool jitter) = 0;
  /// The default: frames may have fewer rays during interaction.
  virtual void SetSamplesOff() = 0;

  /// As the methods of either class.
  virtual bool CompareWithGroundTruth(vtkVolume* volume) = 0;
  virtual bool TraceRay(vtkVolume* volume, int x, int y, TraceIn arithmetic, vtkTable* cells) = 0;
  virtual void GetDiagnosticPixels(vtkFloatArray* pixels) = 0;
  /// Counted from the lower left of the window.
  virtual std::optional<PickedPoint> Pick(
    vtkRenderer* renderer, vtkVolume* volume, int x, int y) = 0;
};

/// structured: of images and rectilinear grids.
std::unique_ptr<AnyMapper> MakeMapper(bool structured);

} // namespace tetmarch

#endif
