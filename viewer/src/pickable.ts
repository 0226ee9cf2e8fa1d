// SPDX-License-Identifier: MIT
//
// What can be picked: what is seen, of every layer that shows simplices or atoms.

import { isVisible } from './layers';
import type { Pickable } from './picking';
import type { ShapeModel } from './shape_model';
import type { State } from './state';
import type { Role } from './types';

function upTo(count: number): Uint32Array {
  return Uint32Array.from({ length: count }, (_, i) => i);
}

/**
 * What is drawn of a model, by groups: of the first group that the ray meets, the nearest is seen. In
 * the plane every layer is a group, topmost first.
 * @param bonds  pairs of vertices that sticks join.
 */
export function pickables(model: ShapeModel, state: State, bonds: Uint32Array): Pickable[][] {
  const { simplices, facts } = model.snapshot;
  const facet = facts.dimension - 1;
  const isPlanar = facts.dimension === 2;
  const groups: Pickable[][] = [];
  const points = upTo(model.pointCount);
  const vertices = points.subarray(0, simplices[0].count);
  const listed = (dimension: number, role: Role) => () => {
    const list = model.meshes[dimension].list(role);
    return list.simplices.subarray(0, list.size);
  };
  const growth = model.grown(state.alpha2);
  const ball = (point: number) => model.points[4 * point + 3] + growth;
  const add = (
    name: string,
    dimension: number,
    members: () => Uint32Array,
    radius2: Pickable['radius2'] = null,
  ) => {
    if (!isVisible(name, state)) return;
    const corners = dimension > 0 ? simplices[dimension].corners : points;
    const pickable = { dimension, members: members(), corners, radius2 };
    const isBehind = isPlanar || name === 'wireframe' || groups.length === 0;
    if (isBehind) groups.push([pickable]);
    else groups[0].push(pickable);
  };
  for (let k = 0; k <= facts.dimension; ++k) {
    add(`apart_${k}`, k, () => {
      const list = model.allOf(k).list('interior');
      return list.simplices.subarray(0, list.size);
    });
  }
  add('singular_vertices', 0, listed(0, 'singular'));
  add('points', 0, () => points);
  add('regular', facet, listed(facet, 'regular'));
  add('singular_triangles', 2, listed(2, 'singular'));
  add('singular_edges', 1, listed(1, 'singular'));
  add('interior', 2, listed(2, 'interior'));
  add('singular_balls', 0, listed(0, 'singular'), ball);
  add('regular_balls', 0, listed(0, 'regular'), ball);
  add('all_balls', 0, () => vertices, ball);
  add('sticks', 0, () => Uint32Array.from(new Set(bonds)));
  add('wireframe', 1, () => upTo(simplices[1].count));
  return groups;
}
