// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The colour maps of tetmarch-render and vtktetmarch (Tools/Common/ColorMaps.json): six hexadecimal
// digits per point, between which colours are linear. `at`: places of the points in 1/1024; without
// them the points are evenly spaced.

// clang-format off
const COLOR_MAP_POINTS = {
  "Viridis": {
    colors:
      "440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e" +
      "26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83e" +
      "addc30c2df23d8e219ece51bfde725",
  },
  "Plasma": {
    colors:
      "0d08872206903105973f049c4c02a15901a56600a77201a87e03a88a09a59511a1a01a9caa2395b32c8e" +
      "bc3587c43e7fcc4778d35171da5a6ae06363e66c5ceb7655f0804ef58b47f89540fba139fdac33feb82c" +
      "fdc527fcd225f8df25f4ed27f0f921",
  },
  "Inferno": {
    colors:
      "0000040403120b0724150b37210c4a2f0a5b3d09654a0c6b57106e64156e71196e7d1e6d8a226a972766" +
      "a32c61b0315bbc3754c73e4cd24644db503be45a31eb6628f1731df68013f98e09fb9d07fcac11fbbc21" +
      "f9cb35f5db4cf2ea69f3f68afcffa4",
  },
  "Magma": {
    colors:
      "0000040303120a0822130d341d114729115a36106b440f7651127c5d177f6a1c81762181832681902a81" +
      "9c2e7faa337db73779c43c75d0416fdc4869e75263ef5d5ef56b5cf9795dfc8961fd9869fea772feb67c" +
      "fec488fed395fde2a3fcf0b2fcfdbf",
  },
  "Cividis": {
    colors:
      "00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a71" +
      "6f70737676767d7c788482798c8878938e789b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25e" +
      "dec958e7d150f0d846f9e03afee838",
  },
  "Cool to Warm": {
    at: [0, 69, 134, 197, 259, 321, 383, 446, 512, 573,
      635, 697, 759, 805, 852, 900, 949, 978, 1000, 1014, 1019, 1024],
    colors:
      "3b4cc04f6ad96484eb799cf88eb1fea3c2feb8cff9cbd8eeddddddebd4c7f4c6aff7b397f59d7ef08b6d" +
      "e8765cdd5f4bcf443bc53233bd222cb81429b60d27b40426",
  },
  "Black-Body Radiation": {
    at: [0, 409.6, 819.2, 1024],
    colors:
      "000000e60000e6e600ffffff",
  },
  "X Ray": {
    colors:
      "ffffff000000",
  },
};
// clang-format on

export const COLOR_MAP_NAMES = Object.keys(COLOR_MAP_POINTS);

/** The points [x, r, g, b] of a colour map, spread from low to high. */
export function colorMapPoints(name, low, high, reversed = false)
{
  const {at, colors} = COLOR_MAP_POINTS[name];
  const all = colors.match(/../g).map((digits) => parseInt(digits, 16) / 255);
  const last = all.length / 3 - 1;
  const points = [];
  for (let i = 0; i <= last; ++i)
  {
    const place = at ? at[i] / 1024 : i / last;
    points.push([reversed ? 1 - place : place, ...all.slice(3 * i, 3 * i + 3)]);
  }
  if (reversed)
  {
    points.reverse();
  }
  return points.map(([place, ...rgb]) => [low + place * (high - low), ...rgb]);
}

/** The colour [r, g, b] of a function at x, linear between its points and constant outside. */
export function colorAt(points, x)
{
  const next = points.findIndex((point) => point[0] > x);
  if (next <= 0)
  {
    return points[next === 0 ? 0 : points.length - 1].slice(1);
  }
  const [below, above] = [points[next - 1], points[next]];
  const share = (x - below[0]) / (above[0] - below[0]);
  return [1, 2, 3].map((k) => below[k] + share * (above[k] - below[k]));
}

export function cssColor(rgb)
{
  return `rgb(${rgb.map((part) => Math.round(255 * part)).join(",")})`;
}
