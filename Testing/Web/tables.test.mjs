// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The page's tables of transfer functions are those of C++ in every bit: tables.json is written by
// Testing/Unit/WebTablesTest.cxx.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import process from "node:process";
import test from "node:test";

import {levelOf, makeTables} from "../../Web/tables.js";

const file = process.env.TETMARCH_WEB_TABLES || new URL("tables.json", import.meta.url);
const cases = JSON.parse(readFileSync(file));
const ramp = cases[0].input;

function made({functions, level, tolerance, options})
{
  return makeTables(functions, {...options, level: levelOf(level, tolerance)});
}

const floats = (numbers) => Array.from(numbers, Math.fround);

for (const {name, input, expected} of cases)
{
  test(`tables: ${name}`, () => {
    const {values, integrals, variations, uniforms, traits} = made(input);
    const texel = (array, channels, i,
      count = channels) => [...array.subarray(channels * i, channels * i + count)];
    assert.deepEqual(levelOf(input.level, input.tolerance), expected.level);
    assert.deepEqual(traits, expected.traits);
    for (const [uniform, numbers] of Object.entries(expected.uniforms))
    {
      assert.deepEqual(uniforms[uniform], floats(numbers), uniform);
    }
    const channels = {R32F: 1, RG32F: 2, RGBA32F: 4}[variations.format];
    assert.equal(channels, expected.entries[0][3].length);
    assert.equal(variations.data.length, channels * values.length / 4);
    for (const [i, value, integral, variation] of expected.entries)
    {
      assert.deepEqual(texel(values, 4, i), floats(value), `value ${i}`);
      assert.deepEqual(texel(integrals, 4, i), integral, `integral ${i}`);
      assert.deepEqual(texel(variations.data, channels, i, variation.length), floats(variation));
    }
  });
}

test("colours of isosurfaces are those at their values", () => {
  const options = {...ramp.options, blend: "isosurfaces", isoValues: [0.375, 1]};
  const {isoColor} = made({...ramp, options}).uniforms;
  assert.deepEqual(isoColor, floats([0.7, 0.6, 0.1, 0.225, 1, 0, 0.4, 0.9]));
});

test("what can't be a function or a level is an error", () => {
  const withOpacity = (opacity) => () =>
    made({...ramp, functions: [{...ramp.functions[0], opacity}]});
  assert.throws(withOpacity([]), /opacity function needs nodes, each of 2 finite numbers/);
  assert.throws(withOpacity([[0, NaN]]), /2 finite numbers/);
  assert.throws(withOpacity([[0, 1], [-1, 1]]), /in order of their scalars/);
  assert.throws(() => made({...ramp, level: "best"}), /accuracy level best.*fast, default/);
  assert.throws(() => made({...ramp, options: {...ramp.options, blend: "slice"}}),
    /blend mode slice.*composite, extreme/);
  for (const components of ["independent", "color_and_opacity"])
  {
    assert.throws(() => made({...ramp, options: {...ramp.options, components}}),
      /of all components and the range of each/);
  }
});
