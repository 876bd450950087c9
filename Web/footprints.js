// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels whose rays may enter a mesh through each of its faces: Entries/Footprint.cxx, in
// double precision like there.
import {reachOf} from "./view.js";

const PIXEL_MARGIN = 1 / 64;
const HIERARCHY_MARGIN = Math.fround(4e-6); // Mesh/BoundaryHierarchy.h
const LAST_DEPTH = 65535;
const LEAST_REACH = 2 ** -1022;

function toPixels(row, w, pixels)
{
  return row.map((x, k) => 0.5 * pixels * (x + w[k]));
}

function lengthOfRow(row)
{
  return Math.hypot(row[0], row[1], row[2]);
}

// The depth 0..65535 of points of the volume.
function depthRow(toClip, halfExtent)
{
  const w = toClip.slice(12, 16);
  const row = lengthOfRow(w) > 0 ? w : toClip.slice(8, 12);
  const scale = 0.5 * LAST_DEPTH / (LEAST_REACH + reachOf(row, halfExtent));
  return [row[0] * scale, row[1] * scale, row[2] * scale, 0.5 * LAST_DEPTH];
}

function clamp(x, low, high)
{
  return Math.min(Math.max(x, low), high);
}

export class Footprints
{
  /**
   * corners: 9 coordinates of each face, counter-clockwise seen from outside; halfExtent: of the
   * volume's frame; size: of the picture in pixels. A face that is turned away, or that no pixel
   * sees, has left > right.
   */
  constructor(corners, view, halfExtent, size)
  {
    const m = view.normalizedToClip;
    this.corners = corners;
    this.mirrored = view.mirrored;
    this.last = size.map((pixels) => pixels - 1);
    this.toW = m.slice(12, 16);
    this.toX = toPixels(m.slice(0, 4), this.toW, size[0]);
    this.toY = toPixels(m.slice(4, 8), this.toW, size[1]);
    this.depth = depthRow(m, halfExtent);
    this.slope = Math.max(lengthOfRow(this.toX), lengthOfRow(this.toY));
    this.slopeOfReach = lengthOfRow(this.toW);
    this.x = new Float64Array(3); // of the projected face, in pixels
    this.y = new Float64Array(3);
    this.margin = 0; // maximum distance at which a ray can enter through it by rounding
    this.count = corners.length / 9;
    this.left = new Uint16Array(this.count);
    this.right = new Uint16Array(this.count);
    this.bottom = new Uint16Array(this.count);
    this.top = new Uint16Array(this.count);
    this.nearest = new Uint16Array(this.count);
    for (let face = 0; face < this.count; ++face)
    {
      this.left[face] = 1;
      this.find(face);
    }
  }

  isEmpty(face) { return this.left[face] > this.right[face]; }

  product(row, corner)
  {
    const {corners} = this;
    return row[0] * corners[corner] + row[1] * corners[corner + 1] + row[2] * corners[corner + 2] +
           row[3];
  }

  project(face)
  {
    let nearest = Infinity;
    let reach = 0;
    for (let i = 0; i < 3; ++i)
    {
      const corner = 9 * face + 3 * i;
      const w = this.product(this.toW, corner);
      this.x[i] = this.product(this.toX, corner) / w;
      this.y[i] = this.product(this.toY, corner) / w;
      nearest = Math.min(nearest, w);
      reach = Math.max(reach, Math.abs(this.x[i]), Math.abs(this.y[i]));
    }
    this.margin =
      PIXEL_MARGIN + HIERARCHY_MARGIN * (this.slope + reach * this.slopeOfReach) / nearest;
  }

  find(face)
  {
    this.project(face);
    const {x, y, last} = this;
    const left = Math.min(x[0], x[1], x[2]);
    const right = Math.max(x[0], x[1], x[2]);
    const bottom = Math.min(y[0], y[1], y[2]);
    const top = Math.max(y[0], y[1], y[2]);
    const area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const turned = this.mirrored ? -area : area;
    const margin = this.margin + 0.5;
    const columns = [Math.ceil(left - margin), Math.floor(right + margin - 1)];
    const rows = [Math.ceil(bottom - margin), Math.floor(top + margin - 1)];
    if (turned < -2 * this.margin * (right - left + top - bottom) || columns[0] > columns[1] ||
        rows[0] > rows[1] || columns[0] > last[0] || rows[0] > last[1] || columns[1] < 0 ||
        rows[1] < 0)
    {
      return;
    }
    this.left[face] = clamp(columns[0], 0, last[0]);
    this.right[face] = clamp(columns[1], 0, last[0]);
    this.bottom[face] = clamp(rows[0], 0, last[1]);
    this.top[face] = clamp(rows[1], 0, last[1]);
    const corner = 9 * face;
    const nearest = Math.min(this.product(this.depth, corner), this.product(this.depth, corner + 3),
      this.product(this.depth, corner + 6));
    this.nearest[face] = clamp(Math.floor(nearest) - 1, 0, LAST_DEPTH);
  }

  /**
   * Of the columns left to right, those in which the projected face covers a pixel of these rows:
   * [first, last], first > last if there is none.
   */
  narrow(bottom, top, left, right)
  {
    const {x, y, margin} = this;
    const low = bottom + 0.5 - margin;
    const high = top + 0.5 + margin;
    let least = Number.MAX_VALUE;
    let most = -Number.MAX_VALUE;
    for (let i = 0; i < 3; ++i)
    {
      const j = (i + 1) % 3;
      const from = y[i] <= y[j] ? i : j;
      const to = from === i ? j : i;
      if (y[to] >= low && y[from] <= high)
      {
        const rise = y[to] - y[from];
        const slope = rise > 0 ? (x[to] - x[from]) / rise : 0;
        const first = y[from] >= low ? x[from] : x[from] + (low - y[from]) * slope;
        const last = y[to] <= high ? x[to] : x[from] + (high - y[from]) * slope;
        least = Math.min(least, first, last);
        most = Math.max(most, first, last);
      }
    }
    return [
      Math.max(left, clamp(Math.ceil(least - margin - 0.5), left, right + 1)),
      Math.min(right, clamp(Math.floor(most + margin - 0.5), left - 1, right))
    ];
  }
}
