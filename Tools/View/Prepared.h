// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Data that is ready to be drawn: read, with its array chosen.
 */
#ifndef tetmarch_Prepared_h
#define tetmarch_Prepared_h

#include "Histogram.h"
#include "VolumeData.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTetMarchFirstPicture.h"

#include <string>
#include <vector>

namespace tetmarch
{

struct ArrayName
{
  std::string Name;
  int Association; // as vtkTetMarchFirstPicture::Associations
  int Components;
};

struct Prepared
{
  VolumeData Data;
  vtkSmartPointer<vtkTetMarchFirstPicture> Choice;
  std::vector<ArrayName> Arrays;
  Histogram Values;    // of what is chosen
  bool Curved = false; // some cells are quadratic, Lagrange or Bezier
};

} // namespace tetmarch

#endif
