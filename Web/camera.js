// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The camera: position, view angle and movements as of vtkCamera; its fit to bounds as of
// vtkRenderer.
import {addScaled, cross, dot, normalize, rotate} from "./vectors.js";

const DEGREE = Math.PI / 180;
const LEAST_NEAR = 0.001; // of the far distance, as vtkRenderer with a depth buffer of 24 bits

/** The 8 corners of [xMin, xMax, yMin, yMax, zMin, zMax]. */
function cornersOf(bounds)
{
  return Array.from(
    {length: 8}, (_, i) => [bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)]]);
}

export class Camera
{
  /** view: the members that toObject() returns. */
  constructor(view)
  {
    this.position = [...view.position];
    this.focalPoint = [...view.focalPoint];
    this.viewUp = normalize(view.viewUp);
    this.viewAngle = view.viewAngle;
    this.parallelProjection = Boolean(view.parallelProjection);
    this.parallelScale = view.parallelScale;
    this.clippingRange = [...view.clippingRange];
  }

  toObject()
  {
    return {
      position: [...this.position],
      focalPoint: [...this.focalPoint],
      viewUp: [...this.viewUp],
      viewAngle: this.viewAngle,
      parallelProjection: this.parallelProjection,
      parallelScale: this.parallelScale,
      clippingRange: [...this.clippingRange],
    };
  }

  copy() { return new Camera(this); }

  /** Takes over all members of another camera. */
  assign(camera) { Object.assign(this, camera.toObject()); }

  get distance() { return Math.hypot(...addScaled(this.position, this.focalPoint, -1)); }

  /** Unit vectors in the world: to the right, up, and towards the viewer. */
  axes()
  {
    const back = normalize(addScaled(this.position, this.focalPoint, -1));
    const right = normalize(cross(this.viewUp, back));
    return {right, up: cross(back, right), back};
  }

  viewMatrix()
  {
    const {right, up, back} = this.axes();
    const rows = [right, up, back].map((axis) => [...axis, -dot(axis, this.position)]);
    return [...rows.flat(), 0, 0, 0, 1];
  }

  /** aspect: width over height. */
  projectionMatrix(aspect)
  {
    const [near, far] = this.clippingRange;
    const depth = far - near;
    if (this.parallelProjection)
    {
      const y = 1 / this.parallelScale;
      return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, -2 / depth, -(far + near) / depth, 0, 0, 0, 1];
    }
    const y = 1 / Math.tan(this.viewAngle * DEGREE / 2);
    return [
      y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, -(far + near) / depth, -2 * far * near / depth, 0, 0,
      -1, 0
    ];
  }

  turnAbout(axis, degrees)
  {
    const arm = addScaled(this.position, this.focalPoint, -1);
    this.position = addScaled(this.focalPoint, rotate(arm, axis, degrees), 1);
  }

  azimuth(degrees) { this.turnAbout(this.viewUp, degrees); }

  elevation(degrees) { this.turnAbout(this.axes().right, -degrees); }

  roll(degrees) { this.viewUp = rotate(this.viewUp, this.axes().back, -degrees); }

  orthogonalizeViewUp() { this.viewUp = this.axes().up; }

  /** Moves towards the focal point; the distance to it is divided by a factor. */
  dolly(factor)
  {
    if (factor > 0)
    {
      const arm = addScaled(this.position, this.focalPoint, -1);
      this.position = addScaled(this.focalPoint, arm, 1 / factor);
    }
  }

  /** Divides the view angle, or the parallel scale, by a factor. */
  zoom(factor)
  {
    if (factor > 0 && this.parallelProjection)
    {
      this.parallelScale /= factor;
    }
    else if (factor > 0)
    {
      this.viewAngle = Math.min(Math.max(this.viewAngle / factor, 1e-8), 179.9);
    }
  }

  /** Makes the scene larger by a factor, as the right button and the wheel do. */
  approach(factor)
  {
    if (this.parallelProjection)
    {
      this.zoom(factor);
    }
    else
    {
      this.dolly(factor);
    }
  }

  /** Height of the view at the focal point. */
  get viewHeight()
  {
    return this.parallelProjection ? 2 * this.parallelScale
                                   : 2 * this.distance * Math.tan(this.viewAngle * DEGREE / 2);
  }

  /**
   * Moves the scene at the focal point by (dx, dy) pixels, to the right and up, of [width,
   * height].
   */
  pan(dx, dy, size)
  {
    const {right, up} = this.axes();
    const pixel = this.viewHeight / size[1];
    const motion = addScaled(right.map((x) => -dx * pixel * x), up, -dy * pixel);
    this.position = addScaled(this.position, motion, 1);
    this.focalPoint = addScaled(this.focalPoint, motion, 1);
  }

  /** Fits the clipping range to [xMin, xMax, yMin, yMax, zMin, zMax]. */
  resetClippingRange(bounds)
  {
    const {back} = this.axes();
    const depths = cornersOf(bounds).map((p) => dot(back, addScaled(this.position, p, -1)));
    let near = Math.min(...depths);
    let far = Math.max(...depths, 1e-18);
    const gap = this.parallelProjection ? 0.1 * this.parallelScale
                                        : 0.2 * Math.tan(this.viewAngle * DEGREE / 2) * far;
    const missing = Math.max(0, gap - (far - near));
    far += missing / 2;
    near = Math.max(0, near - missing / 2);
    near = 0.99 * near - (far - near) * 0.5;
    far = 1.01 * far + (far - near) * 0.5;
    near = near >= far ? 0.01 * far : near;
    this.clippingRange = [Math.max(near, LEAST_NEAR * far), far];
  }

  /** Shows all of the bounds from the same direction. aspect: width over height. */
  reset(bounds, aspect = 1)
  {
    const {back} = this.axes();
    const diagonal = Math.hypot(...[0, 2, 4].map((i) => bounds[i + 1] - bounds[i]));
    const radius = 0.5 * (diagonal || 1);
    const narrow = Math.min(1, aspect);
    const halfAngle = Math.atan(Math.tan(this.viewAngle * DEGREE / 2) * narrow);
    if (Math.abs(dot(normalize(this.viewUp), back)) > 0.999)
    {
      this.viewUp = [-this.viewUp[2], this.viewUp[0], this.viewUp[1]];
    }
    this.focalPoint = [0, 2, 4].map((i) => (bounds[i] + bounds[i + 1]) / 2);
    this.position = addScaled(this.focalPoint, back, radius / Math.sin(halfAngle));
    this.parallelScale = radius / narrow;
    this.resetClippingRange(bounds);
  }

  /** Shows all of the bounds, seen from a direction: +-1 along the axis 0, 1 or 2. */
  lookFrom(axis, sign, bounds, aspect = 1)
  {
    const back = [0, 0, 0];
    back[axis] = sign;
    this.viewUp = axis === 2 ? [0, 1, 0] : [0, 0, 1];
    this.position = addScaled(this.focalPoint, back, 1);
    this.reset(bounds, aspect);
  }
}
