// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// From the functions of the written scene and the choices in the panel to the functions drawn.
import {colorMapPoints} from "./color_maps.js";
import {endsOf, spreadPoints} from "./opacity_points.js";

export const WRITTEN = "as written";

/** Points of colours without those that repeat the first or the last colour. */
export function trimColors(points)
{
  const same = (a, b) => a.every((part, k) => k === 0 || part === b[k]);
  const last = points.length - 1;
  const first = points.findIndex((point) => !same(point, points[0]));
  if (first < 0)
  {
    return [points[0], points[last]];
  }
  let end = last;
  while (same(points[end - 1], points[last]))
  {
    --end;
  }
  return points.slice(first - 1, end + 1);
}

/** The volumes that share functions, since they are blocks of one: { name, indices, range }. */
export function groupVolumes(volumes)
{
  const groups = new Map();
  volumes.forEach(({name, group, range}, i) => {
    const known = groups.get(group) || {name, indices: [], range: [Infinity, -Infinity]};
    known.indices.push(i);
    known.range = [Math.min(known.range[0], range[0]), Math.max(known.range[1], range[1])];
    groups.set(group, known);
  });
  return [...groups.values()];
}

/** All values that a volume or its functions have. */
export function chartRange(volumeRange, {color, opacity})
{
  const ends = [...volumeRange, ...endsOf(color), ...endsOf(opacity)];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  return high > low ? [low, high] : [low - 0.5, high + 0.5];
}

/** The colours that a choice in the panel makes: { map, reversed, range }. */
export function chosenColors(written, {map, reversed, range})
{
  if (map !== WRITTEN)
  {
    return colorMapPoints(map, ...range, reversed);
  }
  const points = spreadPoints(written, endsOf(written), reversed ? [range[1], range[0]] : range);
  return reversed ? points.reverse() : points;
}
