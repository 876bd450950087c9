// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnnotationText.h"

#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <cmath>

namespace tetmarch
{

void SetUpText(vtkTextProperty* text, const std::array<double, 3>& color, double size)
{
  text->SetColor(color[0], color[1], color[2]);
  text->SetFontSize(static_cast<int>(std::lround(size)));
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

std::array<int, 2> MeasureText(const std::string& text, vtkTextProperty* property)
{
  constexpr int dotsPerInch = 72; // of windows, unless told otherwise
  int box[4] = { 0, -1, 0, -1 };
  if (vtkTextRenderer* measure = vtkTextRenderer::GetInstance())
  {
    measure->GetBoundingBox(property, vtkStdString(text), box, dotsPerInch);
  }
  return { { box[1] - box[0] + 1, box[3] - box[2] + 1 } };
}

} // namespace tetmarch
