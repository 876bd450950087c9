// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The order in which the blocks of a volume are drawn: VTKModule/Blocks/BlockOrder.cxx.
import {invert, transformPoint} from "./matrices.js";

// From and to along each axis of the data.
function boxOf({data})
{
  const {center, radius, halfExtent} = data.frame;
  return halfExtent.map((half, a) => [center[a] - half * radius, center[a] + half * radius]);
}

// The eye in coordinates of the data: (point, 1), or (direction towards it, 0).
function eyeInData(camera, matrix)
{
  const {position, focalPoint, parallelProjection} = camera;
  const eye =
    parallelProjection ? [...position.map((x, a) => x - focalPoint[a]), 0] : [...position, 1];
  return transformPoint(invert(matrix), eye);
}

// Whether a plane has a on its side away from the eye, and b between it and the eye.
function isBeyondAPlane(a, b, eye)
{
  return a.some(([low, high], k) => {
    const eyeBelow = eye[3] !== 0 ? eye[k] <= low : eye[k] <= 0;
    const eyeAbove = eye[3] !== 0 ? eye[k] >= high : eye[k] >= 0;
    return (b[k][1] <= low && eyeBelow) || (b[k][0] >= high && eyeAbove);
  });
}

function distanceOf(box, eye)
{
  return box.reduce((sum, [low, high], k) => {
    const middle = 0.5 * (low + high);
    return sum + (eye[3] !== 0 ? (middle - eye[k]) ** 2 : -middle * eye[k]);
  }, 0);
}

/** Volumes that are blocks of the same data. */
export function backToFront(volumes, camera)
{
  if (volumes.length < 2)
  {
    return volumes;
  }
  const eye = eyeInData(camera, volumes[0].data.matrix);
  const boxes = volumes.map(boxOf);
  const comesBefore = (a, b) =>
    isBeyondAPlane(boxes[a], boxes[b], eye) && !isBeyondAPlane(boxes[b], boxes[a], eye);
  const left = volumes.map((_, i) => i);
  left.sort((a, b) => distanceOf(boxes[b], eye) - distanceOf(boxes[a], eye));
  const order = [];
  while (left.length > 0)
  {
    const free = left.findIndex((box) => !left.some((other) => comesBefore(other, box)));
    order.push(...left.splice(Math.max(free, 0), 1)); // a cycle: the farthest one
  }
  return order.map((i) => volumes[i]);
}
