// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyActions.h"
#include "MonkeyGrids.h"

#include <iterator>
#include <limits>

namespace tetmarch::testing
{
namespace
{
using State = MonkeyState;
using Random = MonkeyRandom;

MonkeyPlane somePlane(Random& random)
{
  MonkeyPlane plane;
  for (int k = 0; k < 3; ++k)
  {
    plane.Origin[k] = 0.2 + 0.6 * random.share();
    plane.Normal[k] = random.share() - 0.5;
  }
  plane.Normal[random.below(3)] += 1.0;
  return plane;
}
} // namespace

const std::vector<MonkeyChange>& monkeyChanges()
{
  static const std::vector<MonkeyChange> table{
    { "another data set", [](State& s, Random& r) { s.Dataset = r.below(MonkeyDatasets); } },
    { "a step of time", [](State& s, Random& r) { s.Step = r.below(MonkeySteps); } },
    { "the next step of time", [](State& s, Random&) { s.Step = (s.Step + 1) % MonkeySteps; } },
    { "points that move", [](State& s, Random&) { s.Moved = !s.Moved; } },
    { "scalars of points or cells",
      [](State& s, Random& r) { s.Array = r.chance(8) ? State::Absent : r.below(2); } },
    { "the vector mode", [](State& s, Random& r) { s.VectorMode = r.below(3) - 1; } },
    { "the vector component", [](State& s, Random& r) { s.VectorComponent = r.below(4); } },
    { "the place of the volume", [](State& s, Random& r)
      { s.Placement = r.below(r.chance(3) ? State::PlacementKinds : State::Flat); } },

    { "the functions",
      [](State& s, Random& r)
      {
        s.Functions = r.of<int>({ State::Bumpy, State::Bumpy, State::Spiky, State::Spiky,
          State::OneColor, State::OneColor, State::Gray, State::Gray, State::Invisible });
      } },
    { "an edit of the opacity", [](State& s, Random& r) { s.Edit = r.below(5); } },
    { "the unit distance",
      [](State& s, Random& r) {
        s.UnitDistance = r.chance(8) ? 0.0 : r.of<double>({ 0.02, 0.25, 1.0, 10.0 });
      } },
    { "shading", [](State& s, Random&) { s.Shade = !s.Shade; } },
    { "ambient",
      [](State& s, Random& r) {
        s.Ambient = r.of<double>({ 0.0, 0.2, 0.6 });
      } },
    { "specular", [](State& s, Random& r) { s.Specular = 0.8 * r.share(); } },
    { "gradient opacity", [](State& s, Random&) { s.GradientOpacity = !s.GradientOpacity; } },
    { "the isosurfaces",
      [](State& s, Random& r) {
        s.IsoValues = r.of<int>({ 0, 1, 3, 5, 33 });
      } },

    { "the blend mode", [](State& s, Random& r)
      { s.BlendMode = r.chance(3) ? Mapper::COMPOSITE_BLEND : r.below(r.chance(6) ? 7 : 6); } },
    { "the opacity law", [](State& s, Random& r) { s.OpacityLaw = r.below(2); } },
    { "the range of averages",
      [](State& s, Random& r) {
        s.AverageLow = r.of<double>({ -1e30, 0.3, 0.6, 2.0 });
      } },
    { "NaN shown or not", [](State& s, Random&) { s.DrawNan = !s.DrawNan; } },
    { "the accuracy", [](State& s, Random& r) { s.Accuracy = r.below(4); } },
    { "the tolerance",
      [](State& s, Random& r) {
        s.Tolerance = r.of<double>({ 1.0 / 16, 1.0 / 255, 1e-4 });
      } },
    { "the budget of time",
      [](State& s, Random& r) {
        s.FrameTimeBudget = r.of<double>({ 0.0, 0.0, 0.001, 10.0 });
      } },
    { "the budget of errors",
      [](State& s, Random& r) {
        s.ErrorBudget = r.of<double>({ 0.0, 0.0, 0.01 });
      } },
    { "the time of a draw",
      [](State& s, Random& r) {
        s.MaxDrawTime = r.of<double>({ 0.0, 0.25, 1e-4 });
      } },
    { "the shader stage", [](State& s, Random& r) { s.ShaderStage = r.below(3); } },
    { "diagnostics", [](State& s, Random&) { s.Diagnostics = !s.Diagnostics; } },
    { "the view mode",
      [](State& s, Random& r) { s.ViewMode = r.chance(2) ? Mapper::VIEW_PICTURE : r.below(8); } },
    { "the range of views",
      [](State& s, Random& r)
      {
        s.AutomaticRange = r.chance(2);
        s.RangeLow = r.of<double>({ 1e-6, 0.001, 0.0 });
      } },
    { "the gradients", [](State& s, Random& r) { s.GradientType = r.below(2); } },
    { "shadows", [](State& s, Random& r) { s.Shadows = r.below(4); } },
    { "shadows of opaque geometry", [](State& s, Random&) { s.OpaqueShadows = !s.OpaqueShadows; } },
    { "scattering",
      [](State& s, Random& r) {
        s.Scattering = r.of<float>({ 0, 0, 0.5f, 2.0f });
      } },
    { "the reach of light",
      [](State& s, Random& r) {
        s.Reach = r.of<float>({ 0, 0.3f, 1.0f });
      } },
    { "occlusion", [](State& s, Random&) { s.Occlusion = !s.Occlusion; } },
    { "its directions", [](State& s, Random& r) { s.Directions = 1 + r.below(8); } },
    { "the time for light",
      [](State& s, Random& r) {
        s.LightTimeBudget = r.of<double>({ 0.0, 1e-6, 0.1 });
      } },
    { "automatic sample distances", [](State& s, Random&) { s.AutoDistance = !s.AutoDistance; } },
    { "the sample distance",
      [](State& s, Random& r) {
        s.SampleDistance = r.of<double>({ 1.0, 1.0, 1.5, 4.0, 100.0 });
      } },
    { "the limit of memory",
      [](State& s, Random& r) {
        s.MaxMemory = r.of<vtkIdType>({ 0, 0, 0, 1000, 20000 });
      } },
    { "the threshold of picks", [](State& s, Random& r) { s.PickOpacity = r.share(); } },

    { "a clipping plane more",
      [](State& s, Random& r)
      {
        if (s.Planes.size() < 4)
        {
          s.Planes.push_back(somePlane(r));
        }
      } },
    { "a clipping plane less",
      [](State& s, Random&)
      {
        if (!s.Planes.empty())
        {
          s.Planes.pop_back();
        }
      } },
    { "a clipping plane elsewhere",
      [](State& s, Random& r)
      {
        if (!s.Planes.empty())
        {
          s.Planes.back() = somePlane(r);
        }
      } },
    { "a clipping plane that is none",
      [](State& s, Random& r)
      {
        if (!s.Planes.empty() && r.chance(2))
        {
          s.Planes.front().Normal = { { 0, 0, 0 } };
        }
      } },
    { "too many clipping planes",
      [](State& s, Random& r)
      {
        if (r.chance(2))
        {
          s.Planes.resize(33, somePlane(r));
        }
      } },
    { "cropping", [](State& s, Random&) { s.Cropping = !s.Cropping; } },
    { "the cropping regions",
      [](State& s, Random& r)
      {
        s.CroppingFlags = r.of<int>({ VTK_CROP_SUBVOLUME, VTK_CROP_SUBVOLUME, VTK_CROP_FENCE,
          VTK_CROP_INVERTED_CROSS, 0x2345678, 0 });
      } },
    { "the cropping planes",
      [](State& s, Random& r)
      {
        s.CroppingLow =
          r.of<double>({ -0.5, 0.1, 0.25, 0.5, 0.9, std::numeric_limits<double>::quiet_NaN() });
      } },

    { "the ball", [](State& s, Random&) { s.Ball = !s.Ball; } },
    { "translucent surfaces", [](State& s, Random& r) { s.Translucent = r.below(3); } },
    { "peeling", [](State& s, Random&) { s.Peeling = !s.Peeling; } },
    { "peeling of volumes", [](State& s, Random&) { s.PeelsVolume = !s.PeelsVolume; } },
    { "the lights", [](State& s, Random& r) { s.Lights = r.below(State::LightKinds); } },
    { "a light elsewhere", [](State& s, Random& r) { s.SunPlace = 4.0 * r.share() - 1.0; } },
    { "two-sided lighting", [](State& s, Random&) { s.TwoSided = !s.TwoSided; } },
    { "the view", [](State& s, Random& r)
      { s.View = r.below(r.chance(2) ? State::ViewKinds : State::Views); } },
    { "the eye's distance", [](State& s, Random& r) { s.Distance = 1.5 + 2.0 * r.share(); } },
    { "parallel projection", [](State& s, Random&) { s.Parallel = !s.Parallel; } },
    { "a second renderer", [](State& s, Random&) { s.SecondRenderer = !s.SecondRenderer; } },
    { "the window's size",
      [](State& s, Random& r) { s.Size = r.below(static_cast<int>(std::size(MonkeySizes))); } },
    { "multisampling",
      [](State& s, Random& r) {
        s.Samples = r.of<int>({ 0, 0, 4 });
      } },
    { "the background", [](State& s, Random& r) { s.Background = r.share(); } },
    { "the update rate",
      [](State& s, Random& r) {
        s.UpdateRate = r.of<double>({ 0.0001, 0.0001, 15.0, 1e6 });
      } },
  };
  return table;
}
} // namespace tetmarch::testing
