// SPDX-License-Identifier: MIT
//
// Draws a ShapeModel with three.js, which keeps the WebGL state, sends what has changed of buffers and
// textures, and brings all back after a lost context.

import * as three from 'three';

import {
  depthRange,
  dot,
  projectionMatrix,
  rowsOf,
  viewMatrix,
  type Camera,
  type Vector,
} from '../camera';
import { kFaces, kQuad, kTriangle, SimplexList } from '../complex_mesh';
import {
  dimensionApart,
  hasOwnColours,
  isVisible,
  keepsColour,
  lineColours,
  plainColour,
  spreadOf,
} from '../layers';
import {
  kClassColours,
  kDimensionColours,
  kPickedColour,
  kRoleColours,
  type Colouring,
  type Rgb,
} from '../palette';
import type { Representative } from '../representative';
import type { ShapeModel } from '../shape_model';
import { isShown, type State } from '../state';
import { kNone } from '../types';
import { quads, type Drawable } from './drawable';
import { Kinds, unit } from './kinds';

/** WebGL 2 is not there. */
export class NoWebGl extends Error {}

/** What the last frame cost, and what was in it. */
export interface FrameReport {
  /** Sent to the graphics processor since the frame before. */
  bytes: number;
  drawCalls: number;
  /** Until the commands were given; on a software renderer until all is drawn. */
  milliseconds: number;
  /** How many simplices are drawn, by layer. */
  drawn: Record<string, number>;
}

const kPickedPixels = 15;

/** A layer that follows a list of the model. */
interface ListLayer {
  name: string;
  list: SimplexList;
  drawable: Drawable;
}

export class Scene {
  readonly renderer: three.WebGLRenderer;
  private readonly world = new three.Scene();
  private readonly eye = new three.Camera();
  private readonly isPlanar: boolean;
  private readonly kinds: Kinds;
  private readonly lists: ListLayer[] = [];
  /** [dimension]: the simplex that was picked, if any. */
  private readonly picked = [kQuad, kQuad, kTriangle, kFaces].map(
    (pattern) => new SimplexList(pattern, 1),
  );
  private readonly layers: Partial<Record<string, Drawable>> = {};
  /** Of the middle of the view to the right, in half widths. */
  shift = 0;
  /** How many simplices make the class that is shown, by layer. */
  private readonly ofClass: Record<string, number> = {};
  private bytes = 0;
  private width = 1;
  private height = 1;

  /** @throws NoWebGl where the browser does not draw in three dimensions. */
  constructor(
    canvas: HTMLCanvasElement,
    readonly model: ShapeModel,
    bonds: Uint32Array,
    trace: Uint32Array,
  ) {
    const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
    if (!context) throw new NoWebGl('WebGL 2 is not available');
    this.renderer = new three.WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.renderer.outputColorSpace = three.LinearSRGBColorSpace; // shaders give what is displayed
    this.renderer.setClearAlpha(0);
    this.renderer.sortObjects = false;
    this.renderer.info.autoReset = true;
    this.kinds = new Kinds(model, this.renderer.capabilities.maxTextureSize);
    this.isPlanar = this.kinds.isPlanar;
    this.addLayers(bonds, trace);
  }

  private add(name: string, drawable: Drawable): Drawable {
    this.layers[name] = drawable;
    this.world.add(drawable.object);
    return drawable;
  }

  private addList(
    name: string,
    list: SimplexList,
    make: (elements: Uint32Array) => Drawable,
  ): Drawable {
    const drawable = this.add(name, make(list.elements));
    this.lists.push({ name, list, drawable });
    return drawable;
  }

  private addLayers(bonds: Uint32Array, trace: Uint32Array): void {
    const { kinds, isPlanar } = this;
    const { meshes, pointCount, snapshot } = this.model;
    const [vertices, edges, triangles] = meshes;
    const colours = kRoleColours;
    const balls = (pixels: number) => (elements: Uint32Array) =>
      kinds.balls(elements, colours.vertex, pixels);
    // In the order of drawing: in the plane what comes later lies above.
    this.addList('singular_balls', vertices.list('singular'), balls(0));
    this.addList('regular_balls', vertices.list('regular'), balls(0));
    this.add('all_balls', balls(0)(quads(snapshot.simplices[0].count)));
    if (isPlanar) this.add('power_cells', kinds.powerCells());
    this.addList('interior', triangles.list('interior'), (elements) =>
      kinds.triangles(elements, colours.interior),
    );
    this.add('voids', kinds.triangles(new Uint32Array(0), colours.interior));
    this.add('wireframe', kinds.wireframe());
    if (bonds.length > 0) this.add('sticks', kinds.sticks(bonds, [120, 128, 140], 0.14));
    if (trace.length > 0) this.add('trace', kinds.sticks(trace, [52, 58, 70], 0.32));
    this.addList('singular_edges', edges.list('singular'), (elements) =>
      kinds.edges(elements, colours.edge, isPlanar ? 3 : 2.6),
    );
    if (isPlanar)
      this.addList('regular', edges.list('regular'), (elements) =>
        kinds.edges(elements, colours.regular, 4),
      );
    this.addList('singular_triangles', triangles.list('singular'), (elements) =>
      kinds.triangles(elements, colours.singular),
    );
    if (!isPlanar)
      this.addList('regular', triangles.list('regular'), (elements) =>
        kinds.triangles(elements, colours.regular, true),
      );
    const pointSize = !isPlanar ? 4 : pointCount < 600 ? 6 : pointCount < 3000 ? 4 : 2.5;
    this.add('points', kinds.balls(quads(pointCount), [70, 78, 92], pointSize));
    this.addList('singular_vertices', vertices.list('singular'), balls(7));
    for (const dimension of [2, 1, 0]) this.addClassLayer(dimension);
  }

  // Simplices of a dimension, each by itself; points are as wide as three edges.
  private simplices(dimension: number, elements: Uint32Array, colour: Rgb, pixels: number) {
    if (dimension === 0) return this.kinds.balls(elements, colour, 3 * pixels);
    if (dimension === 1) return this.kinds.edges(elements, colour, pixels);
    return this.kinds.triangles(elements, colour, false, dimension === 3);
  }

  // Above everything else, so that it is found. Made when it is first seen. An atom that is seen as a
  // ball is marked as one.
  private showPicked(state: State): void {
    const { picked } = state;
    if (!picked) return;
    const name = `picked_${picked.dimension}`;
    const list = this.picked[picked.dimension];
    if (!this.layers[name]) {
      const drawable = this.simplices(picked.dimension, list.elements, kPickedColour, 6);
      drawable.material.depthTest = drawable.material.depthWrite = false;
      drawable.material.transparent = true;
      drawable.uniforms.opacity.value = 0.85;
      this.add(name, drawable);
    }
    if (picked.dimension === 0) {
      const radius2 = this.model.points[4 * picked.simplex + 3] + this.model.grown(state.alpha2);
      const isBall = isShown(state, 'balls') && dimensionApart(state) < 0 && radius2 > 0;
      this.layers[name]!.uniforms.pixels.value = isBall ? 0 : kPickedPixels;
    }
    if (list.size > 0 && list.simplices[0] === picked.simplex) return;
    list.size = 1;
    list.put(0, picked.simplex);
    this.bytes += this.layers[name]!.update(list);
  }

  // All simplices of a dimension by themselves, for moving apart.
  private addApart(dimension: number): void {
    const list = this.model.allOf(dimension).list('interior');
    const colour = kDimensionColours[dimension];
    this.addList(`apart_${dimension}`, list, (elements) =>
      this.simplices(dimension, elements, colour, 2.6),
    );
  }

  /** CSS pixels, and how many of the device make one. */
  resize(width: number, height: number, pixelRatio: number): void {
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
    this.width = width * pixelRatio;
    this.height = height * pixelRatio;
  }

  get aspect(): number {
    return this.width / this.height;
  }

  /** Takes over the model's current index. Costs what has changed. */
  updateLists(): void {
    for (const { list, drawable } of this.lists) this.bytes += drawable.update(list);
  }

  setColouring(colouring: Colouring, state: State): void {
    const { vertices, facets, voids } = colouring;
    const { kinds, isPlanar } = this;
    const { pointCount, snapshot } = this.model;
    const [{ count: vertexCount }] = snapshot.simplices;
    if (vertices)
      kinds.tables.recolour(kinds.colours, pointCount, (p) =>
        vertices(p < vertexCount ? p : kNone),
      );
    if (facets) {
      const D = snapshot.facts.dimension;
      kinds.tables.recolour(kinds.ownColours(D - 1), snapshot.simplices[D - 1].count, facets);
    }
    if (voids) {
      if (isPlanar)
        kinds.tables.recolour(kinds.ownColours(2), snapshot.simplices[2].count, voids.colour);
      const list = new SimplexList(kTriangle, voids.triangles.length);
      voids.triangles.forEach((triangle, place) => list.put(place, triangle));
      this.bytes += this.layers.voids!.replace(list.elements);
    }
    for (const [name, drawable] of Object.entries(this.layers)) {
      if (!drawable) continue;
      const isOwn = facets !== null && hasOwnColours(name, isPlanar);
      const colouring = isOwn ? 2 : vertices ? 1 : 0;
      drawable.uniforms.colouring.value = keepsColour(name) ? 0 : colouring;
      const colour = plainColour(name, state, isPlanar);
      if (colour) drawable.uniforms.colour.value = unit(colour);
    }
  }

  /** [point]: where its component goes, x, y, z, and its way from the wave's source. */
  setOffsets(offsets: Float32Array): void {
    this.kinds.tables.replace(this.kinds.offsets, offsets);
  }

  /** The plane that clips, scene: what has dot(xyz, p) + w > 0 is not seen. */
  clipPlane(state: State, camera: Camera): [number, number, number, number] {
    const normals: Record<string, Vector> = {
      x: [1, 0, 0],
      y: [0, 1, 0],
      z: [0, 0, 1],
      view: rowsOf(camera.turn)[2],
    };
    const normal = normals[state.clipAxis];
    if (!normal) return [0, 0, 0, -1];
    const target = state.clipAxis === 'view' ? dot(normal, camera.target) : 0;
    return [...normal, -(target + state.clipPlace)];
  }

  /** What makes a class of cycles of a dimension: above everything else. */
  setClass(representative: Representative, dimension: number): void {
    representative.forEach((members, k) => {
      const list = new SimplexList([kQuad, kQuad, kTriangle][k], members.length);
      members.forEach((simplex, place) => list.put(place, simplex));
      const name = `class_${k}`;
      const drawable = this.layers[name]!;
      drawable.uniforms.colour.value = unit(kClassColours[dimension]);
      this.bytes += drawable.replace(list.elements);
      this.ofClass[name] = members.length;
    });
  }

  private addClassLayer(dimension: number): void {
    const pixels = dimension === 0 ? 2.6 : 5;
    const drawable = this.simplices(dimension, new Uint32Array(0), kClassColours[0], pixels);
    drawable.material.depthTest = drawable.material.depthWrite = false;
    drawable.material.transparent = true;
    drawable.uniforms.opacity.value = dimension === 2 ? 0.45 : 1;
    this.add(`class_${dimension}`, drawable);
  }

  private showLayers(state: State): void {
    const apart = dimensionApart(state);
    if (apart >= 0 && !this.layers[`apart_${apart}`]) {
      this.addApart(apart);
      this.updateLists();
    }
    for (const [name, drawable] of Object.entries(this.layers)) {
      if (drawable) drawable.object.visible = isVisible(name, state);
    }
    this.layers.all_balls!.show(6 * this.model.snapshot.simplices[0].count);
    this.layers.points!.show(6 * this.model.pointCount);
  }

  /** Draws a frame. */
  render(state: State, camera: Camera, fog: Rgb, isDark: boolean): FrameReport {
    const begin = performance.now();
    this.showPicked(state);
    this.showLayers(state);
    const spread = 1 + 2 * state.explosion;
    const offCentre = Math.hypot(...camera.target);
    const balls = isShown(state, 'balls') ? Math.sqrt(Math.max(0, this.largestRadius2(state))) : 0;
    const reach = (1.05 + balls) * spread + offCentre;
    const isOrthographic = this.isPlanar || state.projection === 'orthographic';
    const range: [number, number] = isOrthographic
      ? [camera.distance - reach, camera.distance + reach]
      : depthRange(camera, reach);
    const u = this.kinds.uniforms;
    u.view.value.fromArray(viewMatrix(camera));
    u.projection.value.fromArray(
      projectionMatrix(camera, this.aspect, isOrthographic, range, this.shift),
    );
    u.clipPlane.value.set(...this.clipPlane(state, camera));
    u.viewport.value.set(this.width, this.height);
    u.explosion.value = spreadOf(state);
    u.explodesParts.value = state.explodedPart === 'components';
    u.wave.value = state.wave === null ? -1 : state.wave * 1.12;
    u.fog.value = unit(fog);
    u.fogRange.value.set(camera.distance - 0.35, camera.distance + 1.9);
    u.isOrthographic.value = isOrthographic;
    u.alpha2.value = this.model.grown(state.alpha2);
    u.planarDepth.value = Math.max(1e-12, this.largestRadius2(state));
    this.setLook(state, isDark);
    this.renderer.render(this.world, this.eye);
    return this.report(begin);
  }

  private largestWeight: number | null = null;
  private largestRadius2(state: State): number {
    if (this.largestWeight === null) {
      this.largestWeight = -Infinity;
      const { points, pointCount } = this.model;
      for (let p = 0; p < pointCount; ++p)
        this.largestWeight = Math.max(this.largestWeight, points[4 * p + 3]);
    }
    return this.largestWeight + this.model.grown(state.alpha2);
  }

  private setLook(state: State, isDark: boolean): void {
    const isTranslucent = state.opacity < 1;
    for (const name of ['regular', 'singular_triangles', 'interior', 'voids'] as const) {
      const drawable = this.layers[name];
      if (!drawable || (name === 'voids' && !this.isPlanar)) continue; // walls of voids are solid
      const isFill = this.isPlanar && name !== 'regular';
      drawable.uniforms.opacity.value = isFill ? 0.75 * state.opacity : state.opacity;
      drawable.material.transparent = isTranslucent || this.isPlanar;
      drawable.material.depthWrite = !isTranslucent && !this.isPlanar;
      if (drawable.uniforms.outline) {
        drawable.uniforms.outline.value = isShown(state, 'outlines') ? 0.38 : 0;
      }
    }
    for (const name of ['apart_2', 'apart_3']) {
      const drawable = this.layers[name];
      if (drawable) drawable.uniforms.outline.value = 0.38;
    }
    for (const [name, colour] of Object.entries(lineColours(isDark))) {
      const drawable = this.layers[name];
      if (drawable) drawable.uniforms.colour.value = unit(colour);
    }
  }

  private report(begin: number): FrameReport {
    const drawn: Record<string, number> = {};
    for (const { name, list, drawable } of this.lists) {
      const perSimplex = list.pattern.offsets.length;
      if (drawable.object.visible) drawn[name] = drawable.shown / perSimplex;
    }
    for (const [name, count] of Object.entries(this.ofClass)) {
      if (this.layers[name]?.object.visible) drawn[name] = count;
    }
    const bytes = this.bytes + this.kinds.tables.takeBytes();
    this.bytes = 0;
    return {
      bytes,
      drawCalls: this.renderer.info.render.calls,
      milliseconds: performance.now() - begin,
      drawn,
    };
  }

  dispose(): void {
    for (const drawable of Object.values(this.layers)) drawable?.dispose();
    this.kinds.tables.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
