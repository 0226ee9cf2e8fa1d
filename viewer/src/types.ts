// SPDX-License-Identifier: MIT
//
// What a snapshot holds: docs/file_formats/snapshot.md, which a test compares with kArrays.

/** The numbers of an array: whole numbers of 32 bits, doubles, or doubles rounded to 24 bits. */
export type PackedType = 'u32' | 'f64' | 'f32';

/** Every array that a snapshot may hold, with the types it may have. */
export const kArrays = {
  coordinates: ['f64'],
  weights: ['f64'],
  vertex_rows: ['u32'],
  hidden: ['u32'],
  duplicates: ['u32'],
  spectrum: ['f64'],
  edges: ['u32'],
  triangles: ['u32'],
  tetrahedra: ['u32'],
  facet_owners: ['u32'],
  facet_neighbours: ['u32'],
  vertices_enters: ['u32'],
  vertices_regular: ['u32'],
  vertices_interior: ['u32'],
  edges_enters: ['u32'],
  edges_regular: ['u32'],
  edges_interior: ['u32'],
  triangles_enters: ['u32'],
  triangles_regular: ['u32'],
  triangles_interior: ['u32'],
  tetrahedra_enters: ['u32'],
  tetrahedra_regular: ['u32'],
  tetrahedra_interior: ['u32'],
  betti_0: ['u32'],
  betti_1: ['u32'],
  betti_2: ['u32'],
  volume: ['f64', 'f32'],
  area_singular: ['f64', 'f32'],
  area_regular: ['f64', 'f32'],
  length: ['f64', 'f32'],
  persistence_0: ['u32'],
  persistence_1: ['u32'],
  persistence_2: ['u32'],
  cycle_pairs: ['u32'],
  cycle_ends: ['u32'],
  cycle_edges: ['u32'],
  line: ['u32'],
  element: ['u32'],
  atom: ['u32'],
  residue: ['u32'],
  residue_id: ['u32'],
  chain: ['u32'],
} as const satisfies Record<string, readonly PackedType[]>;

export type ArrayName = keyof typeof kArrays;

/** An index of the spectrum that stands out. alpha2 is a squared length, alpha its signed root. */
export interface Notable {
  name: string;
  reason: string;
  index: number;
  alpha2: number | null;
  alpha: number | null;
}

export type LabelName = 'element' | 'atom' | 'residue' | 'residue_id' | 'chain';

/** The header's members beside the list of arrays. */
export interface Facts {
  version: number;
  program: string;
  source: string;
  unit: string;
  radii: string;
  weights: 'none' | 'given' | 'molecule_radii';
  start: { index: number; alpha2: number | null; alpha: number | null; reason: string };
  dimension: 2 | 3;
  affine_dimension: number;
  sites: number;
  hidden: number;
  duplicates: number;
  vertices: number;
  edges: number;
  triangles: number;
  tetrahedra?: number;
  spectrum_size: number;
  pairs_0: number;
  pairs_1: number;
  pairs_2?: number;
  cycles?: number;
  cycle_edges?: number;
  notable: Notable[];
  dictionaries: Partial<Record<LabelName, string[]>>;
}

/** An entry of the header's list. */
export interface ArrayEntry {
  name: string;
  type: PackedType;
  length: number;
  stride: number;
  offset: number;
}

/** No cell, no row. */
export const kNone = 0xffffffff;

/**
 * All simplices of one dimension with their three indices of the spectrum. A simplex is singular
 * from `enters`, regular from `regular`, interior from `interior` on; spectrumSize + 1 is never.
 */
export interface Simplices {
  dimension: number;
  count: number;
  /**
   * [(dimension + 1) * simplex + corner]: vertices. Cells are positively oriented; facets are seen
   * from outside the cell beside them that enters first; others ascend.
   */
  corners: Uint32Array;
  enters: Uint32Array;
  regular: Uint32Array;
  interior: Uint32Array;
}

/** Which words the sites carry, for one kind of label. */
export interface Labels {
  words: string[];
  /** [row]: number of its word. */
  codes: Uint32Array;
}

/** Cycles around tunnels, one after the other. */
export interface Cycles {
  /** [cycle]: whose, by number of the pair of dimension 1; ascending. */
  pairs: Uint32Array;
  /** [cycle]: where its edges end. */
  ends: Uint32Array;
  edges: Uint32Array;
}

/** A snapshot, read and completed. Nothing in it changes. */
export interface Snapshot {
  facts: Facts;
  /** [dimension * row + axis]: exact, input units. */
  coordinates: Float64Array;
  /** [row]: signed squared lengths; empty where all are 0. */
  weights: Float64Array;
  /** [vertex]: its row. */
  vertexRows: Uint32Array;
  hidden: Uint32Array;
  /** Pairs: a row and the lowest row equal to it. */
  duplicates: Uint32Array;
  /** [index - 1]: alpha2, never decreasing. */
  spectrum: Float64Array;
  /** [dimension]: 0..D. */
  simplices: Simplices[];
  /** [facet]: 4 * cell + corner opposite; empty where the sites span less than space. */
  facetOwners: Uint32Array;
  /** [facet]: the cell on the other side, kNone on the convex hull. */
  facetNeighbours: Uint32Array;
  /** [dimension][index - 1] */
  betti: Uint32Array[];
  /** [index - 1] */
  volume: Float64Array | Float32Array;
  areaSingular: Float64Array | Float32Array;
  areaRegular: Float64Array | Float32Array;
  /** [index - 1]; empty in the plane. */
  length: Float64Array | Float32Array;
  /**
   * [dimension][2 * pair]: the simplex of that dimension that begins a class of cycles, and the one of
   * the next that ends it, kNone for never. Classes that live at one index at least.
   */
  persistence: Uint32Array[];
  /** Of some tunnels in space. */
  cycles: Cycles;
  /** [row]: line of the input; empty where it has none. */
  line: Uint32Array;
  labels: Partial<Record<LabelName, Labels>>;
}

export type Role = 'exterior' | 'singular' | 'regular' | 'interior';

/** The role of a simplex at an index. */
export function roleAt(simplices: Simplices, simplex: number, index: number): Role {
  if (index < simplices.enters[simplex]) return 'exterior';
  if (index < simplices.regular[simplex]) return 'singular';
  return index < simplices.interior[simplex] ? 'regular' : 'interior';
}

/**
 * The rows of a simplex, ascending. Numbers of vertices go on with those of hidden sites, which are
 * in no simplex but have rows as well.
 */
export function rowsOf(
  snapshot: Snapshot,
  { dimension, simplex }: { dimension: number; simplex: number },
): number[] {
  const { count, corners } = snapshot.simplices[dimension];
  if (simplex >= count) return [snapshot.hidden[simplex - count]];
  const vertices = corners.subarray((dimension + 1) * simplex, (dimension + 1) * (simplex + 1));
  return [...vertices].map((v) => snapshot.vertexRows[v]).sort((a, b) => a - b);
}

/** Other rows that are equal to one that stands for them. */
export function equalRows({ duplicates }: Snapshot, row: number): number[] {
  const rows: number[] = [];
  for (let i = 0; i < duplicates.length; i += 2)
    if (duplicates[i + 1] === row) rows.push(duplicates[i]);
  return rows;
}
