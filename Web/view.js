// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the march knows of the camera, as uniforms: VTKModule/View/View.cxx, RayPoints.cxx and
// FittedDepths.cxx, in double precision like there.
import {determinant3, invert, multiply, transformPoint} from "./matrices.js";

const MARGIN = 1.01;

/** The greatest product of a row of a matrix and a point of the volume's box. */
export function reachOf(row, halfExtent)
{
  return Math.abs(row[0]) * halfExtent[0] + Math.abs(row[1]) * halfExtent[1] +
         Math.abs(row[2]) * halfExtent[2];
}

// The clip matrix with depths that fit the volume.
function fittedDepths(toClip, halfExtent)
{
  const m = toClip.slice();
  const z = m.slice(8, 12);
  const w = m.slice(12, 16);
  if (w[0] === 0 && w[1] === 0 && w[2] === 0)
  {
    const scale = w[3] / (MARGIN * reachOf(z, halfExtent));
    return [...m.slice(0, 8), z[0] * scale, z[1] * scale, z[2] * scale, 0, ...w];
  }
  const reach = reachOf(w, halfExtent);
  const far = Math.max(w[3] + MARGIN * reach, 1e-3 * reach);
  const near = Math.max(w[3] - MARGIN * reach, 0.5 * (w[3] - reach), 1e-3 * far);
  const depths = w.map((x) => x * (far + near) / (far - near));
  depths[3] -= 2 * far * near / (far - near);
  return [...m.slice(0, 8), ...depths, ...w];
}

// From an inverse: clip x and y -> the point at that clip depth.
function pointsAtDepth(depth, inverse)
{
  return inverse.map((x, i) => i % 4 === 3 ? x + depth * inverse[i - 1] : x);
}

function rayPoints(view, halfExtent)
{
  const [x, y, z, w] = view.eye;
  const distance = Math.hypot(x, y, z);
  if (w * 2 > distance)
  {
    const depth = view.cutsNearPlane ? 1 : -1;
    return pointsAtDepth(depth, invert(fittedDepths(view.normalizedToClip, halfExtent)));
  }
  const m = view.normalizedToClip.slice();
  m.splice(8, 4, x / distance, y / distance, z / distance, 0);
  return invert(m);
}

// At which rays begin: unit normal and offset; 0 if all of the volume is behind it.
function nearPlane(view)
{
  const plane = [0, 1, 2, 3].map((i) => view.normalizedToClip[8 + i] + view.normalizedToClip[12 + i]);
  const length = Math.hypot(plane[0], plane[1], plane[2]);
  return plane.map((x) => view.cutsNearPlane ? x / length : 0);
}

function classify(toClip, halfExtent)
{
  let cutsNearPlane = false;
  let cutsFarPlane = false;
  for (let corner = 0; corner < 8; ++corner)
  {
    const p = halfExtent.map((half, a) => corner >> a & 1 ? half : -half);
    const [, , z, w] = transformPoint(toClip, p);
    cutsNearPlane = cutsNearPlane || z <= -w;
    cutsFarPlane = cutsFarPlane || z >= w;
  }
  return {cutsNearPlane, cutsFarPlane};
}

// The common point of all lines of sight in view coordinates, or the direction towards the eye.
function eyeOf(projection)
{
  const eye = [2, 6, 10, 14].map((i) => -invert(projection)[i]);
  const unit = eye[3] !== 0 ? eye[3] : Math.max(...eye.slice(0, 3).map(Math.abs));
  return eye.map((x) => x / unit);
}

// No number leaves the range of floats; homogeneous coordinates may be scaled.
function inFloatRange(m)
{
  const exponent = Math.floor(Math.log2(Math.max(...m.map(Math.abs)))) + 1;
  return Math.abs(exponent) > 64 ? m.map((x) => x * 2 ** -exponent) : m;
}

/** From the normalised frame of a volume to the world. */
export function normalizedToWorld(volume)
{
  const {center, radius} = volume.frame;
  const toData =
    [radius, 0, 0, center[0], 0, radius, 0, center[1], 0, 0, radius, center[2], 0, 0, 0, 1];
  return multiply(volume.matrix, toData);
}

/** The view of a volume; null if a matrix is singular or not finite. */
export function viewOf(camera, aspect, volume)
{
  const toWorld = normalizedToWorld(volume);
  const toView = multiply(camera.viewMatrix(), toWorld);
  const projection = camera.projectionMatrix(aspect);
  const normalizedToClip = inFloatRange(multiply(projection, toView));
  const inverse = invert(normalizedToClip);
  const fromView = invert(toView);
  if (!inverse || !fromView || !(Math.abs(determinant3(toView)) > 0) ||
      !normalizedToClip.every(Number.isFinite))
  {
    return null;
  }
  const clipToNormalized = inFloatRange(inverse);
  const {halfExtent} = volume.frame;
  const view = {
    normalizedToClip,
    clipToNormalized,
    eye: transformPoint(fromView, eyeOf(projection)),
    toWorld,
    mirrored: determinant3(toView) < 0,
    ...classify(normalizedToClip, halfExtent)
  };
  return {...view, rayPoints: rayPoints(view, halfExtent), nearPlane: nearPlane(view)};
}
