// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The effects of light whose cost is measured, each by a name
 */
#ifndef tetmarch_bench_Effects_h
#define tetmarch_bench_Effects_h

#include <array>
#include <string>
#include <vector>

class vtkRenderer;
class vtkTetMarchVolumeMapper;
class vtkVolumeProperty;

namespace tetmarch::bench
{
/// Nothing on.
extern const std::string NoEffect;

/// What effects are switched in.
struct EffectScene
{
  vtkRenderer* Renderer;
  vtkTetMarchVolumeMapper* Mapper;
  vtkVolumeProperty* Property;
  std::array<double, 6> Bounds; // of the grid
  double ScalarWidth;           // of the range that the functions show
};

struct Effect
{
  std::string Name;
  std::string What;
  std::string On; // the effect that it adds to, which comes before it
  void (*Apply)(const EffectScene& scene);
};

/// But for NoEffect.
const std::vector<Effect>& effects();
bool isEffect(const std::string& name);

/// Switches all others off.
void applyEffect(const std::string& name, const EffectScene& scene);
} // namespace tetmarch::bench

#endif
