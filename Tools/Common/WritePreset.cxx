// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "OutputFile.h"
#include "TransferFunctionPreset.h"

#include <nlohmann/json.hpp>

namespace
{
using nlohmann::ordered_json;

const char* GetColorSpaceName(vtkColorTransferFunction* color)
{
  switch (color->GetColorSpace())
  {
    case VTK_CTF_HSV:
      return "HSV";
    case VTK_CTF_LAB:
      return "Lab";
    case VTK_CTF_DIVERGING:
      return "Diverging";
    case VTK_CTF_LAB_CIEDE2000:
      return "Lab/CIEDE2000";
    case VTK_CTF_STEP:
      return "Step";
    default:
      return "RGB";
  }
}

ordered_json DescribeFunctions(
  const std::string& name, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  ordered_json preset;
  preset["Name"] = name;
  preset["ColorSpace"] = GetColorSpaceName(color);
  preset["HSVWrap"] = color->GetHSVWrap() != 0;
  preset["UseLogScale"] = color->GetScale() == VTK_CTF_LOG10 ? 1 : 0;
  preset["NanColor"] = std::vector<double>(color->GetNanColor(), color->GetNanColor() + 3);
  std::vector<double> points;
  std::vector<double> shape;
  for (int i = 0; i < color->GetSize(); ++i)
  {
    double node[6];
    color->GetNodeValue(i, node);
    points.insert(points.end(), node, node + 4);
    shape.insert(shape.end(), node + 4, node + 6);
  }
  preset["RGBPoints"] = points;
  preset["RGBPointsShape"] = shape;
  points.clear();
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    points.insert(points.end(), node, node + 4);
  }
  preset["Points"] = points;
  return preset;
}
} // namespace

namespace tetmarch
{

void WritePreset(const std::string& path, const std::string& name, vtkColorTransferFunction* color,
  vtkPiecewiseFunction* opacity)
{
  if (color->GetSize() == 0 || opacity->GetSize() == 0)
  {
    throw Failure("a preset needs colours and opacities, but the function of " +
                  std::string(color->GetSize() == 0 ? "colours" : "opacity") + " has no points");
  }
  const auto presets = ordered_json::array({ DescribeFunctions(name, color, opacity) });
  // A name that isn't UTF-8 is no reason to lose the functions.
  const std::string text = presets.dump(2, ' ', false, ordered_json::error_handler_t::replace);
  WriteFile(path, text + '\n');
}

} // namespace tetmarch
