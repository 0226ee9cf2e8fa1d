// SPDX-License-Identifier: MIT
//
// What is drawn, by name: which of it is seen in a state, and in what colour. Beside the layers that
// people choose from there are the balls on the boundary and all of them, the voids (walls of them; in
// the plane all of a hole), the simplices of one dimension by themselves, "apart_2", for moving apart, and
// the one that was picked, "picked_2", and what makes the class that is shown, "class_1" its edges.

import { kDimensionColours, kRoleColours, type Rgb } from './palette';
import { isShown, kExplodedParts, type Layer, type State } from './state';

/** The dimension of simplices that move apart by themselves; -1 where none do. */
export function dimensionApart(state: State): number {
  return state.explosion > 0 ? kExplodedParts.indexOf(state.explodedPart) - 1 : -1;
}

/** How far things have moved apart: by so many times their distance from the middle. */
export function spreadOf(state: State): number {
  return 1.6 * state.explosion;
}

export function isVisible(name: string, state: State): boolean {
  const apart = dimensionApart(state);
  if (name.startsWith('apart_')) return name === `apart_${apart}`;
  if (name.startsWith('picked_'))
    return (
      name === `picked_${state.picked?.dimension}` &&
      (apart < 0 || apart === state.picked?.dimension)
    );
  if (name.startsWith('class_')) return apart < 0 && state.shownClass !== null;
  if (apart >= 0) return false; // simplices by themselves are seen alone
  if (name === 'voids') return state.colour === 'void';
  const clips = state.clipAxis !== 'off'; // then balls inside are seen too
  if (name === 'singular_balls' || name === 'regular_balls') {
    return isShown(state, 'balls') && !clips;
  }
  if (name === 'all_balls') return isShown(state, 'balls') && clips;
  if (name === 'power_cells') return isShown(state, 'power_cells') && isShown(state, 'balls');
  return isShown(state, name as Layer);
}

/** Of a layer whose simplices all have one colour; null where it is always the same. */
export function plainColour(name: string, state: State, isPlanar: boolean): Rgb | null {
  if (name.endsWith('_balls')) return isPlanar ? [168, 201, 228] : [150, 190, 222];
  const byDimension = state.colour === 'dimension';
  const [vertex, edge, triangle] = kDimensionColours;
  const role = kRoleColours;
  const colours: Record<string, Rgb> = {
    regular: byDimension ? (isPlanar ? edge : triangle) : role.regular,
    singular_triangles: byDimension ? triangle : role.singular,
    interior: byDimension ? triangle : role.interior,
    singular_edges: byDimension ? edge : role.edge,
    singular_vertices: byDimension ? vertex : role.vertex,
  };
  return colours[name] ?? null;
}

/** Layers whose simplices have colours of their own where facets have. */
export function hasOwnColours(name: string, isPlanar: boolean): boolean {
  return (
    ['regular', 'voids'].includes(name) ||
    name === (isPlanar ? 'singular_edges' : 'singular_triangles')
  );
}

/** Layers that have their colour whatever others are coloured by. */
export function keepsColour(name: string): boolean {
  return (
    name.startsWith('picked_') ||
    name.startsWith('class_') || ['points', 'power_cells', 'trace', 'wireframe'].includes(name)
  );
}

/** Colours of layers that are lines and dots between others: they go with what is behind. */
export function lineColours(isDark: boolean): Record<string, Rgb> {
  return isDark
    ? {
        wireframe: [190, 200, 215],
        points: [200, 208, 220],
        trace: [226, 230, 236],
        power_cells: [20, 24, 32],
      }
    : {
        wireframe: [70, 80, 96],
        points: [62, 70, 84],
        trace: [58, 64, 76],
        power_cells: [255, 255, 255],
      };
}
