// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PngFile.h"

#include "Failure.h"
#include "Messages.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>

namespace tetmarch
{

void DivideByOpacity(vtkImageData* rgba)
{
  auto* pixel = static_cast<unsigned char*>(rgba->GetScalarPointer());
  const unsigned char* end = pixel + 4 * rgba->GetNumberOfPoints();
  for (; pixel != end; pixel += 4)
  {
    const int opacity = pixel[3];
    for (int k = 0; k < 3 && opacity > 0; ++k)
    {
      pixel[k] = static_cast<unsigned char>(
        std::min(255, (2 * 255 * pixel[k] + opacity) / (2 * opacity))); // rounded
    }
  }
}

vtkSmartPointer<vtkUnsignedCharArray> EncodePng(vtkImageData* picture)
{
  const int errorsBefore = Messages::GetNumberOfErrors();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(picture);
  writer->Write();
  vtkSmartPointer<vtkUnsignedCharArray> bytes = writer->GetResult();
  if (Messages::GetNumberOfErrors() > errorsBefore || writer->GetErrorCode() != 0 || !bytes)
  {
    throw Failure("the picture can't be encoded as PNG");
  }
  return bytes;
}

std::string_view GetBytes(vtkUnsignedCharArray* bytes)
{
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

} // namespace tetmarch
