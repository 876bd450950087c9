// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Edits of an opacity function: points [x, opacity] in ascending order, linear between them and
// constant outside. Each edit returns a new list; equal x make a jump.

const clampNumber = (value, low, high) => Math.min(Math.max(value, low), high);

/** The first and the last x. */
export const endsOf = (points) => [points[0][0], points[points.length - 1][0]];

export function opacityAt(points, x)
{
  const next = points.findIndex((point) => point[0] > x);
  if (next <= 0)
  {
    return points[next === 0 ? 0 : points.length - 1][1];
  }
  const [below, above] = [points[next - 1], points[next]];
  return below[1] + (above[1] - below[1]) * (x - below[0]) / (above[0] - below[0]);
}

/** Moves a point, at most up to its neighbours and the ends of the range. */
export function movePoint(points, index, [x, opacity], [low, high])
{
  const least = index > 0 ? points[index - 1][0] : low;
  const most = index + 1 < points.length ? points[index + 1][0] : high;
  const moved = [clampNumber(x, least, most), clampNumber(opacity, 0, 1)];
  return points.map((point, i) => i === index ? moved : point);
}

/** Adds a point: { points, index }, which is the place of the new one. */
export function addPoint(points, point)
{
  const [x, opacity] = point;
  const next = points.findIndex((other) => other[0] > x);
  const index = next < 0 ? points.length : next;
  const added = [x, clampNumber(opacity, 0, 1)];
  return {points: [...points.slice(0, index), added, ...points.slice(index)], index};
}

/** Adds a point halfway to the next one, or to the one before the last, on the function. */
export function splitAfter(points, index)
{
  if (points.length < 2)
  {
    return addPoint(points, points[0]);
  }
  const first = Math.min(index, points.length - 2);
  const x = 0.5 * (points[first][0] + points[first + 1][0]);
  return addPoint(points, [x, 0.5 * (points[first][1] + points[first + 1][1])]);
}

/** Removes a point; the last one stays. */
export function removePoint(points, index)
{
  return points.length > 1 ? points.filter((_, i) => i !== index) : points;
}

/** The points with their x moved linearly from one range to another. */
export function spreadPoints(points, from, to)
{
  const [[low, high], [newLow, newHigh]] = [from, to];
  const scale = high > low ? (newHigh - newLow) / (high - low) : 0;
  return points.map(([x, ...rest]) => [newLow + (x - low) * scale, ...rest]);
}

/**
 * The fewest of the points that keep a function within a tolerance (Douglas and Peucker, 1973).
 */
export function simplifyPoints(points, tolerance)
{
  const ends = [points[0], points[points.length - 1]];
  let worst = 0;
  let index = 0;
  points.forEach(([x, opacity], i) => {
    const error = Math.abs(opacity - opacityAt(ends, x));
    if (i > 0 && i + 1 < points.length && error > worst)
    {
      [worst, index] = [error, i];
    }
  });
  if (worst <= tolerance)
  {
    return points.length > 1 ? ends : points;
  }
  const parts = [points.slice(0, index + 1), points.slice(index)];
  const [before, after] = parts.map((part) => simplifyPoints(part, tolerance));
  return [...before, ...after.slice(1)];
}
