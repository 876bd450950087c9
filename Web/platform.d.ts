// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// For tsc: what browsers have and TypeScript 4.8 doesn't know, and node's modules, whose types
// aren't checked.

declare module "node:*";
declare var DecompressionStream: any;

interface Uint8ArrayConstructor
{
  fromBase64?(text: string): Uint8Array;
}
