// SPDX-License-Identifier: MIT
//
// What is known of atoms: bonds and the backbone for orientation, and who an atom is.

import type { LabelName, Snapshot } from './types';

/** The word of a row among its labels; empty where the input does not say. */
export function labelOf(snapshot: Snapshot, name: LabelName, row: number): string {
  const labels = snapshot.labels[name];
  return labels ? labels.words[labels.codes[row]] : '';
}

/** "CA of ALA 12, chain A"; empty for points. */
export function atomName(snapshot: Snapshot, row: number): string {
  const label = (name: LabelName) => labelOf(snapshot, name, row);
  const atom = label('atom') || label('element');
  const residue = [label('residue'), label('residue_id')].filter(Boolean).join(' ');
  const chain = label('chain');
  return [atom && residue ? `${atom} of ${residue}` : atom, chain && `chain ${chain}`]
    .filter(Boolean)
    .join(', ');
}

// Covalent radii in ångström: Cordero et al., Covalent radii revisited, Dalton Trans. (2008).
const kCovalentRadii: Record<string, number> = {
  H: 0.31,
  D: 0.31,
  B: 0.84,
  C: 0.76,
  N: 0.71,
  O: 0.66,
  F: 0.57,
  Na: 1.66,
  Mg: 1.41,
  Al: 1.21,
  Si: 1.11,
  P: 1.07,
  S: 1.05,
  Cl: 1.02,
  K: 2.03,
  Ca: 1.76,
  Mn: 1.39,
  Fe: 1.32,
  Co: 1.26,
  Ni: 1.24,
  Cu: 1.32,
  Zn: 1.22,
  Se: 1.2,
  Br: 1.2,
  I: 1.39,
};
const kTolerance = 0.45; // of bond lengths, as most programs of molecules have it

function distance(snapshot: Snapshot, a: number, b: number): number {
  const x = snapshot.coordinates;
  return Math.hypot(x[3 * a] - x[3 * b], x[3 * a + 1] - x[3 * b + 1], x[3 * a + 2] - x[3 * b + 2]);
}

/** Pairs of vertices that are bonded: edges of the triangulation as long as a covalent bond. */
export function bondsOf(snapshot: Snapshot): Uint32Array {
  const bonds: number[] = [];
  if (snapshot.facts.weights !== 'molecule_radii' || snapshot.facts.dimension !== 3) {
    return new Uint32Array(0);
  }
  const radius = (row: number) => kCovalentRadii[labelOf(snapshot, 'element', row)] ?? 1.3;
  const isHydrogen = (row: number) => /^[HD]$/.test(labelOf(snapshot, 'element', row));
  const { corners, count } = snapshot.simplices[1];
  for (let e = 0; e < count; ++e) {
    const [v, w] = [corners[2 * e], corners[2 * e + 1]];
    const [a, b] = [snapshot.vertexRows[v], snapshot.vertexRows[w]];
    if (isHydrogen(a) && isHydrogen(b)) continue;
    if (distance(snapshot, a, b) <= radius(a) + radius(b) + kTolerance) bonds.push(v, w);
  }
  return Uint32Array.from(bonds);
}

/**
 * Pairs of vertices that follow each other in a backbone: alpha carbons of proteins and phosphorus
 * of nucleic acids, in the order of the rows.
 */
export function traceOf(snapshot: Snapshot): Uint32Array {
  const trace: number[] = [];
  if (!snapshot.labels.atom || snapshot.facts.dimension !== 3) return new Uint32Array(0);
  const vertexOfRow = new Map<number, number>();
  snapshot.vertexRows.forEach((row, v) => vertexOfRow.set(row, v));
  let last = -1;
  for (let row = 0; row < snapshot.facts.sites; ++row) {
    const atom = labelOf(snapshot, 'atom', row);
    const element = labelOf(snapshot, 'element', row);
    const isAlphaCarbon = atom === 'CA' && element === 'C';
    const isPhosphorus = atom === 'P' && element === 'P';
    if (!isAlphaCarbon && !isPhosphorus) continue;
    if (last >= 0 && labelOf(snapshot, 'chain', last) === labelOf(snapshot, 'chain', row)) {
      const [v, w] = [vertexOfRow.get(last), vertexOfRow.get(row)];
      const most = isAlphaCarbon ? 4.5 : 8.5; // Å: neighbours, and no gap
      if (v !== undefined && w !== undefined && distance(snapshot, last, row) < most) {
        trace.push(v, w);
      }
    }
    last = row;
  }
  return Uint32Array.from(trace);
}
