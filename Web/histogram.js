// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The histogram behind the opacity function.

/**
 * Numbers of values in bins of equal width over a range. parts: { scalars, range } of each block,
 * with scalars from 0 to 1 over its range; those that are not finite are left out.
 */
export function countValues(parts, [low, high], bins = 128)
{
  const counts = new Array(bins).fill(0);
  const width = high > low ? high - low : 1;
  for (const {scalars, range} of parts)
  {
    const [offset, scale] = [(range[0] - low) / width, (range[1] - range[0]) / width];
    for (const scalar of scalars)
    {
      if (Number.isFinite(scalar))
      {
        const bin = Math.floor((offset + scale * scalar) * bins);
        ++counts[Math.min(Math.max(bin, 0), bins - 1)];
      }
    }
  }
  return counts;
}

/**
 * The histogram as the path of an SVG: its bins between the coordinates left and right, upwards
 * from bottom. Heights are logarithmic: of most data, one value is far more frequent than all
 * others.
 */
export function histogramPath(counts, {left, right, bottom, height})
{
  const greatest = Math.log1p(counts.reduce((a, b) => Math.max(a, b), 1));
  const text = (number) => number.toFixed(2);
  const steps = counts.map((count, bin) => {
    const y = bottom - height * Math.log1p(count) / greatest;
    const x = left + (right - left) * (bin + 1) / counts.length;
    return `V${text(y)}H${text(x)}`;
  });
  return `M${text(left)},${text(bottom)}${steps.join("")}V${text(bottom)}Z`;
}
