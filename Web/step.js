// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The volumes and surfaces of one step in time.
import {backToFront} from "./block_order.js";
import {transformPoint} from "./matrices.js";
import {SURFACE_SHADERS, surfaceArrays, Surfaces} from "./surfaces.js";
import {normalizedToWorld} from "./view.js";
import {Volume} from "./volume.js";

function includePoint(bounds, point)
{
  point.slice(0, 3).forEach((value, a) => {
    bounds[2 * a] = Math.min(bounds[2 * a], value);
    bounds[2 * a + 1] = Math.max(bounds[2 * a + 1], value);
  });
}

export class Step
{
  constructor(gl, data)
  {
    this.gl = gl;
    this.data = data;
    this.volumes = data.volumes.map((volume, i) => new Volume(gl, volume, i));
    this.surfaces = null;
    this.known = new Map(); // textures by the rows of the page
  }

  /**
   * Uploads what it needs. before: the step that was shown, whose textures are used again or
   * deleted; or null.
   */
  async load(archive, programs, before, onProgress)
  {
    const {surfaces} = this.data;
    const indices =
      [...this.volumes.flatMap((volume) => volume.arrays), ...surfaceArrays(surfaces)];
    await archive.load(indices, onProgress);
    const kept = before ? before.known : new Map();
    for (const volume of this.volumes)
    {
      volume.upload(archive, kept, this.known);
    }
    kept.forEach((texture, key) => {
      if (!this.known.has(key))
      {
        this.gl.deleteTexture(texture.texture);
      }
    });
    if (surfaces.length > 0)
    {
      this.surfaces =
        new Surfaces(this.gl, surfaces, archive, await programs.get(...SURFACE_SHADERS));
    }
    this.checkMemory();
    this.bounds = this.findBounds(archive);
    indices.forEach((index) => archive.forget(index));
    if (before)
    {
      before.release();
    }
  }

  checkMemory()
  {
    if (this.gl.getError() === this.gl.OUT_OF_MEMORY)
    {
      throw new Error(
        "This browser's graphics have no room for the data of the scene. Close other " +
        "pages, open this one on another computer, or write a page of a smaller part of the data.");
    }
  }

  release()
  {
    this.volumes.forEach((volume) => volume.release());
    if (this.surfaces)
    {
      this.surfaces.release();
    }
  }

  // x, y and z from and to, of the volumes' boxes and the surfaces' points.
  findBounds(archive)
  {
    const bounds = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
    for (const {data} of this.volumes)
    {
      const toWorld = normalizedToWorld(data);
      for (let corner = 0; corner < 8; ++corner)
      {
        const p = data.frame.halfExtent.map((half, a) => corner >> a & 1 ? half : -half);
        includePoint(bounds, transformPoint(toWorld, p));
      }
    }
    for (const {positions, matrix} of this.data.surfaces)
    {
      const points = archive.array(positions);
      for (let i = 0; i < points.length; i += 3)
      {
        includePoint(bounds, transformPoint(matrix, points.subarray(i, i + 3)));
      }
    }
    return bounds[0] <= bounds[1] ? bounds : [-1, 1, -1, 1, -1, 1];
  }

  /** The volumes as VTK draws them: one after the other, and the blocks of each back to front. */
  ordered(camera)
  {
    const groups = new Map();
    this.volumes.forEach((volume) => {
      const {group} = volume.data;
      groups.set(group, [...(groups.get(group) || []), volume]);
    });
    return [...groups.values()].flatMap((blocks) => backToFront(blocks, camera));
  }
}
