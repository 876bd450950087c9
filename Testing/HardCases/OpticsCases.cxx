// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars that are hard to tell apart, to hold or to draw; all on the cube of "jittered-cube".
#include "CaseGroup.h"
#include "CaseOptics.h"
#include "CaseScalars.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace tetmarch::testing
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

HardCase& addValues(
  CaseGroup& group, const std::string& name, const std::string& what, const ValueMap& map)
{
  return fills(group.add(name, what, [map] { return withPointValues(jitteredCube(), map); }));
}

HardCase& addCellValues(
  CaseGroup& group, const std::string& name, const std::string& what, const ValueMap& map)
{
  HardCase& hard =
    fills(group.add(name, what, [map] { return withCellValues(jitteredCube(), map); }));
  hard.CellScalars = true;
  hard.SetOptics = standardOpticsOfCells();
  return hard;
}

// Cells that touch one are passed through and not drawn, so that no ray's length is known.
void addNotFinite(CaseGroup& group)
{
  addValues(group, "nan-at-some-points", "every 17th value is not a number",
    [](double f, vtkIdType i) { return i % 17 == 0 ? NaN : f; })
    .Known = Answer::None;
  addValues(group, "inf-at-some-points", "every 17th value is infinite, by turns +, -",
    [](double f, vtkIdType i) { return i % 17 != 0  ? f
                                       : i % 2 == 0 ? Infinite
                                                    : -Infinite; })
    .Known = Answer::None;
  addValues(group, "nan-everywhere", "no value is a number", [](double, vtkIdType) { return NaN; })
    .Known = Answer::None;
  addValues(
    group, "inf-everywhere", "all values are +infinity", [](double, vtkIdType) { return Infinite; })
    .Known = Answer::None;
  addCellValues(group, "nan-in-some-cells", "every 17th cell's value is not a number",
    [](double c, vtkIdType i) { return i % 17 == 0 ? NaN : c; })
    .Known = Answer::None;
}

void addMagnitudes(CaseGroup& group)
{
  addValues(group, "constant", "one value everywhere", [](double, vtkIdType) { return 0.3; });
  addValues(group, "constant-zero", "zero everywhere", [](double, vtkIdType) { return 0.0; });
  addCellValues(
    group, "constant-in-cells", "one value in all cells", [](double, vtkIdType) { return 0.3; });
  for (const auto& [name, factor] : { std::pair<const char*, double>{ "1e30", 1e30 },
         { "1e-30", 1e-30 }, { "1e-40", 1e-40 }, { "1e300", 1e300 }, { "1e-300", 1e-300 } })
  {
    addValues(group, std::string("values-times-") + name,
      std::string("values and transfer functions times ") + name,
      [factor = factor](double f, vtkIdType) { return factor * f; })
      .SamePictureAs = "jittered-cube";
  }
  addValues(group, "values-nearly-equal", "values 1000 (1 + 1e-7 f): floats can't tell them apart",
    [](double f, vtkIdType) { return 1000.0 * (1.0 + 1e-7 * f); })
    .SamePictureAs = "jittered-cube";
  addValues(group, "outlier", "one value of 1e30 among 0..1; transfer functions over 0..1",
    [](double f, vtkIdType i) { return i == 171 ? 1e30 : f; })
    .SetOptics = standardOpticsOver({ 0.0, 1.0 });
  addCellValues(group, "outlier-in-cells", "the same in cells",
    [](double c, vtkIdType i) { return i == 650 ? 1e30 : c; })
    .SetOptics = standardOpticsOver({ 0.0, 1.0 });
}

struct ScalarType
{
  const char* Name;
  int VtkType;
};
constexpr ScalarType IntegerTypes[] = { { "bit", VTK_BIT }, { "char", VTK_CHAR },
  { "signed-char", VTK_SIGNED_CHAR }, { "unsigned-char", VTK_UNSIGNED_CHAR },
  { "short", VTK_SHORT }, { "unsigned-short", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
  { "unsigned-int", VTK_UNSIGNED_INT }, { "long", VTK_LONG },
  { "unsigned-long", VTK_UNSIGNED_LONG }, { "long-long", VTK_LONG_LONG },
  { "unsigned-long-long", VTK_UNSIGNED_LONG_LONG }, { "id-type", VTK_ID_TYPE } };

void addTypes(CaseGroup& group)
{
  for (const ScalarType& type : IntegerTypes)
  {
    const int vtkType = type.VtkType;
    const ArrayMap map = [vtkType](vtkDataArray* values) { return overWholeType(values, vtkType); };
    fills(group.add(std::string("points-") + type.Name,
      std::string("point scalars over the whole range of ") + type.Name,
      [map] { return withPointArray(jitteredCube(), map); }));
  }
  for (const ScalarType& type :
    { ScalarType{ "bit", VTK_BIT }, { "unsigned-char", VTK_UNSIGNED_CHAR }, { "int", VTK_INT },
      { "long-long", VTK_LONG_LONG }, { "unsigned-long-long", VTK_UNSIGNED_LONG_LONG } })
  {
    const int vtkType = type.VtkType;
    const ArrayMap map = [vtkType](vtkDataArray* values) { return overWholeType(values, vtkType); };
    HardCase& hard = fills(group.add(std::string("cells-") + type.Name,
      std::string("cell scalars over the whole range of ") + type.Name,
      [map] { return withCellArray(jitteredCube(), map); }));
    hard.CellScalars = true;
    hard.SetOptics = standardOpticsOfCells();
  }

  const std::int64_t beyondDouble = (std::int64_t(1) << 53) + 1;
  const ArrayMap signedMap = [=](vtkDataArray* values)
  { return asSigned64(values, beyondDouble, 1000); };
  fills(group.add("int64-beyond-double", "2^53 + 1 ... 2^53 + 1001: doubles skip every second one",
    [signedMap] { return withPointArray(jitteredCube(), signedMap); }));
  const std::uint64_t beyondSigned = (std::uint64_t(1) << 63) + 1;
  const ArrayMap unsignedMap = [=](vtkDataArray* values)
  { return asUnsigned64(values, beyondSigned, std::uint64_t(1) << 33); };
  fills(group.add("uint64-beyond-signed", "2^63 + 1 ... 2^63 + 2^33 + 1",
    [unsignedMap] { return withPointArray(jitteredCube(), unsignedMap); }));
}
} // namespace

void addOpticsCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "optics");
  addNotFinite(group);
  addMagnitudes(group);
  addTypes(group);
}
} // namespace tetmarch::testing
