// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The histogram behind the opacity function.

/** Numbers of scalars, 0 to 1, in bins of equal width; those that are not finite are left out. */
export function countScalars(scalars, bins = 128)
{
  const counts = new Array(bins).fill(0);
  for (const scalar of scalars)
  {
    if (Number.isFinite(scalar))
    {
      ++counts[Math.min(Math.max(Math.floor(scalar * bins), 0), bins - 1)];
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
