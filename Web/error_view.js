// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of error bounds, as those of VTKModule/Diagnostics/ViewColors.cxx.
import {pageTexture} from "./textures.js";

const ERROR_COLORS = [
  [0, 0.16, 0.13, 0.42], [0.25, 0.57, 0.2, 0.52], [0.5, 0.9, 0.37, 0.35], [0.75, 0.98, 0.69, 0.33],
  [1, 1, 0.97, 0.72]
];

/** A texture of one row. */
export function errorColorTexture(gl)
{
  const count = 256;
  const bytes = new Uint8Array(4 * count).fill(255);
  for (let i = 0; i < count; ++i)
  {
    const place = i / (count - 1) * (ERROR_COLORS.length - 1);
    const low = ERROR_COLORS[Math.min(Math.floor(place), ERROR_COLORS.length - 2)];
    const high = ERROR_COLORS[ERROR_COLORS.indexOf(low) + 1];
    const share = place - ERROR_COLORS.indexOf(low);
    for (let k = 0; k < 3; ++k)
    {
      bytes[4 * i + k] = Math.round(255 * (low[k + 1] + (high[k + 1] - low[k + 1]) * share));
    }
  }
  return pageTexture(gl, {kind: "2d", format: "RGBA8", width: count, height: 1}, bytes);
}

/** What a scalar bar shows of them. exponents: the least and the greatest decimal logarithm. */
export function errorLegend(exponents)
{
  const [low, high] = exponents;
  const range = [10 ** low, 10 ** high];
  const color = ERROR_COLORS.map(([share, ...rgb]) => [10 ** (low + share * (high - low)), ...rgb]);
  return {title: "Error bound", color, range, logarithmic: true};
}
