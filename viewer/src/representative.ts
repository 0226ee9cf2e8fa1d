// SPDX-License-Identifier: MIT
//
// What makes a class of cycles, at an index of its life: of a component its vertices, of a void what
// encloses it (in the plane a hole's cells, too), of a tunnel a cycle that the snapshot has and the
// triangle that fills it. And the other way round: of which classes a simplex is a part.

import { componentsAt, voidsAt } from './connections';
import { isAlive, livesOf, type Life } from './persistence';
import type { Picked } from './state';
import { kNone, type Snapshot } from './types';

/** [dimension]: simplices of it. */
export type Representative = [vertices: number[], edges: number[], triangles: number[]];

/** The number of the cycle around a tunnel; -1 where the snapshot has none. */
function cycleOf({ cycles, persistence }: Snapshot, { begun }: Life): number {
  return cycles.pairs.findIndex((pair) => persistence[1][2 * pair] === begun);
}

function edgesOf({ cycles }: Snapshot, cycle: number): number[] {
  return [...cycles.edges.subarray(cycle === 0 ? 0 : cycles.ends[cycle - 1], cycles.ends[cycle])];
}

/** The facets that have one side in a group of cells, and those cells. */
function walls(snapshot: Snapshot, of: Uint32Array, group: number): [number[], number[]] {
  const { facetOwners, facetNeighbours } = snapshot;
  const facets: number[] = [];
  facetOwners.forEach((owner, facet) => {
    const beyond = facetNeighbours[facet];
    const isOneIn = of[owner >>> 2] === group;
    if (isOneIn !== (beyond !== kNone && of[beyond] === group)) facets.push(facet);
  });
  const cells: number[] = [];
  of.forEach((its, cell) => {
    if (its === group) cells.push(cell);
  });
  return [facets, cells];
}

/** What makes a class; empty where it does not live, or where that is not known. */
export function representativeOf(snapshot: Snapshot, life: Life, index: number): Representative {
  if (!isAlive(life, index)) return [[], [], []];
  const { dimension: D } = snapshot.facts;
  if (life.dimension === 0) {
    const { of } = componentsAt(snapshot, index);
    const vertices: number[] = [];
    of.forEach((group, v) => {
      if (group === of[life.begun]) vertices.push(v);
    });
    return [vertices, [], []];
  }
  if (life.dimension === D - 1) {
    const { of } = voidsAt(snapshot, index);
    if (of.length === 0) return [[], [], []];
    const [facets, cells] = walls(snapshot, of, of[life.ended]);
    return D === 2 ? [[], facets, cells] : [[], [], facets];
  }
  const cycle = cycleOf(snapshot, life);
  return cycle < 0 ? [[], [], []] : [[], edgesOf(snapshot, cycle), [life.ended]];
}

const isBegunOrEndedBy = ({ dimension, begun, ended }: Life, picked: Picked) =>
  (dimension === picked.dimension && begun === picked.simplex) ||
  (dimension === picked.dimension - 1 && ended === picked.simplex);

function longestFirst(snapshot: Snapshot, lives: Iterable<Life>): Life[] {
  const { spectrum } = snapshot;
  const alpha2 = (index: number) => (index > spectrum.length ? Infinity : spectrum[index - 1]);
  const length = ({ birth, death }: Life) => alpha2(death) - alpha2(birth);
  return [...lives].sort((a, b) => length(b) - length(a) || a.begun - b.begun);
}

/**
 * The tunnels in space that live at an index and have an edge or a vertex in their cycles, or that a
 * simplex begins or ends; the longest life first.
 */
export function tunnelsOf(snapshot: Snapshot, picked: Picked, index: number): Life[] {
  const { simplices, facts, cycles, persistence } = snapshot;
  const { dimension, simplex } = picked;
  if (facts.dimension === 2) return [];
  const edges = simplices[1].corners;
  const begun = new Set<number>();
  cycles.pairs.forEach((pair, cycle) => {
    const isIn = edgesOf(snapshot, cycle).some((edge) =>
      dimension === 0
        ? edges[2 * edge] === simplex || edges[2 * edge + 1] === simplex
        : dimension === 1 && edge === simplex,
    );
    if (isIn) begun.add(persistence[1][2 * pair]);
  });
  const isOf = (life: Life) =>
    life.dimension === 1 &&
    isAlive(life, index) &&
    (begun.has(life.begun) || isBegunOrEndedBy(life, picked));
  return longestFirst(snapshot, livesOf(snapshot).filter(isOf));
}

/** The voids (in the plane holes) that live at an index and have a facet or a cell. */
export function voidsOf(snapshot: Snapshot, picked: Picked, index: number): Life[] {
  const { dimension, simplex } = picked;
  const D = snapshot.facts.dimension;
  const { facetOwners, facetNeighbours } = snapshot;
  if (dimension < D - 1 || facetOwners.length === 0) return [];
  const { of } = voidsAt(snapshot, index);
  const beside =
    dimension === D ? [simplex] : [facetOwners[simplex] >>> 2, facetNeighbours[simplex]];
  const groups = beside.map((cell) => of[cell] ?? kNone).filter((group) => group !== kNone);
  const isOf = (life: Life) =>
    life.dimension === D - 1 && isAlive(life, index) && groups.includes(of[life.ended]);
  return longestFirst(snapshot, livesOf(snapshot).filter(isOf));
}

/** The component of a simplex at an index. */
function componentsOf(snapshot: Snapshot, { dimension, simplex }: Picked, index: number): Life[] {
  const { enters, corners } = snapshot.simplices[dimension];
  if (enters[simplex] > index) return [];
  const { of } = componentsAt(snapshot, index);
  const vertex = corners[(dimension + 1) * simplex];
  const isOf = (life: Life) =>
    life.dimension === 0 && isAlive(life, index) && of[life.begun] === of[vertex];
  return livesOf(snapshot).filter(isOf);
}

/** All classes that live at an index and have a simplex in what makes them. */
export function classesOf(snapshot: Snapshot, picked: Picked, index: number): Life[] {
  if (picked.simplex >= snapshot.simplices[picked.dimension].count) return []; // hidden
  return [
    ...voidsOf(snapshot, picked, index),
    ...tunnelsOf(snapshot, picked, index),
    ...componentsOf(snapshot, picked, index),
  ];
}
