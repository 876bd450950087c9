// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the march from the transfer functions of a volume, as Appearance/TransferTables.cxx
// makes them and GL/TableTextures.cxx uploads and binds them.
import {integralTable, slopeVariationsOf, transparentRangesOf, widthOfRange} from "./integral_table.js";
import {checkFunctions, evaluate, extinctionOf} from "./transfer_functions.js";

// The functions of each table, as Appearance/Blending.cxx and Components.cxx choose them.
function functionsOfTables(functions, {law, range, blend, components, extraRanges})
{
  const ranges = [range, ...extraRanges];
  const {color, opacity} = functions[0];
  const low = range[0];
  const intensity = [[low, 0, 0, 0], [low + widthOfRange(range), 1, 1, 1]];
  const opacities = {color: [[opacity[0][0], 1, 1, 1]], opacity};
  const colors = {color, opacity: [[color[0][0], 1]]};
  const kinds = {
    composite: () => [{functions: functions[0], law, range}],
    extreme: () => [{functions: functions[0], law: "unstructured", range}],
    isosurfaces: () => kinds.extreme(),
    sum: () => [{functions: {color: intensity, opacity}, law: "unstructured", range}],
    independent: () => functions.map((own, k) => ({functions: own, law, range: ranges[k]})),
    direct_color: () => [{functions: opacities, law, range}],
    color_and_opacity:
      () => [...kinds.direct_color(), {functions: colors, law: "unstructured", range: ranges[1]}]
  };
  const kind = components === "single" ? blend : components;
  if (!Object.hasOwn(kinds, kind))
  {
    throw new Error(
      `Transfer functions can't be edited for the blend mode ${blend} of components ` +
      `${components}, but only for ${Object.keys(kinds).join(", ")}.`);
  }
  const wanted = kinds[kind]();
  if (wanted.some((one) => !one.range) || (kind === "independent") !== (functions.length > 1))
  {
    throw new Error("The transfer functions of several components drawn together can only be " +
                    "edited with those of all components and the range of each.");
  }
  return wanted;
}

// Texels of the total variations: of colour; with several channels also of extinction, and of the
// slopes of the first table.
function variationTexels(tables, channels)
{
  const slopes = channels === 4 ? slopeVariationsOf(tables[0].values) : null;
  return joined(Float32Array, tables.map((table, k) => {
    const of = [table.variations.color, table.variations.extinction];
    const all = k === 0 && slopes ? [...of, slopes.extinction, slopes.emission] : of;
    const texels = new Float32Array(channels * table.size);
    for (let c = 0; c < Math.min(channels, all.length); ++c)
    {
      for (let i = 0; i < table.size; ++i)
      {
        texels[channels * i + c] = all[c][i];
      }
    }
    return texels;
  }));
}

function joined(Type, arrays)
{
  const all = new Type(arrays.reduce((sum, array) => sum + array.length, 0));
  let at = 0;
  for (const array of arrays)
  {
    all.set(array, at);
    at += array.length;
  }
  return all;
}

// Colours and opacities of isosurfaces at stored scalars, as Appearance/Blending.cxx finds them.
function isoColors(functions, range, stored)
{
  const colorAt = (x) => [...evaluate(functions, "unstructured", x, x, 1)];
  return floats(stored.flatMap((share) => colorAt(range[0] + share * widthOfRange(range))));
}

const floats = (numbers) => Array.from(numbers, Math.fround);

// The colour and extinction of scalars that are not finite.
function nanColorOf([r, g, b, opacity], law)
{
  const color = [r, g, b].map((x) => Math.min(Math.max(0, x), 1));
  return floats([...color, extinctionOf(opacity, law)]);
}

/**
 * The tables of the march, one after the other, as GL/TableTextures.cxx uploads and binds them,
 * from the functions { color, opacity, nan } of a volume; for "independent" from an array of them.
 * `structured`: of an image or rectilinear grid. `level`: of levelOf(). `blend`: "composite",
 * "extreme", "sum" or "isosurfaces", whose values `isoValues` are stored scalars. `components`:
 * "single", "independent", "color_and_opacity" or "direct_color"; `extraRanges` are those of the
 * further scalars. Each uniform is an array.
 */
export function makeTables(functions, {
  law,
  range,
  structured,
  level,
  blend = "composite",
  components = "single",
  extraRanges = [],
  isoValues = []
})
{
  const all = [].concat(functions);
  all.forEach(checkFunctions);
  const wanted = functionsOfTables(all, {law, range, blend, components, extraRanges});
  const tables = wanted.map((one) => integralTable(one.functions, one.law, one.range, level));
  const [first] = tables;
  const ranges = transparentRangesOf(first.values);
  const channels = structured ? 4 : components === "single" ? 1 : 2;
  const uniforms = {
    tableSize: [first.size],
    tableScale: floats([first.scale]),
    tableOffset: floats([first.offset]),
    givenIntegralUnit: floats(first.unit),
    constantColor: [...first.values.subarray(0, 3)],
    nanColor: nanColorOf(blend === "sum" ? [0, 0, 0, 0] : all[0].nan, wanted[0].law),
    givenTransparentRanges: floats(ranges)
  };
  if (blend === "isosurfaces")
  {
    uniforms.isoColor = isoColors(all[0], range, isoValues);
  }
  if (components !== "single")
  {
    const sizes = tables.map((table) => table.size);
    uniforms.tableSizes = sizes;
    uniforms.tableFirst = sizes.map((_, k) => sizes.slice(0, k).reduce((sum, n) => sum + n, 0));
    uniforms.tableIntegralUnits = floats(tables.flatMap((table) => table.unit));
    uniforms.tablePlace = floats(tables.flatMap((table) => [table.scale, table.offset]));
  }
  return {
    values: joined(Float32Array, tables.map((table) => table.values)),
    integrals: joined(Uint32Array, tables.map((table) => table.integrals)),
    variations: {
      data: variationTexels(tables, channels),
      format: {1: "R32F", 2: "RG32F", 4: "RGBA32F"}[channels]
    },
    uniforms,
    traits: {
      constantColor: first.values.every((x, i) => i % 4 === 3 || x === first.values[i % 4]),
      transparentRanges: ranges[0] > -3e38 || ranges[1] < 3e38 || ranges[2] < ranges[3]
    }
  };
}

/** The parameters of a level of accuracy, as levelOf() of VTKModule/Optics/AccuracyLevel.h. */
export function levelOf(name, tolerance)
{
  const levels = {
    fast: [false, 1 / 512, 1, 1024, 1024],
    default: [true, 1 / 255, 64, 1024, 65536],
    accurate: [true, 1 / 4096, 256, 1024, 65536],
    reference: [true, 1e-5, 1265, 4096, 65536],
    sampled: [false, 1 / 255, 1, 1024, 65536]
  };
  if (!Object.hasOwn(levels, name))
  {
    throw new Error(`There is no accuracy level ${name}, but ${Object.keys(levels).join(", ")}.`);
  }
  const [adaptive, most, trials, leastEntries, mostEntries] = levels[name];
  const kept = name === "default" ? tolerance : adaptive ? Math.min(most, tolerance) : most;
  return {
    adaptive,
    tolerance: kept,
    trials: adaptive ? Math.ceil(4 / Math.sqrt(kept)) : trials,
    sampled: name === "sampled",
    leastEntries,
    mostEntries
  };
}
