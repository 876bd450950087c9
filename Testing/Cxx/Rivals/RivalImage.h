// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A field on an image of the unit cube, for VTK's mapper for images
 */
#ifndef tetmarch_testing_RivalImage_h
#define tetmarch_testing_RivalImage_h

#include "Grids.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace tetmarch::testing
{
/// So many points along each edge.
inline vtkSmartPointer<vtkImageData> makeImage(int points, const Field& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  const double spacing = 1.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->SetValue(i, static_cast<float>(field(p[0], p[1], p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}
} // namespace tetmarch::testing

#endif
