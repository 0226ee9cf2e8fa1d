// SPDX-License-Identifier: MIT
import * as three from 'three';

import { kQuad, type SimplexList } from '../complex_mesh';

export type Uniforms = Record<string, three.IUniform>;

/** Something drawn from one index buffer. */
export class Drawable {
  readonly object: three.Mesh | three.LineSegments;
  readonly uniforms: Uniforms;
  private index: three.BufferAttribute;

  constructor(
    elements: Uint32Array,
    readonly material: three.RawShaderMaterial,
    isLines = false,
  ) {
    const geometry = new three.BufferGeometry();
    this.index = new three.BufferAttribute(elements, 1).setUsage(three.DynamicDrawUsage);
    geometry.setIndex(this.index);
    geometry.setDrawRange(0, isLines ? Infinity : 0);
    this.object = isLines
      ? new three.LineSegments(geometry, material)
      : new three.Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.uniforms = material.uniforms;
  }

  /** Takes over what has changed in a list. Returns how many bytes will be sent. */
  update(list: SimplexList): number {
    let bytes = 0;
    for (const { start, count } of list.takeChanges()) {
      this.index.addUpdateRange(start, count);
      bytes += 4 * count;
    }
    if (bytes > 0) this.index.needsUpdate = true;
    this.show(list.size * list.pattern.offsets.length);
    return bytes;
  }

  /** Another index buffer, all of which is shown. Returns how many bytes will be sent. */
  replace(elements: Uint32Array): number {
    const { geometry } = this.object;
    geometry.dispose(); // the old one, on the graphics processor
    this.index = new three.BufferAttribute(elements, 1).setUsage(three.DynamicDrawUsage);
    geometry.setIndex(this.index);
    this.show(elements.length);
    return elements.byteLength;
  }

  /** How many elements are drawn. */
  get shown(): number {
    return this.object.geometry.drawRange.count;
  }

  show(elements: number): void {
    this.object.geometry.setDrawRange(0, elements);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}

/** Elements of quads for points or edges 0..count - 1. */
export function quads(count: number): Uint32Array<ArrayBuffer> {
  const elements = new Uint32Array(6 * count);
  for (let i = 0; i < count; ++i) {
    for (let c = 0; c < 6; ++c) elements[6 * i + c] = 4 * i + kQuad.offsets[c];
  }
  return elements;
}
