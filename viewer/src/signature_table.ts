// SPDX-License-Identifier: MIT
//
// The signatures as CSV, with the columns of `orthoball signatures`.

import { alphaFromAlpha2 } from './alpha';
import { shortestText } from './mesh_files';
import type { Quantity } from './quantities';
import type { Snapshot } from './types';

const kRowsAPart = 10_000;

function columnsOf(
  snapshot: Snapshot,
  quantities: readonly Quantity[],
): [string, (index: number) => string][] {
  const { spectrum, facts } = snapshot;
  const number = (x: number) => (Number.isFinite(x) ? shortestText(x) : '');
  const of = (name: string): [string, (index: number) => string] => {
    const values = quantities.find((quantity) => quantity.name === name)?.values();
    return [name, (index) => (values ? number(values[index]) : '')];
  };
  const D = facts.dimension;
  const byDimension = Array.from({ length: D + 1 }, (_, k) => k);
  const roles = ['exterior', 'singular', 'regular', 'interior'];
  return [
    ['index', (index) => String(index)],
    ['alpha2', (index) => number(spectrum[index - 1])],
    ['alpha', (index) => number(alphaFromAlpha2(spectrum[index - 1]))],
    ...byDimension.slice(0, D).map((k) => of(`betti_${k}`)),
    of('euler'),
    ...roles.flatMap((role) =>
      byDimension.map((k): [string, (index: number) => string] => {
        const [name, text] = of(`${role}_${k}`);
        return [name, (index) => text(index) || '0']; // roles that a cell never has
      }),
    ),
    ...['volume', 'area_singular', 'area_regular', 'area', 'length'].map(of),
  ];
}

/** The table in parts, as a Blob takes it: one text of everything may be too long. */
export function signatureParts(snapshot: Snapshot, quantities: readonly Quantity[]): string[] {
  const columns = columnsOf(snapshot, quantities);
  const parts = [`${columns.map(([name]) => name).join(',')}\n`];
  for (let first = 1; first <= snapshot.spectrum.length; first += kRowsAPart) {
    const end = Math.min(snapshot.spectrum.length + 1, first + kRowsAPart);
    let text = '';
    for (let index = first; index < end; ++index) {
      text += `${columns.map(([, textOf]) => textOf(index)).join(',')}\n`;
    }
    parts.push(text);
  }
  return parts;
}
