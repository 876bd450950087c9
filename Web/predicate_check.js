// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether this browser's graphics compute on which side of a ray an edge lies as the march needs
// it: exactly, and a projected vertex with the same bits wherever it is projected. See
// VTKModule/Variants/PredicateCases.cxx; the cases here are fewer.
import {Target} from "./targets.js";
import {pageTexture} from "./textures.js";

const SIDE = 64; // the shader takes cases modulo 64 rows
const TEXELS = 6;
const CHECK = ["passes/full_view.vert.glsl", "passes/predicate_check.frag.glsl"];

// Numbers of a linear congruential generator (Numerical Recipes, 2007, "ranqd1").
function randomIntegers(seed)
{
  let state = seed;
  return (most) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor(state / 4294967296 * (2 * most + 1)) - most;
  };
}

// p and q: any points, a point and nearly its multiple, or neighbouring convergents of a slope.
function edgeOf(kind, random)
{
  if (kind === 0)
  {
    return [0, 1, 2, 3].map(() => random(8388607));
  }
  if (kind === 1)
  {
    const [x, y, factor] = [random(4095), random(4095), random(1023)];
    return [x, y, x * factor + random(1), y * factor + random(1)];
  }
  let [a, b, c, d] = [1, 0, 0, 1];
  while (Math.max(a, b) < 2097152)
  {
    const quotient = 2 + random(1);
    [a, b, c, d] = [a * quotient + c, b * quotient + d, a, b];
  }
  return [a, b, c, d];
}

function makeCases()
{
  const random = randomIntegers(17);
  const texels = new Float32Array(4 * TEXELS * SIDE * SIDE);
  for (let i = 0; i < SIDE * SIDE; ++i)
  {
    const at = 4 * TEXELS * i;
    texels.set(edgeOf(i % 3, random), at);
    for (let k = 4; k < 4 * TEXELS; ++k)
    {
      texels[at + k] = random(8388607) / 8388608;
    }
  }
  return texels;
}

// As turnsLeft() of tet/edge_sign.glsl, of vertices 1 and 2.
function turnsLeft([px, py, qx, qy], cross)
{
  const turn = cross !== 0 ? cross : px !== qx ? px - qx : qy - py;
  return turn >= 0;
}

function isRight(edge, answer, isSameEverywhere)
{
  const [px, py, qx, qy] = edge.map(BigInt);
  const cross = Number(px * qy - qx * py);
  const isValue = (found) =>
    Math.sign(found) === Math.sign(cross) && Math.abs(found - cross) <= 2 ** -22 * Math.abs(cross);
  const left = turnsLeft(edge, cross) ? 1 : 0;
  return isValue(answer[0]) && isValue(answer[1]) && answer[2] === left && answer[3] === 1 - left &&
         isSameEverywhere;
}

/** How many of 4096 cases are wrong. */
export async function countWrongCases(gl, programs)
{
  const program = await programs.get(...CHECK, ["POINT_SCALARS"]);
  const texels = makeCases();
  const row = {kind: "2d", format: "RGBA32F", width: TEXELS * SIDE, height: SIDE};
  const cases = pageTexture(gl, row, texels);
  const target = new Target(gl, ["RGBA32F", "RGBA32F"]);
  target.resize(SIDE, SIDE);
  target.bind();
  gl.disable(gl.BLEND);
  gl.disable(gl.DEPTH_TEST);
  program.use({turns: [3]}, {caseTexture: cases});
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const all = [0, 0, SIDE, SIDE];
  const edges = target.read(0, all);
  const points = target.read(1, all);
  target.release();
  gl.deleteTexture(cases.texture);
  let wrong = 0;
  for (let i = 0; i < SIDE * SIDE; ++i)
  {
    const edge = Array.from(texels.subarray(4 * TEXELS * i, 4 * TEXELS * i + 4));
    wrong += isRight(edge, edges.subarray(4 * i, 4 * i + 4), points[4 * i + 3] === 1) ? 0 : 1;
  }
  return wrong;
}

/** Throws an Error if rays would get lost among tetrahedra. */
export async function checkPredicate(gl, programs)
{
  const wrong = await countWrongCases(gl, programs);
  if (wrong > 0 && !gl.isContextLost())
  {
    throw new Error(
      `This browser's graphics round where they must not: ${wrong} of 4096 cases are ` +
      "wrong, so rays would get lost among the tetrahedra. Update the graphics " +
      "driver, or try another browser.");
  }
}
