// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lists of PLOT3D files.
#include "ReaderCase.h"

#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

namespace
{
template <typename Number>
void Append(std::string& bytes, std::initializer_list<Number> numbers)
{
  for (const Number number : numbers)
  {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
  }
}

/// Of 2 x 3 x 4 points: coordinates or five arrays, which are all of the same values.
std::string WritePoints(int arrays)
{
  std::string bytes;
  Append<int>(bytes, { 2, 3, 4 });
  if (arrays == 5)
  {
    Append<float>(bytes, { 0.5f, 0.0f, 1.0f, 2.0f }); // Mach number, angle, Reynolds number, time
  }
  for (int array = 0; array < arrays; ++array)
  {
    for (int i = 0; i < 24; ++i)
    {
      const int at[] = { i % 2, i / 2 % 3, i / 6 };
      Append<float>(bytes, { static_cast<float>(arrays == 3 ? at[array] : at[0] + 1) });
    }
  }
  return bytes;
}

class Plot3D : public ReaderCase
{
protected:
  void SetUp() override
  {
    ReaderCase::SetUp();
    this->WriteText("a.xyz", WritePoints(3));
    this->WriteText("a.q", WritePoints(5));
    this->WriteText("cut.xyz", WritePoints(3).substr(0, 100));
  }
};
} // namespace

TEST_F(Plot3D, IsCurvilinear)
{
  const std::string path = this->WriteText("a.p3d",
    R"({ // with a comment
    "filenames": [{"time": 0.5, "xyz": "a.xyz", "q": "a.q"}, {"time": 2, "xyz": "a.xyz"}] })");
  const auto volume = tetmarch::ReadVolume(path, 0);
  EXPECT_EQ(volume.Times, (std::vector<double>{ 0.5, 2.0 }));
  auto* grid = vtkStructuredGrid::SafeDownCast(volume.Input);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->GetNumberOfCells(), 6);
  vtkDataArray* density = grid->GetPointData()->GetArray("Density");
  ASSERT_TRUE(density);
  EXPECT_EQ(density->GetTuple1(0), 1.0);
  EXPECT_EQ(density->GetTuple1(1), 2.0);
}

TEST_F(Plot3D, RefusesWhatIsNone)
{
  const std::pair<const char*, const char*> texts[] = {
    { "[1", "it is no JSON object" },
    { "{}", "it has no list \"filenames\"" },
    { R"({"filenames": []})", "it has no list \"filenames\"" },
    { R"({"filenames": [{"xyz": "a.xyz"}]})", "needs a \"time\"" },
    { R"({"filenames": [{"time": 1, "xyz": 3}]})", "the name of a file \"xyz\" is no text" },
    { R"({"filenames": [{"time": 1, "xyz": "b.xyz"}]})", "it lists 'b.xyz', which isn't there" },
    { R"({"functions": [110, "a"], "filenames": [{"time": 1, "xyz": "a.xyz"}]})",
      "the value of \"functions\" is of a wrong type" },
    { R"({"filenames": [{"time": 1, "xyz": "cut.xyz"}]})", "the file is damaged" },
    { R"({"filenames": [{"time": 1, "xyz": "a.q", "q": "a.xyz"}]})", "the file is damaged" },
  };
  for (const auto& [text, error] : texts)
  {
    const std::string found = GetError(this->WriteText("a.p3d", text));
    EXPECT_NE(found.find(error), std::string::npos) << text << ": " << found;
  }
}
