// SPDX-License-Identifier: MIT
//
// Tables that shaders look things up in: textures of four numbers an entry, entry i at column
// i % kTexelsAcross of row i / kTexelsAcross, as texel() of shaders.ts has it.

import * as three from 'three';

const kTexelsAcross = 2048;

/** There is more than the graphics processor takes. */
export class TooLarge extends Error {}

export type Table = three.DataTexture;
type Data = Float32Array | Uint32Array | Uint8Array;

function format(data: Data): [three.PixelFormat, three.TextureDataType] {
  if (data instanceof Uint32Array) return [three.RGBAIntegerFormat, three.UnsignedIntType];
  return [three.RGBAFormat, data instanceof Uint8Array ? three.UnsignedByteType : three.FloatType];
}

/** All tables of a scene. */
export class Tables {
  private readonly all: Table[] = [];
  private bytes = 0;

  /** @param maxRows  the largest height that the graphics processor takes. */
  constructor(private readonly maxRows: number) {}

  /**
   * A table of `count` entries of four numbers, padded to whole rows.
   * @throws TooLarge
   */
  add(data: Data, count: number): Table {
    const rows = Math.max(1, Math.ceil(count / kTexelsAcross));
    if (rows > this.maxRows) {
      const [needed, most] = [count, this.maxRows * kTexelsAcross].map((n) =>
        n.toLocaleString('en'),
      );
      throw new TooLarge(
        `a table of it has ${needed} entries, and this graphics processor takes ${most} at most`,
      );
    }
    const padded = new (data.constructor as new (length: number) => Data)(4 * kTexelsAcross * rows);
    padded.set(data);
    const table = new three.DataTexture(padded as never, kTexelsAcross, rows, ...format(data));
    if (data instanceof Uint32Array) table.internalFormat = 'RGBA32UI';
    this.all.push(table);
    this.send(table);
    return table;
  }

  /** A table of simplices with `width` corners each. */
  addCorners(corners: Uint32Array, width: number): Table {
    const count = corners.length / width;
    const data = new Uint32Array(4 * count);
    for (let i = 0; i < count; ++i)
      for (let c = 0; c < width; ++c) data[4 * i + c] = corners[width * i + c];
    return this.add(data, count);
  }

  /** Other numbers, at most as many as before. */
  replace(table: Table, data: Float32Array): void {
    (table.image.data as unknown as Float32Array).set(data);
    this.send(table);
  }

  /** Other colours of the first `count` entries. */
  recolour(table: Table, count: number, colourOf: (i: number) => readonly number[]): void {
    const data = table.image.data as unknown as Uint8Array;
    for (let i = 0; i < count; ++i) data.set(colourOf(i), 4 * i);
    this.send(table);
  }

  private send(table: Table): void {
    table.needsUpdate = true;
    this.bytes += (table.image.data as unknown as ArrayBufferView).byteLength;
  }

  /** How many bytes go to the graphics processor since the last call. */
  takeBytes(): number {
    const bytes = this.bytes;
    this.bytes = 0;
    return bytes;
  }

  dispose(): void {
    for (const table of this.all) table.dispose();
  }
}
