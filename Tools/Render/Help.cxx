// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

std::string tetmarch::GetHelp()
{
  return R"(Usage: tetmarch-render INPUT [options]

Renders one array of an unstructured grid, an image or a rectilinear grid as a volume into a PNG file, by
marching each ray from cell to cell. INPUT is a file of VTK (.vtu, .vti, .vtr, .pvtu, .pvti, .vtm, .vtpc,
.vtk, ...), Exodus (.ex2, .e, .exo, .g), CGNS (.cgns), MetaImage (.mhd, .mha), NRRD (.nrrd, .nhdr), of
nothing but the values of an image (.raw), or a list of such files as time steps (.pvd, .series). Blocks of
images and rectilinear grids are drawn one over the other. Other blocks are merged where their points
coincide; images among them and curvilinear grids are taken as hexahedra.

Data
  --list                    print all arrays, which of them is drawn, and the time steps; draw nothing
  --check                   print all that is wrong with the file, its blocks and its arrays; draw nothing;
                            exit status 1 if anything is
  --array NAME              the array to draw (default: one of all blocks that looks like a physical value,
                            points before cells, one component before several; a line on stderr says which);
                            blocks without it are not drawn
  --component K             of several components the one to draw, counted from 0, or magnitude (default: 0,
                            and of an array that was not asked for magnitude)
  --association WHERE       points or cells: where to look for the array (default: points, then cells)
  --time-step K             the time step, counted from 0 (default: the last)
  --time all|FROM:TO        draw these time steps, each as --time-step does, into numbered files: out.png
                            becomes out_0000.png and so on. Colours, opacities and camera are the same for
                            all, chosen by the values and the boxes of all these steps
  --interpolation HOW       of images and rectilinear grids: linear (default) between the values, or nearest:
                            each value holds in a cell of its own
  --dimensions NX,NY,NZ     of a .raw file: numbers of values along x, which vary fastest, y and z
  --type TYPE               of its values: uint8, int8, uint16, int16, uint32, int32, uint64, int64, float or
                            double (default for both: from names like NAME_256x256x128_uint8.raw)
  --spacing SX,SY,SZ        the distances of its values (default: 1,1,1)
  --big-endian              of each value the most significant byte comes first (default: last)

Transfer function
  --preset FILE             colour and opacity points from a JSON preset as ParaView exports it
  --colors NAME             a colour map, also in the place of a preset's colours; list prints the names
  --range LO,HI             spread the preset, or the default transfer function, over these values
                            (default: the preset's own values; 2nd to 98th percentile of the data, of
                            images without what most of them is; with --time, what holds those of all steps)
  --nan R,G,B[,OPACITY]     draw cells with values that are not finite in this colour, from 0 to 1 each
                            (default: they are not drawn; opacity: 1)
  --gradient-opacity G,O[,G,O...]
                            opacities, 0 to 1, of magnitudes of the scalar's gradient, in units of the
                            scalar over those of the coordinates; they weaken what the preset says
                            (default: 1 everywhere)
  --unit-distance D         the length that opacities are meant for (default: such that half of the pixels
                            that show anything are more than half opaque, and few are all but opaque; with
                            --preset of images and rectilinear grids the mean distance of values)
  --opacity-law LAW         unstructured: extinction = opacity / D, as VTK's unstructured mappers (default);
                            structured: -ln(1 - opacity) / D, as VTK's mappers for images (default of images
                            and rectilinear grids)

Accuracy
  --accuracy LEVEL          fast, default, accurate or reference (default: default); or sampled: images and
                            rectilinear grids by samples along each ray, with the look of VTK's mapper
  --sample-distance D       --accuracy sampled at this distance, in units of the data (default: half of the
                            mean spacing, less in volumes of less than a million cells)
  --jitter                  the first sample of each pixel's ray lies elsewhere (--accuracy sampled)
  --tolerance T             greatest error of a channel, 1e-6 to 1 (default: 1/255); fast promises none
  --frame-time SECONDS      find the best level whose frames keep this time, by drawing some, and use it
  --error E                 the cheapest level that keeps this error, 1e-6 to 1; with --frame-time, the least
                            accuracy. With either, --accuracy and --tolerance are not used

Light (--shade, or any other option of these, has the volume lit)
  --shade                   light the surfaces of constant scalar
  --light WHERE[,I]         headlight, or X,Y,Z: from where light shines, from infinitely far; I: its
                            intensity (default: 1). Several can be given (default: one headlight)
  --ambient A, --diffuse D, --specular S
                            how much of the volume's colour is seen without light, and where light shines;
                            how bright highlights are; 0 to 1 each (default: 0.1, 0.7, 0.2)
  --specular-power P        how small highlights are (default: 10)
  --shadows HOW             off (default), or shadows of the volume in itself: with light kept at the
                            vertices, or looked for along each ray, or automatic, whichever is cheaper:
                            vertices, rays or automatic
  --opaque-shadows          where the volume casts shadows, those of --surface cast some into it, too
  --scattering B            0 (default): light shines on surfaces only; to 1: it is scattered where there is
                            no clear surface; to 2: everywhere. Above 0 the volume casts shadows
  --reach R                 how far light, but for that of headlights, is followed for shadows, 0 to 1
                            (default: 1, all the way)
  --occlusion RADIUS        the volume keeps ambient light from its inside, over this share of the diagonal
                            of the volume's box, 0 to 1 (default: it does not)

View
  --camera PX,PY,PZ,FX,FY,FZ,UX,UY,UZ[,ANGLE]
                            position, focal point, view up, view angle in degrees (default: oblique, or from
                            the broad side of what is flat, all of the volume in view, 30 degrees)
  --turntable N             draw N pictures from all around, into numbered files as --time does: the camera
                            goes around the focal point, about its view up (default: about the axis that is
                            upwards, with all of the volume in view from all sides). With --time the time
                            steps go by evenly during the one turn, from the first to the last
  --parallel-scale S        parallel projection; S is half of the picture's height in world units
  --blend MODE              composite (default), maximum, minimum, average, additive, or isosurface
  --isovalues V[,V...]      the surfaces of these scalars (--blend isosurface)
  --view WHAT               picture (default), or with a legend of the colours what its pixels cost or may
                            be off by: error (bound of a channel, 0 to 1), cells or lookups; or
                            illumination (light without the volume's colour), gradients (directions as
                            colours), or of unstructured grids faces (the boundary faces by which rays enter,
                            each in a colour of its own) or coordinates (barycentric ones in those faces as
                            red, green and blue)
  --clip PX,PY,PZ,NX,NY,NZ  cut the volume at the plane through a point; what is on the side that the normal
                            points to is left. Several can be given
  --crop X0,X1,Y0,Y1,Z0,Z1  two planes across each axis divide the volume into 27 regions (in the data's
                            coordinates)
  --crop-regions WHICH      which of them are left: middle (default), fence, inverted-fence, cross or
                            inverted-cross
  --surface FILE            draw the polygons of a .vtp or .vtk file, too, opaque and light grey. Several can
                            be given
  --scalar-bar              a bar with the colours of values, and the array's name
  --outline                 the box of the data, as lines that the volume hides as it hides surfaces
  --axes                    axes with coordinates along edges of that box
  --background R,G,B|none   from 0 to 1 each (default: 0.08,0.09,0.12), or none: the file has opacities, and
                            can be laid over anything
  --size WxH                in pixels, up to 16384x16384 (default: 1024x768)
  --tile-size N             a picture with more pixels along a side is drawn in tiles, which need less of the
                            GPU's memory (default: 4096; without limit for what looks at a frame as a whole:
                            --stats, --frames, --frame-time, --pixel, --view error, cells or lookups)

Output
  --output FILE.png         (default: INPUT's base name + .png in the current folder; with --pixel: none)
  --stats FILE.json         figures of the data, seconds of each stage and of a frame, the GL in use
  --compare                 add to the figures how far the picture is from one in double precision, and
                            what its pixels cost (takes seconds to minutes)
  --pixel X,Y               print the ray of one pixel, cell by cell, as the CPU marches it in float and in
                            double; X and Y are its column and row in the picture, from the upper left
  --pixel-json FILE.json    the same as JSON
  --frames N                render N more times for the frame time in the figures (default: 5 with --stats)
                            Each FILE may be -, standard output. A file gets its name when it is complete:
                            a full disk or Ctrl-C leaves the file of before
  --quiet                   no progress bar on the terminal, and no notes; warnings and errors stay
  --threads N               use so many threads, also those of Mesa's llvmpipe (default: one a processor)

  --help, --version

Environment
  TETMARCH_GL=egl|osmesa    which offscreen GL to use (default: egl if it works, else osmesa)

Exit status: 0 done, 1 failure, 2 bad command line.
)";
}
