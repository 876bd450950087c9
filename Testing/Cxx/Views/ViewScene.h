// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window for the view modes that show a number of each pixel as a colour
 */
#ifndef tetmarch_testing_ViewScene_h
#define tetmarch_testing_ViewScene_h

#include "Scene.h"

#include "vtkLookupTable.h"
#include "vtkTetMarchFrameStatistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
/// The view modes that show a number of each pixel, and the statistics of that number.
constexpr std::pair<int, int> Views[] = { { vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND,
                                            vtkTetMarchFrameStatistics::ERROR_BOUND },
  { vtkTetMarchVolumeMapper::VIEW_CELLS, vtkTetMarchFrameStatistics::CELLS },
  { vtkTetMarchVolumeMapper::VIEW_LOOKUPS, vtkTetMarchFrameStatistics::LOOKUPS } };

/// Before a blue background, without diagnostics.
class ViewScene : public Scene
{
public:
  explicit ViewScene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize)
    : Scene(grid, width, height)
  {
    this->Mapper->CollectDiagnosticsOff();
    this->Renderer->SetBackground(0.2, 0.4, 0.6);
    this->property()->SetScalarOpacityUnitDistance(0.05);
  }
  Image view(int mode)
  {
    this->Mapper->SetViewMode(mode);
    this->Window->Render();
    return this->frame();
  }
  vtkLookupTable* table() { return this->Mapper->GetViewLookupTable(); }
};

inline Grid viewLattice() { return jitteredLattice(8, 0.15, 5, sineField()); }

/// Which colour of the table each pixel has; -1 if it is none of them.
inline std::vector<int> entriesOf(const Image& frame, vtkLookupTable* table)
{
  const auto bytes = [](const auto* rgb)
  {
    std::array<int, 3> key{};
    for (int k = 0; k < 3; ++k)
    {
      key[k] = static_cast<int>(std::lround(255.0 * double(rgb[k])));
    }
    return key;
  };
  std::map<std::array<int, 3>, int> entries;
  for (int i = 0; i < table->GetNumberOfTableValues(); ++i)
  {
    EXPECT_TRUE(entries.emplace(bytes(table->GetTableValue(i)), i).second) << "twice: " << i;
  }
  std::vector<int> found;
  for (std::size_t i = 0; i < frame.Rgba.size(); i += 4)
  {
    const auto at = entries.find(bytes(&frame.Rgba[i]));
    found.push_back(at == entries.end() ? -1 : at->second);
  }
  return found;
}

/// The colours of the frame are those of the statistics, from the least to the greatest; all other
/// pixels are the background's.
inline void expectColorsOfStatistics(ViewScene& scene, const Image& frame, int quantity)
{
  vtkLookupTable* table = scene.table();
  std::vector<int> entries = entriesOf(frame, table);
  const auto background = std::count(entries.begin(), entries.end(), -1);
  const vtkTetMarchFrameStatistics* statistics = scene.Mapper->GetLastFrameStatistics();
  const auto count = static_cast<int>(statistics->GetNumberOfPixels(quantity));
  ASSERT_GT(count, 100);
  ASSERT_EQ(count, static_cast<int>(entries.size() - background));
  const float blue[3] = { 51 / 255.0f, 102 / 255.0f, 153 / 255.0f };
  const Mask colored = differsFrom(frame, blue, 0.5f / 255.0f);
  EXPECT_EQ(std::count(colored.begin(), colored.end(), true), count);
  std::sort(entries.begin(), entries.end());
  int off = 0;
  for (int i = 0; i < count; ++i)
  {
    const double value = statistics->GetPercentile(quantity, 100.0 * (i + 0.5) / count);
    const auto expected = static_cast<int>(table->GetIndex(value));
    const int entry = entries[static_cast<std::size_t>(background + i)];
    ASSERT_LE(std::abs(entry - expected), 1) << i << " of " << count << ", " << value;
    off += entry != expected; // between two entries, rounded to the other
  }
  EXPECT_LE(off, count / 100);
}
} // namespace tetmarch::testing

#endif
