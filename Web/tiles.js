// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture part by part, so that no draw keeps the browser or the GPU for long.

const MILLISECONDS_OF_TILE = 36;
const MILLISECONDS_OF_TIMERS = 3; // until a browser tells that a tile is done
// Tiles are as wide as the picture, and so are for all threads of a software renderer, each of
// which draws squares of 64 x 64 pixels.
const BAND = 8; // rows of pixels
// A band that was empty may take this share of the dearest one in the next picture.
const LEAST_SHARE = 1 / 3;

// How many, from the first one on, take no longer together than a tile may: none if that one does.
function fitting(first, end, costOf)
{
  let next = first;
  for (let sum = costOf(next); sum <= MILLISECONDS_OF_TILE; sum += costOf(next))
  {
    ++next;
    if (next === end)
    {
      break;
    }
  }
  return next - first;
}

function nextTask()
{
  return new Promise((resolve) => setTimeout(resolve, 0));
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
    this.longest = 0; // milliseconds of a tile of the last picture
    this.size = [0, 0];
    this.costs = null; // milliseconds of each band of the last picture, if it had this size
    this.least = 0;
    this.unknown = MILLISECONDS_OF_TILE; // of a band without a last picture
  }

  begin(size)
  {
    const [width, height] = size;
    if (this.size[0] !== width || this.size[1] !== height)
    {
      this.size = [width, height];
      this.bands = Math.ceil(height / BAND);
      this.costs = null;
    }
    this.longest = 0;
    this.next = new Float32Array(this.bands);
  }

  note(part, milliseconds)
  {
    const [, y, width, height] = part;
    this.longest = Math.max(this.longest, milliseconds);
    const ofPixel = Math.max(milliseconds - MILLISECONDS_OF_TIMERS, 0) / (width * height);
    const bands = Math.ceil(height / BAND);
    for (let band = y / BAND; band < y / BAND + bands; ++band)
    {
      this.next[band] += ofPixel * width * Math.min(BAND, height);
    }
    this.unknown = Math.max(ofPixel * this.size[0] * BAND, MILLISECONDS_OF_TILE / 4);
  }

  end()
  {
    this.costs = this.next;
    this.least = LEAST_SHARE * this.costs.reduce((most, cost) => Math.max(most, cost), 0);
  }

  costOf(band) { return this.costs ? Math.max(this.costs[band], this.least) : this.unknown; }

  // Parts of the picture: some bands, or a piece of one.
  * parts()
  {
    const [width, height] = this.size;
    for (let band = 0, bands = 0; band < this.bands; band += Math.max(bands, 1))
    {
      bands = fitting(band, this.bands, (b) => this.costOf(b));
      const y = band * BAND;
      const tall = Math.min(Math.max(bands, 1) * BAND, height - y);
      const pieces = bands > 0 ? 1 : Math.ceil(this.costOf(band) / MILLISECONDS_OF_TILE);
      const wide = Math.ceil(width / pieces);
      for (let x = 0; x < width; x += wide)
      {
        yield [x, y, Math.min(wide, width - x), tall];
      }
    }
  }

  /**
   * Calls draw(part) for all parts of a picture, then finish(). isWanted(): whether to go on.
   * Returns whether the picture is complete. A part is prepared while the GPU draws the one before.
   */
  async draw(size, draw, isWanted, finish = () => {})
  {
    this.begin(size);
    let pending = null;
    let last = performance.now();
    for (const part of this.parts())
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
    if (isWanted())
    {
      finish();
    }
    await pending;
    const complete = isWanted();
    if (complete)
    {
      this.end();
    }
    return complete;
  }
}
