// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

namespace tetmarch::bench
{
std::string helpText()
{
  return R"(Usage: tetmarch-bench [accuracy|refinement|effects|structured] [options]

Times vtkTetMarchVolumeMapper beside VTK's other ways to draw an unstructured grid, one frame each in turn,
prints a table in Markdown and, if asked, writes every figure as JSON.

  accuracy                  every level and tolerance, every rival, three transfer functions, and how far each
                            picture is from that in double precision
  refinement                the same of one field on finer and finer meshes, against the field itself
  effects                   gradient opacity, shading, shadows and so on, each beside a frame without
  structured                images: vtkTetMarchSmartVolumeMapper beside VTK's mappers, with errors

  --datasets A,B,...        of lattice162k, lattice1.3m, lattice6m, lattice:N (6 N^3 tetrahedra), golfball,
                            golfball-slab, golfball-wake, cheese, cheese:N (not convex), front1.3m, front:N (a sharp
                            front), refined:N (one smooth wave), and, if --more-data has them, wheelset, crushed-can
                            (solid parts), golfball-medium, bluntfin, oxygen
                            (default: the first three, golfball, golfball-slab, golfball-wake, cheese, wheelset,
                            crushed-can)
  --functions A,B,...       of own (of all but front, refined and flows of others), smooth, ramp, spikes (default: own)
  --mappers A,B,...         of tetmarch, tetmarch:1/N (tolerance), tetmarch-fast, tetmarch-accurate,
                            tetmarch-reference, tetmarch-compute (by a compute shader), projected, bunyk,
                            bunyk-homogeneous, bunyk-preintegration, bunyk-partial, bunyk-linear, zsweep,
                            resample:N/K (N^3 points, K samples a spacing)
                            (default: tetmarch, projected, bunyk; in a GPU's report tetmarch-compute, too)
  --effects A,B,...         of gradient-opacity, headlight, one-light, five-lights, local-lights, cell-gradients,
                            vertex-shadows, ray-shadows, headlight-shadows, occlusion, shadows-occlusion,
                            scattering, illumination (default: all)
                            Of structured: --datasets bonsai, aneurism, headsq, carotid (if --more-data has
                            structured/), marschner-lobb:N; --functions ramp, peaks, smooth; --mappers tetmarch-fast,
                            tetmarch, tetmarch-accurate, gpu:K (VTK's on the GPU, K samples a voxel), gpu-jitter:K,
                            gpu-stored:K (of scalars as stored, the others are of floats), fixed-point
  --stride N                of structured: errors are those of every N-th pixel of every N-th row (default: 4)
  --against PROGRAM         of another build: its 'tetmarch' draws by turns with those of this one
  --errors                  measure errors, too
  --size WxH                of the window (default: 512x512)
  --rounds N                how often each mapper starts in a new process (default: 2)
  --frames N                frames of a mapper in a round, after the first (default: 5)
  --limit SECONDS           a mapper that takes longer for a frame, or five times as long to get ready or
                            for its first frame, is left out from there on (default: 60)
  --enough SECONDS          a mapper whose frames of a round have taken so long together draws no more of them,
                            but one beside the first (default: no end; accuracy: 10, effects: 20;
                            structured: 2, and no more than one)
  --quick                   tiny lattices, a small window and few frames; options after it still count
  --data FOLDER             where golfball_small.vtu lies (default: Data/ of the sources)
  --more-data FOLDER        where golfball/golfball_medium.vtu and others lie; datasets that are not there
                            are left out (default: ../shared/data beside the sources)
  --output FILE.json
  --markdown FILE.md        the table that is printed
  --gpu-report FILE.json    the figures with all that the GL says of itself, what its driver can do, and how far its
                            pictures are from those of the CPU: to be sent to us, whatever fails
  --cache FOLDER            where resampled scalars are kept with the time they took (default: a folder that is
                            deleted at the end)
  --help

Environment: TETMARCH_GL=egl|osmesa as for tetmarch-render; LP_NUM_THREADS for Mesa's llvmpipe.
)";
}
} // namespace tetmarch::bench
