// SPDX-License-Identifier: MIT
//
// A signature is a step function: value v[i] from position x[i] on. With more steps than pixels it
// is drawn from four values of every column of pixels, the first, the least, the largest and the
// last, joined by lines: the same pixels as of all steps (the M4 aggregation of Jugel, Jerzak,
// Hackenbroich, Markl 2014).

import { countAtMost } from './alpha';

/** Points of a curve, positions never decreasing. */
export interface Curve {
  x: number[];
  y: number[];
}

/**
 * The steps of indices `first`..`last` as points to be joined by lines.
 * @param x        [index]: ascending; only `first`..`last` are read.
 * @param place    a position as it lies along the axis: the identity, or a logarithm.
 * @param columns  of pixels.
 */
export function stepCurve(
  x: ArrayLike<number>,
  y: ArrayLike<number>,
  first: number,
  last: number,
  place: (x: number) => number,
  columns: number,
): Curve {
  const curve: Curve = { x: [], y: [] };
  const add = (px: number, py: number) => {
    curve.x.push(px);
    curve.y.push(py);
  };
  if (last < first) return curve;
  if (last - first < 2 * columns) {
    for (let i = first; i <= last; ++i) {
      if (i > first) add(x[i], y[i - 1]);
      add(x[i], y[i]);
    }
    return curve;
  }
  const begin = place(x[first]);
  const width = (place(x[last]) - begin) / columns;
  const columnOf = (i: number) =>
    width > 0 ? Math.min(columns - 1, Math.floor((place(x[i]) - begin) / width)) : 0;
  for (let i = first; i <= last;) {
    const column = columnOf(i);
    let [least, largest] = [i, i];
    const start = i;
    for (; i <= last; ++i) {
      if (columnOf(i) !== column) break;
      if (y[i] < y[least]) least = i;
      if (y[i] > y[largest]) largest = i;
    }
    const end = i - 1;
    if (start > first) add(x[start], y[start - 1]); // the step before ends here
    let before = -1;
    for (const at of [start, least, largest, end].sort((a, b) => a - b)) {
      if (at !== before) add(x[at], y[at]);
      before = at;
    }
  }
  return curve;
}

/** The indices whose steps are seen between two positions, of [1..x.length - 1]. */
export function indicesBetween(x: Float64Array, from: number, to: number): [number, number] {
  const all = x.subarray(1);
  return [Math.max(1, countAtMost(all, from)), countAtMost(all, to)];
}
