// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a page: base64 text in elements, deflated, with the bytes of numbers put apart.

const NUMBERS = {
  uint8: Uint8Array,
  uint16: Uint16Array,
  uint32: Uint32Array,
  float32: Float32Array
};

const DAMAGED = "The file is damaged or was cut short. Copy it again, or write it again.";

/** The text of a data element of the page. */
export function textOfElement(id)
{
  const element = document.getElementById(id);
  if (!element)
  {
    throw new Error(DAMAGED);
  }
  return element.textContent;
}

/** The scene of the page. */
export function readScene()
{
  try
  {
    return JSON.parse(textOfElement("scene"));
  }
  catch (error)
  {
    throw new Error(DAMAGED);
  }
}

function bytesOfText(text)
{
  if (Uint8Array.fromBase64)
  {
    return Uint8Array.fromBase64(text);
  }
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i)
  {
    bytes[i] = binary.charCodeAt(i);
  }
  return bytes;
}

async function inflated(parts, size)
{
  const stream = new Blob(parts).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(size);
  const reader = stream.getReader();
  let filled = 0;
  for (;;)
  {
    const {done, value} = await reader.read();
    if (done)
    {
      break;
    }
    if (filled + value.length > size)
    {
      throw new Error(DAMAGED);
    }
    bytes.set(value, filled);
    filled += value.length;
  }
  if (filled !== size)
  {
    throw new Error(DAMAGED);
  }
  return bytes;
}

// The opposite of what the writer does: byte b of number i is planes[b * numbers + i].
function interleaved(planes, stride)
{
  const bytes = new Uint8Array(planes.length);
  const numbers = planes.length / stride;
  for (let b = 0; b < stride; ++b)
  {
    for (let i = 0, from = b * numbers, to = b; i < numbers; ++i, to += stride)
    {
      bytes[to] = planes[from + i];
    }
  }
  return bytes;
}

export class Archive
{
  /** textOf(id): the text of an element. */
  constructor(scene, textOf = textOfElement)
  {
    this.rows = scene.arrays;
    this.textOf = textOf;
    this.loaded = new Map();
  }

  /** Loads arrays by index. onProgress is called with the share that is done, 0..1. */
  async load(indices, onProgress)
  {
    const missing = [...new Set(indices)].filter((i) => !this.loaded.has(i));
    const bytesOf = (i) => this.rows[i].count * NUMBERS[this.rows[i].type].BYTES_PER_ELEMENT;
    const all = missing.reduce((sum, i) => sum + bytesOf(i), 0);
    let done = 0;
    for (const i of missing)
    {
      const row = this.rows[i];
      const planes = await this.inflatedRow(row, bytesOf(i));
      const bytes = row.filter > 1 ? interleaved(planes, row.filter) : planes;
      this.loaded.set(i, new NUMBERS[row.type](bytes.buffer));
      done += bytes.length;
      onProgress(all > 0 ? done / all : 1);
    }
  }

  async inflatedRow(row, size)
  {
    try
    {
      return await inflated(row.parts.map((id) => bytesOfText(this.textOf(id))), size);
    }
    catch (error)
    {
      throw error instanceof RangeError ? error : new Error(DAMAGED); // RangeError: no memory
    }
  }

  /** A typed array that was loaded. */
  array(index) { return this.loaded.get(index); }

  /** Forgets an array that is on the GPU. */
  forget(index) { this.loaded.delete(index); }
}
