// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A volume of the page on the GPU: what the march reads, by the names of its shaders.
import {cornersOfFaces, EntryLists, listsFaces} from "./entry_lists.js";
import {imageCellOf} from "./image_cells.js";
import {widthOfRange} from "./integral_table.js";
import {transpose} from "./matrices.js";
import {levelOf, makeTables} from "./tables.js";
import {arrayTexture, packsSquares, pageTexture, squareTexture} from "./textures.js";
import {pickFeatures, pictureFeatures} from "./variants.js";
import {viewOf} from "./view.js";

const TRIALS_WHERE_BENT = 8; // Frame/FrameStages.cxx
const MOST_SCALARS = 200000;
const PICK = {
  opacity: 0.5,
  trials: 512
}; // Optics/AccuracyLevel.h

function blendKind(features)
{
  const named = {EXTREME: "extreme", SUM: "sum", ISOSURFACES: "isosurfaces"};
  return named[Object.keys(named).find((name) => features.has(name))] || "composite";
}

function componentKind(features)
{
  const named = {
    INDEPENDENT: "independent",
    COLOR_AND_OPACITY: "color_and_opacity",
    DIRECT_COLOR: "direct_color"
  };
  return named[Object.keys(named).find((name) => features.has(name))] || "single";
}

// A sample of the scalars, 0..1: of vertices, of tetrahedra, of their corners or of an image.
function scalarsOf({textures, uniforms}, archive)
{
  const [name, stride, first] = textures.valueTexture         ? ["valueTexture", 1, 0]
                                : textures["slabTextures[0]"] ? ["slabTextures[0]", 1, 0]
                                : textures.cellScalarBuffer   ? ["cellScalarBuffer", 1, 0]
                                : textures.cornerScalarBuffer ? ["cornerScalarBuffer", 1, 0]
                                                              : ["vertexBuffer", 4, 3];
  const row = textures[name];
  const array = archive.array(row.array);
  const whole = {R8: 255, R16: 65535}[row.format] || 1;
  const [scale, offset] = uniforms.valueMap ? uniforms.valueMap.values : [1, 0];
  const count = Math.floor(array.length / stride);
  const step = Math.max(1, Math.floor(count / MOST_SCALARS));
  const scalars = [];
  for (let i = 0; i < count; i += step)
  {
    scalars.push(array[i * stride + first] / whole * scale + offset);
  }
  return Float32Array.from(scalars.filter((s) => s >= 0 && s <= 1));
}

export class Volume
{
  constructor(gl, data, index)
  {
    this.gl = gl;
    this.data = data;
    this.index = index;
    this.features = new Set(data.features);
    const {valueTexture} = data.textures;
    if (valueTexture && this.features.has("POINT_SCALARS") && packsSquares(gl, valueTexture))
    {
      this.features.add("PACKED_SQUARES");
    }
    this.values = {};
    for (const [name, {values}] of Object.entries(data.uniforms))
    {
      this.values[name] = values;
    }
    this.textures = {};
    this.functions = data.functions;
    this.traits = null; // of edited tables
    this.lists = new EntryLists(gl);
  }

  get isStructured() { return this.features.has("STRUCTURED"); }

  /** Indices of the arrays that it needs. */
  get arrays()
  {
    const ofTextures = Object.values(this.data.textures).map((row) => row.array);
    return [...ofTextures, this.data.cells].filter((index) => index !== null);
  }

  /**
   * Makes the textures of arrays that the archive has loaded. Textures by the rows of the page:
   * before, of another step; known, of this one.
   */
  upload(archive, before, known)
  {
    for (const [name, row] of Object.entries(this.data.textures))
    {
      const squares = name === "valueTexture" && this.features.has("PACKED_SQUARES");
      const make = squares ? squareTexture : pageTexture;
      const key = JSON.stringify([squares, row]);
      if (!known.has(key))
      {
        known.set(key, before.get(key) || make(this.gl, row, archive.array(row.array)));
      }
      this.textures[name] = known.get(key);
    }
    this.cells = this.data.cells === null ? null : archive.array(this.data.cells);
    this.boundary = this.cornersOf("boundaryBuffer", archive);
    this.visiblePart = this.cornersOf("visibleFaceBuffer", archive);
    this.scalars = scalarsOf(this.data, archive);
  }

  // Returns the corners of the faces in a texture. Returns null if the texture is missing, or if it
  // has so many faces that rays search the hierarchy instead.
  cornersOf(name, archive)
  {
    const {textures} = this.data;
    const faces = textures[name] && archive.array(textures[name].array);
    return faces && listsFaces(faces)
             ? cornersOfFaces(archive.array(textures.vertexBuffer.array), faces)
             : null;
  }

  // The visible part belongs to the written functions: an edit ends its use.
  get entersVisiblePart() { return this.visiblePart !== null && !this.traits; }

  /** Edited transfer functions in place of the written ones; of several components, the first. */
  setFunctions(functions, level)
  {
    const {gl, data} = this;
    const all = [functions, ...this.functions.slice(1)];
    const tables = makeTables(all, {
      law: data.law,
      range: data.range,
      extraRanges: data.extraRanges,
      structured: this.isStructured,
      level,
      blend: blendKind(this.features),
      components: componentKind(this.features),
      isoValues: (this.values.isoValue || []).slice(0, (this.values.isoSurfaceCount || [0])[0])
    });
    this.releaseTables();
    this.edited = {
      tableValueBuffer: arrayTexture(gl, "RGBA32F", tables.values),
      tableIntegralBuffer: arrayTexture(gl, "RGBA32UI", tables.integrals),
      tableVariationBuffer: arrayTexture(gl, tables.variations.format, tables.variations.data)
    };
    Object.assign(this.textures, this.edited);
    Object.assign(this.values, tables.uniforms);
    this.functions = all;
    this.traits = tables.traits;
  }

  releaseTables()
  {
    Object.values(this.edited || {}).forEach(({texture}) => this.gl.deleteTexture(texture));
    this.edited = null;
  }

  /** Frees what the steps of time don't share. */
  release()
  {
    this.releaseTables();
    this.lists.release();
  }

  /** The level of a page's name as the march takes it. */
  levelFor(name, tolerance)
  {
    const level = levelOf(name, tolerance);
    const factor = level.adaptive && this.isStructured ? TRIALS_WHERE_BENT : 1;
    return {...level, trials: level.trials * factor};
  }

  /** The features of a picture that has the lists of listEntries(), or not. */
  pictureFeatures(level, counts, opaqueDepth, hasLists)
  {
    const entries = {lists: hasLists, visiblePart: hasLists && this.entersVisiblePart};
    return pictureFeatures(
      this.features, {level, traits: this.traits, counts, opaqueDepth, entries});
  }

  /** Lists the faces through which the rays of a picture enter; null if they are to search them. */
  listEntries(view, size)
  {
    const corners = this.entersVisiblePart ? this.visiblePart : this.boundary;
    if (!corners || view.cutsNearPlane)
    {
      return null;
    }
    this.lists.update(corners, view, this.data.frame.halfExtent, size);
    return this.lists;
  }

  pickFeatures() { return pickFeatures(this.features, this.traits); }

  /** The view of a camera; null if it shows nothing. */
  viewOf(camera, aspect) { return viewOf(camera, aspect, this.data); }

  /**
   * Values of all uniforms of the march. size: of the target in pixels; depthsPerPixel: [x, y].
   * @returns {Object<string, number[]>}
   */
  valuesFor(view, level, size, depthsPerPixel)
  {
    return {
      ...this.values,
      viewport: [0, 0, size[0], size[1]],
      eye: view.eye,
      rayPoints: transpose(view.rayPoints),
      nearPlane: view.nearPlane,
      cutsFarPlane: [view.cutsFarPlane ? 1 : 0],
      clipToNormalized: transpose(view.clipToNormalized),
      depthsPerPixel,
      givenTolerance: [level.tolerance],
      givenTrials: [level.trials]
    };
  }

  /** The same for a pick. */
  valuesForPick(view, size)
  {
    const level = {tolerance: 1 - PICK.opacity, trials: PICK.trials};
    const values = this.valuesFor(view, level, size, [1, 1]);
    if (values.tableSizes && !values.tableSize)
    {
      values.tableSize = values.tableSizes.slice(0, 1);
      values.givenIntegralUnit = (values.tableIntegralUnits || [0, 0, 0, 0]).slice(0, 4);
    }
    return {...values, transmittanceLeft: [1 - PICK.opacity]};
  }

  /** The value of a scalar 0..1. */
  valueOf(scalar)
  {
    const {range} = this.data;
    return range[0] + scalar * widthOfRange(range);
  }

  /**
   * The cell of the data that has this number in the shaders, at a point of the normalised frame.
   */
  cellOf(number, point)
  {
    return this.cells ? this.cells[number] : imageCellOf(this.data, number, point);
  }
}
