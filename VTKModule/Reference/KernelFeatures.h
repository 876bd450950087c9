// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Features that kernels have in common.
#ifndef TetMarchReferenceKernelFeatures_h
#define TetMarchReferenceKernelFeatures_h

#include "Variants/Features.h"

// Of every march.
#define TETMARCH_MARCH_FEATURES                                                                    \
  (TETMARCH_WITH_HAS_FMA | TETMARCH_WITH_BVH | TETMARCH_WITH_HIDDEN_CELLS)
// The same features of a march through lattices, in place of one through tetrahedra.
#define TETMARCH_IN_LATTICES(features)                                                             \
  (((features) & ~(TETMARCH_WITH_HAS_FMA | TETMARCH_WITH_BVH)) | TETMARCH_WITH_STRUCTURED |        \
    TETMARCH_WITH_RECTILINEAR)
// Of every picture; unless useClipping() says otherwise, nothing is cut away.
#define TETMARCH_PICTURE_FEATURES                                                                  \
  (TETMARCH_MARCH_FEATURES | TETMARCH_WITH_DIAGNOSTICS | TETMARCH_WITH_TRACED |                    \
    TETMARCH_WITH_CLIPPED | TETMARCH_WITH_CROPPED)
// Of a volume: emission and absorption.
#define TETMARCH_VOLUME_FEATURES (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_NAN_SHOWN)
// Of a volume with one table of opacity, which tells where it is transparent.
#define TETMARCH_ONE_OPACITY_FEATURES (TETMARCH_VOLUME_FEATURES | TETMARCH_WITH_TRANSPARENT_RANGES)
// Of a volume with gradient opacity and in any light.
#define TETMARCH_LIT_FEATURES                                                                      \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_GRADIENT_OPACITY | TETMARCH_WITH_SHADING |        \
    TETMARCH_WITH_WORLD_LIGHTS | TETMARCH_WITH_SCATTERING | TETMARCH_WITH_CAST_SHADOWS |           \
    TETMARCH_WITH_SEVERAL_SHADOWS | TETMARCH_WITH_HEADLIGHT_SHADOWS | TETMARCH_WITH_OCCLUSION |    \
    TETMARCH_WITH_EXACT_LIGHT)
// Of surfaces in any light.
#define TETMARCH_LIT_SURFACE_FEATURES                                                              \
  (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_ISOSURFACES | TETMARCH_WITH_SHADING |                 \
    TETMARCH_WITH_WORLD_LIGHTS)
// Of rays towards the light.
#define TETMARCH_LIGHT_RAY_FEATURES                                                                \
  (TETMARCH_MARCH_FEATURES | TETMARCH_WITH_NAN_SHOWN | TETMARCH_WITH_GRADIENT_OPACITY |            \
    TETMARCH_WITH_LIGHT_RAYS | TETMARCH_WITH_OPAQUE_SHADOWS)

#endif
