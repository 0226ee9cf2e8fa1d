// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { isAlive, livesOf, longestLives, middleOf } from '../../src/persistence';
import { placeWithin } from '../../src/plot_range';
import { axisValues } from '../../src/state';
import { kNone } from '../../src/types';
import { kSamples, orthoball, snapshotOf, spread } from '../program';

describe.each(Object.entries(kSamples))('the lives of a %s', (_, input) => {
  it('are those of `orthoball persistence`', async () => {
    const snapshot = await snapshotOf(input);
    const never = snapshot.spectrum.length + 1;
    const own = livesOf(snapshot).map(({ dimension, birth, death }) =>
      [dimension, birth, death === never ? '' : death].join(),
    );
    const lines = orthoball('persistence', input, '--indices').toString().trim().split('\n');
    expect(own.sort()).toEqual(
      lines
        .slice(1)
        .map((line) => line.split(',').slice(0, 3).join())
        .sort(),
    );
  });

  it('add up to the Betti numbers at every index', async () => {
    const snapshot = await snapshotOf(input);
    const lives = livesOf(snapshot);
    for (const index of spread(snapshot.spectrum.length, 40)) {
      const alive = lives.filter((life) => isAlive(life, index));
      snapshot.betti.forEach((betti, k) =>
        expect(alive.filter(({ dimension }) => dimension === k).length).toBe(betti[index - 1]),
      );
    }
  });

  it('begin with the simplex that enters at their birth', async () => {
    const snapshot = await snapshotOf(input);
    for (const { dimension, birth, begun } of livesOf(snapshot)) {
      expect(snapshot.simplices[dimension].enters[begun]).toBe(birth);
    }
    expect(snapshot.persistence[0].filter((simplex) => simplex === kNone).length).toBe(1);
  });
});

describe('the longest lives', () => {
  it('of two linked tori are two components, four tunnels and two voids', async () => {
    const snapshot = await snapshotOf(kSamples.surface);
    const x = axisValues(snapshot, 'alpha');
    const length = ({ birth, death }: { birth: number; death: number }) =>
      death < x.length ? x[death] - x[birth] : Infinity;
    for (const [dimension, count] of [2, 4, 2].entries()) {
      const lives = longestLives(livesOf(snapshot), x, dimension, count + 1);
      expect(length(lives[count - 1])).toBeGreaterThan(3 * length(lives[count]));
      for (const life of lives) {
        const middle = middleOf(life, x);
        expect(isAlive(life, middle)).toBe(true);
        if (length(life) > 0.1 && life.death < x.length) {
          expect(x[middle]).toBeLessThanOrEqual((x[life.birth] + x[life.death]) / 2);
          expect(x[middle + 1]).toBeGreaterThan((x[life.birth] + x[life.death]) / 2);
        }
      }
    }
  });
});

describe('a place within a range', () => {
  it.each([
    [[2, 200], false, 101, 0.5],
    [[2, 200], true, 20, 0.5],
    [[-3, 3], true, 0, 0.5],
    [[0, 7], false, 14, 2],
  ] as const)('%s, logarithmic %s: %s', (range, isLog, value, share) => {
    const place = placeWithin(range, isLog);
    expect(place(value)).toBeCloseTo(share, 12);
    expect(place(range[0])).toBe(0);
    expect(place(range[1])).toBe(1);
  });
});
