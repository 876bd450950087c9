// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A mapper that looks at the GL state around its frames, in the GL and in VTK's records
 */
#ifndef tetmarch_testing_WatchedMapper_h
#define tetmarch_testing_WatchedMapper_h

#include "vtkTetMarchVolumeMapper.h"

#include <functional>

namespace tetmarch::testing
{
class WatchedMapper : public vtkTetMarchVolumeMapper
{
public:
  static WatchedMapper* New();
  vtkTypeMacro(WatchedMapper, vtkTetMarchVolumeMapper);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /// If set, called with what draws the frame.
  std::function<void(const std::function<void()>&)> Around;
  int Frames = 0;
  int Samples = 0; ///< of the framebuffer
};
} // namespace tetmarch::testing

#endif
