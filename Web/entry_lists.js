// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces through which the rays of a picture may enter a mesh, in lists per tile of pixels:
// Entries/EntryLists.h.
import {Footprints} from "./footprints.js";
import {arrayTexture} from "./textures.js";

const MOST_FACES = 1 << 19; // more take longer to list than a frame may take
const MOST_TILES = 1 << 20;
const MOST_CANDIDATES = 1 << 22;
const MOST_CANDIDATES_OF_ALL = 1 << 24; // what the GPU has room for
const MOST_SHIFT_OF_PIXELS = 4;         // larger tiles have a resolution of a 16th of their edge
const MOST_PIXELS = 2 * 4 ** MOST_SHIFT_OF_PIXELS; // of a face, for its tile
const MOST_SHIFT = 16;
const DEPTHS = 1 << 16;

/** Whether a mesh has so few faces that lists are made for each view. */
export function listsFaces(faces)
{
  return faces.length / 4 <= MOST_FACES;
}

/** 9 coordinates of each face. vertices, faces: of vertexBuffer and boundaryBuffer. */
export function cornersOfFaces(vertices, faces)
{
  const corners = new Float32Array(faces.length / 4 * 9);
  for (let face = 0; 4 * face < faces.length; ++face)
  {
    for (let i = 0; i < 9; ++i)
    {
      corners[9 * face + i] = vertices[4 * faces[4 * face + Math.floor(i / 3)] + i % 3];
    }
  }
  return corners;
}

function mostCandidates(footprints, shift)
{
  const {left, right, bottom, top, count} = footprints;
  let sum = 0;
  for (let f = 0; f < count; ++f)
  {
    sum += footprints.isEmpty(f) ? 0
                                 : ((right[f] >> shift) - (left[f] >> shift) + 1) *
                                     ((top[f] >> shift) - (bottom[f] >> shift) + 1);
  }
  return sum;
}

function tilesAlong(pixels, shift)
{
  return pixels + (1 << shift) - 1 >> shift;
}

// Tiles are about as large as the footprint of a face.
function chosenShift(footprints, [width, height])
{
  const {left, right, bottom, top, count} = footprints;
  let pixels = 0;
  let faces = 0;
  for (let f = 0; f < count; ++f)
  {
    if (!footprints.isEmpty(f))
    {
      const covered = (right[f] - left[f] + 1) * (top[f] - bottom[f] + 1);
      pixels += Math.min(covered, MOST_PIXELS);
      ++faces;
    }
  }
  let shift = 0;
  while (shift < MOST_SHIFT_OF_PIXELS && 2 * 4 ** shift * faces < pixels)
  {
    ++shift;
  }
  const fits = (most) => tilesAlong(width, shift) * tilesAlong(height, shift) <= MOST_TILES &&
                         mostCandidates(footprints, shift) <= most;
  while (shift < MOST_SHIFT_OF_PIXELS && !fits(MOST_CANDIDATES) ||
         shift < MOST_SHIFT && !fits(MOST_CANDIDATES_OF_ALL))
  {
    ++shift;
  }
  return shift;
}

// Calls visit(tile, pixels) for each tile that has pixels of a face: first and last in x and y, as
// in EntryCandidate::Where.
function visitTiles(footprints, shift, tilesPerRow, face, visit)
{
  const [left, right, bottom, top] =
    [footprints.left[face], footprints.right[face], footprints.bottom[face], footprints.top[face]];
  const lastInTile = (1 << shift) - 1;
  const ofSquare = Math.max(shift - MOST_SHIFT_OF_PIXELS, 0);
  const isSmall = left >> shift === right >> shift || bottom >> shift === top >> shift;
  if (!isSmall)
  {
    footprints.project(face);
  }
  for (let row = bottom >> shift; row <= top >> shift; ++row)
  {
    const y = row << shift;
    const low = Math.max(bottom, y);
    const high = Math.min(top, y + lastInTile);
    const [first, last] = isSmall ? [left, right] : footprints.narrow(low, high, left, right);
    for (let column = first >> shift; column <= last >> shift && first <= last; ++column)
    {
      const x = column << shift;
      const [from, to] = [Math.max(first - x, 0), Math.min(last - x, lastInTile)];
      const pixels = high - y >> ofSquare << 12 | low - y >> ofSquare << 8 | to >> ofSquare << 4 |
                     from >> ofSquare;
      visit(row * tilesPerRow + column, pixels);
    }
  }
}

// The faces that are seen, by depth, then by index.
function nearestFirst(footprints)
{
  const {nearest, count} = footprints;
  const next = new Uint32Array(DEPTHS + 1);
  for (let f = 0; f < count; ++f)
  {
    next[nearest[f] + 1] += footprints.isEmpty(f) ? 0 : 1;
  }
  for (let depth = 0; depth < DEPTHS; ++depth)
  {
    next[depth + 1] += next[depth];
  }
  const order = new Uint32Array(next[DEPTHS]);
  for (let f = 0; f < count; ++f)
  {
    if (!footprints.isEmpty(f))
    {
      order[next[nearest[f]]++] = f;
    }
  }
  return order;
}

/**
 * The lists of a picture: { tileShift, tilesPerRow, depthPlane, first, candidates }, as in C++.
 * The whole mesh must lie before the eye. See Footprints for the parameters.
 */
export function makeEntryLists(corners, view, halfExtent, size)
{
  const footprints = new Footprints(corners, view, halfExtent, size);
  const tileShift = chosenShift(footprints, size);
  const tilesPerRow = tilesAlong(size[0], tileShift);
  const tiles = tilesPerRow * tilesAlong(size[1], tileShift);
  const first = new Uint32Array(tiles + 1);
  const order = nearestFirst(footprints);
  order.forEach(
    (face) => visitTiles(footprints, tileShift, tilesPerRow, face, (tile) => ++first[tile + 1]));
  for (let tile = 0; tile < tiles; ++tile)
  {
    first[tile + 1] += first[tile];
  }
  const next = first.slice();
  const candidates = new Uint32Array(2 * first[tiles]);
  order.forEach((face) => {
    const depth = footprints.nearest[face] << 16;
    visitTiles(footprints, tileShift, tilesPerRow, face, (tile, pixels) => {
      const at = 2 * next[tile]++;
      candidates[at] = face;
      candidates[at + 1] = depth | pixels;
    });
  });
  return {tileShift, tilesPerRow, depthPlane: footprints.depth, first, candidates};
}

/** The lists of one view on the GPU. */
export class EntryLists
{
  constructor(gl)
  {
    this.gl = gl;
    this.key = null;
    this.textures = {};
    this.values = {}; // of uniforms
  }

  /** Makes the lists of a view, unless they are there. */
  update(corners, view, halfExtent, size)
  {
    const {gl} = this;
    const key = [...view.normalizedToClip, ...size].join(" ");
    if (this.corners === corners && this.key === key)
    {
      return;
    }
    this.release();
    const lists = makeEntryLists(corners, view, halfExtent, size);
    this.textures = {
      entryTileBuffer: arrayTexture(gl, "R32UI", lists.first),
      entryCandidateBuffer: arrayTexture(gl, "RG32UI", lists.candidates)
    };
    this.values = {
      entryTileShift: [lists.tileShift],
      entryTilesPerRow: [lists.tilesPerRow],
      entryDepthPlane: lists.depthPlane
    };
    this.corners = corners;
    this.key = key;
  }

  release()
  {
    Object.values(this.textures).forEach(({texture}) => this.gl.deleteTexture(texture));
    this.textures = {};
    this.key = null;
  }
}
