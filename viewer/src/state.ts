// SPDX-License-Identifier: MIT
//
// What is shown: one plain object, and functions that give the next one.

import { alpha2At, alpha2FromAlpha, alphaFromAlpha2, countAtMost } from './alpha';
import { firstLook } from './first_look';
import type { Snapshot } from './types';

export const kLayers = [
  'regular',
  'singular_triangles',
  'singular_edges',
  'singular_vertices',
  'interior',
  'balls',
  'power_cells',
  'points',
  'wireframe',
  'trace',
  'sticks',
  'outlines',
] as const;
export type Layer = (typeof kLayers)[number];

export const kColours = [
  'role',
  'component',
  'dimension',
  'element',
  'residue',
  'chain',
  'void',
] as const;
export type Colour = (typeof kColours)[number];

export const kExplodedParts = [
  'components',
  'vertices',
  'edges',
  'triangles',
  'tetrahedra',
] as const;
export type ExplodedPart = (typeof kExplodedParts)[number];

export type ClipAxis = 'off' | 'x' | 'y' | 'z' | 'view';
export type PlotAxis = 'alpha' | 'alpha2' | 'index';
export type Theme = 'system' | 'light' | 'dark';

/** A simplex that was chosen. */
export interface Picked {
  dimension: number;
  simplex: number;
}

export interface State {
  index: number;
  /** What the balls grow by: the label of the index, or a number between it and the next. */
  alpha2: number;
  /** Where the page began, and why there. */
  start: { index: number; reason: string };
  layers: readonly Layer[];
  colour: Colour;
  /** Of the surface, 0..1. */
  opacity: number;
  projection: 'perspective' | 'orthographic';
  clipAxis: ClipAxis;
  /** -1..1 across the box. */
  clipPlace: number;
  explodedPart: ExplodedPart;
  /** 0: not at all. */
  explosion: number;
  theme: Theme;
  background: 'plain' | 'white' | 'black';
  plotAxis: PlotAxis;
  plotScale: 'linear' | 'log';
  /** Upwards. */
  valueScale: 'linear' | 'log';
  /** Whether the persistence diagram is shown. */
  diagram: boolean;
  /** Names of quantities. */
  panels: readonly string[];
  picked: Picked | null;
  /** The simplex that begins the class of cycles that is shown. */
  shownClass: Picked | null;
  /** Share of the way that the wave's front has run from the picked simplex; null without. */
  wave: number | null;
}

function moleculeColour({ labels }: Snapshot): Colour {
  if ((labels.chain?.words.length ?? 0) > 1) return 'chain';
  return labels.element ? 'element' : 'role';
}

export function startState(snapshot: Snapshot): State {
  const { facts } = snapshot;
  const inSpace = facts.dimension === 3;
  // Of a large molecule its balls are what people know; the shape inside is a thicket at first.
  const isLargeMolecule = inSpace && facts.weights === 'molecule_radii' && facts.vertices > 1500;
  const layers: Layer[] = isLargeMolecule
    ? ['balls']
    : ['regular', 'singular_triangles', 'singular_edges', 'singular_vertices'];
  if (!inSpace) layers.push('interior', 'points');
  if (inSpace && facts.triangles < 60_000 && !isLargeMolecule) layers.push('outlines');
  const { index, alpha2, reason, isSurface } = firstLook(snapshot);
  return {
    index,
    alpha2,
    start: { index, reason },
    layers,
    // Of a thin shell some triangles bound flat tetrahedra and some none: that says little at first.
    colour: isLargeMolecule
      ? moleculeColour(snapshot)
      : isSurface && facts.edges < 1e6
        ? 'component'
        : 'role',
    opacity: 1,
    projection: inSpace ? 'perspective' : 'orthographic',
    clipAxis: 'off',
    clipPlace: 0,
    explodedPart: 'components',
    explosion: 0,
    theme: 'system',
    background: 'plain',
    plotAxis: 'alpha',
    plotScale: 'linear',
    valueScale: 'linear',
    diagram: true,
    panels: inSpace ? ['betti_1', 'betti_2', 'volume'] : ['betti_0', 'betti_1', 'volume'],
    picked: null,
    shownClass: null,
    wave: null,
  };
}

/** At an index of the spectrum, held within 0..s. */
export function atIndex(state: State, snapshot: Snapshot, index: number): State {
  const held = Math.min(snapshot.spectrum.length, Math.max(0, Math.round(index)));
  return { ...state, index: held, alpha2: alpha2At(snapshot.spectrum, held), wave: null };
}

/** At an alpha2, also between two entries of the spectrum. */
export function atAlpha2(state: State, snapshot: Snapshot, alpha2: number): State {
  if (Number.isNaN(alpha2)) return state;
  return { ...state, index: countAtMost(snapshot.spectrum, alpha2), alpha2, wave: null };
}

export function atAlpha(state: State, snapshot: Snapshot, alpha: number): State {
  return atAlpha2(state, snapshot, alpha2FromAlpha(alpha));
}

export function stepped(state: State, snapshot: Snapshot, steps: number): State {
  return atIndex(state, snapshot, state.index + steps);
}

/** The next notable alpha in a direction, 1 or -1; the same state where there is none. */
export function atNextNotable(state: State, snapshot: Snapshot, direction: number): State {
  const indices = snapshot.facts.notable
    .map((notable) => notable.index)
    .concat(state.start.index)
    .sort((a, b) => a - b);
  const next =
    direction > 0
      ? indices.find((index) => index > state.index)
      : indices.reverse().find((index) => index < state.index);
  return next === undefined ? state : atIndex(state, snapshot, next);
}

export function withLayer(state: State, layer: Layer, isShown: boolean): State {
  const others = state.layers.filter((other) => other !== layer);
  return { ...state, layers: isShown ? [...others, layer] : others };
}

const kSeenThrough = 0.3; // opacity

/**
 * Coloured in another way. Voids in space lie within the shape, which is seen instead of balls and
 * through while they are looked at.
 */
export function colouredBy(state: State, colour: Colour, inSpace: boolean): State {
  const next = { ...state, colour };
  if (!inSpace) return next;
  if (colour !== 'void') {
    const wasForVoids = state.colour === 'void' && state.opacity === kSeenThrough;
    return wasForVoids ? { ...next, opacity: 1 } : next;
  }
  const surface: Layer[] = ['regular', 'singular_triangles'];
  return {
    ...next,
    opacity: state.opacity === 1 ? kSeenThrough : state.opacity,
    layers: [...new Set([...state.layers, ...surface])].filter((layer) => layer !== 'balls'),
  };
}

export function isShown(state: State, layer: Layer): boolean {
  return state.layers.includes(layer);
}

/** Values along the axis of the plot: [index], 0 being the place of the empty complex. */
export function axisValues(snapshot: Snapshot, axis: PlotAxis): Float64Array {
  const { spectrum } = snapshot;
  const values = new Float64Array(spectrum.length + 1);
  for (let i = 1; i < values.length; ++i) {
    const alpha2 = spectrum[i - 1];
    values[i] = axis === 'index' ? i : axis === 'alpha2' ? alpha2 : alphaFromAlpha2(alpha2);
  }
  values[0] = axis === 'index' ? 0 : (values[1] ?? 0);
  return values;
}

/** A text for people who do not see the shape: alpha and what is counted. */
export function spokenState(state: State, snapshot: Snapshot): string {
  const { facts, betti } = snapshot;
  if (state.index === 0) return 'Empty complex, nothing is in the shape yet';
  const words =
    facts.dimension === 3
      ? [
          ['component', 'components'],
          ['tunnel', 'tunnels'],
          ['void', 'voids'],
        ]
      : [
          ['component', 'components'],
          ['hole', 'holes'],
        ];
  const counts = words.map(([one, many], k) => {
    const count = betti[k][state.index - 1];
    return `${count} ${count === 1 ? one : many}`;
  });
  const alpha = Number(alphaFromAlpha2(state.alpha2).toPrecision(4));
  return `alpha ${alpha}${facts.unit === 'Å' ? ' ångström' : ''}, ${counts.join(', ')}`;
}
