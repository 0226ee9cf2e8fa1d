// SPDX-License-Identifier: MIT

import { alphaFromAlpha2 } from './alpha';
import type { PlotAxis } from './state';
import type { Snapshot } from './types';

// As `orthoball signatures --plot` does.
const kShare = 0.8; // of the top simplices
const kTimes = 15; // their stretch, at most

/**
 * What is worth seeing of an axis: from its begin to every change of the topology, but at most 15
 * times the stretch in which 4/5 of the triangles or tetrahedra enter.
 */
export function usefulRange(snapshot: Snapshot, axis: PlotAxis): [number, number] {
  const { spectrum, betti, simplices, facts } = snapshot;
  const s = spectrum.length;
  if (s === 0) return [0, 1];
  if (axis === 'index') return [1, Math.max(2, s)];
  const valueOf = (index: number) =>
    axis === 'alpha2' ? spectrum[index - 1] : alphaFromAlpha2(spectrum[index - 1]);
  let lastChange = 1;
  for (const numbers of betti) {
    for (let i = s - 1; i > lastChange; --i) {
      if (numbers[i] === numbers[i - 1]) continue;
      lastChange = i + 1;
      break;
    }
  }
  const from = valueOf(1);
  let to = valueOf(lastChange);
  const tops = simplices[Math.max(0, facts.affine_dimension)];
  if (tops.count > 0) {
    const entering = Uint32Array.from(tops.enters).sort();
    const low = valueOf(entering[Math.floor(((1 - kShare) / 2) * (tops.count - 1))]);
    const high = valueOf(entering[Math.floor(((1 + kShare) / 2) * (tops.count - 1))]);
    to = Math.max(Math.min(to, low + kTimes * (high - low)), high);
  }
  const end = Math.min(valueOf(s), to + 0.04 * (to - from));
  return end > from ? [from, end] : [from - 1, from + 1];
}

/** Where a value lies within a range, 0..1 across it; beyond it outside of that. */
export function placeWithin(
  [from, to]: readonly [number, number],
  isLog: boolean,
): (x: number) => number {
  const size = (to - from) / 1000;
  const scaled = !isLog
    ? (x: number) => x
    : from > 0
      ? (x: number) => Math.log(Math.max(x, from / 1e6))
      : (x: number) => Math.asinh(x / size); // nearly logarithmic on both sides of 0
  const [low, high] = [scaled(from), scaled(to)];
  return (x) => (high > low ? (scaled(x) - low) / (high - low) : 0.5);
}
