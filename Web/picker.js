// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the ray of a pixel meets: passes/pick.frag.glsl in one pixel.
import {transformPoint} from "./matrices.js";
import {Target} from "./targets.js";

const PICK_SHADERS = ["passes/tile.vert.glsl", "passes/pick.frag.glsl"];
const WHOLE = [-1, -1, 3, 3];

export class Picker
{
  constructor(gl, programs)
  {
    this.gl = gl;
    this.programs = programs;
    this.target = new Target(gl, ["RGBA32F", "RGBA32F"]);
  }

  /** pixel: from the lower left corner of a picture of that size with these depths. */
  async pick(scene, size, pixel, depth)
  {
    let nearest = null;
    for (let i = scene.volumes.length - 1; i >= 0; --i)
    {
      const found = await this.pickVolume(scene, scene.volumes[i], size, pixel, depth);
      if (found && (!nearest || found.depth < nearest.depth))
      {
        nearest = found;
      }
    }
    return nearest;
  }

  async pickVolume(scene, volume, size, pixel, depth)
  {
    const gl = this.gl;
    const view = volume.viewOf(scene.camera, size[0] / size[1]);
    if (!view)
    {
      return null;
    }
    const program = await this.programs.get(...PICK_SHADERS, volume.pickFeatures());
    this.target.resize(1, 1);
    this.target.bind();
    this.target.clear();
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    const viewport = [-pixel[0], -pixel[1], ...size];
    program.use({...volume.valuesForPick(view, size), viewport, tile: WHOLE},
      {...volume.textures, opaqueDepthTexture: depth});
    gl.drawArrays(gl.TRIANGLES, 0, 6);
    const hit = this.target.read(0, [0, 0, 1, 1]);
    const place = this.target.read(1, [0, 0, 1, 1]);
    if (!(hit[3] > 0))
    {
      return null;
    }
    const point = Array.from(place.subarray(0, 3));
    const clip = transformPoint(view.normalizedToClip, point);
    return {
      volume: volume.index,
      cell: volume.cellOf(hit[0] + 65536 * hit[1], point),
      position: transformPoint(view.toWorld, point).slice(0, 3),
      value: volume.valueOf(hit[2]),
      depth: clip[2] / clip[3]
    };
  }
}
