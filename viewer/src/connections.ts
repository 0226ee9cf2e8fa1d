// SPDX-License-Identifier: MIT
//
// What hangs together at one index: components of the complex, voids beside it, and how far it is
// from one vertex to the others along its edges. Made when it is asked for, in time linear in the
// simplices (distances: nearly).

import { kNone, type Snapshot } from './types';
import { UnionFind } from './union_find';

/** Numbers of groups, largest group first, equal ones by their first member; kNone for no group. */
export interface Groups {
  /** [member] */
  of: Uint32Array;
  count: number;
}

function grouped(sets: UnionFind, size: number, isMember: (i: number) => boolean): Groups {
  const sizes = new Map<number, number>();
  for (let i = 0; i < size; ++i) {
    if (isMember(i)) sizes.set(sets.find(i), (sizes.get(sets.find(i)) ?? 0) + 1);
  }
  const order = [...sizes].sort(([a, sizeA], [b, sizeB]) => sizeB - sizeA || a - b);
  const number = new Map(order.map(([root], i) => [root, i]));
  const of = new Uint32Array(size).fill(kNone);
  for (let i = 0; i < size; ++i) if (isMember(i)) of[i] = number.get(sets.find(i)) ?? kNone;
  return { of, count: order.length };
}

/** The components of the complex at an index, as groups of vertices. Their number is betti 0. */
export function componentsAt(snapshot: Snapshot, index: number): Groups {
  const [vertices, edges] = snapshot.simplices;
  const sets = new UnionFind(vertices.count);
  for (let e = 0; e < edges.count; ++e) {
    if (edges.enters[e] <= index) sets.unite(edges.corners[2 * e], edges.corners[2 * e + 1]);
  }
  return grouped(sets, vertices.count, (v) => vertices.enters[v] <= index);
}

/**
 * The voids at an index (in the plane holes), as groups of cells: those outside the complex that are
 * not joined to the outside. Their number is betti D - 1.
 */
export function voidsAt(snapshot: Snapshot, index: number): Groups {
  const D = snapshot.facts.dimension;
  const [facets, cells] = [snapshot.simplices[D - 1], snapshot.simplices[D]];
  if (snapshot.facetOwners.length === 0) return { of: new Uint32Array(0), count: 0 };
  const outside = cells.count;
  const sets = new UnionFind(cells.count + 1);
  for (let f = 0; f < facets.count; ++f) {
    if (facets.enters[f] <= index) continue;
    const neighbour = snapshot.facetNeighbours[f];
    sets.unite(snapshot.facetOwners[f] >>> 2, neighbour === kNone ? outside : neighbour);
  }
  return grouped(
    sets,
    cells.count,
    (c) => cells.enters[c] > index && sets.find(c) !== sets.find(outside),
  );
}

/** A heap of vertices by distance. */
class Front {
  private readonly heap: [number, number][] = [];

  push(distance: number, vertex: number): void {
    const { heap } = this;
    let at = heap.length;
    heap.push([distance, vertex]);
    while (at > 0) {
      const parent = (at - 1) >> 1;
      if (heap[parent][0] <= heap[at][0]) break;
      [heap[parent], heap[at]] = [heap[at], heap[parent]];
      at = parent;
    }
  }

  pop(): [number, number] | undefined {
    const { heap } = this;
    const top = heap[0];
    const last = heap.pop();
    if (!last || heap.length === 0) return top;
    heap[0] = last;
    for (let at = 0; ;) {
      let child = 2 * at + 1;
      if (child >= heap.length) break;
      if (child + 1 < heap.length && heap[child + 1][0] < heap[child][0]) ++child;
      if (heap[at][0] <= heap[child][0]) break;
      [heap[at], heap[child]] = [heap[child], heap[at]];
      at = child;
    }
    return top;
  }
}

/**
 * [vertex]: length of the shortest way along edges of the complex at an index from any of `sources`;
 * infinite where there is none.
 * @param positions  [3 * vertex + axis]
 */
export function distancesAt(
  snapshot: Snapshot,
  index: number,
  sources: readonly number[],
  positions: ArrayLike<number>,
): Float64Array {
  const [vertices, edges] = snapshot.simplices;
  const first = new Uint32Array(vertices.count + 2);
  const inComplex = (e: number) => edges.enters[e] <= index;
  for (let e = 0; e < edges.count; ++e) {
    if (inComplex(e)) for (const end of [0, 1]) ++first[edges.corners[2 * e + end] + 2];
  }
  for (let v = 0; v <= vertices.count; ++v) first[v + 1] += first[v];
  const neighbours = new Uint32Array(first[vertices.count + 1]);
  for (let e = 0; e < edges.count; ++e) {
    if (!inComplex(e)) continue;
    const [a, b] = [edges.corners[2 * e], edges.corners[2 * e + 1]];
    neighbours[first[a + 1]++] = b;
    neighbours[first[b + 1]++] = a;
  }
  const distances = new Float64Array(vertices.count).fill(Infinity);
  const front = new Front();
  for (const source of sources) {
    distances[source] = 0;
    front.push(0, source);
  }
  for (let next = front.pop(); next; next = front.pop()) {
    const [distance, v] = next;
    if (distance > distances[v]) continue;
    for (let i = first[v]; i < first[v + 1]; ++i) {
      const w = neighbours[i];
      const step = Math.hypot(
        positions[3 * v] - positions[3 * w],
        positions[3 * v + 1] - positions[3 * w + 1],
        positions[3 * v + 2] - positions[3 * w + 2],
      );
      if (distance + step >= distances[w]) continue;
      distances[w] = distance + step;
      front.push(distances[w], w);
    }
  }
  return distances;
}
