// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/EntryListTextures.h"

#include "GL/ProgramCapture.h"

#include "vtkShaderProgram.h"

namespace tetmarch
{

namespace
{

constexpr const char* TileName = "entryTileBuffer";
constexpr const char* CandidateName = "entryCandidateBuffer";

} // namespace

static_assert(sizeof(EntryCandidate) == 8, "arrays are uploaded as they are");

std::string EntryListTextures::upload(
  vtkOpenGLRenderWindow* window, const EntryLists& lists, const Fingerprint& version)
{
  this->TileShift = lists.TileShift;
  this->TilesPerRow = lists.TilesPerRow;
  this->DepthPlane = lists.DepthPlane;
  this->Entered = enteredPixels(lists);
  return this->There.update(
    version,
    [&]
    {
      const std::string error =
        this->Tiles.upload(window, TexelFormat::R32UI, lists.First.data(), lists.First.size());
      return error.empty() ? this->Candidates.upload(window, TexelFormat::RG32UI,
                               lists.Candidates.data(), lists.Candidates.size())
                           : error;
    },
    [&] { return this->bytes(); });
}

void EntryListTextures::bind(vtkShaderProgram* program)
{
  this->Tiles.bind(program, TileName);
  this->Candidates.bind(program, CandidateName);
  program->SetUniformi("entryTileShift", this->TileShift);
  program->SetUniformi("entryTilesPerRow", this->TilesPerRow);
  program->SetUniform4f("entryDepthPlane", this->DepthPlane.data());
}

void EntryListTextures::unbind()
{
  this->Tiles.unbind();
  this->Candidates.unbind();
}

Viewport EntryListTextures::enteredPart(const Viewport& target) const
{
  const EnteredPixels& in = this->Entered;
  return overlapOf(
    target, { target.X + in.Left, target.Y + in.Bottom, in.Right - in.Left, in.Top - in.Bottom });
}

void EntryListTextures::removeFrom(CapturedProgram& captured)
{
  captured.Textures.erase(TileName);
  captured.Textures.erase(CandidateName);
}

void EntryListTextures::release(vtkWindow* window)
{
  this->There.forget();
  this->Tiles.release(window);
  this->Candidates.release(window);
}

} // namespace tetmarch
