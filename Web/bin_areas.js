// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Coarser samples of transfer functions with the same integrals as finer ones, in the steps of
// VTKModule/Optics/BinAreas.cxx. Samples are r, g, b, extinction, one after the other.

/**
 * Add to `sum` the integrals of C tau and tau over a piece of unit length on which they are linear
 * from sample i to sample j.
 */
export function addLinearIntegrals(samples, i, j, sum)
{
  const p = 4 * i;
  const q = 4 * j;
  const from = samples[p + 3];
  const to = samples[q + 3];
  for (let k = 0; k < 3; ++k)
  {
    sum[k] += (samples[p + k] * (2 * from + to) + samples[q + k] * (from + 2 * to)) / 6;
  }
  sum[3] += 0.5 * (from + to);
}

// The minimum and maximum of each component of samples.
class Span
{
  constructor()
  {
    this.least = [1e300, 1e300, 1e300, 1e300];
    this.most = [-1e300, -1e300, -1e300, -1e300];
  }
  add(samples, i, factor)
  {
    for (let k = 0; k < 4; ++k)
    {
      const x = samples[4 * i + k] * (k < 3 ? factor : 1);
      this.least[k] = Math.min(this.least[k], x);
      this.most[k] = Math.max(this.most[k], x);
    }
  }
  clamped(x, k) { return Math.min(Math.max(x, this.least[k]), this.most[k]); }
}

// A sample to be corrected: its C tau and tau, and the span of the functions in its two bins.
function binNode(fine, at, perBin)
{
  const last = fine.length / 4 - 1;
  const weighted = new Span();
  const seen = new Span(); // of colours with extinction
  for (let i = Math.max(at - perBin, 0); i <= Math.min(at + perBin, last); ++i)
  {
    const tau = fine[4 * i + 3];
    weighted.add(fine, i, tau);
    if (tau > 0)
    {
      seen.add(fine, i, 1);
    }
  }
  const [r, g, b, tau] = fine.subarray(4 * at, 4 * at + 4);
  const fixed = at === 0 || at === last; // frequent values of the data
  return {value: [r * tau, g * tau, b * tau, tau], fixed, weighted, seen};
}

// The difference between the integrals of the fine samples and those between two kept ones.
function missingBetween(fine, begin, end)
{
  const sum = [0, 0, 0, 0];
  for (let i = begin; i < end; ++i)
  {
    addLinearIntegrals(fine, i, i + 1, sum);
  }
  const line = [0, 0, 0, 0];
  addLinearIntegrals(fine, begin, end, line);
  return sum.map((x, k) => x / (end - begin) - line[k]);
}

// An amount is added to both ends, half each, or as far as they stay within the span of their fine
// samples.
function addToEnds(amount, k, left, right)
{
  const add = (x, node) => {
    const before = node.value[k];
    node.value[k] = node.fixed ? before : node.weighted.clamped(before + x, k);
    return node.value[k] - before;
  };
  const rest = amount - add(0.5 * amount, left);
  add(rest - add(rest, right), left);
}

/**
 * Every perBin-th of the fine samples, corrected such that the integrals of tau between them stay,
 * and those of C tau as far as the colours of nearby samples allow.
 */
export function keepBinAreas(fine, perBin)
{
  const bins = (fine.length / 4 - 1) / perBin;
  const kept = new Float64Array(4 * (bins + 1));
  for (let i = 0; i <= bins; ++i)
  {
    kept.set(fine.subarray(4 * i * perBin, 4 * i * perBin + 4), 4 * i);
  }
  // The colour and extinction of a corrected node.
  const keep = (i, node) => {
    const tau = node.value[3];
    for (let k = 0; k < 3 && tau > 0; ++k)
    {
      kept[4 * i + k] = node.seen.clamped(node.value[k] / tau, k);
    }
    kept[4 * i + 3] = tau;
  };
  let left = null; // the node at the begin of a bin, if it is corrected
  for (let i = 0; i < bins; ++i)
  {
    const missing = missingBetween(fine, i * perBin, (i + 1) * perBin);
    // If the functions are linear, the remainder is rounding, which has no colour.
    const right =
      missing.some((x) => !(Math.abs(x) < 1e-12)) ? binNode(fine, (i + 1) * perBin, perBin) : null;
    if (right)
    {
      left = left || binNode(fine, i * perBin, perBin);
      missing.forEach((x, k) => addToEnds(x, k, left, right));
    }
    if (left)
    {
      keep(i, left);
    }
    left = right;
  }
  if (left)
  {
    keep(bins, left);
  }
  return kept;
}
