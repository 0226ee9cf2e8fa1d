// SPDX-License-Identifier: MIT
//
// Which simplex lies under a place of the view: the first triangle, ball, edge or point that the
// ray meets where it is not clipped, edges and points being as wide as a few pixels.

import { dot, type Vector } from './camera';
import type { Picked } from './state';

export interface Ray {
  origin: Vector;
  /** Of unit length. */
  direction: Vector;
  /** Half width of edges and points: a share of the distance from the origin, and at least so much. */
  widthPerDistance: number;
  width: number;
}

/** Simplices of one dimension that can be picked. */
export interface Pickable {
  dimension: number;
  members: Uint32Array;
  /** [(dimension + 1) * member + corner]: points. */
  corners: Uint32Array;
  /** Of points, squared; null for points as wide as edges are. What is not positive is not there. */
  radius2: ((point: number) => number) | null;
}

/** Where things are drawn. */
export interface Placement {
  place: (point: number) => Vector;
  /** How far every simplex moves by itself: so many times its middle. */
  spread: number;
  /** What has dot(xyz, p) + w > 0 is not seen. */
  clip: readonly [number, number, number, number];
}

interface Hit extends Picked {
  distance: number;
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const along = (ray: Ray, t: number): Vector => [
  ray.origin[0] + t * ray.direction[0],
  ray.origin[1] + t * ray.direction[1],
  ray.origin[2] + t * ray.direction[2],
];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** How far a point is above the plane that clips. */
function above([x, y, z, w]: Placement['clip'], p: Vector): number {
  return x * p[0] + y * p[1] + z * p[2] + w;
}

/** Distance along a ray to a triangle (Möller, Trumbore 1997); NaN where they do not meet. */
function toTriangle(ray: Ray, { clip }: Placement, [a, b, c]: readonly Vector[]): number {
  const [u, v] = [minus(b, a), minus(c, a)];
  const h = cross(ray.direction, v);
  const determinant = dot(u, h);
  const s = minus(ray.origin, a);
  const x = dot(s, h) / determinant;
  if (!(x >= 0 && x <= 1)) return NaN;
  const q = cross(s, u);
  const y = dot(ray.direction, q) / determinant;
  if (!(y >= 0 && x + y <= 1)) return NaN;
  const distance = dot(v, q) / determinant;
  return above(clip, along(ray, distance)) > 0 ? NaN : distance;
}

function toEdge(ray: Ray, { clip }: Placement, [a, b]: readonly Vector[]): number {
  const [u, w] = [minus(b, a), minus(ray.origin, a)];
  const [uu, ud, uw, dw] = [dot(u, u), dot(u, ray.direction), dot(u, w), dot(ray.direction, w)];
  const determinant = uu - ud * ud;
  const share = determinant > 1e-12 ? Math.min(1, Math.max(0, (uw - ud * dw) / determinant)) : 0;
  const nearest: Vector = [a[0] + share * u[0], a[1] + share * u[1], a[2] + share * u[2]];
  const toNearest = minus(nearest, ray.origin);
  const distance = dot(toNearest, ray.direction);
  const miss = Math.sqrt(Math.max(0, dot(toNearest, toNearest) - distance * distance));
  const isNear = miss <= Math.max(ray.width, ray.widthPerDistance * distance);
  // A wide edge covers what it bounds.
  return isNear && above(clip, nearest) <= 0 ? distance - 0.002 : NaN;
}

/** A ball is cut open by the plane: behind it the ray meets the disk of the cut. */
function toBall(ray: Ray, { clip }: Placement, centre: Vector, radius2: number): number {
  const toCentre = minus(centre, ray.origin);
  const middle = dot(toCentre, ray.direction);
  const half2 = radius2 - (dot(toCentre, toCentre) - middle * middle);
  if (!(half2 >= 0)) return NaN;
  const [enter, leave] = [middle - Math.sqrt(half2), middle + Math.sqrt(half2)];
  const outside = above(clip, along(ray, enter));
  if (outside <= 0) return enter;
  const cut =
    enter -
    outside /
      (clip[0] * ray.direction[0] + clip[1] * ray.direction[1] + clip[2] * ray.direction[2]);
  return cut > enter && cut < leave ? cut : NaN;
}

function toPoint(ray: Ray, placement: Placement, centre: Vector): number {
  const width = Math.max(
    ray.width,
    ray.widthPerDistance * dot(minus(centre, ray.origin), ray.direction),
  );
  return above(placement.clip, centre) > 0
    ? NaN
    : toBall(ray, placement, centre, width * width) - 0.003;
}

const kFaces = [
  [1, 2, 3],
  [0, 3, 2],
  [0, 1, 3],
  [0, 2, 1],
];

function toSimplex(ray: Ray, placement: Placement, places: Vector[]): number {
  switch (places.length) {
    case 1:
      return toPoint(ray, placement, places[0]);
    case 2:
      return toEdge(ray, placement, places);
    case 3:
      return toTriangle(ray, placement, places);
    default: {
      let nearest = NaN;
      for (const face of kFaces) {
        const distance = toTriangle(
          ray,
          placement,
          face.map((corner) => places[corner]),
        );
        if (!(distance >= nearest)) nearest = Number.isNaN(distance) ? nearest : distance;
      }
      return nearest;
    }
  }
}

/** Moves a simplex by itself away from the middle of the scene. */
function spreadOut(places: Vector[], spread: number): Vector[] {
  const middle = [0, 1, 2].map(
    (axis) => places.reduce((sum, p) => sum + p[axis], 0) / places.length,
  );
  return places.map((p) => [
    p[0] + spread * middle[0],
    p[1] + spread * middle[1],
    p[2] + spread * middle[2],
  ]);
}

/** The first that the ray meets; null for none. */
export function pick(
  ray: Ray,
  pickables: readonly Pickable[],
  placement: Placement,
): Picked | null {
  let best: Hit | null = null;
  for (const { dimension, members, corners, radius2 } of pickables) {
    const width = dimension + 1;
    for (const simplex of members) {
      let places: Vector[] = [];
      for (let c = 0; c < width; ++c) places.push(placement.place(corners[width * simplex + c]));
      if (placement.spread > 0) places = spreadOut(places, placement.spread);
      const distance = radius2
        ? toBall(ray, placement, places[0], radius2(simplex))
        : toSimplex(ray, placement, places);
      if (distance > 0 && !(best && best.distance <= distance)) {
        best = { dimension, simplex, distance };
      }
    }
  }
  return best && { dimension: best.dimension, simplex: best.simplex };
}
