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
import { kQuad, kTriangle, SimplexList } from '../complex_mesh';
import { dimensionApart, isVisible, keepsColour, lineColours, plainColour } from '../layers';
import {
  kDimensionColours,
  kPickedColour,
  kRoleColours,
  type Colouring,
  type Rgb,
} from '../palette';
import type { ShapeModel } from '../shape_model';
import { isShown, type State } from '../state';
import { kNone } from '../types';
import { Drawable, quads, type Uniforms } from './drawable';
import {
  kBallFragment,
  kBallVertex,
  kEdgeFragment,
  kEdgeVertex,
  kLineFragment,
  kLineVertex,
  kTriangleFragment,
  kTriangleVertex,
} from './shaders';
import { Tables, type Table } from './textures';

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

function unit(colour: Rgb): three.Vector3 {
  return new three.Vector3(...colour.map((c) => c / 255));
}

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
  private readonly shared: Uniforms;
  private readonly tables: Tables;
  private readonly points: Table;
  private readonly offsets: Table;
  private readonly colours: Table;
  private readonly facetColours: Table;
  /** [dimension]: made when they are first drawn. */
  private readonly corners: (Table | undefined)[] = [];
  private readonly lists: ListLayer[] = [];
  /** [dimension]: the simplex that was picked, if any. */
  private readonly picked = [kQuad, kQuad, kTriangle].map((pattern) => new SimplexList(pattern, 1));
  private readonly layers: Partial<Record<string, Drawable>> = {};
  /** Of the middle of the view to the right, in half widths. */
  shift = 0;
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
    const { snapshot, points, pointCount } = model;
    this.isPlanar = snapshot.facts.dimension === 2;
    this.tables = new Tables(this.renderer.capabilities.maxTextureSize);
    this.points = this.tables.add(points, pointCount);
    this.offsets = this.tables.add(new Float32Array(4 * pointCount), pointCount);
    this.colours = this.tables.add(new Uint8Array(4 * pointCount), pointCount);
    const facets = snapshot.facetOwners.length;
    this.facetColours = this.tables.add(new Uint8Array(4 * facets), facets);
    const matrix = () => ({ value: new three.Matrix4() });
    this.shared = {
      view: matrix(),
      projection: matrix(),
      clipPlane: { value: new three.Vector4(0, 0, 0, -1) },
      viewport: { value: new three.Vector2(1, 1) },
      explosion: { value: 0 },
      explodesParts: { value: true },
      points: { value: this.points },
      offsets: { value: this.offsets },
      colours: { value: this.colours },
      ownColours: { value: this.facetColours },
      wave: { value: -1 },
      fog: { value: new three.Vector3(1, 1, 1) },
      fogRange: { value: new three.Vector2(1, 2) },
      isOrthographic: { value: false },
      alpha2: { value: 0 },
      planarDepth: { value: 1 },
    };
    this.addLayers(bonds, trace);
    this.addPicked();
  }

  private cornersOf(dimension: number): Table {
    return (this.corners[dimension] ??= this.tables.addCorners(
      this.model.snapshot.simplices[dimension].corners,
      dimension + 1,
    ));
  }

  private material(vertex: string, fragment: string, own: Uniforms): three.RawShaderMaterial {
    const uniforms = {
      ...this.shared,
      opacity: { value: 1 },
      colouring: { value: 0 },
      isFlat: { value: this.isPlanar },
      isPlanar: { value: this.isPlanar },
      ...own,
    };
    return new three.RawShaderMaterial({
      glslVersion: three.GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms,
      side: three.DoubleSide,
      transparent: this.isPlanar, // so that everything is drawn in the order of its layers
      depthTest: !this.isPlanar,
      depthWrite: !this.isPlanar,
    });
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

  private triangles(
    elements: Uint32Array,
    colour: Rgb,
    hasInside: boolean,
    isSolid = false,
  ): Drawable {
    const material = this.material(kTriangleVertex, kTriangleFragment, {
      corners: { value: this.cornersOf(isSolid ? 3 : 2) },
      colour: { value: unit(colour) },
      isSolid: { value: isSolid },
      hasInside: { value: hasInside },
      outline: { value: 0 },
    });
    material.forceSinglePass = false; // where it is translucent, backs come before fronts
    return new Drawable(elements, material);
  }

  private edges(elements: Uint32Array, colour: Rgb, own: Uniforms): Drawable {
    return new Drawable(
      elements,
      this.material(kEdgeVertex, kEdgeFragment, {
        corners: { value: this.cornersOf(1) },
        ends: { value: this.points },
        hasEnds: { value: false },
        colour: { value: unit(colour) },
        radius: { value: 0 },
        pixels: { value: 2 },
        ...own,
      }),
    );
  }

  private balls(elements: Uint32Array, colour: Rgb, pixels: number): Drawable {
    return new Drawable(
      elements,
      this.material(kBallVertex, kBallFragment, {
        colour: { value: unit(colour) },
        pixels: { value: pixels },
      }),
    );
  }

  // Pairs of vertices as sticks.
  private sticks(pairs: Uint32Array, colour: Rgb, radius: number): Drawable {
    const sticks = this.edges(quads(pairs.length / 2), colour, {
      corners: { value: this.tables.addCorners(pairs, 2) },
      radius: { value: 2 * radius * this.model.scale },
      pixels: { value: 1.5 },
    });
    sticks.show(3 * pairs.length);
    return sticks;
  }

  private addLayers(bonds: Uint32Array, trace: Uint32Array): void {
    const { meshes, pointCount, snapshot } = this.model;
    const [vertices, edges, triangles] = meshes;
    const colours = kRoleColours;
    const balls = (pixels: number) => (elements: Uint32Array) =>
      this.balls(elements, colours.vertex, pixels);
    const edgesOf = (colour: Rgb, pixels: number) => (elements: Uint32Array) =>
      this.edges(elements, colour, { pixels: { value: pixels } });
    const trianglesOf = (colour: Rgb, hasInside: boolean) => (elements: Uint32Array) =>
      this.triangles(elements, colour, hasInside);
    // In the order of drawing: in the plane what comes later lies above.
    this.addList('singular_balls', vertices.list('singular'), balls(0));
    this.addList('regular_balls', vertices.list('regular'), balls(0));
    this.add('all_balls', balls(0)(quads(snapshot.simplices[0].count)));
    if (this.isPlanar) this.addPowerCells();
    this.addList('interior', triangles.list('interior'), trianglesOf(colours.interior, false));
    this.add('wireframe', this.wireframe());
    if (bonds.length > 0) this.add('sticks', this.sticks(bonds, [120, 128, 140], 0.14));
    if (trace.length > 0) this.add('trace', this.sticks(trace, [52, 58, 70], 0.32));
    this.addList(
      'singular_edges',
      edges.list('singular'),
      edgesOf(colours.edge, this.isPlanar ? 3 : 2.6),
    );
    if (this.isPlanar) this.addList('regular', edges.list('regular'), edgesOf(colours.regular, 4));
    this.addList(
      'singular_triangles',
      triangles.list('singular'),
      trianglesOf(colours.singular, false),
    );
    if (!this.isPlanar)
      this.addList('regular', triangles.list('regular'), trianglesOf(colours.regular, true));
    const pointSize = !this.isPlanar ? 4 : pointCount < 600 ? 6 : pointCount < 3000 ? 4 : 2.5;
    this.add('points', this.balls(quads(pointCount), [70, 78, 92], pointSize));
    this.addList('singular_vertices', vertices.list('singular'), balls(7));
  }

  // Above everything else, so that it is found.
  private addPicked(): void {
    const [vertex, edge, triangle] = this.picked.map(({ elements }) => elements);
    const drawables = [
      this.balls(vertex, kPickedColour, 12),
      this.edges(edge, kPickedColour, { pixels: { value: 6 } }),
      this.triangles(triangle, kPickedColour, false),
    ];
    drawables.forEach((drawable, k) => {
      drawable.material.depthTest = drawable.material.depthWrite = false;
      drawable.material.transparent = true;
      drawable.uniforms.opacity.value = 0.85;
      this.add(`picked_${k}`, drawable);
    });
  }

  private showPicked({ picked }: State): void {
    if (!picked || picked.dimension > 2) return;
    const list = this.picked[picked.dimension];
    if (list.size > 0 && list.simplices[0] === picked.simplex) return;
    list.size = 1;
    list.put(0, picked.simplex);
    this.bytes += this.layers[`picked_${picked.dimension}`]!.update(list);
  }

  // All simplices of a dimension by themselves, for moving apart.
  private addApart(dimension: number): void {
    const list = this.model.allOf(dimension).list('interior');
    const colour = kDimensionColours[dimension];
    this.addList(`apart_${dimension}`, list, (elements) => {
      if (dimension === 0) return this.balls(elements, colour, 8);
      if (dimension === 1) return this.edges(elements, colour, { pixels: { value: 2.6 } });
      return this.triangles(elements, colour, false, dimension === 3);
    });
  }

  private wireframe(): Drawable {
    const elements = this.model.snapshot.simplices[1].corners;
    const material = this.material(kLineVertex, kLineFragment, {
      colour: { value: new three.Vector3() },
    });
    material.transparent = true;
    material.depthWrite = false;
    const wireframe = new Drawable(elements, material, true);
    wireframe.uniforms.opacity.value = 0.35;
    return wireframe;
  }

  // Borders of power cells, seen on disks only: these have written depths below the borders'.
  private addPowerCells(): void {
    const ends = this.model.powerEdges();
    const count = this.model.snapshot.simplices[1].count;
    const cells = this.edges(quads(count), [255, 255, 255], {
      ends: { value: this.tables.add(ends, 2 * count) },
      hasEnds: { value: true },
      pixels: { value: 1.6 },
    });
    cells.material.depthTest = true;
    cells.material.depthFunc = three.GreaterDepth;
    this.add('power_cells', cells).show(6 * count);
    for (const name of ['singular_balls', 'regular_balls', 'all_balls']) {
      const { material } = this.layers[name]!;
      material.depthTest = material.depthWrite = true;
    }
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
    const { vertices, facets } = colouring;
    const { pointCount, snapshot } = this.model;
    const vertexCount = snapshot.simplices[0].count;
    if (vertices)
      this.tables.recolour(this.colours, pointCount, (p) => vertices(p < vertexCount ? p : kNone));
    if (facets && !this.isPlanar)
      this.tables.recolour(this.facetColours, snapshot.facetOwners.length, facets);
    for (const [name, drawable] of Object.entries(this.layers)) {
      if (!drawable) continue;
      const isTriangle = name === 'regular' || name === 'singular_triangles';
      const takesOwn = facets && isTriangle && !this.isPlanar;
      const colouring = takesOwn ? 2 : vertices ? 1 : 0;
      drawable.uniforms.colouring.value = keepsColour(name) ? 0 : colouring;
      const colour = plainColour(name, state, this.isPlanar);
      if (colour) drawable.uniforms.colour.value = unit(colour);
    }
  }

  /** [point]: where its component goes, x, y, z, and its way from the wave's source. */
  setOffsets(offsets: Float32Array): void {
    this.tables.replace(this.offsets, offsets);
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
    const u = this.shared;
    u.view.value.fromArray(viewMatrix(camera));
    u.projection.value.fromArray(
      projectionMatrix(camera, this.aspect, isOrthographic, range, this.shift),
    );
    u.clipPlane.value.set(...this.clipPlane(state, camera));
    u.viewport.value.set(this.width, this.height);
    u.explosion.value = 1.6 * state.explosion;
    u.explodesParts.value = state.explodedPart === 'components';
    u.wave.value = state.wave === null ? -1 : state.wave * 1.12;
    u.fog.value = unit(fog);
    u.fogRange.value.set(camera.distance - 0.35, camera.distance + 1.9);
    u.isOrthographic.value = isOrthographic;
    u.alpha2.value = Number.isFinite(state.alpha2)
      ? state.alpha2 * this.model.scale ** 2
      : state.alpha2 > 0
        ? 1e6
        : -1e6;
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
    const radius2 = this.largestWeight + state.alpha2 * this.model.scale ** 2;
    return Number.isFinite(radius2) ? radius2 : 0;
  }

  private setLook(state: State, isDark: boolean): void {
    const isTranslucent = state.opacity < 1;
    for (const name of ['regular', 'singular_triangles', 'interior'] as const) {
      const drawable = this.layers[name];
      if (!drawable) continue;
      const isFill = this.isPlanar && name === 'interior';
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
    const bytes = this.bytes + this.tables.takeBytes();
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
    this.tables.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
