// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tiles of a picture cover each pixel once, and after a first picture none takes long.
import assert from "node:assert/strict";
import test from "node:test";

import {Tiles} from "../../Web/tiles.js";

const MOST = 50; // milliseconds
const TIMERS = 3;

// Simulates a picture; costOf(row) is the time in milliseconds that a pixel of the row takes.
// Returns the tiles with their times.
function drawn(tiles, size, costOf)
{
  const [width, height] = size;
  const times = new Uint8Array(width * height);
  const parts = [];
  tiles.begin(size);
  for (const part of tiles.parts())
  {
    const [x, y, wide, tall] = part;
    let milliseconds = TIMERS;
    for (let row = y; row < y + tall; ++row)
    {
      milliseconds += wide * costOf(row);
      for (let column = x; column < x + wide; ++column)
      {
        ++times[row * width + column];
      }
    }
    tiles.note(part, milliseconds);
    parts.push({part, milliseconds});
  }
  tiles.end();
  assert.ok(times.every((n) => n === 1), "each pixel once");
  return parts;
}

const CASES = [
  {name: "a quick GPU", size: [900, 600], costOf: () => 1e-6, most: 3},
  {name: "an empty part, then a dear one", size: [701, 403], costOf: (y) => y > 200 ? 2e-3 : 0},
  {name: "slower than a band a tile", size: [333, 67], costOf: () => 4e-2},
  {name: "one pixel", size: [1, 1], costOf: () => 1, most: 1},
];

for (const {name, size, costOf, most = Infinity} of CASES)
{
  test(`Tiles: ${name}`, () => {
    const tiles = new Tiles(null);
    drawn(tiles, size, costOf);
    const parts = drawn(tiles, size, costOf);
    assert.ok(parts.length <= most, `${parts.length} tiles`);
    const longest = Math.max(...parts.map(({milliseconds}) => milliseconds));
    assert.ok(longest <= MOST, `${longest} ms`);
    assert.equal(tiles.longest, longest);
  });
}
