// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { indicesBetween, stepCurve } from '../../src/step_curve';

const identity = (x: number) => x;

/** The rows of pixels that a curve touches in each of `columns` columns over [0, 1): [least, most]. */
function raster(x: number[], y: number[], columns: number): [number, number][] {
  const spans = Array.from({ length: columns }, (): [number, number] => [Infinity, -Infinity]);
  for (let i = 0; i < x.length; ++i) {
    const span = spans[Math.min(columns - 1, Math.floor(x[i] * columns))];
    span[0] = Math.min(span[0], y[i]);
    span[1] = Math.max(span[1], y[i]);
  }
  return spans;
}

describe('stepCurve', () => {
  it('gives few steps as they are', () => {
    const curve = stepCurve([0, 1, 2], [5, 7, 7], 0, 2, identity, 100);
    expect(curve).toEqual({ x: [0, 1, 1, 2, 2], y: [5, 5, 7, 7, 7] });
  });

  it('gives four values a column of a million steps, the least and the largest among them', () => {
    const count = 1_000_000;
    const x = Array.from({ length: count }, (_, i) => i / count);
    const y = x.map((at, i) => Math.sin(40 * at) + (i % 9973 === 0 ? 3 : 0));
    const curve = stepCurve(x, y, 0, count - 1, identity, 500);
    expect(curve.x.length).toBeLessThan(5 * 500 + 1);
    const [all, reduced] = [raster(x, y, 500), raster(curve.x, curve.y, 500)];
    // The step that reaches over from the column before is in the reduced curve too.
    for (let c = 0; c < 500; ++c) {
      expect(reduced[c][0]).toBeLessThanOrEqual(all[c][0]);
      expect(reduced[c][1]).toBeGreaterThanOrEqual(all[c][1]);
      expect(reduced[c][1] - all[c][1]).toBeLessThan(
        0.001 + (all[c][1] > 2 ? 0 : 3.1) * Number(reduced[c][1] > 2),
      );
    }
    expect(curve.x.every((at, i) => i === 0 || at >= curve.x[i - 1])).toBe(true);
  });

  it('knows no columns where all positions are equal', () => {
    const x = new Array<number>(1000).fill(2);
    const curve = stepCurve(
      x,
      x.map((_, i) => i),
      0,
      999,
      identity,
      10,
    );
    expect(Math.max(...curve.y)).toBe(999);
  });
});

describe('indicesBetween', () => {
  it('includes the step that reaches into the range', () => {
    const x = Float64Array.from([0, 1, 2, 3, 4, 5]);
    expect(indicesBetween(x, 2.5, 4)).toEqual([2, 4]);
    expect(indicesBetween(x, -1, 9)).toEqual([1, 5]);
  });
});
