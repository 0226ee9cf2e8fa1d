// SPDX-License-Identifier: MIT
//
// Which simplex lies under a place of the view: the first triangle, ball, edge or point that the
// ray meets, edges and points being as wide as a few pixels.

import type { Vector } from './camera';
import type { SimplexList } from './complex_mesh';
import type { Picked } from './state';

export interface Ray {
  origin: Vector;
  /** Of unit length. */
  direction: Vector;
  /** Half width of edges and points, as a share of the distance from the origin, and at least. */
  widthPerDistance: number;
  width: number;
}

export interface Hit extends Picked {
  distance: number;
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Where points are drawn; what is clipped or moved is nowhere or elsewhere. */
export type Place = (point: number) => Vector;

function nearer(
  best: Hit | null,
  dimension: number,
  simplex: number,
  distance: number,
): Hit | null {
  if (!(distance > 0) || (best && best.distance <= distance)) return best;
  return { dimension, simplex, distance };
}

/** Distance along a ray to a triangle (Möller, Trumbore 1997); NaN where they do not meet. */
function distanceToTriangle(ray: Ray, a: Vector, b: Vector, c: Vector): number {
  const [u, v] = [minus(b, a), minus(c, a)];
  const h = cross(ray.direction, v);
  const determinant = dot(u, h);
  const s = minus(ray.origin, a);
  const q = cross(s, u);
  const [x, y] = [dot(s, h) / determinant, dot(ray.direction, q) / determinant];
  return x >= 0 && y >= 0 && x + y <= 1 ? dot(v, q) / determinant : NaN;
}

export function pickTriangle(
  best: Hit | null,
  ray: Ray,
  list: SimplexList,
  corners: Uint32Array,
  place: Place,
  isSeen: (place: Vector) => boolean,
): Hit | null {
  for (let i = 0; i < list.size; ++i) {
    const t = list.simplices[i];
    const distance = distanceToTriangle(
      ray,
      place(corners[3 * t]),
      place(corners[3 * t + 1]),
      place(corners[3 * t + 2]),
    );
    if (!(distance > 0) || (best && best.distance <= distance)) continue;
    const [o, d] = [ray.origin, ray.direction];
    if (isSeen([o[0] + distance * d[0], o[1] + distance * d[1], o[2] + distance * d[2]])) {
      best = nearer(best, 2, t, distance);
    }
  }
  return best;
}

export function pickEdge(
  best: Hit | null,
  ray: Ray,
  list: SimplexList,
  corners: Uint32Array,
  place: Place,
  isSeen: (place: Vector) => boolean,
): Hit | null {
  for (let i = 0; i < list.size; ++i) {
    const e = list.simplices[i];
    const [a, b] = [place(corners[2 * e]), place(corners[2 * e + 1])];
    // The nearest points of the ray and the edge.
    const [u, w] = [minus(b, a), minus(ray.origin, a)];
    const [uu, ud, uw, dw] = [dot(u, u), dot(u, ray.direction), dot(u, w), dot(ray.direction, w)];
    const determinant = uu - ud * ud;
    const along = determinant > 1e-12 ? Math.min(1, Math.max(0, (uw - ud * dw) / determinant)) : 0;
    const point: Vector = [a[0] + along * u[0], a[1] + along * u[1], a[2] + along * u[2]];
    const toPoint = minus(point, ray.origin);
    const distance = dot(toPoint, ray.direction);
    const miss = Math.sqrt(Math.max(0, dot(toPoint, toPoint) - distance * distance));
    if (miss > Math.max(ray.width, ray.widthPerDistance * distance) || !isSeen(point)) continue;
    // A wide edge covers what it bounds.
    best = nearer(best, 1, e, distance - 0.002);
  }
  return best;
}

/** @param radiusOf  0 for a point as wide as edges are. */
export function pickBall(
  best: Hit | null,
  ray: Ray,
  points: Iterable<number>,
  place: Place,
  radiusOf: (point: number) => number,
  isSeen: (place: Vector) => boolean,
): Hit | null {
  for (const p of points) {
    const centre = place(p);
    const toCentre = minus(centre, ray.origin);
    const along = dot(toCentre, ray.direction);
    const own = radiusOf(p);
    if (Number.isNaN(own)) continue;
    const radius = own || Math.max(ray.width, ray.widthPerDistance * along);
    const half2 = radius * radius - (dot(toCentre, toCentre) - along * along);
    if (half2 < 0 || !isSeen(centre)) continue;
    best = nearer(best, 0, p, along - Math.sqrt(half2) - (own ? 0 : 0.003));
  }
  return best;
}
