// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { describe, expect, it } from 'vitest';

import { livesOf, type Life } from '../../src/persistence';
import { classesOf, representativeOf, tunnelsOf, voidsOf } from '../../src/representative';
import { rowsOf, type Snapshot } from '../../src/types';
import { inFolder, kSamples, orthoball, snapshotOf } from '../program';

/** An object of `orthoball persistence --representatives`. */
interface Written {
  dimension: number;
  index: number;
  rows: number[];
  rings?: number[][];
  triangles?: number[][];
  cells?: number[][];
  birth_simplex: number[];
  death_simplex: number[] | null;
}

function written(input: string, ...args: string[]): Promise<Written[]> {
  return inFolder((folder) => {
    const path = join(folder, 'classes.json');
    const pairs = join(folder, 'pairs.csv');
    orthoball('persistence', input, '-o', pairs, '--representatives', path, ...args);
    return JSON.parse(readFileSync(path, 'utf8'));
  });
}

function lifeOf(snapshot: Snapshot, one: Written): Life {
  const { dimension } = one;
  const begins = (life: Life) =>
    life.dimension === dimension &&
    String(rowsOf(snapshot, { dimension, simplex: life.begun })) === String(one.birth_simplex);
  return livesOf(snapshot).find(begins)!;
}

const named = (snapshot: Snapshot, dimension: number, simplices: number[]) =>
  simplices.map((simplex) => String(rowsOf(snapshot, { dimension, simplex }))).sort();
const sorted = (lists: number[][]) => lists.map(String).sort();

function sides(ring: number[]): number[][] {
  return ring.map((a, i) => [a, ring[(i + 1) % ring.length]].sort((x, y) => x - y));
}

describe('what makes a class', () => {
  it('is in space what `orthoball persistence --representatives` writes', async () => {
    const snapshot = await snapshotOf(kSamples.surface);
    const all = await written(kSamples.surface, '--minimum-length', '0.05');
    expect(all.map((one) => one.dimension)).toEqual([0, 0, 1, 1, 1, 1, 2, 2]);
    for (const one of all) {
      const life = lifeOf(snapshot, one);
      const [vertices, edges, triangles] = representativeOf(snapshot, life, one.index);
      if (one.dimension === 0) {
        expect(named(snapshot, 0, vertices)).toEqual(one.rows.map(String).sort());
      } else if (one.dimension === 1) {
        expect(named(snapshot, 1, edges)).toEqual(sorted(one.rings!.flatMap(sides)));
        expect(named(snapshot, 2, triangles)).toEqual([String(one.death_simplex)]);
      } else {
        expect(named(snapshot, 2, triangles)).toEqual(sorted(one.triangles!));
      }
      expect(representativeOf(snapshot, life, life.death)).toEqual([[], [], []]);
      // And back again, from any part of it.
      const dimension = [vertices, edges, triangles].findIndex((of) => of.length > 0);
      const simplex = [vertices, edges, triangles][dimension][0];
      expect(classesOf(snapshot, { dimension, simplex }, one.index)).toContain(life);
    }
  });

  it('is in the plane what encloses a hole, and its cells', async () => {
    const snapshot = await snapshotOf(kSamples.plane);
    expect(snapshot.cycles.pairs.length).toBe(0);
    const all = await written(kSamples.plane, '--minimum-length', '0.05');
    expect(all.filter((one) => one.dimension === 1).length).toBe(2);
    for (const one of all.filter((each) => each.dimension === 1)) {
      const life = lifeOf(snapshot, one);
      const [, edges, cells] = representativeOf(snapshot, life, one.index);
      expect(named(snapshot, 1, edges)).toEqual(sorted(one.rings!.flatMap(sides)));
      expect(named(snapshot, 2, cells)).toEqual(sorted(one.cells!));
      expect(voidsOf(snapshot, { dimension: 1, simplex: edges[0] }, one.index)).toEqual([life]);
      expect(voidsOf(snapshot, { dimension: 2, simplex: cells[0] }, one.index)).toEqual([life]);
      expect(tunnelsOf(snapshot, { dimension: 1, simplex: edges[0] }, one.index)).toEqual([]);
    }
  });
});
