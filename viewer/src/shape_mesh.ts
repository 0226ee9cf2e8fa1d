// SPDX-License-Identifier: MIT
//
// The boundary of the shape at one index with everything singular, as `orthoball shape` has it: the
// same vertices, triangles and edges in the same order, turned the same way.

import type { Role, Simplices, Snapshot } from './types';
import { roleAt } from './types';

export interface ShapeMesh {
  index: number;
  /** [vertex]: input rows. */
  rows: number[];
  /** [3 * vertex + axis]: input units; the third is 0 in the plane. */
  coordinates: Float64Array;
  /** Vertices of this mesh. */
  triangles: number[][];
  triangleRoles: Role[];
  edges: number[][];
  edgeRoles: Role[];
  isolated: number[];
}

interface Side {
  low: number;
  high: number;
  triangle: number;
  ascends: boolean;
}

/**
 * Turns singular triangles so that two that share an edge with no third run through it in opposite
 * directions, going out from the first triangle of every patch.
 */
function orientAlike(triangles: number[][]): void {
  const sides: Side[] = triangles.flatMap((corners, triangle) =>
    corners.map((from, i) => {
      const to = corners[(i + 1) % 3];
      return { low: Math.min(from, to), high: Math.max(from, to), triangle, ascends: from < to };
    }),
  );
  sides.sort((a, b) => a.low - b.low || a.high - b.high || a.triangle - b.triangle);
  const links: { triangle: number; differs: boolean }[][] = triangles.map(() => []);
  for (let first = 0, last = 0; first < sides.length; first = last) {
    const [a, b] = [sides[first], sides[first + 1]];
    while (last < sides.length && sides[last].low === a.low && sides[last].high === a.high) ++last;
    if (last - first !== 2) continue;
    const differs = a.ascends === b.ascends;
    links[a.triangle].push({ triangle: b.triangle, differs });
    links[b.triangle].push({ triangle: a.triangle, differs });
  }
  const isDone = new Uint8Array(triangles.length);
  const isTurned = new Uint8Array(triangles.length);
  for (let start = 0; start < triangles.length; ++start) {
    if (isDone[start]) continue;
    isDone[start] = 1;
    const front = [start];
    for (let t = front.pop(); t !== undefined; t = front.pop()) {
      for (const link of links[t]) {
        if (isDone[link.triangle]) continue;
        isDone[link.triangle] = 1;
        isTurned[link.triangle] = isTurned[t] ^ Number(link.differs);
        front.push(link.triangle);
      }
    }
  }
  triangles.forEach((corners, t) => {
    if (isTurned[t]) [corners[1], corners[2]] = [corners[2], corners[1]];
  });
}

/** The corners of a simplex as the model has them: facets as seen from outside. */
function cornersOf(simplices: Simplices, simplex: number): number[] {
  const width = simplices.dimension + 1;
  return [...simplices.corners.subarray(width * simplex, width * (simplex + 1))];
}

const ascending = (numbers: number[]) => numbers.sort((a, b) => a - b);

export function shapeMesh(snapshot: Snapshot, index: number): ShapeMesh {
  const D = snapshot.facts.dimension;
  const [regular, singular]: number[][][] = [[], []];
  const mesh: ShapeMesh = {
    index,
    rows: [],
    coordinates: new Float64Array(0),
    triangles: [],
    triangleRoles: [],
    edges: [],
    edgeRoles: [],
    isolated: [],
  };
  const facets = snapshot.simplices[D - 1];
  for (let f = 0; f < facets.count; ++f) {
    const role = roleAt(facets, f, index);
    if (role !== 'regular' && role !== 'singular') continue;
    const corners = role === 'regular' ? cornersOf(facets, f) : ascending(cornersOf(facets, f));
    if (D === 2) {
      mesh.edges.push(corners);
      mesh.edgeRoles.push(role);
    } else {
      (role === 'regular' ? regular : singular).push(corners);
    }
  }
  orientAlike(singular);
  mesh.triangles = [...regular, ...singular];
  mesh.triangleRoles = mesh.triangles.map((_, i) => (i < regular.length ? 'regular' : 'singular'));
  if (D === 3) {
    const edges = snapshot.simplices[1];
    for (let e = 0; e < edges.count; ++e) {
      if (roleAt(edges, e, index) === 'singular') mesh.edges.push(ascending(cornersOf(edges, e)));
    }
    mesh.edgeRoles = mesh.edges.map(() => 'singular');
  }
  const vertices = snapshot.simplices[0];
  for (let v = 0; v < vertices.count; ++v) {
    if (roleAt(vertices, v, index) === 'singular') mesh.isolated.push(v);
  }
  numberVertices(mesh, snapshot);
  return mesh;
}

/** Gives numbers to the vertices that are used, in their order. */
function numberVertices(mesh: ShapeMesh, snapshot: Snapshot): void {
  const D = snapshot.facts.dimension;
  const number = new Int32Array(snapshot.simplices[0].count).fill(-1);
  for (const corners of [...mesh.triangles, ...mesh.edges]) for (const v of corners) number[v] = 0;
  for (const v of mesh.isolated) number[v] = 0;
  number.forEach((isUsed, v) => {
    if (isUsed < 0) return;
    number[v] = mesh.rows.length;
    mesh.rows.push(snapshot.vertexRows[v]);
  });
  mesh.coordinates = new Float64Array(3 * mesh.rows.length);
  mesh.rows.forEach((row, v) => {
    for (let axis = 0; axis < D; ++axis)
      mesh.coordinates[3 * v + axis] = snapshot.coordinates[D * row + axis];
  });
  for (const corners of [...mesh.triangles, ...mesh.edges]) {
    corners.forEach((v, i) => (corners[i] = number[v]));
  }
  mesh.isolated = mesh.isolated.map((v) => number[v]);
}
