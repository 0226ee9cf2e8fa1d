// SPDX-License-Identifier: MIT
//
// Which shape is shown first, unless somebody chose one. For points without weights in space, which
// mostly lie on a surface, `auto` of the program (the first solid shape) is often too late: what
// people come to see is the surface. There the two-sided area of the shape hardly changes while
// alpha grows, from where the points' gaps are closed to where the inside fills.

import { alphaFromAlpha2 } from './alpha';
import type { Snapshot } from './types';

const kTolerance = 0.06; // of the area
const kLeastShare = 1.3; // of the hull's area: a thin shell has about twice as much, both sides counted
const kLeastFactor = 1.6; // of alpha, for a stretch that means something

/** Index in the middle of the longest stretch, as a factor of alpha, in which the area stays. */
export function surfaceIndex(snapshot: Snapshot): number | null {
  const { spectrum, areaRegular, areaSingular, simplices } = snapshot;
  const s = spectrum.length;
  const area = (i: number) => areaRegular[i - 1] + 2 * areaSingular[i - 1];
  let first = 1;
  for (const index of simplices[0].enters) first = Math.max(first, index);
  while (first <= s && !(spectrum[first - 1] > 0 && area(first) > 0)) ++first;
  // Indices of the window by descending and ascending area.
  const [most, least]: [number[], number[]] = [[], []];
  let [mostAt, leastAt] = [0, 0];
  let best: { factor: number; begin: number; end: number } | null = null;
  for (let begin = first, end = first; end <= s; ++end) {
    while (most.length > mostAt && area(most[most.length - 1]) <= area(end)) most.pop();
    while (least.length > leastAt && area(least[least.length - 1]) >= area(end)) least.pop();
    most.push(end);
    least.push(end);
    while (area(most[mostAt]) > (1 + kTolerance) * area(least[leastAt])) {
      ++begin;
      if (most[mostAt] < begin) ++mostAt;
      if (least[leastAt] < begin) ++leastAt;
    }
    const factor = spectrum[Math.min(s - 1, end)] / spectrum[begin - 1];
    const isHull = area(begin) < kLeastShare * area(s);
    if (!isHull && begin < end && factor > (best?.factor ?? kLeastFactor ** 2))
      best = { factor, begin, end };
  }
  if (!best) return null;
  const middle = Math.sqrt(
    alphaFromAlpha2(spectrum[best.begin - 1]) * alphaFromAlpha2(spectrum[best.end - 1]),
  );
  let index = best.begin;
  while (index < best.end && spectrum[index] <= middle * middle) ++index;
  return index;
}

/** The index to begin with, with the reason in words. */
export function firstLook(snapshot: Snapshot): {
  index: number;
  alpha2: number;
  reason: string;
  isSurface: boolean;
} {
  const { start, dimension, weights } = snapshot.facts;
  const wasChosen = start.reason === '';
  const surface =
    !wasChosen && dimension === 3 && weights === 'none' ? surfaceIndex(snapshot) : null;
  if (surface !== null) {
    return {
      index: surface,
      alpha2: snapshot.spectrum[surface - 1],
      reason: 'the surface: around here its area stays the same for the longest while',
      isSurface: true,
    };
  }
  return {
    index: start.index,
    alpha2: start.alpha2 ?? -Infinity,
    reason: start.reason,
    isSurface: false,
  };
}
