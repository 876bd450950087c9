// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A bar at the right of the picture that tells which value has which colour.
 */
#ifndef tetmarch_ScalarBar_h
#define tetmarch_ScalarBar_h

#include <array>
#include <string>

class vtkColorTransferFunction;

namespace tetmarch
{
class Overlay;

struct ScalarBar
{
  std::string Title;
  vtkColorTransferFunction* Colors;
  std::array<double, 2> Range;
  double Share;  // of the picture's width
  double Scale;  // lines and text, as large as in a picture of 1024 x 768
  bool HasPlate; // a dark one behind it

  void AddTo(Overlay& overlay) const;
};

} // namespace tetmarch

#endif
