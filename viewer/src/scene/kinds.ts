// SPDX-License-Identifier: MIT
//
// The kinds of things that are drawn, triangles, edges, balls and lines, each with its shaders, and
// what all of them look things up in.

import * as three from 'three';

import type { Rgb } from '../palette';
import type { ShapeModel } from '../shape_model';
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

export function unit(colour: Rgb): three.Vector3 {
  return new three.Vector3(...colour.map((c) => c / 255));
}

function sharedUniforms(points: Table, offsets: Table, colours: Table) {
  const matrix = () => ({ value: new three.Matrix4() });
  return {
    view: matrix(),
    projection: matrix(),
    clipPlane: { value: new three.Vector4(0, 0, 0, -1) },
    viewport: { value: new three.Vector2(1, 1) },
    explosion: { value: 0 },
    explodesParts: { value: true },
    points: { value: points },
    offsets: { value: offsets },
    colours: { value: colours },
    wave: { value: -1 },
    fog: { value: new three.Vector3(1, 1, 1) },
    fogRange: { value: new three.Vector2(1, 2) },
    isOrthographic: { value: false },
    alpha2: { value: 0 },
    planarDepth: { value: 1 },
  };
}

export class Kinds {
  readonly isPlanar: boolean;
  readonly tables: Tables;
  /** [point]: of its component's way, and its way from the wave's source. */
  readonly offsets: Table;
  /** [point] */
  readonly colours: Table;
  /** Of all kinds. */
  readonly uniforms: ReturnType<typeof sharedUniforms>;
  /** [dimension]: made when they are first drawn. */
  private readonly corners: (Table | undefined)[] = [];
  private readonly own: (Table | undefined)[] = [];

  /** @param maxRows  of textures. */
  constructor(
    private readonly model: ShapeModel,
    maxRows: number,
  ) {
    const { points, pointCount, snapshot } = model;
    this.isPlanar = snapshot.facts.dimension === 2;
    this.tables = new Tables(maxRows);
    this.offsets = this.tables.add(new Float32Array(4 * pointCount), pointCount);
    this.colours = this.tables.add(new Uint8Array(4 * pointCount), pointCount);
    this.uniforms = sharedUniforms(this.tables.add(points, pointCount), this.offsets, this.colours);
  }

  private cornersOf(dimension: number): Table {
    return (this.corners[dimension] ??= this.tables.addCorners(
      this.model.snapshot.simplices[dimension].corners,
      dimension + 1,
    ));
  }

  /** [simplex of a dimension]: colours of their own, for edges and triangles. */
  ownColours(dimension: number): Table {
    const { count } = this.model.snapshot.simplices[dimension];
    return (this.own[dimension] ??= this.tables.add(new Uint8Array(4 * count), count));
  }

  private material(vertex: string, fragment: string, own: Uniforms): three.RawShaderMaterial {
    const uniforms = {
      ...this.uniforms,
      opacity: { value: 1 },
      colouring: { value: 0 },
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

  /**
   * @param hasInside  backs are the inside of the shape.
   * @param isSolid    tetrahedra, by their faces.
   */
  triangles(elements: Uint32Array, colour: Rgb, hasInside = false, isSolid = false): Drawable {
    const material = this.material(kTriangleVertex, kTriangleFragment, {
      corners: { value: this.cornersOf(isSolid ? 3 : 2) },
      ownColours: { value: this.ownColours(2) },
      colour: { value: unit(colour) },
      isSolid: { value: isSolid },
      hasInside: { value: hasInside },
      outline: { value: 0 },
    });
    material.forceSinglePass = false; // where it is translucent, backs come before fronts
    return new Drawable(elements, material);
  }

  edges(elements: Uint32Array, colour: Rgb, pixels: number, own: Uniforms = {}): Drawable {
    return new Drawable(
      elements,
      this.material(kEdgeVertex, kEdgeFragment, {
        corners: { value: this.cornersOf(1) },
        ownColours: { value: this.isPlanar ? this.ownColours(1) : this.colours },
        ends: this.uniforms.points,
        hasEnds: { value: false },
        colour: { value: unit(colour) },
        radius: { value: 0 },
        pixels: { value: pixels },
        ...own,
      }),
    );
  }

  /** @param pixels  across; 0 for as large as the balls are. */
  balls(elements: Uint32Array, colour: Rgb, pixels: number): Drawable {
    const balls = this.material(kBallVertex, kBallFragment, {
      colour: { value: unit(colour) },
      pixels: { value: pixels },
    });
    // In the plane they hide each other by their power distances; points lie above.
    if (this.isPlanar && pixels === 0) balls.depthTest = balls.depthWrite = true;
    balls.alphaToCoverage = this.isPlanar && pixels === 0;
    return new Drawable(elements, balls);
  }

  /** Pairs of vertices as sticks. @param radius  input units. */
  sticks(pairs: Uint32Array, colour: Rgb, radius: number): Drawable {
    const sticks = this.edges(quads(pairs.length / 2), colour, 1.5, {
      corners: { value: this.tables.addCorners(pairs, 2) },
      radius: { value: 2 * radius * this.model.scale },
    });
    sticks.show(3 * pairs.length);
    return sticks;
  }

  /** All edges of the triangulation as thin lines. */
  wireframe(): Drawable {
    const material = this.material(kLineVertex, kLineFragment, {
      colour: { value: new three.Vector3() },
    });
    material.transparent = true;
    material.depthWrite = false;
    const wireframe = new Drawable(this.model.snapshot.simplices[1].corners, material, true);
    wireframe.uniforms.opacity.value = 0.35;
    return wireframe;
  }

  /** Borders of power cells, seen on disks only: these have written depths below the borders'. */
  powerCells(): Drawable {
    const ends = this.model.powerEdges();
    const { count } = this.model.snapshot.simplices[1];
    const cells = this.edges(quads(count), [255, 255, 255], 1.6, {
      ends: { value: this.tables.add(ends, 2 * count) },
      hasEnds: { value: true },
    });
    cells.material.depthTest = true;
    cells.material.depthFunc = three.GreaterDepth;
    cells.show(6 * count);
    return cells;
  }
}
