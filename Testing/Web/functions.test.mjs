// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The page's transfer functions: colour maps, edits of opacity, histogram.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import test from "node:test";

import {COLOR_MAP_NAMES, colorAt, colorMapPoints} from "../../Web/color_maps.js";
import {chartRange, chosenColors, groupVolumes, trimColors} from "../../Web/function_choices.js";
import {countValues, histogramPath} from "../../Web/histogram.js";
import * as opacities from "../../Web/opacity_points.js";

const maps =
  JSON.parse(readFileSync(new URL("../../Tools/Common/ColorMaps.json", import.meta.url)));

test("The colour maps are those of tetmarch-render", () => {
  assert.deepEqual(COLOR_MAP_NAMES, maps.map((map) => map.Name));
  for (const {Name, RGBPoints} of maps)
  {
    const points = colorMapPoints(Name, 0, 1);
    assert.deepEqual([points[0][0], points[points.length - 1][0]], [0, 1]);
    for (let i = 0; i < RGBPoints.length; i += 4)
    {
      const found = colorAt(points, RGBPoints[i]);
      RGBPoints.slice(i + 1, i + 4)
        .forEach(
          (part, k) => assert.ok(Math.abs(part - found[k]) < 0.51 / 255, `${Name} ${i} ${k}`));
    }
  }
});

// K. Moreland, "Diverging Color Maps for Scientific Visualization" (2009), which lists them.
test("Cool to Warm goes through the grey of its inventor and the blue and red beside it", () => {
  const points = colorMapPoints("Cool to Warm", 0, 1);
  for (const [x, ...expected] of [
         [0.5, 221, 221, 221], [0.25, 141, 176, 254], [0.75, 244, 154, 123]])
  {
    colorAt(points, x).forEach(
      (part, k) => assert.ok(Math.abs(255 * part - expected[k]) < 1.5, `${x}: ${255 * part}`));
  }
});

test("A colour map fills a range, from its other end if it is reversed", () => {
  const [low, high] = [maps[0].RGBPoints.slice(1, 4), maps[0].RGBPoints.slice(-3)];
  const near = (a, b) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) < 0.51 / 255));
  const points = colorMapPoints("Viridis", 20, 70, true);
  assert.deepEqual([points[0][0], points[32][0]], [20, 70]);
  near(colorAt(points, 20), high);
  near(colorAt(points, 99), low);
});

const ramp = [[0, 0], [4, 0.5], [4, 0.75], [10, 1]];

/** @type {[string, () => any, any][]} */
const edits = [
  ["values before the first point", () => opacities.opacityAt(ramp, -1), 0],
  ["values behind the last point", () => opacities.opacityAt(ramp, 11), 1],
  ["values between", () => opacities.opacityAt(ramp, 2), 0.25],
  ["the upper side of a jump", () => opacities.opacityAt(ramp, 4), 0.75],
  ["a move", () => opacities.movePoint(ramp, 1, [3, 0.6], [0, 10])[1], [3, 0.6]],
  ["a move past a neighbour", () => opacities.movePoint(ramp, 1, [7, 2], [0, 10])[1], [4, 1]],
  ["a move out of the range", () => opacities.movePoint(ramp, 3, [70, -2], [0, 10])[3], [10, 0]],
  [
    "a point that is added", () => opacities.addPoint(ramp, [5, 0.1]),
    {points: [...ramp.slice(0, 3), [5, 0.1], ramp[3]], index: 3}
  ],
  ["a point behind all", () => opacities.addPoint(ramp, [12, 3]).points[4], [12, 1]],
  ["a point halfway", () => opacities.splitAfter(ramp, 0).points[1], [2, 0.25]],
  ["a point halfway before the last", () => opacities.splitAfter(ramp, 3).points[3], [7, 0.875]],
  ["a point beside the only one", () => opacities.splitAfter([[1, 1]], 0).points, [[1, 1], [1, 1]]],
  ["a point that is removed", () => opacities.removePoint(ramp, 1), [ramp[0], ramp[2], ramp[3]]],
  ["the last point, which stays", () => opacities.removePoint([[1, 1]], 0), [[1, 1]]],
  ["points over another range", () => opacities.spreadPoints(ramp, [0, 10], [-1, 4])[1], [1, 0.5]],
];
for (const [name, edit, expected] of edits)
{
  test(`Opacities: ${name}`, () => assert.deepEqual(edit(), expected));
}

test("Colours as written are spread and reversed as colour maps are", () => {
  const written = [[0, 1, 0, 0], [1, 0, 1, 0], [4, 0, 0, 1]];
  const choose = (reversed, range) => chosenColors(written, {map: "as written", reversed, range});
  assert.deepEqual(choose(false, [0, 4]), written);
  assert.deepEqual(choose(true, [10, 18]), [[10, 0, 0, 1], [16, 0, 1, 0], [18, 1, 0, 0]]);
});

test("The chart has all values of the data and of the functions", () => {
  const functions = {color: [[2, 0, 0, 0], [9, 1, 1, 1]], opacity: [[-3, 0], [5, 1]]};
  assert.deepEqual(chartRange([0, 7], functions), [-3, 9]);
  assert.deepEqual(chartRange([4, 4], {color: [[4, 0, 0, 0]], opacity: [[4, 0]]}), [3.5, 4.5]);
});

test("The ends of sampled colours are where the colours begin and end to change", () => {
  const [a, b, c] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const points = [[0, ...a], [1, ...a], [2, ...b], [3, ...a], [4, ...c], [5, ...c], [6, ...c]];
  assert.deepEqual(trimColors(points), points.slice(1, 5));
  assert.deepEqual(trimColors([[0, ...a], [1, ...a], [2, ...a]]), [[0, ...a], [2, ...a]]);
});

test("Sampled opacities become few points, and the same function within the tolerance", () => {
  const sampled = Array.from({length: 513}, (_, i) => [i / 512, (i / 512) ** 2]);
  const few = opacities.simplifyPoints(sampled, 1e-3);
  assert.ok(few.length <= 24, `${few.length} points`);
  sampled.forEach(([x, a]) => assert.ok(Math.abs(opacities.opacityAt(few, x) - a) <= 1e-3, `${x}`));
  assert.deepEqual(opacities.simplifyPoints(ramp, 1e-3), ramp);
  assert.deepEqual(opacities.simplifyPoints([[1, 1]], 1e-3), [[1, 1]]);
});

test("Blocks of a volume share their functions", () => {
  const volumes = [
    {name: "a", group: 0, range: [0, 2]}, {name: "a", group: 0, range: [1, 5]},
    {name: "b", group: 1, range: [7, 8]}
  ];
  assert.deepEqual(groupVolumes(volumes),
    [{name: "a", indices: [0, 1], range: [0, 5]}, {name: "b", indices: [2], range: [7, 8]}]);
});

test("The histogram counts the finite values of all blocks, and the ends in the last bins", () => {
  const parts = [{scalars: [0, 0.24, 0.5, 1, NaN], range: [0, 4]}, {scalars: [0.5], range: [4, 8]}];
  assert.deepEqual(countValues(parts, [0, 4], 4), [2, 0, 1, 2]);
  assert.deepEqual(countValues(parts, [0, 8], 4), [2, 1, 1, 1]);
  const place = {left: 0, right: 4, bottom: 10, height: 10};
  const path = histogramPath([0, Math.E - 1, 0, Math.E ** 2 - 1], place);
  assert.equal(path, "M0.00,10.00V10.00H1.00V5.00H2.00V10.00H3.00V0.00H4.00V10.00Z");
});
