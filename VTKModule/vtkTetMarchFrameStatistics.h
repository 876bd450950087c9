// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchFrameStatistics
 * @brief   What the pixels of a frame of vtkTetMarchVolumeMapper cost, and how far they may be off
 *
 * Quantities are taken over the pixels whose ray met the mesh. Errors are of a channel (r, g, b,
 * opacity; 0..1) of the volume's own picture in float, before it is blended and rounded to the
 * bytes of the window.
 *
 * @sa vtkTetMarchVolumeMapper::GetLastFrameStatistics
 */
#ifndef vtkTetMarchFrameStatistics_h
#define vtkTetMarchFrameStatistics_h

#include "vtkObject.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For std::unique_ptr

class vtkFloatArray;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchFrameStatistics : public vtkObject
{
public:
  static vtkTetMarchFrameStatistics* New();
  vtkTypeMacro(vtkTetMarchFrameStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * ERROR_BOUND: what the march knows each channel not to exceed in error, but for rounding and for
   * what transfer functions do between the entries of their tables; see
   * vtkTetMarchVolumeMapper::AccuracyLevelType for its formula.
   * CELLS: tetrahedra that the ray crossed.
   * LOOKUPS: lookups of the segment integral, each of which looks the tables up.
   * TRUE_ERROR: the greatest error of a channel against the reference; there after
   * vtkTetMarchVolumeMapper::CompareWithGroundTruth().
   */
  enum QuantityType
  {
    ERROR_BOUND = 0,
    CELLS = 1,
    LOOKUPS = 2,
    TRUE_ERROR = 3
  };

  /**
   * Pixels whose ray met the mesh, and of which there is that quantity; 0 if it was not measured.
   */
  vtkIdType GetNumberOfPixels(int quantity) const;

  //@{
  /**
   * Of a quantity over those pixels; 0 if there are none. Percent 0..100: the least value that so
   * many of the pixels don't exceed.
   */
  double GetMinimum(int quantity) const;
  double GetMean(int quantity) const;
  double GetRootMeanSquare(int quantity) const;
  double GetMaximum(int quantity) const;
  double GetPercentile(int quantity, double percent) const;
  //@}

  //@{
  /**
   * Seconds that the frame took without what was measured on the side, and bytes that the mapper
   * held on the GPU.
   */
  vtkGetMacro(Seconds, double);
  vtkGetMacro(GPUMemoryBytes, vtkTypeInt64);
  //@}

  //@{
  /**
   * For the mapper: values of a quantity, one a pixel; negative where the ray met nothing.
   */
  void SetValues(int quantity, vtkFloatArray* values);
  vtkSetMacro(Seconds, double);
  vtkSetMacro(GPUMemoryBytes, vtkTypeInt64);
  //@}

  /**
   * Forget all that was measured.
   */
  void Clear();

protected:
  vtkTetMarchFrameStatistics();
  ~vtkTetMarchFrameStatistics() override;

  double Seconds = 0.0;
  vtkTypeInt64 GPUMemoryBytes = 0;

private:
  vtkTetMarchFrameStatistics(const vtkTetMarchFrameStatistics&) = delete;
  void operator=(const vtkTetMarchFrameStatistics&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
