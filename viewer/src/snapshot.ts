// SPDX-License-Identifier: MIT
//
// Reads a snapshot, docs/file_formats/snapshot.md, and completes what the file leaves to its reader:
// the corners and indices of facets, which follow from the cells beside them.

import {
  kArrays,
  kNone,
  type ArrayEntry,
  type ArrayName,
  type Cycles,
  type Facts,
  type LabelName,
  type Labels,
  type PackedType,
  type Simplices,
  type Snapshot,
} from './types';

/** The bytes are not a snapshot, or not all of it. `reason` is a word for programs. */
export class SnapshotError extends Error {
  constructor(
    readonly reason: 'missing' | 'damaged' | 'version',
    message: string,
  ) {
    super(message);
  }
}

const kMagic = 'OBsnap1\n';
const kPiece = 1 << 20; // letters: one string of everything would take its size once more

function damaged(what: string): SnapshotError {
  return new SnapshotError('damaged', `The data in this page is damaged: ${what}.`);
}

/**
 * The bytes of base64 text; of damaged text an error.
 * @param parts  of the text, one after the other: browsers do not make strings as long as it may be.
 */
export function bytesFromBase64(parts: readonly string[]): Uint8Array<ArrayBuffer> {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  if (length % 4 !== 0) throw damaged('its text is cut short');
  const end = parts.slice(-2).join('').slice(-2);
  const bytes = new Uint8Array((length / 4) * 3 - (end === '==' ? 2 : end.endsWith('=') ? 1 : 0));
  let at = 0;
  let rest = ''; // less than four letters
  for (const part of parts) {
    const text = rest + part;
    const whole = text.length - (text.length % 4);
    rest = text.slice(whole);
    for (let begin = 0; begin < whole; begin += kPiece) {
      let binary: string;
      try {
        binary = atob(text.slice(begin, Math.min(whole, begin + kPiece)));
      } catch {
        throw damaged('its text has letters that do not belong there');
      }
      for (let i = 0; i < binary.length; ++i) bytes[at++] = binary.charCodeAt(i);
    }
  }
  return bytes;
}

/** What a gzip file holds. */
export async function gunzipped(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw damaged('it cannot be unpacked');
  }
}

/** Puts the planes of `size`-byte numbers back together. */
function unplaned(bytes: Uint8Array, length: number, size: number): Uint8Array<ArrayBuffer> {
  const numbers = new Uint8Array(length * size);
  for (let plane = 0; plane < size; ++plane) {
    const begin = plane * length;
    for (let i = 0, at = plane; i < length; ++i, at += size) numbers[at] = bytes[begin + i];
  }
  return numbers;
}

function numbersOf(bytes: Uint8Array, length: number, stride: number): Uint32Array<ArrayBuffer> {
  const numbers = new Uint32Array(length);
  const [b1, b2, b3] = [length, 2 * length, 3 * length];
  for (let i = 0; i < length; ++i) {
    numbers[i] = bytes[i] | (bytes[b1 + i] << 8) | (bytes[b2 + i] << 16) | (bytes[b3 + i] << 24);
  }
  if (stride === 0) return numbers;
  for (let i = 0; i < length; ++i) {
    const kept = numbers[i];
    const difference = (kept >>> 1) ^ -(kept & 1);
    numbers[i] = i < stride ? difference : difference + numbers[i - stride];
  }
  return numbers;
}

/** The arrays of a file by their names. */
class PackedFile {
  readonly facts: Facts;
  private readonly entries = new Map<string, ArrayEntry>();
  private readonly arrays: Uint8Array;

  constructor(bytes: Uint8Array<ArrayBuffer>) {
    const magic = new TextDecoder().decode(bytes.subarray(0, 8));
    if (magic !== kMagic) {
      if (magic.startsWith('OBsnap')) {
        throw new SnapshotError(
          'version',
          'The data in this page was written by another version of orthoball than the page.',
        );
      }
      throw damaged('it does not begin as a snapshot does');
    }
    const size = Number(new DataView(bytes.buffer).getBigUint64(8, true));
    if (16 + size > bytes.length) throw damaged('it ends within its header');
    let header: Facts & { arrays: ArrayEntry[] };
    try {
      header = JSON.parse(new TextDecoder().decode(bytes.subarray(16, 16 + size)));
    } catch {
      throw damaged('its header cannot be read');
    }
    this.facts = header;
    this.arrays = bytes.subarray(16 + size);
    for (const entry of header.arrays) {
      const types: readonly PackedType[] | undefined = kArrays[entry.name as ArrayName];
      if (!types?.includes(entry.type)) throw damaged(`the array ${entry.name} is not known`);
      const end = entry.offset + entry.length * (entry.type === 'f64' ? 8 : 4);
      if (end > this.arrays.length) throw damaged(`it ends within the array ${entry.name}`);
      this.entries.set(entry.name, entry);
    }
  }

  has(name: ArrayName): boolean {
    return this.entries.has(name);
  }

  private find(name: ArrayName, length: number): [ArrayEntry, Uint8Array] {
    const entry = this.entries.get(name);
    if (!entry) throw damaged(`the array ${name} is missing`);
    if (entry.length !== length) {
      throw damaged(`the array ${name} has ${entry.length} numbers instead of ${length}`);
    }
    return [entry, this.arrays.subarray(entry.offset)];
  }

  numbers(name: ArrayName, length: number): Uint32Array {
    const [entry, bytes] = this.find(name, length);
    return numbersOf(bytes, length, entry.stride);
  }

  /** Row numbers, or numbers of vertices or cells: all of them below `end`, or kNone. */
  numbersBelow(end: number, name: ArrayName, length: number, mayBeNone = false): Uint32Array {
    const numbers = this.numbers(name, length);
    for (let i = 0; i < length; ++i) {
      if (numbers[i] >= end && !(mayBeNone && numbers[i] === kNone)) {
        throw damaged(`${name} has the number ${numbers[i]}, where there are ${end}`);
      }
    }
    return numbers;
  }

  doubles(name: ArrayName, length: number): Float64Array {
    return new Float64Array(unplaned(this.find(name, length)[1], length, 8).buffer);
  }

  reals(name: ArrayName, length: number): Float64Array | Float32Array {
    if (this.find(name, length)[0].type === 'f64') return this.doubles(name, length);
    return new Float32Array(unplaned(this.find(name, length)[1], length, 4).buffer);
  }
}

const kNouns = ['vertices', 'edges', 'triangles', 'tetrahedra'] as const;

function simplicesOf(file: PackedFile, facts: Facts, dimension: number): Simplices {
  const noun = kNouns[dimension];
  const count = facts[noun] ?? 0;
  const hasCells = facts.affine_dimension === facts.dimension;
  // Indices of the spectrum and never.
  const indices = (role: 'enters' | 'regular' | 'interior') =>
    file.numbersBelow(facts.spectrum_size + 2, `${noun}_${role}`, count);
  const enters = indices('enters');
  if (hasCells && dimension === facts.dimension - 1) {
    const empty = new Uint32Array(0); // until completeFacets
    return { dimension, count, corners: empty, enters, regular: empty, interior: empty };
  }
  const corners =
    noun === 'vertices'
      ? Uint32Array.from({ length: count }, (_, i) => i)
      : file.numbersBelow(facts.vertices, noun, (dimension + 1) * count);
  if (hasCells && dimension === facts.dimension) {
    return { dimension, count, corners, enters, regular: enters, interior: enters };
  }
  const [regular, interior] = [indices('regular'), indices('interior')];
  return { dimension, count, corners, enters, regular, interior };
}

/**
 * The corners of a cell's facet in the order that has the cell on its inside: counterclockwise seen
 * from outside the cell, in the plane with the cell on the left.
 */
export function outwardFacet(cells: Simplices, cell: number, apex: number): number[] {
  const width = cells.dimension + 1;
  const facet: number[] = [];
  for (let i = 1; i < width; ++i) facet.push(cells.corners[width * cell + ((apex + i) % width)]);
  if (width === 4 && apex % 2 === 1) [facet[1], facet[2]] = [facet[2], facet[1]];
  return facet;
}

/** The corner of a cell that a facet, given by its corners in another cell, does not have. */
function apexOf(cells: Simplices, cell: number, facet: readonly number[]): number {
  const width = cells.dimension + 1;
  let apex = 0;
  while (facet.includes(cells.corners[width * cell + apex])) ++apex;
  return apex;
}

/**
 * Gives facets the indices that their cells tell, and their corners as seen from outside the cell
 * that enters first: a regular facet has that cell on its inside.
 */
function completeFacets(
  facets: Simplices,
  cells: Simplices,
  owners: Uint32Array,
  neighbours: Uint32Array,
  never: number,
): Simplices {
  const width = facets.dimension + 1;
  const corners = new Uint32Array(width * facets.count);
  const regular = new Uint32Array(facets.count);
  const interior = new Uint32Array(facets.count);
  for (let facet = 0; facet < facets.count; ++facet) {
    const cell = owners[facet] >>> 2;
    const neighbour = neighbours[facet];
    const one = cells.enters[cell];
    const other = neighbour === kNone ? never : cells.enters[neighbour];
    regular[facet] = Math.min(one, other);
    interior[facet] = Math.max(one, other);
    let outward = outwardFacet(cells, cell, owners[facet] & 3);
    if (other < one) outward = outwardFacet(cells, neighbour, apexOf(cells, neighbour, outward));
    corners.set(outward, width * facet);
  }
  return { ...facets, corners, regular, interior };
}

function pairsOf(file: PackedFile, simplices: readonly Simplices[], dimension: number) {
  const name = `persistence_${dimension}` as ArrayName;
  const count = file.facts[`pairs_${dimension}` as 'pairs_0'] ?? 0;
  const pairs = file.numbers(name, 2 * count);
  const [born, filling] = [simplices[dimension].count, simplices[dimension + 1].count];
  for (let i = 0; i < pairs.length; i += 2) {
    if (pairs[i] >= born || (pairs[i + 1] >= filling && pairs[i + 1] !== kNone)) {
      throw damaged(`${name} has the pair ${pairs[i]}, ${pairs[i + 1]}`);
    }
  }
  return pairs;
}

function cyclesOf(file: PackedFile, facts: Facts): Cycles {
  const [count, length] = [facts.cycles ?? 0, facts.cycle_edges ?? 0];
  const none = new Uint32Array(0);
  if (facts.dimension === 2) return { pairs: none, ends: none, edges: none };
  const ends = file.numbersBelow(length + 1, 'cycle_ends', count);
  if (ends.some((end, i) => end < (i > 0 ? ends[i - 1] : 0))) throw damaged('cycle_ends descend');
  return {
    pairs: file.numbersBelow(facts.pairs_1, 'cycle_pairs', count),
    ends,
    edges: file.numbersBelow(facts.edges, 'cycle_edges', length),
  };
}

function labelsOf(file: PackedFile, facts: Facts): Snapshot['labels'] {
  const labels: Snapshot['labels'] = {};
  for (const name of Object.keys(facts.dictionaries) as LabelName[]) {
    const words = facts.dictionaries[name] ?? [];
    const codes = file.numbersBelow(words.length, name, facts.sites);
    labels[name] = { words, codes } satisfies Labels;
  }
  return labels;
}

/**
 * Reads a whole snapshot.
 * @throws SnapshotError that says in plain words what is wrong; nothing is shown of damaged data.
 */
export function readSnapshot(bytes: Uint8Array<ArrayBuffer>): Snapshot {
  const file = new PackedFile(bytes);
  const facts = file.facts;
  const D = facts.dimension;
  const s = facts.spectrum_size;
  const hasCells = facts.affine_dimension === D;
  const simplices: Simplices[] = [];
  for (let k = 0; k <= D; ++k) simplices.push(simplicesOf(file, facts, k));
  let facetOwners: Uint32Array = new Uint32Array(0);
  let facetNeighbours: Uint32Array = new Uint32Array(0);
  if (hasCells) {
    const [facets, cells] = [simplices[D - 1], simplices[D]];
    facetOwners = file.numbersBelow(4 * cells.count, 'facet_owners', facets.count);
    facetNeighbours = file.numbersBelow(cells.count, 'facet_neighbours', facets.count, true);
    simplices[D - 1] = completeFacets(facets, cells, facetOwners, facetNeighbours, s + 1);
  }
  const none = new Float64Array(0);
  return {
    facts,
    coordinates: file.doubles('coordinates', D * facts.sites),
    weights: file.has('weights') ? file.doubles('weights', facts.sites) : none,
    vertexRows: file.numbersBelow(facts.sites, 'vertex_rows', facts.vertices),
    hidden: file.numbersBelow(facts.sites, 'hidden', facts.hidden),
    duplicates: file.numbersBelow(facts.sites, 'duplicates', 2 * facts.duplicates),
    spectrum: file.doubles('spectrum', s),
    simplices,
    facetOwners,
    facetNeighbours,
    betti: ([0, 1, 2] as const).slice(0, D).map((k) => file.numbers(`betti_${k}`, s)),
    volume: file.reals('volume', s),
    areaSingular: file.reals('area_singular', s),
    areaRegular: file.reals('area_regular', s),
    length: D === 3 ? file.reals('length', s) : none,
    persistence: [0, 1, 2].slice(0, D).map((k) => pairsOf(file, simplices, k)),
    cycles: cyclesOf(file, facts),
    line: file.has('line') ? file.numbers('line', facts.sites) : new Uint32Array(0),
    labels: labelsOf(file, facts),
  };
}
