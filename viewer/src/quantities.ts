// SPDX-License-Identifier: MIT
//
// Everything that can be plotted against alpha: what the snapshot holds for every index, and the
// numbers of simplices by role, which follow from their indices.

import type { Role, Snapshot } from './types';

const kNouns = ['vertices', 'edges', 'triangles', 'tetrahedra'] as const;

/** A signature: its name in the program's tables, in words, and its values. */
export interface Quantity {
  name: string;
  title: string;
  /** Power of the unit of length; null for counts. */
  power: number | null;
  /** [index]: 0..s. */
  values: () => ArrayLike<number>;
}

/** The values at index 1 on, with 0 for the empty complex before them. */
function fromZero(values: ArrayLike<number>): Float64Array {
  const all = new Float64Array(values.length + 1);
  all.set(values, 1);
  return all;
}

/** [index]: how many simplices of a dimension have a role. */
export function roleCounts(snapshot: Snapshot, dimension: number, role: Role): Float64Array {
  const { enters, regular, interior } = snapshot.simplices[dimension];
  const counts = new Float64Array(snapshot.facts.spectrum_size + 2);
  const [from, to] = {
    exterior: [null, enters],
    singular: [enters, regular],
    regular: [regular, interior],
    interior: [interior, null],
  }[role];
  if (from) for (const index of from) ++counts[index];
  else counts[0] = enters.length;
  if (to) for (const index of to) --counts[index];
  for (let i = 1; i < counts.length; ++i) counts[i] += counts[i - 1];
  return counts.subarray(0, -1);
}

function eulerNumbers(snapshot: Snapshot): Float64Array {
  const values = new Float64Array(snapshot.facts.spectrum_size + 1);
  snapshot.betti.forEach((betti, k) => {
    for (let i = 0; i < betti.length; ++i) values[i + 1] += k % 2 === 0 ? betti[i] : -betti[i];
  });
  return values;
}

function twoSidedArea(snapshot: Snapshot): Float64Array {
  return fromZero(snapshot.areaRegular).map((regular, i) =>
    i === 0 ? 0 : regular + 2 * snapshot.areaSingular[i - 1],
  );
}

/** Keeps what `make` gives, made when it is first wanted. */
function once<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => (made ??= make());
}

/** All quantities of a snapshot, in the order in which they are offered. */
export function quantitiesOf(snapshot: Snapshot): Quantity[] {
  const D = snapshot.facts.dimension;
  const inSpace = D === 3;
  const bettiTitles = inSpace ? ['Components', 'Tunnels', 'Voids'] : ['Components', 'Holes'];
  const quantities: Quantity[] = snapshot.betti.map((betti, k) => ({
    name: `betti_${k}`,
    title: bettiTitles[k],
    power: null,
    values: once(() => fromZero(betti)),
  }));
  const add = (
    name: string,
    title: string,
    power: number | null,
    values: () => ArrayLike<number>,
  ) => quantities.push({ name, title, power, values: once(values) });
  add('volume', inSpace ? 'Volume' : 'Area', D, () => fromZero(snapshot.volume));
  add('area', inSpace ? 'Surface area, both sides' : 'Perimeter, both sides', D - 1, () =>
    twoSidedArea(snapshot),
  );
  add(
    'area_regular',
    inSpace ? 'Area of the regular part' : 'Length of the regular part',
    D - 1,
    () => fromZero(snapshot.areaRegular),
  );
  add(
    'area_singular',
    inSpace ? 'Area of the singular part' : 'Length of the singular part',
    D - 1,
    () => fromZero(snapshot.areaSingular),
  );
  if (inSpace) add('length', 'Length: 4π × mean width', 1, () => fromZero(snapshot.length));
  add('euler', 'Euler number', null, () => eulerNumbers(snapshot));
  for (const role of ['singular', 'regular', 'interior', 'exterior'] as const) {
    const word = role[0].toUpperCase() + role.slice(1);
    for (let k = 0; k <= D; ++k) {
      const isPossible = k < D || role === 'interior' || role === 'exterior';
      if (isPossible || snapshot.facts.affine_dimension < D) {
        add(`${role}_${k}`, `${word} ${kNouns[k]}`, null, () => roleCounts(snapshot, k, role));
      }
    }
  }
  return quantities;
}
