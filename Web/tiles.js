// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture part by part, so that no draw keeps the browser or the GPU for long.

const MILLISECONDS_OF_TILE = 30;
const LEAST_PIXELS = 64;
const MOST_PIXELS = 1 << 24;
const BLOCK = 64; // pixels of an edge: software draws such squares, each by one thread

function nextTask()
{
  return new Promise((resolve) => setTimeout(resolve, 0));
}

// The end of a part of about this many pixels: that of a block, if there is one. A small rest
// belongs to it.
function endOfPart(begin, pixels, size)
{
  const end = begin + Math.max(4, Math.round(pixels));
  const aligned = end - end % BLOCK;
  const wanted = aligned > begin ? aligned : end;
  return size - wanted < (wanted - begin) / 4 ? size : wanted;
}

/** Resolves when the GPU has done what it was told so far. */
export async function gpuDone(gl)
{
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  while (sync && !gl.isContextLost())
  {
    await nextTask();
    const state = gl.clientWaitSync(sync, gl.SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED)
    {
      break;
    }
  }
  gl.deleteSync(sync);
}

export class Tiles
{
  constructor(gl)
  {
    this.gl = gl;
    this.pixels = 64 * 64; // of a tile, by the time that the last one took
    this.longest = 0;      // milliseconds of a tile of the last picture
  }

  // Parts of a picture, row by row; their size follows this.pixels.
  * parts([width, height])
  {
    for (let y = 0, top = 0; y < height; y = top)
    {
      const rows = Math.max(this.pixels / width, Math.min(Math.sqrt(this.pixels), BLOCK));
      top = endOfPart(y, rows, height);
      for (let x = 0, right = 0; x < width; x = right)
      {
        right = endOfPart(x, this.pixels / (top - y), width);
        yield [x, y, right - x, top - y];
      }
    }
  }

  note(part, milliseconds)
  {
    this.longest = Math.max(this.longest, milliseconds);
    const drawn = part[2] * part[3];
    const fitting = drawn * MILLISECONDS_OF_TILE / Math.max(milliseconds, 1);
    const next = Math.min(Math.max(fitting, this.pixels / 4), this.pixels * 4);
    this.pixels = Math.min(Math.max(next, LEAST_PIXELS), MOST_PIXELS);
  }

  /**
   * Calls draw(part) for all parts of a picture. isWanted(): whether to go on. Returns whether the
   * picture is complete. A part is prepared while the GPU draws the one before.
   */
  async draw(size, draw, isWanted)
  {
    this.longest = 0;
    let pending = null;
    let last = performance.now();
    for (const part of this.parts(size))
    {
      draw(part);
      const done = gpuDone(this.gl).then(() => {
        const now = performance.now();
        this.note(part, now - last);
        last = now;
      });
      await pending;
      pending = done;
      if (!isWanted())
      {
        break;
      }
    }
    await pending;
    return isWanted();
  }
}
