// SPDX-License-Identifier: MIT
//
// A view as a link: what differs from the first look, in the fragment of the page's address.

import type { Camera } from './camera';
import {
  atAlpha2,
  atIndex,
  kColours,
  kExplodedParts,
  kLayers,
  type Colour,
  type ExplodedPart,
  type Layer,
  type State,
} from './state';
import { beginOf, lifeBegunBy } from './persistence';
import type { Snapshot } from './types';

const kWords = {
  projection: ['perspective', 'orthographic'],
  clipAxis: ['off', 'x', 'y', 'z', 'view'],
  theme: ['system', 'light', 'dark'],
  background: ['plain', 'white', 'black'],
  plotAxis: ['alpha', 'alpha2', 'index'],
  plotScale: ['linear', 'log'],
  valueScale: ['linear', 'log'],
  colour: kColours,
  explodedPart: kExplodedParts,
} as const satisfies Partial<Record<keyof State, readonly string[]>>;
const kNumbers = { opacity: [0, 1], clipPlace: [-1, 1], explosion: [0, 1] } as const;

type WordKey = keyof typeof kWords;
type NumberKey = keyof typeof kNumbers;

const short = (x: number) => String(Number(x.toPrecision(6)));

/** "#index=12&colour=element&camera=..."; empty for the first look. */
export function linkText(state: State, start: State, camera: Camera | null): string {
  const parts = new URLSearchParams();
  if (state.index !== start.index) parts.set('index', String(state.index));
  if (state.alpha2 !== start.alpha2 && Number.isFinite(state.alpha2))
    parts.set('alpha2', String(state.alpha2));
  for (const key of Object.keys(kWords) as WordKey[]) {
    if (state[key] !== start[key]) parts.set(key, state[key]);
  }
  for (const key of Object.keys(kNumbers) as NumberKey[]) {
    if (state[key] !== start[key]) parts.set(key, short(state[key]));
  }
  const layers = [...state.layers].sort().join(' ');
  if (layers !== [...start.layers].sort().join(' ')) parts.set('show', layers);
  if (state.panels.join(' ') !== start.panels.join(' '))
    parts.set('panels', state.panels.join(' '));
  if (state.diagram !== start.diagram) parts.set('diagram', state.diagram ? 'shown' : 'hidden');
  if (state.picked) parts.set('picked', `${state.picked.dimension} ${state.picked.simplex}`);
  if (state.shownClass)
    parts.set('class', `${state.shownClass.dimension} ${state.shownClass.simplex}`);
  if (camera)
    parts.set(
      'camera',
      [...camera.target, ...camera.turn, camera.distance]
        .map((x) => Number(x.toPrecision(10)))
        .join(' '),
    );
  const text = parts.toString();
  return text ? `#${text}` : '';
}

function cameraOf(text: string | null): Camera | null {
  const numbers = (text ?? '').split(' ').map(Number);
  if (numbers.length !== 8 || numbers.some((x) => !Number.isFinite(x))) return null;
  const [tx, ty, tz, x, y, z, w, distance] = numbers;
  const length = Math.hypot(x, y, z, w);
  if (length < 1e-6 || distance <= 0) return null;
  return { target: [tx, ty, tz], turn: [x / length, y / length, z / length, w / length], distance };
}

/** The state that a fragment asks for; what makes no sense in it is passed over. */
export function stateFromLink(
  start: State,
  snapshot: Snapshot,
  fragment: string,
): { state: State; camera: Camera | null } {
  const parts = new URLSearchParams(fragment.replace(/^#/, ''));
  let state = { ...start };
  const index = Number(parts.get('index') ?? NaN);
  if (Number.isInteger(index)) state = atIndex(state, snapshot, index);
  const alpha2 = Number(parts.get('alpha2') ?? NaN);
  if (Number.isFinite(alpha2)) {
    // An index says more than its label, which others may share.
    const byAlpha2 = atAlpha2(state, snapshot, alpha2);
    state = Number.isInteger(index) ? { ...state, alpha2 } : byAlpha2;
  }
  for (const key of Object.keys(kWords) as WordKey[]) {
    const word = parts.get(key);
    const words: readonly string[] = kWords[key];
    if (word !== null && words.includes(word))
      state = { ...state, [key]: word as Colour | ExplodedPart };
  }
  for (const key of Object.keys(kNumbers) as NumberKey[]) {
    const number = Number(parts.get(key) ?? NaN);
    const [least, most] = kNumbers[key];
    if (number >= least && number <= most) state = { ...state, [key]: number };
  }
  const layers = parts.get('show');
  if (layers !== null) {
    const named = layers.split(' ');
    state = { ...state, layers: kLayers.filter((layer: Layer) => named.includes(layer)) };
  }
  const diagram = parts.get('diagram');
  if (diagram !== null) state = { ...state, diagram: diagram === 'shown' };
  const panels = parts.get('panels');
  if (panels) state = { ...state, panels: panels.split(' ').slice(0, 5) };
  const [dimension, simplex] = (parts.get('picked') ?? '').split(' ').map(Number);
  const count =
    dimension === 0
      ? snapshot.vertexRows.length + snapshot.hidden.length
      : snapshot.simplices[dimension]?.count;
  if (Number.isInteger(simplex) && simplex >= 0 && simplex < count) {
    state = { ...state, picked: { dimension, simplex } };
  }
  const [k, begun] = (parts.get('class') ?? '').split(' ').map(Number);
  const life = lifeBegunBy(snapshot, { dimension: k, simplex: begun });
  if (life) state = { ...state, shownClass: beginOf(life) };
  return { state, camera: cameraOf(parts.get('camera')) };
}
