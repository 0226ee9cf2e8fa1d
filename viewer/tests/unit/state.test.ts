// SPDX-License-Identifier: MIT
import { beforeAll, describe, expect, it } from 'vitest';

import { startCamera } from '../../src/camera';
import { componentsAt, distancesAt, voidsAt } from '../../src/connections';
import { linkText, stateFromLink } from '../../src/link';
import { RoleCounts } from '../../src/role_counts';
import { ShapeModel } from '../../src/shape_model';
import {
  atAlpha2,
  atIndex,
  atNextNotable,
  spokenState,
  startState,
  stepped,
  withLayer,
} from '../../src/state';
import type { Snapshot } from '../../src/types';
import { orthoball, signatureRows, snapshotOf, sourceFile, spread } from '../program';

const kTori = sourceFile('examples/data/linked_tori.csv');
let tori: Snapshot;
let plane: Snapshot;
beforeAll(async () => {
  tori = await snapshotOf(kTori);
  plane = await snapshotOf(sourceFile('examples/data/figure_eight.csv'));
});

describe('the state', () => {
  it('begins where the two tori are two hollow surfaces', () => {
    const { index, start } = startState(tori);
    expect(tori.betti.map((betti) => betti[index - 1])).toEqual([2, 4, 2]);
    expect(start.reason).toContain('surface');
  });

  it('begins where the user wants', async () => {
    const chosen = startState(await snapshotOf(kTori, '--alpha2', '0.25'));
    expect(chosen.alpha2).toBe(0.25);
    const line = orthoball('signatures', kTori, '--alpha2', '0.25').toString().split('\n')[1];
    expect(chosen.index).toBe(Number(line.split(',')[0]));
  });

  it('goes to the index of an alpha2 as the command line does, closed', () => {
    const state = startState(tori);
    for (const index of spread(tori.spectrum.length, 20)) {
      const label = tori.spectrum[index - 1];
      const reached = atAlpha2(state, tori, label).index;
      expect(tori.spectrum[reached - 1]).toBe(label);
      expect(reached === tori.spectrum.length || tori.spectrum[reached] > label).toBe(true);
    }
    expect(atAlpha2(state, tori, -1).index).toBe(0);
    expect(atAlpha2(state, tori, NaN)).toBe(state);
  });

  it('is held within the spectrum', () => {
    const state = startState(tori);
    expect(atIndex(state, tori, 1e9).index).toBe(tori.spectrum.length);
    expect(stepped(atIndex(state, tori, 1), tori, -5).index).toBe(0);
    expect(stepped(state, tori, 1).index).toBe(state.index + 1);
  });

  it('finds the next notable alpha in both directions, and stays at the last', () => {
    let state = atIndex(startState(tori), tori, 0);
    const seen: number[] = [];
    for (;;) {
      const next = atNextNotable(state, tori, 1);
      if (next === state) break;
      seen.push(next.index);
      state = next;
    }
    const known = new Set(
      tori.facts.notable.map(({ index }) => index).concat(startState(tori).index),
    );
    expect(seen).toEqual([...known].sort((a, b) => a - b));
    expect(atNextNotable(state, tori, -1).index).toBe(seen.at(-2));
  });

  it('speaks alpha and the Betti numbers', () => {
    expect(spokenState(startState(tori), tori)).toMatch(
      /^alpha 0\.\d+, 2 components, 4 tunnels, 2 voids$/,
    );
    expect(spokenState(atIndex(startState(tori), tori, 0), tori)).toContain('Empty');
  });
});

describe('a link', () => {
  it('brings back what was shown', () => {
    const start = startState(tori);
    const camera = { ...startCamera(new ShapeModel(tori).points, 10, 3, false), distance: 2.5 };
    const shown = {
      ...withLayer(atIndex(start, tori, 1234), 'balls', true),
      colour: 'component' as const,
      clipAxis: 'view' as const,
      clipPlace: 0.25,
      panels: ['betti_2', 'area'],
      picked: { dimension: 2, simplex: 17 },
    };
    const read = stateFromLink(start, tori, linkText(shown, start, camera));
    expect({ ...read.state, layers: [...read.state.layers].sort() }).toEqual({
      ...shown,
      layers: [...shown.layers].sort(),
    });
    expect(read.camera!.distance).toBeCloseTo(2.5);
  });

  it('is empty for the first look', () => {
    expect(linkText(startState(tori), startState(tori), null)).toBe('');
  });

  it('passes over what makes no sense', () => {
    const start = startState(tori);
    const { state, camera } = stateFromLink(
      start,
      tori,
      '#index=x&colour=loud&opacity=7&camera=1+2&picked=9+9&show=regular+nothing',
    );
    expect(state).toEqual({ ...start, layers: ['regular'] });
    expect(camera).toBeNull();
  });
});

describe('connections', () => {
  it('count as many components and voids as the Betti numbers', () => {
    for (const snapshot of [tori, plane]) {
      const D = snapshot.facts.dimension;
      for (const index of spread(snapshot.spectrum.length, 25)) {
        expect(componentsAt(snapshot, index).count).toBe(snapshot.betti[0][index - 1]);
        expect(voidsAt(snapshot, index).count).toBe(snapshot.betti[D - 1][index - 1]);
      }
    }
  });

  it('reach a component and nothing else', () => {
    const { index } = startState(tori);
    const { of } = componentsAt(tori, index);
    const ways = distancesAt(tori, index, [0], new Float64Array(3 * of.length));
    ways.forEach((way, v) => expect(Number.isFinite(way)).toBe(of[v] === of[0]));
  });
});

describe('counts by role', () => {
  it('are those of the program, tetrahedra included', () => {
    const counter = new RoleCounts(tori);
    for (const row of signatureRows(kTori, [1, 5000, 2000, 9000])) {
      for (let k = 0; k <= 3; ++k) {
        const expected = Object.fromEntries(
          ['exterior', 'singular', 'regular', 'interior'].map((role) => [
            role,
            row[`${role}_${k}`],
          ]),
        );
        expect(counter.at(row.index!, k)).toEqual(expected);
      }
    }
  });
});
