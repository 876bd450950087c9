// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of a scene: background and surfaces, then the volumes over them in tiles; coarse,
// complete, or a view of the error bound.
import {Target} from "./targets.js";
import {gpuDone, Tiles} from "./tiles.js";

const MARCH = ["passes/tile.vert.glsl", "passes/march.frag.glsl"];
const FULL_VIEW = "passes/full_view.vert.glsl";
const COARSE_MILLISECONDS = 50;

export class Frames
{
  constructor(gl, programs, errorColors)
  {
    this.gl = gl;
    this.programs = programs;
    this.errorColors = errorColors;
    this.base = new Target(gl, ["RGBA8"], true);
    this.picture = new Target(gl, ["RGBA8"]);
    this.coarse = new Target(gl, ["RGBA8"]);
    this.measures = new Target(gl, ["RGBA32F", "RGBA32F", "RGBA32F"]);
    this.tiles = new Tiles(gl);
    this.coarseTiles = new Tiles(gl);
    this.coarseness = 4; // pixels between rays while somebody moves
  }

  release()
  {
    [this.base, this.picture, this.coarse, this.measures].forEach((target) => target.release());
  }

  // Background and opaque surfaces, and their depths.
  async drawBase(scene, size)
  {
    const gl = this.gl;
    const program = await this.programs.get(FULL_VIEW, "web/background.frag.glsl");
    this.base.resize(...size);
    this.base.bind();
    this.base.clear();
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.SCISSOR_TEST);
    program.use({
      viewport: [0, 0, ...size],
      lowColor: scene.background,
      highColor: scene.background2 || scene.background
    },
      {});
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    if (scene.surfaces)
    {
      scene.surfaces.draw(scene.camera, size[0] / size[1]);
    }
  }

  // The volumes with their programs, back to front.
  async prepared(scene, counts, size, raySize)
  {
    const aspect = size[0] / size[1];
    const opaqueDepth = (view) => view.cutsFarPlane || scene.surfaces !== null;
    const drawn = [];
    for (const volume of scene.volumes)
    {
      const view = volume.viewOf(scene.camera, aspect);
      if (!view)
      {
        continue;
      }
      const level = volume.levelFor(scene.level.name, scene.level.tolerance);
      const lists = volume.listEntries(view, raySize);
      const features = volume.pictureFeatures(level, counts, opaqueDepth(view), lists !== null);
      const perPixel = [size[0] / raySize[0], size[1] / raySize[1]];
      drawn.push({
        program: await this.programs.get(...MARCH, features),
        values: {...volume.valuesFor(view, level, raySize, perPixel), ...lists?.values},
        textures: {...volume.textures, ...lists?.textures, opaqueDepthTexture: this.base.depth}
      });
    }
    return drawn;
  }

  // One triangle that covers the tile: along the common edge of two, pixels are drawn twice.
  drawTile(drawn, target, [x, y, width, height])
  {
    const gl = this.gl;
    const ndc = (pixel, size) => 2 * pixel / size - 1;
    const tile = [
      ndc(x, target.size[0]), ndc(y, target.size[1]), ndc(x + 2 * width, target.size[0]),
      ndc(y + 2 * height, target.size[1])
    ];
    target.bind();
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, y, width, height);
    for (const {program, values, textures} of drawn)
    {
      program.use({...values, tile}, textures);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
    gl.disable(gl.SCISSOR_TEST);
  }

  blendPremultiplied()
  {
    const gl = this.gl;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** A frame with fewer rays on the canvas, in about the time that a frame may take. */
  async drawCoarse(scene, size, isWanted)
  {
    const gl = this.gl;
    const raySize = size.map((pixels) => Math.max(1, Math.round(pixels / this.coarseness)));
    await this.drawBase(scene, size);
    this.coarse.resize(...raySize);
    const drawn = await this.prepared(scene, false, size, raySize);
    const enlarge = await this.programs.get(FULL_VIEW, "passes/enlarge.frag.glsl");
    const begun = performance.now();
    this.coarse.bind();
    this.coarse.clear();
    const draw = (part) => {
      this.blendPremultiplied();
      this.drawTile(drawn, this.coarse, part);
    };
    const complete = await this.coarseTiles.draw(raySize, draw, isWanted);
    const share = Math.max(1, performance.now() - begun) / COARSE_MILLISECONDS;
    this.coarseness = Math.min(Math.max(this.coarseness * Math.min(Math.sqrt(share), 2), 1), 16);
    if (complete)
    {
      this.picture.resize(...size);
      this.base.copyTo(this.picture.framebuffer);
      this.picture.bind();
      this.blendPremultiplied();
      enlarge.use({viewport: [0, 0, ...size]}, {pictureTexture: this.coarse.colors[0]});
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      this.picture.copyTo(null);
    }
    return complete;
  }

  /** A complete frame on the canvas. */
  async drawComplete(scene, size, isWanted)
  {
    await this.drawBase(scene, size);
    const drawn = await this.prepared(scene, false, size, size);
    this.picture.resize(...size);
    this.base.copyTo(this.picture.framebuffer);
    const draw = (part) => {
      this.blendPremultiplied();
      this.drawTile(drawn, this.picture, part);
    };
    return this.tiles.draw(size, draw, isWanted, () => this.picture.copyTo(null));
  }

  /**
   * The measures of all rays (Diagnostics/MarchCounters.h), summed up, with the greatest error
   * bound; null if they were not wanted to the end. They stay in this.measures.
   */
  async count(scene, size, isWanted)
  {
    const gl = this.gl;
    await this.drawBase(scene, size);
    const drawn = await this.prepared(scene, true, size, size);
    this.measures.resize(...size);
    this.measures.bind();
    this.measures.clear();
    const draw = (part) => {
      gl.disable(gl.BLEND);
      this.drawTile(drawn.slice(-1), this.measures, part);
    };
    if (!await this.tiles.draw(size, draw, isWanted))
    {
      return null;
    }
    const all = [0, 0, ...size];
    const work = this.measures.read(1, all);
    const trouble = this.measures.read(2, all);
    const sums = {rays: 0, cells: 0, errorBound: 0, refused: 0, lost: 0, guarded: 0};
    for (let i = 0; i < work.length; i += 4)
    {
      sums.rays += work[i] > 0 ? 1 : 0;
      sums.cells += work[i];
      sums.errorBound = Math.max(sums.errorBound, work[i + 2]);
      sums.refused += trouble[i];
      sums.lost += trouble[i + 1];
      sums.guarded += trouble[i + 2];
    }
    return sums;
  }

  /** The error bounds of the last count, in colours. range: of decimal logarithms. */
  async showErrors(size, range)
  {
    const gl = this.gl;
    const program = await this.programs.get(FULL_VIEW, "passes/view.frag.glsl");
    this.picture.resize(...size);
    this.base.copyTo(this.picture.framebuffer);
    this.picture.bind();
    gl.disable(gl.BLEND);
    program.use({viewport: [0, 0, ...size], measure: [2], logarithmic: [1], measureRange: range},
      {measureTexture: this.measures.colors[1], colorTexture: this.errorColors});
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.picture.copyTo(null);
    await gpuDone(gl);
  }
}
