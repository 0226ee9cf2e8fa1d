// SPDX-License-Identifier: MIT
//
// The lives of components, tunnels and voids: from the index at which each begins to the one at which
// it ends.

import { countAtMost } from './alpha';
import type { Picked } from './state';
import { kNone, type Snapshot } from './types';

/** One class of cycles. */
export interface Life {
  dimension: number;
  /** First index. */
  birth: number;
  /** First index at which it is gone; spectrumSize + 1 for never. */
  death: number;
  /** The simplex of its dimension that begins it. */
  begun: number;
  /** The simplex of the next dimension that ends it; kNone for never. */
  ended: number;
}

const kLivesOf = new WeakMap<Snapshot, Life[]>();

/** All of them, always the same objects. */
export function livesOf(snapshot: Snapshot): Life[] {
  const known = kLivesOf.get(snapshot);
  if (known) return known;
  const lives = madeLives(snapshot);
  kLivesOf.set(snapshot, lives);
  return lives;
}

function madeLives(snapshot: Snapshot): Life[] {
  const never = snapshot.spectrum.length + 1;
  return snapshot.persistence.flatMap((pairs, dimension) => {
    const [enters, ends] = [dimension, dimension + 1].map((k) => snapshot.simplices[k].enters);
    return Array.from({ length: pairs.length / 2 }, (_, i) => {
      const [begun, ended] = [pairs[2 * i], pairs[2 * i + 1]];
      return {
        dimension,
        birth: enters[begun],
        death: ended === kNone ? never : ends[ended],
        begun,
        ended,
      };
    });
  });
}

/** The class that a simplex begins; null for none. */
export function lifeBegunBy(snapshot: Snapshot, begin: Picked | null): Life | null {
  const is = (life: Life) =>
    life.dimension === begin?.dimension && life.begun === begin.simplex;
  return begin ? (livesOf(snapshot).find(is) ?? null) : null;
}

/** The simplex that begins a class. */
export function beginOf({ dimension, begun }: Life): Picked {
  return { dimension, simplex: begun };
}

export function isAlive({ birth, death }: Life, index: number): boolean {
  return birth <= index && index < death;
}

/** The index in the middle of a life, as it lies along an axis: [index] ascending values. */
export function middleOf({ birth, death }: Life, x: Float64Array): number {
  const last = x.length - 1;
  const middle = (x[birth] + x[Math.min(death, last)]) / 2;
  const index = countAtMost(x.subarray(1), middle);
  return Math.min(Math.max(birth, index), Math.min(death - 1, last));
}

/** The longest lives of a dimension along an axis, longest first; those that never end before all. */
export function longestLives(
  lives: readonly Life[],
  x: Float64Array,
  dimension: number,
  count: number,
): Life[] {
  const length = ({ birth, death }: Life) => (death < x.length ? x[death] - x[birth] : Infinity);
  const isBefore = (a: Life, b: Life) =>
    length(a) > length(b) || (length(a) === length(b) && a.birth < b.birth);
  const longest: Life[] = []; // few, of many
  for (const life of lives) {
    if (life.dimension !== dimension) continue;
    let at = longest.length;
    while (at > 0 && isBefore(life, longest[at - 1])) --at;
    if (at >= count) continue;
    longest.splice(at, 0, life);
    longest.length = Math.min(longest.length, count);
  }
  return longest;
}
