// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The modules of Web/ can be put together as one script, as Web/bundle.cmake does.
import assert from "node:assert/strict";
import {readdirSync, readFileSync} from "node:fs";
import test from "node:test";

const folder = new URL("../../Web/", import.meta.url);
const read = (name) => readFileSync(new URL(name, folder), "utf8");
const listed = read("modules.txt").split("\n").filter((line) => /^[a-z]/.test(line));

test("modules.txt lists each module once", () => {
  const files = readdirSync(folder).filter((name) => name.endsWith(".js"));
  assert.deepEqual([...listed].sort(), files.sort());
});

test("No two modules declare the same name", () => {
  const owners = new Map();
  for (const name of listed)
  {
    const declared = read(name).matchAll(
      /^(?:export )?(?:async )?(?:function\*?|class|const|let) (?:(\w+)|[[{]([^\]}=]*))/gm);
    for (const [, one, several] of declared)
    {
      for (const each of one ? [one] : several.match(/\w+/g))
      {
        assert.ok(!owners.has(each), `${each} is in ${name} and in ${owners.get(each)}`);
        owners.set(each, name);
      }
    }
  }
});

test("An import has a line of its own, and renames nothing", () => {
  for (const name of listed)
  {
    const lines = read(name).match(/^(import|export) ?[{*"'].*|^.*\bimport\(.*/gm) || [];
    for (const line of lines)
    {
      assert.match(line, /^import \{[\w ,]+\} from "\.\/\w+\.js";$/, name);
      assert.doesNotMatch(line, / as /, name);
      assert.ok(listed.includes(/\/(\w+\.js)/.exec(line)[1]), `${name}: ${line}`);
    }
  }
});
