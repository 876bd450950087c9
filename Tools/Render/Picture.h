// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The scene: one volume in one window, opaque surfaces, what is drawn beside it, and a legend if a
 * view mode wants one.
 */
#ifndef tetmarch_Picture_h
#define tetmarch_Picture_h

#include "Annotations.h"
#include "AnyMapper.h"
#include "CommandLine.h"
#include "PixelTrace.h"
#include "Tiles.h"
#include "VolumeData.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"
#include "vtkVolume.h"

#include <memory>

class vtkTetMarchFirstPicture;

namespace tetmarch
{

class Picture
{
public:
  /// `bounds` are what is to be in view. Throws Failure if no GL can be had, a surface can't be
  /// read, or the command line asks for what is not to be had of such data.
  Picture(const VolumeData& data, const double bounds[6], vtkTetMarchFirstPicture* choice,
    const CommandLine& commandLine);

  /// Other data of the same kind, as the next time step.
  void SetData(const VolumeData& data);

  /// Goes around the focal point, about the view-up vector.
  void Turn(double degrees);

  /// Draws and waits until it is drawn; seconds. Throws Failure if VTK reported an error.
  double Render();

  /// Draws until a budget of time has found its level: until it stays for a while. Throws Failure.
  void Settle();

  /// Draws once more, with statistics, and compares with the picture in double precision. Throws
  /// Failure.
  void Compare();

  /// Draws once more, and marches the ray of a pixel, counted from the upper left. Throws Failure.
  void Trace(const std::array<int, 2>& pixel, PixelTrace& trace);

  /// What was drawn last, as WriteOutput() does. Throws Failure if that fails.
  void Write(const std::string& name);

  vtkRenderWindow* GetWindow() { return this->Window; }
  AnyMapper& GetMapper() { return *this->Mapper; }

private:
  void SetUpWindow();
  void SetUpMapper();
  void SetUpProperty();
  void AddSurface(const std::string& path);

  const CommandLine& Options;
  const Tiles Pieces;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  std::unique_ptr<AnyMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTetMarchLegend> Legend;
  std::unique_ptr<Annotations> Beside;
  vtkSmartPointer<vtkImageData> Assembled; // of tiles
};

} // namespace tetmarch

#endif
