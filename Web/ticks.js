// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Round numbers along a scale.

/**
 * Multiples of 1, 2 or 5 times a power of ten, from least to most; atMost: their maximum number.
 */
export function makeTicks(least, most, atMost)
{
  if (!(least < most) || !Number.isFinite(most - least) || atMost < 1)
  {
    return [];
  }
  const slack = 1e-9;
  const ends = (step) => [Math.ceil(least / step - slack), Math.floor(most / step + slack)];
  const power = 10 ** Math.floor(Math.log10((most - least) / atMost));
  const step = [1, 2, 5, 10, 20, 50, 100].map((factor) => factor * power).find((candidate) => {
    const [first, last] = ends(candidate);
    return last - first < atMost;
  });
  const [first, last] = ends(step);
  const ticks = [];
  for (let i = first; i <= last; ++i)
  {
    ticks.push(Number((i * step).toPrecision(12)));
  }
  return ticks;
}

/** Powers of ten from least to most, which are above 0. */
export function makeLogTicks(least, most)
{
  const ticks = [];
  for (let i = Math.ceil(Math.log10(least) - 1e-9); i <= Math.log10(most) + 1e-9; ++i)
  {
    ticks.push(Number(`1e${i}`));
  }
  return ticks;
}
