// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the properties of a vtkTetMarchVolumeMapper, and the window, ask of a frame.
#ifndef vtkTetMarchVolumeMapperOptions_h
#define vtkTetMarchVolumeMapperOptions_h

#include "vtkTetMarchVolumeMapperInternals.h"

#include "Diagnostics/MeasureView.h"
#include "GL/PeelHooks.h"

struct vtkTetMarchVolumeMapper::Internals::FrameOptions
{
  /** `hooks` and the mapper's table of colours for views are referred to. */
  FrameOptions(vtkTetMarchVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const tetmarch::AccuracyLevel& level, const tetmarch::PeelHooks& hooks);
  FrameOptions(const FrameOptions&) = delete;
  void operator=(const FrameOptions&) = delete;

  /** Not something about the picture, a part of it or what is picked: its time is that of others.
   */
  bool MarchesPicture = false;
  tetmarch::OpacityLaw Law;
  tetmarch::VectorOptions Vector;
  tetmarch::BlendOptions Blend;
  tetmarch::EffectOptions Effects;
  tetmarch::ClippingOptions Clipping;
  tetmarch::DrawOptions Draw;

private:
  tetmarch::MeasureView View; // what Draw.View refers to
};

#endif
