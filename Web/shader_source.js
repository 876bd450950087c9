// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Complete shaders from the files of Shaders/: their #include lines are followed, once per file,
// and their conditions evaluated, by the rules of Shaders/README.md.

function parseCondition(text, symbols)
{
  const words = text.match(/[A-Za-z0-9_]+|&&|\|\||[!()]/g) || [];
  let at = 0;
  const parseValue = () => {
    const word = words[at++];
    if (word === "!")
    {
      return !parseValue();
    }
    if (word === "(")
    {
      const inside = parseOr();
      if (words[at++] !== ")")
      {
        throw new Error(`missing ) in the condition ${text}`);
      }
      return inside;
    }
    if (word === "0" || word === "1")
    {
      return word === "1";
    }
    if (!symbols.has(word))
    {
      throw new Error(`unknown symbol ${word} in the condition ${text}`);
    }
    return parseCondition(symbols.get(word), symbols);
  };
  const parseAnd = () => {
    let all = parseValue();
    while (words[at] === "&&")
    {
      ++at;
      all = parseValue() && all;
    }
    return all;
  };
  const parseOr = () => {
    let any = parseAnd();
    while (words[at] === "||")
    {
      ++at;
      any = parseAnd() || any;
    }
    return any;
  };
  const found = parseOr();
  if (at < words.length)
  {
    throw new Error(`unexpected ${words[at]} in the condition ${text}`);
  }
  return found;
}

class Conditions
{
  constructor(symbols)
  {
    this.symbols = symbols;
    this.levels = [];
  }

  get active() { return this.levels.length === 0 || this.levels[this.levels.length - 1].active; }

  define(line)
  {
    const [, name, value] = /^#define (\w+)(.*)/.exec(line);
    this.symbols.set(name, value);
  }

  // Whether the line is a condition, or defines a symbol of conditions.
  take(line)
  {
    const level = this.levels[this.levels.length - 1];
    if (line.startsWith("#define TETMARCH_"))
    {
      if (this.active)
      {
        this.define(line);
      }
    }
    else if (line.startsWith("#if "))
    {
      const outer = this.active;
      const active = outer && parseCondition(line.slice(4), this.symbols);
      this.levels.push({outer, active, done: active});
    }
    else if (line.startsWith("#elif "))
    {
      level.active = level.outer && !level.done && parseCondition(line.slice(6), this.symbols);
      level.done = level.done || level.active;
    }
    else if (line.startsWith("#else"))
    {
      level.active = level.outer && !level.done;
      level.done = true;
    }
    else if (line.startsWith("#endif"))
    {
      this.levels.pop();
    }
    else
    {
      return false;
    }
    return true;
  }
}

const PRECISION = ["float", "int", "sampler2D", "usampler2D", "sampler2DArray"]
                    .map((type) => `precision highp ${type};\n`)
                    .join("");

// The outputs of a fragment shader, which GLSL ES declares by name.
function withOutputs(text)
{
  const count = new Set(text.match(/gl_FragData\[\d\]/g)).size;
  let outputs = "";
  for (let i = 0; i < count; ++i)
  {
    outputs += `layout(location = ${i}) out highp vec4 fragOutput${i};\n`;
  }
  return text.replace("//VTK::Output::Dec", () => outputs)
    .replace(/gl_FragData\[(\d)\]/g, "fragOutput$1");
}

/**
 * The text of an entry point in GLSL ES 3.00. files: texts by name; features: names that are on,
 * all others of allFeatures are off; header: lines before the text.
 */
export function composeShader(files, entry, allFeatures, features, header = "")
{
  const symbols = new Map(allFeatures.map((name) => [`TETMARCH_${name}`, "0"]));
  for (const name of features)
  {
    symbols.set(`TETMARCH_${name}`, "1");
  }
  const conditions = new Conditions(symbols);
  for (const line of files["derived_conditions.glsl"].split("\n"))
  {
    if (line.startsWith("#define "))
    {
      conditions.define(line);
    }
  }
  const included = new Set();
  const lines = [];
  const append = (name) => {
    if (included.has(name))
    {
      return;
    }
    included.add(name);
    if (files[name] === undefined)
    {
      throw new Error(`the page has no shader file ${name}`);
    }
    for (const line of files[name].split("\n"))
    {
      if (conditions.take(line) || !conditions.active)
      {
        continue;
      }
      const include = /^#include "(.*)"/.exec(line);
      if (include)
      {
        append(include[1]);
      }
      else
      {
        lines.push(line);
      }
    }
  };
  append(entry);
  return withOutputs(`#version 300 es\n${PRECISION}${header}${lines.join("\n")}\n`);
}
