// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a field on the unit cube looks like, without any mesh
 */
#ifndef tetmarch_bench_ExactPicture_h
#define tetmarch_bench_ExactPicture_h

#include "Datasets.h"
#include "Images.h"

class vtkRenderer;
class vtkVolumeProperty;

namespace tetmarch::bench
{
/**
 * The emission-absorption integral of the field over the unit cube by the property's functions,
 * with the opacity law of unstructured mappers: 2000 midpoints a ray, of each of which colour and
 * extinction are taken for constant. Premultiplied RGBA of the renderer's whole viewport.
 */
testing::Image exactPicture(
  const ExactField& field, vtkVolumeProperty* property, vtkRenderer* renderer);
} // namespace tetmarch::bench

#endif
