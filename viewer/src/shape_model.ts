// SPDX-License-Identifier: MIT
//
// A snapshot made ready for drawing: points in scene units, and the simplices by role at a current
// index. Knows nothing of how it is drawn.

import { ComplexMesh, kFaces, kQuad, kTriangle } from './complex_mesh';
import { kNone, type Role, type Snapshot } from './types';

function extentOf(coordinates: Float64Array, D: number): { centre: number[]; size: number } {
  const low = new Array<number>(D).fill(Infinity);
  const high = new Array<number>(D).fill(-Infinity);
  for (let i = 0; i < coordinates.length; ++i) {
    low[i % D] = Math.min(low[i % D], coordinates[i]);
    high[i % D] = Math.max(high[i % D], coordinates[i]);
  }
  if (coordinates.length === 0) return { centre: [0, 0, 0], size: 1 };
  const centre = low.map((x, axis) => x / 2 + high[axis] / 2);
  const size = Math.hypot(...low.map((x, axis) => high[axis] / 2 - x / 2));
  while (centre.length < 3) centre.push(0);
  return { centre, size: size > 0 && Number.isFinite(size) ? size : 1 };
}

export class ShapeModel {
  /** Scene units per unit of length: the sites' box has a half diagonal of 1. */
  readonly scale: number;
  /** Of the box, input units. */
  readonly centre: readonly number[];
  /**
   * [4 * point + i]: x, y, z and the weight, scene units. Points are the vertices, then the hidden
   * sites.
   */
  readonly points: Float32Array<ArrayBuffer>;
  readonly pointCount: number;
  readonly isPlanar: boolean;
  /** [dimension]: vertices, edges and triangles of the complex, as they are always drawn. */
  readonly meshes: readonly ComplexMesh[];
  private readonly extra = new Map<number, ComplexMesh>();
  index = 0;
  /** Simplices looked at by the last move. */
  touched = 0;
  private readonly never: number;

  constructor(readonly snapshot: Snapshot) {
    const { facts, coordinates, weights, vertexRows, hidden, simplices } = snapshot;
    const D = facts.dimension;
    const { centre, size } = extentOf(coordinates, D);
    this.isPlanar = D === 2;
    this.centre = centre;
    this.scale = 1 / size;
    this.pointCount = vertexRows.length + hidden.length;
    this.points = new Float32Array(4 * this.pointCount);
    for (let p = 0; p < this.pointCount; ++p) {
      const row = this.rowOf(p);
      for (let axis = 0; axis < D; ++axis) {
        this.points[4 * p + axis] = (coordinates[D * row + axis] - centre[axis]) * this.scale;
      }
      this.points[4 * p + 3] = weights.length > 0 ? weights[row] * this.scale * this.scale : 0;
    }
    this.never = facts.spectrum_size + 1;
    const mesh = (k: number, roles: Role[]) =>
      new ComplexMesh(simplices[k], k === 2 ? kTriangle : kQuad, this.never, roles);
    this.meshes = [
      mesh(0, ['singular', 'regular']),
      mesh(1, D === 2 ? ['singular', 'regular'] : ['singular']),
      mesh(2, ['singular', 'regular', 'interior']),
    ];
  }

  /** What squared radii grow by at an alpha2, scene units; finite also where that is not. */
  grown(alpha2: number): number {
    return Math.min(1e6, Math.max(-1e6, alpha2 * this.scale ** 2));
  }

  /** The input row of a point. */
  rowOf(point: number): number {
    const { vertexRows, hidden } = this.snapshot;
    return point < vertexRows.length ? vertexRows[point] : hidden[point - vertexRows.length];
  }

  /** All simplices of the complex of a dimension by themselves, listed from now on. */
  allOf(dimension: number): ComplexMesh {
    let mesh = this.extra.get(dimension);
    if (!mesh) {
      // As if they were inside as soon as they are there.
      const { corners, enters, count } = this.snapshot.simplices[dimension];
      const simplices = { dimension, count, corners, enters, regular: enters, interior: enters };
      const pattern = [kQuad, kQuad, kTriangle, kFaces][dimension];
      mesh = new ComplexMesh(simplices, pattern, this.never, ['interior']);
      mesh.moveTo(this.index);
      this.extra.set(dimension, mesh);
    }
    return mesh;
  }

  moveTo(index: number): void {
    this.index = index;
    this.touched = 0;
    for (const mesh of [...this.meshes, ...this.extra.values()]) this.touched += mesh.moveTo(index);
  }

  /** Centres of the orthoballs of triangles, [3 * cell + axis] in scene units; plane only. */
  orthocentres(): Float32Array {
    const { simplices } = this.snapshot;
    const cells = simplices[2];
    const centres = new Float32Array(3 * cells.count);
    for (let c = 0; c < cells.count; ++c) {
      const [a, b, d] = [0, 1, 2].map((i) => 4 * cells.corners[3 * c + i]);
      const p = this.points;
      // |x - a|^2 - wa = |x - b|^2 - wb = |x - d|^2 - wd, with a at the origin.
      const [bx, by, dx, dy] = [p[b] - p[a], p[b + 1] - p[a + 1], p[d] - p[a], p[d + 1] - p[a + 1]];
      const rb = (bx * bx + by * by - p[b + 3] + p[a + 3]) / 2;
      const rd = (dx * dx + dy * dy - p[d + 3] + p[a + 3]) / 2;
      const determinant = bx * dy - by * dx;
      centres[3 * c] = p[a] + (rb * dy - rd * by) / determinant;
      centres[3 * c + 1] = p[a + 1] + (bx * rd - dx * rb) / determinant;
    }
    return centres;
  }

  /** Ends of the edges of the power diagram, pairs of [x, y, z, 0] in scene units; plane only. */
  powerEdges(): Float32Array<ArrayBuffer> {
    const { snapshot, points } = this;
    const edges = snapshot.simplices[1];
    const centres = this.orthocentres();
    const ends = new Float32Array(8 * edges.count);
    if (snapshot.facetOwners.length === 0) return ends;
    for (let e = 0; e < edges.count; ++e) {
      const [owner, neighbour] = [snapshot.facetOwners[e] >>> 2, snapshot.facetNeighbours[e]];
      for (const axis of [0, 1]) ends[8 * e + axis] = centres[3 * owner + axis];
      if (neighbour !== kNone) {
        for (const axis of [0, 1]) ends[8 * e + 4 + axis] = centres[3 * neighbour + axis];
        continue;
      }
      // A ray: out of the hull, across the edge. Its cell lies on the edge's left.
      const [a, b] = [4 * edges.corners[2 * e], 4 * edges.corners[2 * e + 1]];
      const [x, y] = [points[b] - points[a], points[b + 1] - points[a + 1]];
      const long = 20 / Math.max(1e-30, Math.hypot(x, y));
      ends[8 * e + 4] = ends[8 * e] + long * y;
      ends[8 * e + 5] = ends[8 * e + 1] - long * x;
    }
    return ends;
  }
}
