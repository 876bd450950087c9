// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_FunctionsTest_h
#define tetmarch_FunctionsTest_h

#include "ViewCase.h"

namespace tetmarch
{

/// The editor of transfer functions, and the picture.
class FunctionsTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void ADraggedPointChangesThePicture();
  void UndoBringsThePictureBack();
  void OtherDataHaveTheirOwnFunctions();
  void IsoValuesAreLinesOfTheChart();
};

} // namespace tetmarch

#endif
