// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// 4x4 matrices as arrays of 16 numbers, row by row, and points.

export function identity()
{
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

export function multiply(a, b)
{
  const product = new Array(16).fill(0);
  for (let r = 0; r < 4; ++r)
  {
    for (let c = 0; c < 4; ++c)
    {
      for (let k = 0; k < 4; ++k)
      {
        product[4 * r + c] += a[4 * r + k] * b[4 * k + c];
      }
    }
  }
  return product;
}

export function transpose(a)
{
  return a.map((_, i) => a[4 * (i % 4) + Math.floor(i / 4)]);
}

/** m (x, y, z, w); w is 1 if p has three numbers. */
export function transformPoint(m, p)
{
  const q = [p[0], p[1], p[2], p.length > 3 ? p[3] : 1];
  return [0, 1, 2, 3].map(
    (r) => m[4 * r] * q[0] + m[4 * r + 1] * q[1] + m[4 * r + 2] * q[2] + m[4 * r + 3] * q[3]);
}

/** The inverse by elimination with the greatest pivot; null if there is none. */
export function invert(m)
{
  const rows =
    [0, 1, 2, 3].map((r) => [...m.slice(4 * r, 4 * r + 4), ...identity().slice(4 * r, 4 * r + 4)]);
  for (let c = 0; c < 4; ++c)
  {
    let best = c;
    for (let r = c + 1; r < 4; ++r)
    {
      best = Math.abs(rows[r][c]) > Math.abs(rows[best][c]) ? r : best;
    }
    const pivot = rows[best][c];
    if (!(Math.abs(pivot) > 0) || !Number.isFinite(pivot))
    {
      return null;
    }
    [rows[c], rows[best]] = [rows[best], rows[c]];
    rows[c] = rows[c].map((x) => x / pivot);
    for (let r = 0; r < 4; ++r)
    {
      const factor = rows[r][c];
      if (r !== c && factor !== 0)
      {
        rows[r] = rows[r].map((x, k) => x - factor * rows[c][k]);
      }
    }
  }
  return rows.flatMap((row) => row.slice(4));
}

/** The determinant of the upper left 3x3 matrix. */
export function determinant3(m)
{
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
         m[2] * (m[4] * m[9] - m[5] * m[8]);
}
