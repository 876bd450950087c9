// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line that the window copies has only options that tetmarch-render accepts together.
#include "CommandLineErrors.h"
#include "RenderCommand.h"

#include <regex>
#include <wordexp.h>

namespace
{
/// As a shell takes the command apart, without the text that it gives to standard input.
std::vector<std::string> GetArguments(const std::string& command)
{
  const std::string line =
    std::regex_replace(command.substr(0, command.find(" <<'END'")), std::regex("\\\\\n"), "");
  wordexp_t words;
  if (wordexp(line.c_str(), &words, WRDE_NOCMD) != 0)
  {
    return {};
  }
  const std::vector<std::string> arguments(words.we_wordv + 1, words.we_wordv + words.we_wordc);
  wordfree(&words);
  return arguments;
}
} // namespace

TEST(CopiedCommand, IsAcceptedWhateverIsSwitchedOn)
{
  tetmarch::ViewState state;
  state.Data.File = "it's a mesh.vtu";
  state.IsoValues = { 0.5 };
  state.Functions.GradientOpacity = { { { 0.0, 0.5, 0.5, 0.0 } }, { { 1.0, 1.0, 0.5, 0.0 } } };
  state.Size = { { 640, 480 } };
  for (int switches = 0; switches < 1024; ++switches)
  {
    state.Effects.Shading = switches & 1;
    state.Effects.GradientOpacity = switches & 2;
    state.Settings.ShadowMethod = switches & 4 ? 1 : 0;
    state.Effects.Scattering = switches & 8;
    state.Settings.OpaqueShadows = switches & 16;
    state.Settings.AmbientOcclusion = switches & 32;
    state.Settings.LightPreset = switches & 128 ? 3 : 0;
    state.Settings.LightTolerance = switches & 256 ? 0.01 : 0.0;
    state.Settings.LightThroughCuts = switches & 512;
    state.Cuts.Crop = switches & 1;
    state.Data.Surface = switches & 64 ? "plate.vtp" : "";
    for (state.BlendMode = 0; state.BlendMode < 6; ++state.BlendMode)
    {
      const auto arguments = GetArguments(tetmarch::WriteCommand(state, "picture.png"));
      ASSERT_EQ(GetError(arguments), "accepted") << switches << " " << state.BlendMode;
      const auto command = ParseCommandLine(arguments);
      const bool composite = state.BlendMode == 0;
      EXPECT_EQ(command.Input, state.Data.File);
      EXPECT_EQ(command.BlendMode, state.BlendMode);
      EXPECT_EQ(command.GradientOpacity.empty(), !(composite && state.Effects.GradientOpacity));
      EXPECT_EQ(command.Given.count("--reach"),
        composite && state.Effects.Shading && (switches & (4 | 8 | 128)) ? 1u : 0u);
      EXPECT_EQ(command.Light.Shade, state.Effects.Shading && (composite || state.BlendMode == 5));
    }
  }
}

TEST(CopiedCommand, HasTheArrayThatIsShown)
{
  tetmarch::ViewState state;
  state.Data.File = "mesh.vtu";
  state.Data.Array = "velocity";
  state.Size = { { 640, 480 } };
  for (const int association : { 0, 1 })
  {
    for (const int component : { -1, 2 })
    {
      state.Data.Association = association;
      state.Data.Component = component;
      const auto arguments = GetArguments(tetmarch::WriteCommand(state, "picture.png"));
      ASSERT_EQ(GetError(arguments), "accepted");
      const auto command = ParseCommandLine(arguments);
      EXPECT_EQ(command.Array, "velocity");
      EXPECT_EQ(command.ArrayAssociation, association);
      EXPECT_EQ(command.Component, component);
    }
  }
}
