// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Testing/Web/tables.json: tables of the march by which Testing/Web/tables.test.mjs checks those of
// Web/tables.js. See JsonText.h.
#include "Appearance/TransferTables.h"

#include "JsonText.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

struct Functions
{
  std::vector<std::array<double, 4>> Color;   // scalar, r, g, b
  std::vector<std::array<double, 2>> Opacity; // scalar, opacity
  std::array<double, 4> Nan;
};

const Functions Ramp{ { { { -1, 0.1, 0.2, 0.9 } }, { { 0.5, 0.7, 0.6, 0.1 } },
                        { { 3, 1, 0, 0.4 } } },
  { { { -1, 0 } }, { { 1, 0.3 } }, { { 3, 0.9 } } }, { { 0.5, 0.25, 1, 0.75 } } };

struct Case
{
  const char* Name;
  std::vector<Functions> Parts{ Ramp };
  OpacityLaw Law = OpacityLaw::Unstructured;
  std::vector<std::array<double, 2>> Ranges{ { { -1, 3 } } };
  bool Structured = false;
  std::pair<const char*, Accuracy> Level{ "default", Accuracy::Default };
  double Tolerance = 1.0 / 256;
  std::pair<const char*, BlendMode> Blend{ "composite", BlendMode::Composite };
  std::pair<const char*, ComponentMix> Mix{ "single", ComponentMix::Single };
};

Case withOpacity(const char* name, const std::vector<std::array<double, 2>>& opacity)
{
  Case one{ name };
  one.Parts[0].Opacity = opacity;
  return one;
}

// With the law of images, which have slopes.
Case ofImage(Case one)
{
  one.Law = OpacityLaw::Structured;
  one.Structured = true;
  return one;
}

std::vector<Case> opticsCases()
{
  using Opacity = std::vector<std::array<double, 2>>;
  const Opacity step{ { { -1, 0.1 } }, { { 0.7, 0.1 } }, { { 0.70000001, 0.8 } }, { { 3, 0.8 } } };
  const Opacity spikes{ { { -1, 0 } }, { { 0.1, 0 } }, { { 0.1004, 0.9 } }, { { 0.1011, 0 } },
    { { 2.2, 0 } }, { { 2.20003, 0.5 } }, { { 2.20006, 0 } }, { { 3, 0 } } };
  const Opacity gaps{ { { -1, 0 } }, { { -0.5, 0 } }, { { -0.2, 0.5 } }, { { 0, 0 } },
    { { 1.5, 0 } }, { { 1.7, 0.2 } }, { { 2.1, 0 } }, { { 3, 0.4 } } };
  Case oneColor = withOpacity("one colour", gaps);
  oneColor.Parts[0].Color = { { { 4, 0.2, 0.4, 0.6 } } };
  Case outside = withOpacity("nodes outside the range", { { { 7, 0.3 } }, { { 9, 0.6 } } });
  outside.Parts[0].Color = { { { 7, 0.1, 0.5, 0.2 } }, { { 8, 1, 1, 1 } } };
  Case beyond{ "nodes on both sides of the range" };
  beyond.Ranges = { { { -0.3, 1.9 } } };
  Case within{ "nodes within a part of the range" };
  within.Ranges = { { { -20, 7 } } };
  Case oneValue{ "range of one value" };
  oneValue.Ranges = { { { 0.25, 0.25 } } };
  return { { "ramp" }, ofImage({ "ramp in an image" }), withOpacity("step", step),
    ofImage(withOpacity("step in an image", step)), withOpacity("spikes", spikes),
    ofImage(withOpacity("spikes in an image", spikes)), withOpacity("gaps", gaps), oneColor,
    withOpacity("constant", { { { 0, 0.5 } } }),
    ofImage(withOpacity("opaque image", { { { 0, 1 } } })),
    withOpacity("transparent", { { { 0, 0 } } }), outside, beyond, within, oneValue };
}

std::vector<Case> drawnCases()
{
  Case fast = ofImage({ "fast" });
  fast.Level = { "fast", Accuracy::Fast };
  Case accurate{ "accurate" };
  accurate.Level = { "accurate", Accuracy::Accurate };
  Case reference{ "reference" };
  reference.Level = { "reference", Accuracy::Reference };
  Case extreme = ofImage({ "extreme" });
  extreme.Blend = { "extreme", BlendMode::Maximum };
  Case sum = ofImage({ "sum" });
  sum.Level = { "sampled", Accuracy::Sampled };
  sum.Blend = { "sum", BlendMode::Additive };
  Case independent{ "independent" };
  independent.Parts.push_back({ { { { 0, 1, 0, 0 } }, { { 9, 0, 1, 0 } } },
    { { { 2, 0 } }, { { 2.5, 0.6 } }, { { 8, 0 } } }, {} });
  independent.Ranges.push_back({ { 0, 9 } });
  independent.Mix = { "independent", ComponentMix::Independent };
  Case both = ofImage({ "colour and opacity" });
  both.Ranges.push_back({ { 0, 2 } });
  both.Mix = { "color_and_opacity", ComponentMix::ColorAndOpacity };
  Case direct{ "direct colour" };
  direct.Mix = { "direct_color", ComponentMix::DirectColor };
  return { fast, accurate, reference, extreme, sum, independent, both, direct };
}

void setFunctions(vtkVolumeProperty* property, int component, const Functions& functions)
{
  vtkNew<vtkColorTransferFunction> color;
  for (const auto& node : functions.Color)
  {
    color->AddRGBPoint(node[0], node[1], node[2], node[3]);
  }
  color->SetNanColor(functions.Nan[0], functions.Nan[1], functions.Nan[2]);
  color->SetNanOpacity(functions.Nan[3]);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& node : functions.Opacity)
  {
    opacity->AddPoint(node[0], node[1]);
  }
  property->SetColor(component, color);
  property->SetScalarOpacity(component, opacity);
}

std::vector<float> floats(const std::vector<double>& numbers)
{
  return std::vector<float>(numbers.begin(), numbers.end());
}

std::string inputOf(const Case& one)
{
  std::vector<std::string> functions;
  for (const Functions& part : one.Parts)
  {
    functions.push_back(object({ { "color", json(part.Color) }, { "opacity", json(part.Opacity) },
      { "nan", json(part.Nan) } }));
  }
  const std::vector<std::array<double, 2>> extra(one.Ranges.begin() + 1, one.Ranges.end());
  return object({ { "functions", json(functions) }, { "level", json(one.Level.first) },
    { "tolerance", json(one.Tolerance) },
    { "options",
      object({ { "law", json(one.Law == OpacityLaw::Structured ? "structured" : "unstructured") },
        { "range", json(one.Ranges[0]) }, { "extraRanges", json(extra) },
        { "structured", json(one.Structured) }, { "blend", json(one.Blend.first) },
        { "components", json(one.Mix.first) } }) } });
}

// As GL/TableTextures.cxx sets them.
Members uniformsOf(const IntegralTable& table, const Components& parts, const ScalarRange& range)
{
  Members uniforms{ { "tableSize", json(std::vector<int>{ table.size() }) },
    { "tableScale", json(floats({ table.scale(range.width()) })) },
    { "tableOffset", json(floats({ table.offset(range.Low) })) },
    { "givenIntegralUnit", json(floats({ table.IntegralUnit.begin(), table.IntegralUnit.end() })) },
    { "nanColor", json(table.NanColor) },
    { "givenTransparentRanges", json(table.Traits.Transparent) } };
  std::vector<int> first, sizes;
  std::vector<double> units, places;
  for (const TablePlace& place : parts.places(table, range))
  {
    first.push_back(place.First);
    sizes.push_back(place.Size);
    units.insert(units.end(), place.IntegralUnit.begin(), place.IntegralUnit.end());
    places.insert(places.end(), { place.Scale, place.Offset });
  }
  if (!parts.isSingle())
  {
    uniforms.insert(uniforms.end(),
      { { "tableFirst", json(first) }, { "tableSizes", json(sizes) },
        { "tableIntegralUnits", json(floats(units)) }, { "tablePlace", json(floats(places)) } });
  }
  return uniforms;
}

// Some entries: place, value, integrals up to it and total variations up to it.
void addEntries(const IntegralTable& table, std::size_t first, std::vector<std::string>& entries)
{
  constexpr std::size_t Count = 12;
  for (std::size_t k = 0; k < Count; ++k)
  {
    const std::size_t i = k * (table.Values.size() - 1) / (Count - 1);
    std::vector<float> variations{ table.Variations[i] };
    if (!table.ExtinctionVariations.empty())
    {
      variations.push_back(table.ExtinctionVariations[i]);
    }
    if (!table.SlopeVariations.empty())
    {
      variations.insert(
        variations.end(), table.SlopeVariations[i].begin(), table.SlopeVariations[i].end());
    }
    entries.push_back(json(std::vector<std::string>{
      json(first + i), json(table.Values[i]), json(table.Integrals[i]), json(variations) }));
  }
}

std::string expectedOf(const Case& one)
{
  vtkNew<vtkVolumeProperty> property;
  std::vector<ScalarRange> ranges;
  for (std::size_t k = 0; k < one.Ranges.size(); ++k)
  {
    ranges.push_back({ one.Ranges[k][0], one.Ranges[k][1] });
  }
  for (std::size_t k = 0; k < one.Parts.size(); ++k)
  {
    setFunctions(property, static_cast<int>(k), one.Parts[k]);
  }
  Blending blend;
  blend.Mode = one.Blend.second;
  const TableInput input{ one.Law, &blend, one.Mix.second, ranges[0],
    { ranges.begin() + 1, ranges.end() }, one.Structured };
  Components parts;
  parts.Mix = input.Mix;
  parts.ExtraRanges = input.ExtraRanges;
  const AccuracyLevel level = levelOf(one.Level.second, one.Tolerance);
  const IntegralTable table = makeTables(property, input, level, parts);
  std::vector<std::string> entries;
  addEntries(table, 0, entries);
  std::size_t first = table.Values.size();
  for (const IntegralTable& extra : parts.Tables)
  {
    addEntries(extra, first, entries);
    first += extra.Values.size();
  }
  const TableTraits& traits = table.Traits;
  return object(
    { { "level",
        object({ { "adaptive", json(level.Adaptive) }, { "tolerance", json(level.ErrorTolerance) },
          { "trials", json(level.MostTrials) }, { "sampled", json(level.Sampled) },
          { "leastEntries", json(level.LeastTableEntries) },
          { "mostEntries", json(level.MostTableEntries) } }) },
      { "uniforms", object(uniformsOf(table, parts, ranges[0])) },
      { "traits", object({ { "constantColor", json(traits.ConstantColor) },
                    { "transparentRanges", json(traits.hasTransparentRanges()) } }) },
      { "entries", json(entries) } });
}

TEST(WebTables, AreThoseOfTheFile)
{
  std::string made;
  for (const std::vector<Case>& cases : { opticsCases(), drawnCases() })
  {
    for (const Case& one : cases)
    {
      made += (made.empty() ? "[\n" : ",\n") +
              object({ { "name", json(one.Name) }, { "input", inputOf(one) },
                { "expected", expectedOf(one) } });
    }
  }
  made += "\n]\n";
  expectStored("tables.json", made, "tables.test.mjs");
}
} // namespace
