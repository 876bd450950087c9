// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Colour and extinction as functions of the scalar, sampled in the steps of
// VTKModule/Optics/TransferFunctions.cxx. Functions are { color: [[x, r, g, b]...], opacity:
// [[x, a]...] }: linear between these nodes and constant beyond them.
import {keepBinAreas} from "./bin_areas.js";

const clampedToUnit = (x) => Math.min(Math.max(0, x), 1);

/** The extinction of an opacity by a law, "structured" or "unstructured". */
export function extinctionOf(opacity, law)
{
  const alpha = clampedToUnit(opacity);
  return law === "structured" ? -Math.log1p(-Math.min(alpha, 1 - 2 ** -24)) : alpha;
}

function checkNodes(nodes, channels, name)
{
  const isNode = (node) => node.length === channels + 1 && node.every(Number.isFinite);
  if (!nodes.length || !nodes.every(isNode))
  {
    throw new Error(`The ${name} function needs nodes, each of ${channels + 1} finite numbers.`);
  }
  if (nodes.some((node, i) => i > 0 && node[0] < nodes[i - 1][0]))
  {
    throw new Error(`The nodes of the ${name} function must be in order of their scalars.`);
  }
}

/** Throws an Error unless the nodes are numbers and in order. */
export function checkFunctions({color, opacity})
{
  checkNodes(color, 3, "colour");
  checkNodes(opacity, 1, "opacity");
}

/**
 * The values of the nodes at `count` equal steps, as vtkPiecewiseFunction::GetTable() and
 * vtkColorTransferFunction::GetTable() interpolate them.
 */
function valuesOf(nodes, begin, end, count)
{
  const channels = nodes[0].length - 1;
  const values = new Float64Array(channels * count);
  let next = 0;
  for (let i = 0; i < count; ++i)
  {
    const x = count > 1 ? begin + (i / (count - 1)) * (end - begin) : begin;
    while (next < nodes.length && x > nodes[next][0])
    {
      ++next;
    }
    const p = nodes[Math.max(next - 1, 0)];
    const q = nodes[Math.min(next, nodes.length - 1)];
    const share = p === q ? 0 : (x - p[0]) / (q[0] - p[0]);
    for (let k = 0; k < channels; ++k)
    {
      values[channels * i + k] = (1 - share) * p[k + 1] + share * q[k + 1];
    }
  }
  return values;
}

/** `count` samples r, g, b, extinction at equal steps. */
export function evaluate(functions, law, begin, end, count)
{
  const colors = valuesOf(functions.color, begin, end, count);
  const opacities = valuesOf(functions.opacity, begin, end, count);
  const samples = new Float64Array(4 * count);
  for (let i = 0; i < count; ++i)
  {
    for (let k = 0; k < 3; ++k)
    {
      samples[4 * i + k] = clampedToUnit(colors[3 * i + k]);
    }
    samples[4 * i + 3] = extinctionOf(opacities[i], law);
  }
  return samples;
}

/**
 * `count` samples of the part of low..high in which a function has nodes; `before` and `after` are
 * the values beyond it.
 */
export function sampleFunctions(functions, law, low, high, count)
{
  const {color, opacity} = functions;
  let begin = Math.max(low, Math.min(color[0][0], opacity[0][0]));
  let end = Math.min(high, Math.max(color[color.length - 1][0], opacity[opacity.length - 1][0]));
  // There are no nodes within the data, or only in so small a part that positions in the table
  // would overflow in float.
  if (!(end - begin > 1e-30 * (high - low)))
  {
    begin = low;
    end = high > low ? high : low + Math.max(1, Math.abs(low));
  }
  const samples = evaluate(functions, law, begin, end, count);
  return {
    begin,
    end,
    samples,
    before: low < begin ? evaluate(functions, law, low, low, 1) : samples.subarray(0, 4),
    after: high > end ? evaluate(functions, law, high, high, 1) : samples.subarray(-4)
  };
}

/**
 * `factor` times as many samples. The extinction is evaluated again; the colour is interpolated.
 */
export function refined(functions, law, coarse, factor)
{
  const count = (coarse.samples.length / 4 - 1) * factor + 1;
  const opacities = valuesOf(functions.opacity, coarse.begin, coarse.end, count);
  const samples = new Float64Array(4 * count);
  for (let i = 0; i < count; ++i)
  {
    const p = 4 * Math.floor(i / factor);
    const q = 4 * Math.ceil(i / factor);
    const share = (i % factor) / factor;
    for (let k = 0; k < 3; ++k)
    {
      samples[4 * i + k] =
        coarse.samples[p + k] + (coarse.samples[q + k] - coarse.samples[p + k]) * share;
    }
    samples[4 * i + 3] = extinctionOf(opacities[i], law);
  }
  return {...coarse, samples};
}

// The maximum difference between the fine samples and the lines between kept ones: in extinction,
// relative to the maximum extinction, or in a colour with extinction.
function deviationOf(fine, kept, perBin)
{
  const last = fine.length / 4 - 1;
  let greatest = 0;
  for (let i = 0; i <= last; ++i)
  {
    greatest = Math.max(greatest, fine[4 * i + 3]);
  }
  let most = 0;
  for (let i = 0; i < last && greatest > 0; ++i)
  {
    const bin = 4 * Math.floor(i / perBin);
    const share = (i % perBin) / perBin;
    const difference = (k) =>
      Math.abs(kept[bin + k] + (kept[bin + 4 + k] - kept[bin + k]) * share - fine[4 * i + k]);
    most = Math.max(most, difference(3) / greatest);
    for (let k = 0; k < 3 && fine[4 * i + 3] > 0; ++k)
    {
      most = Math.max(most, difference(k));
    }
  }
  return most;
}

/** Every perBin-th of the samples with the areas between them, and their `deviation`. */
export function keepAreas(fine, perBin)
{
  const samples = keepBinAreas(fine.samples, perBin);
  return {...fine, samples, deviation: deviationOf(fine.samples, samples, perBin)};
}
