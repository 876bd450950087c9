// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of a page as textures of WebGL 2.

// 16-bit normalised integers are no format of WebGL: they become floats.
const FORMATS = {
  R8: ["R8", "RED", "UNSIGNED_BYTE", 1],
  RGBA8: ["RGBA8", "RGBA", "UNSIGNED_BYTE", 4],
  R16: ["R32F", "RED", "FLOAT", 1],
  R32F: ["R32F", "RED", "FLOAT", 1],
  RG32F: ["RG32F", "RG", "FLOAT", 2],
  RGBA16: ["RGBA32F", "RGBA", "FLOAT", 4],
  RGBA16F: ["RGBA16F", "RGBA", "HALF_FLOAT", 4],
  RGBA32F: ["RGBA32F", "RGBA", "FLOAT", 4],
  R8UI: ["R8UI", "RED_INTEGER", "UNSIGNED_BYTE", 1],
  R32UI: ["R32UI", "RED_INTEGER", "UNSIGNED_INT", 1],
  RG32UI: ["RG32UI", "RG_INTEGER", "UNSIGNED_INT", 2],
  RGBA32UI: ["RGBA32UI", "RGBA_INTEGER", "UNSIGNED_INT", 4]
};

const MOST_BYTES_OF_SQUARES = 1 << 27;

// The data of a texture has the type of its format.
function numbersFor(format, array)
{
  if (format !== "R16" && format !== "RGBA16")
  {
    return array;
  }
  const floats = new Float32Array(array.length);
  for (let i = 0; i < array.length; ++i)
  {
    floats[i] = array[i] / 65535;
  }
  return floats;
}

function newTexture(gl, target)
{
  const texture = gl.createTexture();
  gl.bindTexture(target, texture);
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(target, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  return texture;
}

function checkSize(most, sizes)
{
  const excess = sizes.findIndex((size, a) => size > most[a]);
  if (excess >= 0)
  {
    throw new Error(
      `This volume needs a texture of ${sizes.join(" x ")} texels, but this browser's ` +
      `graphics take at most ${
        most.slice(0, sizes.length).join(" x ")}. Open the page on another ` +
      "computer, or write a page of a coarser or smaller part of the data.");
  }
}

/** log2 of the number of texels in a row of a texture that replaces an array. */
export function rowShift(gl)
{
  return Math.floor(Math.log2(Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), 8192)));
}

/** An array of texels of a format, in rows. */
export function arrayTexture(gl, format, array)
{
  const [internal, layout, type, components] = FORMATS[format];
  const texels = array.length / components;
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  const width = 1 << rowShift(gl);
  const height = Math.max(1, Math.ceil(texels / width));
  checkSize([most, most], [width, height]);
  const numbers = numbersFor(format, array);
  const padded = new numbers.constructor(width * height * components);
  padded.set(numbers);
  const texture = newTexture(gl, gl.TEXTURE_2D);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl[internal], width, height, 0, gl[layout], gl[type], padded);
  return {target: gl.TEXTURE_2D, texture};
}

function layeredTexture(gl, format, size, numbers)
{
  const [internal, layout, type] = FORMATS[format];
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  checkSize([most, most, gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS)], size);
  const [width, height, layers] = size;
  const texture = newTexture(gl, gl.TEXTURE_2D_ARRAY);
  gl.texImage3D(
    gl.TEXTURE_2D_ARRAY, 0, gl[internal], width, height, layers, 0, gl[layout], gl[type], numbers);
  return {target: gl.TEXTURE_2D_ARRAY, texture};
}

/**
 * Whether the values of an image are packed by squares: four times the memory, a fourth of the
 * reads.
 */
export function packsSquares(gl, {width, height, layers, format})
{
  const bytes = 4 * (width + 1) * (height + 1) * layers * (format === "R8" ? 1 : 4);
  return bytes <= MOST_BYTES_OF_SQUARES &&
         Math.max(width, height) < gl.getParameter(gl.MAX_TEXTURE_SIZE);
}

/**
 * Each value with its next ones along x, y and both, in the order of textureGather(), from the
 * value before the first on; outside of the image there are the values at its sides.
 */
export function packSquares({width, height, layers}, values)
{
  const squares = new values.constructor(4 * (width + 1) * (height + 1) * layers);
  let at = 0;
  for (let k = 0; k < layers; ++k)
  {
    for (let j = 0; j <= height; ++j)
    {
      const south = (k * height + Math.max(j - 1, 0)) * width;
      const north = (k * height + Math.min(j, height - 1)) * width;
      for (let i = 0; i <= width; ++i)
      {
        const west = Math.max(i - 1, 0);
        const east = Math.min(i, width - 1);
        squares[at++] = values[north + west];
        squares[at++] = values[north + east];
        squares[at++] = values[south + east];
        squares[at++] = values[south + west];
      }
    }
  }
  return squares;
}

/** The texture of the squares of an image, for PACKED_SQUARES. */
export function squareTexture(gl, row, array)
{
  const size = [row.width + 1, row.height + 1, row.layers];
  const squares = packSquares(row, numbersFor(row.format, array));
  return layeredTexture(gl, row.format === "R8" ? "RGBA8" : "RGBA32F", size, squares);
}

/**
 * A texture of the page, or one with such a row { kind, format, width, height }, with its array.
 */
export function pageTexture(gl, row, array)
{
  if (row.kind === "buffer")
  {
    return arrayTexture(gl, row.format, array);
  }
  const [internal, layout, type] = FORMATS[row.format];
  const numbers = numbersFor(row.format, array);
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (row.kind === "2d")
  {
    checkSize([most, most], [row.width, row.height]);
    const texture = newTexture(gl, gl.TEXTURE_2D);
    gl.texImage2D(
      gl.TEXTURE_2D, 0, gl[internal], row.width, row.height, 0, gl[layout], gl[type], numbers);
    return {target: gl.TEXTURE_2D, texture};
  }
  return layeredTexture(gl, row.format, [row.width, row.height, row.layers], numbers);
}
