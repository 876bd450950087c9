// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The page's lists of entries are those of C++: entry_lists.json is written by
// Testing/Unit/WebEntryListsTest.cxx. Squares of an image have the values of textureGather().
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import test from "node:test";

import {cornersOfFaces, makeEntryLists} from "../../Web/entry_lists.js";
import {packSquares} from "../../Web/textures.js";

const {vertices, faces, cases} =
  JSON.parse(readFileSync(new URL("entry_lists.json", import.meta.url), "utf8"));
const corners = cornersOfFaces(Float32Array.from(vertices), Uint32Array.from(faces));

for (const {name, input, expected} of cases)
{
  test(`entry lists: ${name}`, () => {
    const lists = makeEntryLists(corners, input.view, input.halfExtent, input.size);
    assert.equal(lists.tileShift, expected.tileShift);
    assert.equal(lists.tilesPerRow, expected.tilesPerRow);
    assert.deepEqual(
      Array.from(lists.depthPlane, Math.fround), Array.from(expected.depthPlane, Math.fround));
    assert.deepEqual([...lists.first], expected.first);
    assert.deepEqual([...lists.candidates], expected.candidates);
  });
}

test("a square has a value and the next ones, those at the sides beyond", () => {
  const size = {width: 2, height: 2, layers: 2};
  const squares = packSquares(size, Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8));
  const at =
    (i, j, k) => [...squares.subarray(4 * (i + 3 * (j + 3 * k)), 4 * (i + 3 * (j + 3 * k)) + 4)];
  assert.equal(squares.length, 4 * 3 * 3 * 2);
  assert.deepEqual(at(1, 1, 0), [3, 4, 2, 1]);
  assert.deepEqual(at(1, 1, 1), [7, 8, 6, 5]);
  assert.deepEqual(at(0, 0, 0), [1, 1, 1, 1]);
  assert.deepEqual(at(2, 1, 0), [4, 4, 2, 2]);
  assert.deepEqual(at(1, 2, 1), [7, 8, 8, 7]);
});
