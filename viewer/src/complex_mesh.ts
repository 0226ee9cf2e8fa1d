// SPDX-License-Identifier: MIT
//
// The simplices of one dimension, listed by their role at a current index, as index buffers that
// can be drawn. Going from one index to another touches the simplices whose role changes between
// the two and no others: three lists of events, sorted by index, tell which. A simplex is taken out
// of its list by moving the last one into its place, so that lists have no gaps and every change
// costs O(1). Which parts of a buffer have changed is kept by blocks, for sending these only.

import { roleAt, type Role, type Simplices } from './types';

const kRoleNumber: Record<Role, number> = { exterior: 0, singular: 1, regular: 2, interior: 3 };

/** Elements of an index buffer that a simplex takes: `width * simplex + pattern[i]`. */
export interface Pattern {
  width: number;
  offsets: readonly number[];
}
/** Two triangles of four corners, for a vertex or an edge as wide as a few pixels. */
export const kQuad: Pattern = { width: 4, offsets: [0, 1, 2, 2, 1, 3] };
export const kTriangle: Pattern = { width: 3, offsets: [0, 1, 2] };
/** The four faces of a tetrahedron. */
export const kFaces: Pattern = { width: 12, offsets: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11] };

const kBlock = 256; // simplices

/** A part of a buffer, in elements. */
export interface Range {
  start: number;
  count: number;
}

/** The simplices of one role. */
export class SimplexList {
  /** [place]: simplices; the first `size` count. */
  readonly simplices: Uint32Array;
  /** [pattern length * place + i] */
  readonly elements: Uint32Array<ArrayBuffer>;
  size = 0;
  private readonly isDirty: Uint8Array;

  constructor(
    readonly pattern: Pattern,
    readonly capacity: number,
  ) {
    this.simplices = new Uint32Array(capacity);
    this.elements = new Uint32Array(capacity * pattern.offsets.length);
    this.isDirty = new Uint8Array(Math.ceil(capacity / kBlock));
  }

  put(place: number, simplex: number): void {
    this.simplices[place] = simplex;
    const { width, offsets } = this.pattern;
    const first = place * offsets.length;
    for (let i = 0; i < offsets.length; ++i)
      this.elements[first + i] = width * simplex + offsets[i];
    this.isDirty[(place / kBlock) | 0] = 1;
  }

  /** The parts that have changed since the last call, and are still in use; apart and ascending. */
  takeChanges(): Range[] {
    const perBlock = kBlock * this.pattern.offsets.length;
    const end = this.size * this.pattern.offsets.length;
    const ranges: Range[] = [];
    for (let block = 0; block < this.isDirty.length; ++block) {
      if (this.isDirty[block] === 0) continue;
      this.isDirty[block] = 0;
      const start = block * perBlock;
      const last = ranges.at(-1);
      const count = Math.min(perBlock, end - start);
      if (count <= 0) continue;
      if (last && last.start + last.count === start) last.count += count;
      else ranges.push({ start, count });
    }
    return ranges;
  }
}

/** Indices from `from[simplex]` on and before `to[simplex]`; null for never ending. */
interface Spans {
  from: Uint32Array;
  to: Uint32Array | null;
}

/** When the simplices of a dimension have a role. */
function spansOf({ enters, regular, interior }: Simplices, role: Role): Spans {
  if (role === 'singular') return { from: enters, to: regular };
  return role === 'regular' ? { from: regular, to: interior } : { from: interior, to: null };
}

/** The simplices whose span is not empty, by increasing rank[simplex]; none that is never. */
function sortedByRank(rank: Uint32Array, { from, to }: Spans, never: number): Uint32Array {
  const begin = new Uint32Array(never + 1);
  let size = 0;
  for (let i = 0; i < rank.length; ++i) {
    if (from[i] >= (to ? to[i] : never) || rank[i] >= never) continue;
    ++begin[rank[i]];
    ++size;
  }
  for (let r = 0, sum = 0; r <= never; ++r) {
    const count = begin[r];
    begin[r] = sum;
    sum += count;
  }
  const sorted = new Uint32Array(size);
  for (let i = 0; i < rank.length; ++i) {
    if (from[i] >= (to ? to[i] : never) || rank[i] >= never) continue;
    sorted[begin[rank[i]]++] = i;
  }
  return sorted;
}

/** Simplices by the index at which one thing happens to them, and how many it has happened to. */
class Events {
  private done = 0;

  constructor(
    private readonly rank: Uint32Array,
    readonly sorted: Uint32Array,
  ) {}

  /** The first event after `index`. */
  private behind(index: number): number {
    let low = 0;
    let high = this.sorted.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.rank[this.sorted[middle]] <= index) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Goes to an index; returns the events passed, in either direction. */
  moveTo(index: number): Uint32Array {
    const target = this.behind(index);
    const passed = this.sorted.subarray(Math.min(target, this.done), Math.max(target, this.done));
    this.done = target;
    return passed;
  }
}

/** How many spans have an index in common at most, given their ends by increasing index. */
function mostAtOnce({ from, to }: Spans, begins: Uint32Array, ends: Uint32Array): number {
  if (!to) return begins.length;
  let most = 0;
  let ended = 0;
  for (let begun = 0; begun < begins.length; ++begun) {
    while (ended < ends.length && to[ends[ended]] <= from[begins[begun]]) ++ended;
    most = Math.max(most, begun + 1 - ended);
  }
  return most;
}

/**
 * The simplices of one dimension by role, at one index after the other. Begins at index 0. Only those
 * of the `drawn` roles are known.
 */
export class ComplexMesh {
  index = 0;
  /** By the number of the role; null for roles that are not drawn. */
  private readonly lists: (SimplexList | null)[] = [null, null, null, null];
  private readonly role: Uint8Array;
  private readonly place: Uint32Array;
  private readonly events: Events[] = [];

  constructor(
    readonly simplices: Simplices,
    pattern: Pattern,
    never: number,
    drawn: readonly Role[],
  ) {
    this.role = new Uint8Array(simplices.count);
    this.place = new Uint32Array(simplices.count);
    for (const role of drawn) {
      const spans = spansOf(simplices, role);
      const begins = sortedByRank(spans.from, spans, never);
      const ends = spans.to ? sortedByRank(spans.to, spans, never) : new Uint32Array(0);
      this.events.push(new Events(spans.from, begins));
      if (spans.to) this.events.push(new Events(spans.to, ends));
      this.lists[kRoleNumber[role]] = new SimplexList(pattern, mostAtOnce(spans, begins, ends));
    }
  }

  /** Of a role that is drawn. */
  list(role: Role): SimplexList {
    const list = this.lists[kRoleNumber[role]];
    if (!list) throw new Error(`simplices that are ${role} are not listed`);
    return list;
  }

  /** Goes to another index. Returns how many simplices were looked at. */
  moveTo(index: number): number {
    this.index = index;
    const passed = this.events.map((events) => events.moveTo(index));
    const count = passed.reduce((sum, simplices) => sum + simplices.length, 0);
    if (count > this.simplices.count) {
      this.listAnew(index);
      return this.simplices.count;
    }
    // First all that leave, then all that come: no list is ever longer than at an index.
    for (const simplices of passed) for (const simplex of simplices) this.leave(simplex, index);
    for (const simplices of passed) for (const simplex of simplices) this.enter(simplex, index);
    return count;
  }

  // In the order of the simplices, which is that of memory: for far ways.
  private listAnew(index: number): void {
    for (const list of this.lists) if (list) list.size = 0;
    this.role.fill(0);
    for (let simplex = 0; simplex < this.simplices.count; ++simplex) this.enter(simplex, index);
  }

  private leave(simplex: number, index: number): void {
    const role = this.role[simplex];
    if (role === 0 || role === kRoleNumber[roleAt(this.simplices, simplex, index)]) return;
    const list = this.lists[role]!;
    const place = this.place[simplex];
    const last = list.simplices[--list.size];
    if (last !== simplex) {
      list.put(place, last);
      this.place[last] = place;
    }
    this.role[simplex] = 0;
  }

  private enter(simplex: number, index: number): void {
    const role = kRoleNumber[roleAt(this.simplices, simplex, index)];
    const list = this.lists[role];
    if (!list || role === this.role[simplex]) return;
    this.role[simplex] = role;
    this.place[simplex] = list.size;
    list.put(list.size++, simplex);
  }
}
