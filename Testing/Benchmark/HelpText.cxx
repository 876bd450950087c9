// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

namespace tetmarch::bench
{
std::string helpText()
{
  return R"(Usage: tetmarch-bench [accuracy|refinement|effects|structured] [options]

Compares the time of vtkTetMarchVolumeMapper with VTK's mappers of unstructured grids, one frame each in turn,
prints a table in Markdown and, on request, writes all figures as JSON.

  accuracy                  every level and tolerance, every rival, three transfer functions, and the error of
                            each picture against double precision
  refinement                the same for one field on successively refined meshes, against the field itself
  effects                   gradient opacity, shading, shadows and so on, each compared with a frame without
  structured                images: vtkTetMarchSmartVolumeMapper compared with VTK's mappers, with errors

  --datasets A,B,...        of lattice162k, lattice1.3m, lattice6m, lattice:N (6 N^3 tetrahedra), golfball,
                            golfball-slab, golfball-wake, cheese, cheese:N (not convex), hanging:N (one cube of 20 is cut
                            into eight), front1.3m, front:N (a sharp front), refined:N (one smooth wave), and, if
                            --more-data has them, wheelset, crushed-can (solid parts), golfball-medium, bluntfin, oxygen
                            (default: the first three, golfball, golfball-slab, golfball-wake, cheese, wheelset,
                            crushed-can)
  --functions A,B,...       of own (of all but front, refined and flows of others), smooth, ramp, spikes (default: own)
  --mappers A,B,...         of tetmarch, tetmarch:1/N (tolerance), tetmarch-fast, tetmarch-accurate,
                            tetmarch-reference, tetmarch-adaptive, tetmarch-adaptive-fast (pixels interpolated
                            within 4/255), tetmarch-compute, tetmarch-fragment (the shader stage),
                            projected, bunyk,
                            bunyk-homogeneous, bunyk-preintegration, bunyk-partial, bunyk-linear, zsweep,
                            resample:N/K (N^3 points, K samples a spacing)
                            (default: tetmarch, projected, bunyk; in a GPU's report both shader stages, too)
  --effects A,B,...         of gradient-opacity, headlight, one-light, five-lights, local-lights, cell-gradients,
                            vertex-shadows, ray-shadows, headlight-shadows, occlusion, shadows-occlusion,
                            scattering, illumination (default: all)
                            With structured: --datasets bonsai, aneurism, headsq, carotid (if --more-data has
                            structured/), marschner-lobb:N; --functions ramp, peaks, smooth; --mappers tetmarch-fast,
                            tetmarch, tetmarch-accurate, tetmarch-adaptive, tetmarch-adaptive-fast, gpu:K (VTK's on
                            the GPU, K samples a voxel), gpu-jitter:K, gpu-stored:K (scalars as stored, the others
                            use floats), fixed-point
  --stride N                with structured: errors of every N-th pixel of every N-th row (default: 4)
  --against PROGRAM         of another build: its 'tetmarch' draws in turn with that of this one
  --errors                  measure errors, too
  --size WxH                of the window (default: 512x512)
  --rounds N                number of rounds, with new processes in each (default: 2)
  --frames N                number of frames of a mapper in a round, after the first (default: 5)
  --limit SECONDS           a mapper that takes longer for a frame, or five times as long for its preparation or
                            its first frame, is left out from then on (default: 60)
  --enough SECONDS          a mapper draws no further frames of a round when its frames have taken this time in
                            total, but at least one besides the first (default: no limit; accuracy: 10,
                            effects: 20; structured: 2, and at most one)
  --quick                   tiny lattices, a small window and few frames; later options override it
  --data FOLDER             the folder of golfball_small.vtu (default: Data/ of the sources)
  --more-data FOLDER        the folder of golfball/golfball_medium.vtu and others; missing datasets are left out
                            (default: ../shared/data beside the sources)
  --output FILE.json
  --markdown FILE.md        the table that is printed
  --gpu-report FILE.json    the figures with the properties of the GL, the capabilities of its driver, and the
                            differences of its pictures from the CPU's: for the developers, even after failures
  --cache FOLDER            the folder of resampled scalars and the times they took (default: a folder that is
                            deleted at the end)
  --help

Environment: TETMARCH_GL=egl|osmesa as for tetmarch-render; LP_NUM_THREADS for Mesa's llvmpipe.
)";
}
} // namespace tetmarch::bench
