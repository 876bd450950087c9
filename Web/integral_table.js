// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of transfer functions and its integrals (Shaders/tables/integral_table.glsl), in the
// steps of VTKModule/Optics/FittingTable.cxx and IntegralTable.cxx.
import {addLinearIntegrals} from "./bin_areas.js";
import {keepAreas, refined, sampleFunctions} from "./transfer_functions.js";

// Two entries before the samples and two behind them contain the constant values beyond them.
const entriesBeyond = 4;
const mostInteger = 4294967295;

/**
 * The samples with the resolution that the level requires; the least and most entries are those of
 * most levels unless it has its own.
 */
function fittingSamples(
  functions, law, [low, high], {tolerance, leastEntries = 1024, mostEntries = 65536})
{
  const binsOf = (entries) => entries - entriesBeyond - 1;
  const mostPerBin = Math.max(4, Math.floor(16384 / leastEntries));
  const leastPerBin = 2;
  const most = 0.5 * tolerance;
  let bins = binsOf(leastEntries);
  let fine = sampleFunctions(functions, law, low, high, bins * mostPerBin + 1);
  let kept = keepAreas(fine, mostPerBin);
  while (kept.deviation > most && bins * 4 <= binsOf(mostEntries))
  {
    // At a kink the deviation is proportional to the width of a bin: insufficient sizes are
    // skipped.
    bins *= kept.deviation > 8 * most && bins * 16 <= binsOf(mostEntries) ? 16 : 4;
    const fineBins = fine.samples.length / 4 - 1;
    if (fineBins < leastPerBin * bins)
    {
      fine = refined(functions, law, fine, Math.floor((leastPerBin * bins) / fineBins));
    }
    kept = keepAreas(fine, (fine.samples.length / 4 - 1) / bins);
  }
  return kept;
}

// A colour without extinction is invisible. It is replaced by that of the nearest entry with
// extinction, so that it doesn't count as a change of colour.
function hideUnseenColors(entries)
{
  const count = entries.length / 4;
  const hasExtinction = (i) => i >= 0 && i < count && entries[4 * i + 3] > 0;
  const seen = [];
  for (let i = 0; i < count; ++i)
  {
    if (hasExtinction(i) || hasExtinction(i - 1) || hasExtinction(i + 1))
    {
      seen.push(i);
    }
  }
  let next = 0; // of seen
  for (let i = 0; i < count && seen.length; ++i)
  {
    while (next + 1 < seen.length && Math.abs(seen[next + 1] - i) <= Math.abs(seen[next] - i))
    {
      ++next;
    }
    entries.copyWithin(4 * i, 4 * seen[next], 4 * seen[next] + 3);
  }
}

/** Integrals up to each entry as integers, and their units. */
function integralsOf(entries)
{
  const sums = new Float64Array(entries.length);
  const sum = [0, 0, 0, 0];
  for (let at = 4; at < entries.length; at += 4)
  {
    addLinearIntegrals(entries, at / 4 - 1, at / 4, sum);
    sums.set(sum, at);
  }
  const unit = sum.map((x) => x / mostInteger);
  const integrals = new Uint32Array(entries.length);
  for (let i = 0; i < sums.length; ++i)
  {
    const ofOne = unit[i % 4];
    integrals[i] = ofOne > 0 ? Math.min(Math.floor(sums[i] / ofOne + 0.5), mostInteger) : 0;
  }
  return {integrals, unit};
}

const greatest = (x, y, z) => Math.max(Math.abs(x), Math.abs(y), Math.abs(z));

/** The total variation up to each entry of the colour, and of the extinction as a float. */
function variationsOf(entries, values)
{
  const count = entries.length / 4;
  const variations = {color: new Float64Array(count), extinction: new Float64Array(count)};
  for (let i = 1; i < count; ++i)
  {
    const change = (k, of) => of[4 * i + k] - of[4 * i + k - 4];
    variations.color[i] = variations.color[i - 1] +
                          greatest(change(0, entries), change(1, entries), change(2, entries));
    variations.extinction[i] = variations.extinction[i - 1] + Math.abs(change(3, values));
  }
  return variations;
}

/** The total variation up to each entry of the slopes of tau and of C tau per entry. */
export function slopeVariationsOf(values)
{
  const count = values.length / 4;
  const variations = {extinction: new Float64Array(count), emission: new Float64Array(count)};
  // The slope of the parabola C tau, and of tau, at the begin (end 0) or end (end 1) of a bin.
  const slopesAt = (bin, end) => {
    const at = 4 * (bin + end);
    const rise = (k) => values[4 * bin + 4 + k] - values[4 * bin + k];
    const ofEmission = (k) => rise(k) * values[at + 3] + values[at + k] * rise(3);
    return [ofEmission(0), ofEmission(1), ofEmission(2), rise(3)];
  };
  let before = [0, 0, 0, 0]; // all is constant before the first bin
  let ofExtinction = 0;
  let ofEmission = 0;
  const pass = (slopes) => {
    ofEmission += greatest(slopes[0] - before[0], slopes[1] - before[1], slopes[2] - before[2]);
    ofExtinction += Math.abs(slopes[3] - before[3]);
    before = slopes;
  };
  const keep = (entry) => {
    variations.extinction[entry] = ofExtinction;
    variations.emission[entry] = ofEmission;
  };
  for (let bin = 0; bin + 1 < count; ++bin)
  {
    pass(slopesAt(bin, 0));
    keep(bin); // the sums up to a bin include the jump at its begin
    pass(slopesAt(bin, 1));
    keep(bin + 1);
  }
  return variations;
}

/**
 * Positions, in entries: there is no extinction up to the first and from the second one on, nor
 * between the third and the fourth, the widest gap between the first two.
 */
export function transparentRangesOf(values)
{
  const ranges = [-3e38, 3e38, 1, 0];
  const count = values.length / 4;
  const isSeen = (i) => values[4 * i + 3] > 0;
  let widest = 0;
  for (let i = 0; i < count; ++i)
  {
    const from = i;
    while (i < count && !isSeen(i))
    {
      ++i;
    }
    const to = i - 1; // entry i has extinction, or is behind the table
    if (from > to)
    {
      continue;
    }
    ranges[0] = from === 0 ? to : ranges[0];
    ranges[1] = i === count ? from : ranges[1];
    if (from > 0 && i < count && to - from > widest)
    {
      widest = to - from;
      ranges.splice(2, 2, from, to);
    }
  }
  return ranges;
}

/** The difference of the scalars stored as 1 and 0. */
export const widthOfRange = ([low, high]) => (high > low ? high - low : 1);

/** The table of the functions over a range of scalars. */
export function integralTable(functions, law, range, level)
{
  const {before, samples, after, begin, end} = fittingSamples(functions, law, range, level);
  const size = samples.length / 4 + entriesBeyond;
  const entries = new Float64Array(4 * size);
  [before, before].forEach((value, i) => entries.set(value, 4 * i));
  entries.set(samples, 8);
  [after, after].forEach((value, i) => entries.set(value, 4 * (size - 2 + i)));
  hideUnseenColors(entries);
  const values = new Float32Array(entries);
  // The position of a stored scalar s = 0..1 in the table, in entries, is scale s + offset.
  const scale = (widthOfRange(range) / (end - begin)) * (size - 5);
  const offset = 2 + ((range[0] - begin) / (end - begin)) * (size - 5);
  const variations = variationsOf(entries, values);
  return {size, values, variations, scale, offset, ...integralsOf(entries)};
}
