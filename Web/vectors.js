// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Vectors as arrays of 3 numbers.

/** a + s b */
export function addScaled(a, b, s)
{
  return [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
}

export function dot(a, b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a, b)
{
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** The vector of length 1; zero remains zero. */
export function normalize(a)
{
  const length = Math.hypot(...a);
  return length > 0 ? a.map((x) => x / length) : [0, 0, 0];
}

/** v, rotated about an axis through the origin, in degrees (Rodrigues, 1840). */
export function rotate(v, axis, degrees)
{
  const k = normalize(axis);
  const angle = degrees * Math.PI / 180;
  const turned = addScaled(v.map((x) => x * Math.cos(angle)), cross(k, v), Math.sin(angle));
  return addScaled(turned, k, dot(k, v) * (1 - Math.cos(angle)));
}
