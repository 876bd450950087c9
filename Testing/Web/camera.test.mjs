// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The page's camera against VTK's: camera_table.json is made by make_camera_table.py.
import assert from "node:assert";
import {readFileSync} from "node:fs";
import test from "node:test";

import {Camera} from "../../Web/camera.js";
import {drag, wheelFactor} from "../../Web/pointer.js";

const table = JSON.parse(readFileSync(new URL("camera_table.json", import.meta.url)));
const RELATIVE_ERROR = 1e-9;

function expectNear(found, expected, name)
{
  const a = [found].flat().map(Number);
  const b = [expected].flat().map(Number);
  const scale = Math.max(1e-9, ...b.map(Math.abs));
  assert.equal(a.length, b.length, name);
  a.forEach((x, i) => assert.ok(
              Math.abs(x - b[i]) <= RELATIVE_ERROR * scale, `${name}: ${a} instead of ${b}`));
}

function move(camera, bounds, [name, ...values])
{
  const aspect = table.size[0] / table.size[1];
  const moves = {
    drag: () => drag(camera, ...values, table.size),
    wheel: () => camera.approach(wheelFactor({deltaY: -100 * values[0], deltaMode: 0})),
    reset: () => camera.reset(bounds, aspect),
    resetClippingRange: () => camera.resetClippingRange(bounds),
  };
  (moves[name] || (() => camera[name](...values)))();
}

for (const row of table.rows)
{
  const words = [row.view.parallelProjection ? "parallel" : "perspective", ...row.move.flat()];
  test(`camera as VTK's: ${words.join(" ")}`, () => {
    const camera = new Camera(row.view);
    if (row.move.length > 0)
    {
      move(camera, row.bounds, row.move);
    }
    if (["drag", "wheel"].includes(row.move[0]))
    {
      camera.resetClippingRange(row.bounds);
    }
    for (const [name, value] of Object.entries(row.after))
    {
      expectNear(camera[name], value, name);
    }
    expectNear(camera.viewMatrix(), row.viewMatrix, "viewMatrix");
    expectNear(
      camera.projectionMatrix(table.size[0] / table.size[1]), row.projectionMatrix, "projection");
  });
}
