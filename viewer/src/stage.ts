// SPDX-License-Identifier: MIT
//
// The part of the page in which the shape is seen: keeps model, camera and scene together, answers
// the mouse, fingers and keys, and draws a frame when something has changed.

import {
  broadSide,
  orbited,
  panned,
  rayAt,
  rolled,
  startCamera,
  zoomed,
  type Camera,
  type Vector,
} from './camera';
import { componentsAt, distancesAt } from './connections';
import { dimensionApart, spreadOf } from './layers';
import { bondsOf, traceOf } from './molecule';
import { changesWithIndex, colouringOf, type Colouring, type Rgb } from './palette';
import { lifeBegunBy } from './persistence';
import { pickables } from './pickable';
import { pick } from './picking';
import { representativeOf } from './representative';
import { Scene, type FrameReport } from './scene/scene';
import { ShapeModel } from './shape_model';
import type { Picked, State } from './state';
import { kNone, type Snapshot } from './types';

export interface StageEvents {
  frame: (report: FrameReport) => void;
  picked: (picked: Picked | null) => void;
  coloured: (colouring: Colouring) => void;
  cameraMoved: (camera: Camera) => void;
  /** False while the graphics context is lost. */
  available: (isAvailable: boolean) => void;
}

const kPickPixels = 5;
const kCardWidth = 286; // CSS pixels on the left, which the shape is not to lie under
const kNarrow = 700; // CSS pixels; there it does

export class Stage {
  readonly model: ShapeModel;
  readonly scene: Scene;
  private readonly bonds: Uint32Array;
  /** [4 * point + i]: the way of its component from the middle, and its way from the wave's source. */
  private moves: Float32Array;
  camera: Camera;
  private state: State;
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private moved = 0;
  private frame = 0;
  private settling = 0;
  private coloured = '';
  private offset = '';
  private shownClass = '';
  private background: Rgb = [255, 255, 255];
  private isDark = false;
  private readonly stop = new AbortController();
  private readonly resizes: ResizeObserver;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly snapshot: Snapshot,
    state: State,
    private readonly events: StageEvents,
  ) {
    this.model = new ShapeModel(snapshot);
    this.bonds = bondsOf(snapshot);
    this.moves = new Float32Array(4 * this.model.pointCount);
    this.scene = new Scene(canvas, this.model, this.bonds, traceOf(snapshot));
    this.state = state;
    this.camera = this.firstCamera();
    this.listen();
    this.resizes = new ResizeObserver(() => this.resize());
    this.resizes.observe(canvas);
    this.resize();
    this.show(state);
  }

  private firstCamera(): Camera {
    const { facts } = this.snapshot;
    const { points, pointCount } = this.model;
    const camera = startCamera(
      points,
      pointCount,
      facts.dimension,
      facts.weights === 'molecule_radii',
    );
    const { clientWidth, clientHeight } = this.canvas;
    const narrow = clientHeight / Math.max(1, clientWidth - this.margin());
    return { ...camera, distance: camera.distance * Math.max(1, Math.min(4, narrow)) };
  }

  private margin(): number {
    return this.canvas.clientWidth > kNarrow ? kCardWidth : 0;
  }

  /** Shows another state. */
  show(state: State): void {
    this.state = state;
    if (this.model.index !== state.index) {
      this.model.moveTo(state.index);
      this.scene.updateLists();
    } else if (this.coloured === '') {
      this.scene.updateLists();
    }
    // What takes time for the whole complex waits until the slider rests, but for the first time.
    clearTimeout(this.settling);
    const isSlow = changesWithIndex(state.colour) || state.shownClass !== null;
    if (this.coloured === '' || !isSlow) this.settle();
    else this.settling = window.setTimeout(() => this.settle(), 60);
    this.draw();
  }

  private settle(): void {
    const { state } = this;
    const coloured = `${state.colour} ${changesWithIndex(state.colour) ? state.index : ''}`;
    if (coloured !== this.coloured) {
      this.coloured = coloured;
      const colouring = colouringOf(this.snapshot, state.colour, state.index);
      this.scene.setColouring(colouring, state);
      this.events.coloured(colouring);
    }
    this.showClass();
    const parts = state.explosion > 0 && state.explodedPart === 'components';
    const source =
      state.wave !== null && state.picked
        ? `${state.picked.dimension}.${state.picked.simplex}`
        : '';
    const offset = parts || source ? `${parts} ${source} ${state.index}` : '';
    if (offset !== '' && offset !== this.offset) {
      this.moves = this.movesOf(parts);
      this.scene.setOffsets(this.moves);
    }
    this.offset = offset;
    this.draw();
  }

  // What makes the class that was chosen, where it lives.
  private showClass(): void {
    const life = lifeBegunBy(this.snapshot, this.state.shownClass);
    const shown = life ? `${life.dimension}.${life.begun} ${this.state.index}` : '';
    if (shown === this.shownClass) return;
    this.shownClass = shown;
    if (life) {
      const made = representativeOf(this.snapshot, life, this.state.index);
      this.scene.setClass(made, life.dimension);
    }
  }

  private movesOf(parts: boolean): Float32Array {
    const { points, pointCount } = this.model;
    const offsets = new Float32Array(4 * pointCount);
    if (parts) {
      const { of, count } = componentsAt(this.snapshot, this.state.index);
      const sums = new Float64Array(4 * count);
      of.forEach((group, v) => {
        if (group === kNone) return;
        for (let axis = 0; axis < 3; ++axis) sums[4 * group + axis] += points[4 * v + axis];
        ++sums[4 * group + 3];
      });
      of.forEach((group, v) => {
        if (group === kNone) return;
        for (let axis = 0; axis < 3; ++axis)
          offsets[4 * v + axis] = sums[4 * group + axis] / sums[4 * group + 3];
      });
    }
    const ways = this.waysFromPicked();
    if (ways) ways.forEach((way, v) => (offsets[4 * v + 3] = way));
    return offsets;
  }

  // [vertex]: share of the longest way; 2 for what cannot be reached.
  private waysFromPicked(): Float64Array | null {
    const { picked, wave, index } = this.state;
    if (!picked || wave === null) return null;
    const { corners } = this.snapshot.simplices[picked.dimension];
    const width = picked.dimension + 1;
    const sources = [...corners.subarray(width * picked.simplex, width * (picked.simplex + 1))];
    const positions = new Float32Array(3 * this.snapshot.simplices[0].count);
    for (let v = 0; v < positions.length / 3; ++v) {
      for (let axis = 0; axis < 3; ++axis)
        positions[3 * v + axis] = this.model.points[4 * v + axis];
    }
    const ways = distancesAt(this.snapshot, index, sources, positions);
    let longest = 0;
    for (const way of ways) if (Number.isFinite(way)) longest = Math.max(longest, way);
    return ways.map((way) => (Number.isFinite(way) ? way / (longest || 1) : 2));
  }

  /** What lies behind the shape: its colour is that of what is far. */
  setBackground(background: Rgb, isDark: boolean): void {
    this.background = background;
    this.isDark = isDark;
    this.draw();
  }

  setCamera(camera: Camera): void {
    this.camera = camera;
    this.draw();
  }

  resetCamera(): void {
    this.moveCamera(this.firstCamera());
  }

  /** Looks along an axis, or at the broad side. */
  lookFrom(side: 'front' | 'broad'): void {
    const turn =
      side === 'front'
        ? ([0, 0, 0, 1] as const)
        : broadSide(this.model.points, this.model.pointCount);
    this.moveCamera({ ...this.firstCamera(), turn });
  }

  moveCamera(camera: Camera): void {
    this.setCamera(camera);
    this.events.cameraMoved(camera);
  }

  /** A frame, before the browser paints next. */
  draw(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.drawNow();
    });
  }

  private drawNow(): void {
    if (this.scene.renderer.getContext().isContextLost()) return;
    this.events.frame(this.scene.render(this.state, this.camera, this.background, this.isDark));
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.scene.resize(clientWidth, clientHeight, Math.min(window.devicePixelRatio, 2));
    this.scene.shift = this.margin() / clientWidth;
    this.drawNow();
  }

  /** The view as a picture of so many pixels, on a background or none. */
  async picture(width: number, height: number, background: string | null): Promise<Blob> {
    this.scene.resize(width, height, 1);
    this.scene.shift = 0;
    this.drawNow();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [width, height];
    const context = copy.getContext('2d')!;
    if (background) {
      context.fillStyle = background;
      context.fillRect(0, 0, width, height);
    }
    context.drawImage(this.canvas, 0, 0);
    this.resize();
    return new Promise((resolve, reject) =>
      copy.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large.'))),
        'image/png',
      ),
    );
  }

  private listen(): void {
    const { signal } = this.stop;
    const on = <K extends keyof HTMLElementEventMap>(
      type: K,
      react: (event: HTMLElementEventMap[K]) => void,
    ) => this.canvas.addEventListener(type, react, { signal, passive: false });
    on('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (this.pointers.size === 1) this.moved = 0;
    });
    on('pointermove', (event) => this.drag(event));
    const release = (event: PointerEvent) => {
      const isClick = this.pointers.size === 1 && this.moved < 4 && event.button === 0;
      this.pointers.delete(event.pointerId);
      if (isClick && event.type === 'pointerup')
        this.events.picked(this.pick(event.offsetX, event.offsetY));
    };
    on('pointerup', release);
    on('pointercancel', release);
    on('contextmenu', (event) => event.preventDefault());
    on('dblclick', () => this.resetCamera());
    on('wheel', (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      this.moveCamera(zoomed(this.camera, Math.exp(-0.0015 * lines * event.deltaY)));
    });
    this.canvas.addEventListener(
      'webglcontextlost',
      (event) => {
        event.preventDefault();
        this.events.available(false);
      },
      { signal },
    );
    this.canvas.addEventListener(
      'webglcontextrestored',
      () => {
        this.events.available(true);
        this.coloured = this.shownClass = '';
        this.settle();
        this.drawNow();
      },
      { signal },
    );
  }

  private drag(event: PointerEvent): void {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const [dx, dy] = [event.clientX - pointer.x, event.clientY - pointer.y];
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.moved += Math.hypot(dx, dy);
    const { clientHeight } = this.canvas;
    if (others.length > 0) {
      const [other] = others;
      const before = Math.hypot(pointer.x - other.x, pointer.y - other.y);
      const now = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      const zoomedOne = zoomed(this.camera, before > 0 ? now / before : 1);
      this.moveCamera(panned(zoomedOne, dx / 2 / clientHeight, -dy / 2 / clientHeight));
      return;
    }
    const pans =
      this.model.isPlanar || event.buttons === 2 || event.buttons === 4 || event.shiftKey;
    if (event.ctrlKey || event.altKey || event.metaKey)
      this.moveCamera(rolled(this.camera, -0.008 * dx));
    else if (pans) this.moveCamera(panned(this.camera, dx / clientHeight, -dy / clientHeight));
    else this.moveCamera(orbited(this.camera, 0.008 * dx, 0.008 * dy));
  }

  /** What is seen at a place of the canvas, CSS pixels. */
  pick(x: number, y: number): Picked | null {
    const { state, camera, model } = this;
    const { clientWidth, clientHeight } = this.canvas;
    const isOrthographic = model.isPlanar || state.projection === 'orthographic';
    const pixel = (2 * Math.tan((Math.PI / 180) * 14)) / clientHeight;
    const ray = {
      ...rayAt(
        camera,
        clientWidth / clientHeight,
        isOrthographic,
        (2 * x) / clientWidth - 1 - this.scene.shift,
        1 - (2 * y) / clientHeight,
      ),
      widthPerDistance: isOrthographic ? 0 : kPickPixels * pixel,
      width: isOrthographic ? kPickPixels * pixel * camera.distance : 0,
    };
    const spread = spreadOf(state);
    const isApart = dimensionApart(state) >= 0;
    const parts = isApart ? 0 : spread;
    const { points } = model;
    const { moves } = this;
    const placement = {
      place: (p: number): Vector => [
        points[4 * p] + parts * moves[4 * p],
        points[4 * p + 1] + parts * moves[4 * p + 1],
        points[4 * p + 2] + parts * moves[4 * p + 2],
      ],
      spread: isApart ? spread : 0,
      clip: this.scene.clipPlane(state, camera),
    };
    for (const group of pickables(model, state, this.bonds)) {
      const picked = pick(ray, group, placement);
      if (picked) return picked;
    }
    return null;
  }

  /** What is seen in the middle of the view. */
  pickMiddle(): Picked | null {
    const { clientWidth, clientHeight } = this.canvas;
    return this.pick((clientWidth * (1 + this.scene.shift)) / 2, clientHeight / 2);
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.settling);
    this.stop.abort();
    this.resizes.disconnect();
    this.scene.dispose();
  }
}
