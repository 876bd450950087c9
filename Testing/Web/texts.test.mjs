// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the page writes: ticks, the camera as text, names of files; and how it frames the picture.
import assert from "node:assert/strict";
import test from "node:test";

import {Camera} from "../../Web/camera.js";
import {cameraCommand, cameraPython} from "../../Web/camera_text.js";
import {fileName} from "../../Web/controls.js";
import {heightFactor, widenCamera} from "../../Web/framing.js";
import {describePick, placeOf} from "../../Web/picked.js";
import {makeLogTicks, makeTicks} from "../../Web/ticks.js";

const camera = {
  position: [-1.5, 0.1 + 0.2, 2e-7],
  focalPoint: [0, 1, 2],
  viewUp: [0, 0, 1],
  viewAngle: 30,
  parallelProjection: false,
  parallelScale: 0.75,
};
const parallel = {
  ...camera,
  parallelProjection: true
};
const numbers = "-1.5,0.30000000000000004,2e-7,0,1,2,0,0,1,30";

const texts = [
  [
    "a command", cameraCommand(camera, [640, 480]),
    `tetmarch-render INPUT --camera=${numbers} --size 640x480`
  ],
  [
    "a parallel command", cameraCommand(parallel, [8, 6]),
    `tetmarch-render INPUT --camera=${numbers} --parallel-scale 0.75 --size 8x6`
  ],
  [
    "Python", cameraPython(parallel, [8, 6]),
    'camera = {"position": (-1.5, 0.30000000000000004, 2e-7), "focal_point": (0, 1, 2), ' +
      '"view_up": (0, 0, 1), "view_angle": 30, "parallel_scale": 0.75}\n' +
      "vtktetmarch.figure(data, size=(8, 6), camera=camera)"
  ],
  ["a file's name", fileName("../a b/<c>.vtu: Temp"), "a_b_c_.vtu_Temp"],
  ["a file's name of other scripts", fileName("温度 λ"), "温度_λ"],
  ["no name", fileName("../<>"), "tetmarch"],
  ["ticks", makeTicks(13, 1013, 5), [200, 400, 600, 800, 1000]],
  ["ticks at both ends", makeTicks(-0.2, 0.3, 6), [-0.2, -0.1, 0, 0.1, 0.2, 0.3]],
  ["ticks of large values", makeTicks(101325, 101327, 4), [101325, 101326, 101327]],
  ["one tick at most", makeTicks(1, 9, 1), [5]],
  ["no ticks of one value", makeTicks(3, 3, 5), []],
  ["ticks of powers", makeLogTicks(1e-6, 2e-3), [1e-6, 1e-5, 1e-4, 1e-3]],
];
for (const [name, found, expected] of texts)
{
  test(`Text: ${name}`, () => assert.deepEqual(found, expected));
}

test("A pick names the cell if there is one, and the volume if there are several", () => {
  const hit = {volume: 1, cell: 0, position: [1, 2, 1 / 3], value: 0.1 + 0.2};
  assert.deepEqual(describePick(hit, ["a", "b"]),
    [["Value", "0.3"], ["Cell", "0"], ["Position", "1, 2, 0.333333"], ["Volume", "b"]]);
  assert.deepEqual(
    describePick({...hit, cell: null}, ["a"]).map(([name]) => name), ["Value", "Position"]);
});

test("A narrow canvas shows the picture's full width", () => {
  assert.equal(heightFactor([800, 600], [1600, 600]), 1);
  const factor = heightFactor([800, 400], [400, 400]);
  assert.equal(factor, 2);
  const wide = {viewAngle: 60, parallelScale: 3};
  widenCamera(wide, factor);
  const halfAngle = wide.viewAngle * Math.PI / 360;
  assert.ok(Math.abs(Math.tan(halfAngle) - 2 * Math.tan(Math.PI / 6)) < 1e-12);
  assert.equal(wide.parallelScale, 6);
});

test("A picked point stays at its place on the picture, unless it is behind the camera", () => {
  const seen = new Camera({
    ...camera,
    position: [0, 0, 2],
    focalPoint: [0, 0, 0],
    viewUp: [0, 1, 0],
    viewAngle: 90,
    clippingRange: [1, 3]
  });
  const place = placeOf(seen, [1, 1, 0], [400, 200]);
  [250, 50].forEach((pixels, k) => assert.ok(Math.abs(place[k] - pixels) < 1e-9, `${place}`));
  assert.equal(placeOf(seen, [0, 0, 3], [400, 200]), null);
});
