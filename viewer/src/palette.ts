// SPDX-License-Identifier: MIT
//
// Colours, [red, green, blue] of 0..255. Categories are those of Okabe and Ito, which people with
// any kind of colour vision can tell apart; sequences follow viridis.

import { componentsAt, voidsAt } from './connections';
import { labelOf } from './molecule';
import type { Colour } from './state';
import { kNone, type Snapshot } from './types';

export type Rgb = readonly [number, number, number];

export const kRoleColours = {
  regular: [92, 158, 214],
  singular: [230, 159, 0],
  edge: [213, 94, 0],
  vertex: [0, 158, 115],
  interior: [158, 172, 190],
} as const satisfies Record<string, Rgb>;

/** [dimension] of a class of cycles, as the persistence diagram has it. */
export const kClassColours: readonly Rgb[] = [
  [0, 114, 178],
  [213, 94, 0],
  [0, 158, 115],
];
export const kPickedColour: Rgb = [255, 48, 128];

export const kDimensionColours: readonly Rgb[] = [
  [0, 158, 115],
  [213, 94, 0],
  [86, 160, 215],
  [204, 121, 167],
];

const kCategories: readonly Rgb[] = [
  [86, 160, 215],
  [230, 159, 0],
  [0, 158, 115],
  [204, 121, 167],
  [213, 94, 0],
  [240, 208, 66],
  [0, 114, 178],
  [140, 140, 150],
];
const kGrey: Rgb = [176, 182, 190];

const kElementColours: Record<string, Rgb> = {
  H: [236, 239, 242],
  C: [130, 138, 150],
  N: [64, 120, 210],
  O: [214, 80, 62],
  S: [226, 184, 36],
  P: [224, 124, 20],
  F: [120, 200, 120],
  Cl: [70, 170, 90],
  Na: [150, 110, 200],
  Mg: [60, 150, 90],
  Fe: [190, 100, 50],
  Zn: [120, 124, 170],
  Ca: [110, 160, 110],
};

const kViridis: readonly Rgb[] = [
  [68, 57, 131],
  [49, 104, 142],
  [33, 145, 140],
  [53, 183, 121],
  [143, 215, 68],
  [240, 229, 48],
];

/** Of a place 0..1 in a sequence. */
export function sequenceColour(place: number): Rgb {
  const at = Math.min(0.999999, Math.max(0, place)) * (kViridis.length - 1);
  const [low, high] = [kViridis[Math.floor(at)], kViridis[Math.floor(at) + 1]];
  const share = at - Math.floor(at);
  return [0, 1, 2].map((i) => Math.round(low[i] + share * (high[i] - low[i]))) as unknown as Rgb;
}

export function categoryColour(number: number): Rgb {
  return number === kNone ? kGrey : kCategories[number % kCategories.length];
}

export interface LegendEntry {
  colour: Rgb;
  text: string;
}

/** How simplices are coloured. */
export interface Colouring {
  /** [vertex]; null for one colour by role or dimension. */
  vertices: ((vertex: number) => Rgb) | null;
  /** [facet]; null unless they have colours of their own. */
  facets: ((facet: number) => Rgb) | null;
  /** Triangles that show voids, walls of them or in the plane all of a hole, and [triangle] colours. */
  voids: { triangles: number[]; colour: (triangle: number) => Rgb } | null;
  legend: LegendEntry[];
}

function byGroups(count: number, noun: string, many: string): LegendEntry[] {
  const shown = Math.min(count, kCategories.length - 1);
  const entries = Array.from({ length: shown }, (_, i) => ({
    colour: categoryColour(i),
    text: i === 0 ? `largest ${noun}` : `${noun} ${i + 1}`,
  }));
  if (count > shown)
    entries.push({
      colour: kCategories[shown],
      text: `the other ${(count - shown).toLocaleString('en')} ${many}`,
    });
  return entries;
}

function byComponent(snapshot: Snapshot, index: number): Colouring {
  const groups = componentsAt(snapshot, index);
  return {
    vertices: (v) => categoryColour(groups.of[v]),
    facets: null,
    voids: null,
    legend: byGroups(groups.count, 'component', 'components'),
  };
}

function byVoid(snapshot: Snapshot, index: number): Colouring {
  const groups = voidsAt(snapshot, index);
  const inSpace = snapshot.facts.dimension === 3;
  const noun = inSpace ? 'void' : 'hole';
  const beside = (facet: number): number => {
    const [owner, neighbour] = [snapshot.facetOwners[facet] >>> 2, snapshot.facetNeighbours[facet]];
    if (groups.of[owner] !== kNone || neighbour === kNone) return groups.of[owner];
    return groups.of[neighbour];
  };
  const facetColour = (facet: number) => categoryColour(beside(facet));
  const facets = snapshot.simplices[snapshot.facts.dimension - 1];
  const triangles: number[] = [];
  if (inSpace) {
    for (let f = 0; f < snapshot.facetOwners.length; ++f)
      if (facets.enters[f] <= index && beside(f) !== kNone) triangles.push(f);
  } else {
    groups.of.forEach((group, cell) => group !== kNone && triangles.push(cell));
  }
  const colour = inSpace ? facetColour : (cell: number) => categoryColour(groups.of[cell]);
  return {
    vertices: () => kGrey,
    facets: snapshot.facetOwners.length > 0 ? facetColour : null,
    voids: { triangles, colour },
    legend: [...byGroups(groups.count, noun, `${noun}s`), { colour: kGrey, text: 'outside' }],
  };
}

function byElement(snapshot: Snapshot): Colouring {
  const words = snapshot.labels.element?.words ?? [];
  const colour = (word: string): Rgb => kElementColours[word] ?? [200, 120, 180];
  return {
    vertices: (v) => colour(labelOf(snapshot, 'element', snapshot.vertexRows[v])),
    facets: null,
    voids: null,
    legend: words.slice(0, 10).map((word) => ({ colour: colour(word), text: word })),
  };
}

function byResidue(snapshot: Snapshot): Colouring {
  // Residues in the order of the rows, chain by chain.
  const place = new Uint32Array(snapshot.facts.sites);
  let count = 0;
  let before = '';
  for (let row = 0; row < place.length; ++row) {
    const name = `${labelOf(snapshot, 'chain', row)} ${labelOf(snapshot, 'residue_id', row)}`;
    if (row > 0 && name !== before) ++count;
    before = name;
    place[row] = count;
  }
  return {
    vertices: (v) => sequenceColour(place[snapshot.vertexRows[v]] / Math.max(1, count)),
    facets: null,
    voids: null,
    legend: [
      { colour: sequenceColour(0), text: 'first residue' },
      { colour: sequenceColour(0.5), text: 'middle' },
      { colour: sequenceColour(1), text: 'last residue' },
    ],
  };
}

function byChain(snapshot: Snapshot): Colouring {
  const labels = snapshot.labels.chain;
  return {
    vertices: (v) => categoryColour(labels ? labels.codes[snapshot.vertexRows[v]] : kNone),
    facets: null,
    voids: null,
    legend: (labels?.words ?? []).slice(0, 8).map((word, i) => ({
      colour: categoryColour(i),
      text: `chain ${word}`,
    })),
  };
}

function plain(snapshot: Snapshot, colour: Colour): LegendEntry[] {
  const inSpace = snapshot.facts.dimension === 3;
  if (colour === 'dimension') {
    return ['vertices', 'edges', 'triangles', ...(inSpace ? ['tetrahedra'] : [])].map(
      (text, k) => ({
        colour: kDimensionColours[k],
        text,
      }),
    );
  }
  return inSpace
    ? [
        { colour: kRoleColours.regular, text: 'regular triangles' },
        { colour: kRoleColours.singular, text: 'singular triangles' },
        { colour: kRoleColours.edge, text: 'singular edges' },
        { colour: kRoleColours.vertex, text: 'singular vertices' },
      ]
    : [
        { colour: kRoleColours.interior, text: 'triangles' },
        { colour: kRoleColours.regular, text: 'regular edges' },
        { colour: kRoleColours.edge, text: 'singular edges' },
        { colour: kRoleColours.vertex, text: 'singular vertices' },
      ];
}

/** Which ways of colouring an input has. */
export function coloursOf(snapshot: Snapshot): Colour[] {
  const colours: Colour[] = ['role', 'component', 'dimension', 'void'];
  if (snapshot.labels.element) colours.push('element');
  if (snapshot.labels.residue_id?.words.some(Boolean)) colours.push('residue');
  if ((snapshot.labels.chain?.words.length ?? 0) > 0 && snapshot.labels.chain?.words.some(Boolean))
    colours.push('chain');
  return colours;
}

/** Whether the colours of simplices depend on the index. */
export function changesWithIndex(colour: Colour): boolean {
  return colour === 'component' || colour === 'void';
}

export function colouringOf(snapshot: Snapshot, colour: Colour, index: number): Colouring {
  switch (colour) {
    case 'component':
      return byComponent(snapshot, index);
    case 'void':
      return byVoid(snapshot, index);
    case 'element':
      return byElement(snapshot);
    case 'residue':
      return byResidue(snapshot);
    case 'chain':
      return byChain(snapshot);
    default:
      return { vertices: null, facets: null, voids: null, legend: plain(snapshot, colour) };
  }
}
