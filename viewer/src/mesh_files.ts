// SPDX-License-Identifier: MIT
//
// A mesh as a file, byte for byte as `orthoball shape` writes it (of STL but for the last bit of
// normals).

import type { ShapeMesh } from './shape_mesh';
import type { Role } from './types';

export const kMeshFormats = ['ply', 'obj', 'stl', 'glb'] as const;
export type MeshFormat = (typeof kMeshFormats)[number];

export interface MeshOptions {
  alpha2: number;
  /** Marks simplices as singular or regular. */
  roles: boolean;
}

/** The shortest decimal text that reads back to the same double, as the program writes it. */
export function shortestText(x: number): string {
  if (x === 0) return '0';
  const [mantissa, exponentText] = x.toExponential().split('e');
  const exponent = Number(exponentText);
  if (exponent >= -4 && exponent < 16) {
    if (exponent >= 0)
      return x.toLocaleString('en', { useGrouping: false, maximumFractionDigits: 20 });
    return x.toFixed(mantissa.replace(/[-.]/g, '').length - 1 - exponent);
  }
  const size = String(Math.abs(exponent)).padStart(2, '0');
  return `${mantissa}e${exponent < 0 ? '-' : '+'}${size}`;
}

function title(mesh: ShapeMesh, { alpha2 }: MeshOptions): string {
  const where =
    mesh.index === 0 && alpha2 === -Infinity
      ? 'index 0, the empty complex'
      : `alpha2 ${Number.isFinite(alpha2) ? shortestText(alpha2) : 'beyond double range'}, index ${mesh.index}`;
  return `boundary of the alpha shape at ${where}`;
}

/** Bytes that grow at their end. */
class Bytes {
  private view: DataView<ArrayBuffer>;
  private size = 0;

  constructor(expected: number) {
    this.view = new DataView(new ArrayBuffer(Math.max(64, expected)));
  }
  private room(bytes: number): number {
    const at = this.size;
    this.size += bytes;
    if (this.size > this.view.byteLength) {
      const larger = new Uint8Array(2 * this.size);
      larger.set(new Uint8Array(this.view.buffer));
      this.view = new DataView(larger.buffer);
    }
    return at;
  }
  text(text: string): void {
    const bytes = new TextEncoder().encode(text);
    const at = this.room(bytes.length);
    new Uint8Array(this.view.buffer).set(bytes, at);
  }
  u8(x: number): void {
    const at = this.room(1); // which may make another view
    this.view.setUint8(at, x);
  }
  u16(x: number): void {
    const at = this.room(2); // which may make another view
    this.view.setUint16(at, x, true);
  }
  u32(x: number): void {
    const at = this.room(4); // which may make another view
    this.view.setUint32(at, x, true);
  }
  f32(x: number): void {
    const at = this.room(4); // which may make another view
    this.view.setFloat32(at, x, true);
  }
  f64(x: number): void {
    const at = this.room(8); // which may make another view
    this.view.setFloat64(at, x, true);
  }
  done(): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.view.buffer, 0, this.size);
  }
}

const kRoleNumbers: Partial<Record<Role, number>> = { singular: 1, regular: 2 };

function plyBytes(mesh: ShapeMesh, options: MeshOptions): Uint8Array<ArrayBuffer> {
  const role = options.roles ? 'property uchar role\n' : '';
  const out = new Bytes(400 + 28 * mesh.rows.length + 14 * mesh.triangles.length);
  out.text(
    `ply\nformat binary_little_endian 1.0\ncomment ${title(mesh, options)}` +
      (options.roles ? '\ncomment role: 1 singular, 2 regular' : '') +
      `\nelement vertex ${mesh.rows.length}\n` +
      'property double x\nproperty double y\nproperty double z\nproperty uint row\n' +
      `element face ${mesh.triangles.length}\nproperty list uchar int vertex_indices\n${role}`,
  );
  if (mesh.edges.length > 0) {
    out.text(
      `element edge ${mesh.edges.length}\nproperty int vertex1\nproperty int vertex2\n${role}`,
    );
  }
  out.text('end_header\n');
  mesh.rows.forEach((row, v) => {
    for (let axis = 0; axis < 3; ++axis) out.f64(mesh.coordinates[3 * v + axis]);
    out.u32(row);
  });
  mesh.triangles.forEach((corners, t) => {
    out.u8(3);
    for (const v of corners) out.u32(v);
    if (options.roles) out.u8(kRoleNumbers[mesh.triangleRoles[t]]!);
  });
  mesh.edges.forEach((corners, e) => {
    for (const v of corners) out.u32(v);
    if (options.roles) out.u8(kRoleNumbers[mesh.edgeRoles[e]]!);
  });
  return out.done();
}

function objBytes(mesh: ShapeMesh, options: MeshOptions): Uint8Array<ArrayBuffer> {
  const out = new Bytes(60 * mesh.rows.length + 24 * mesh.triangles.length);
  out.text(`# ${title(mesh, options)}\n`);
  for (let v = 0; v < mesh.rows.length; ++v) {
    out.text(`v ${[...mesh.coordinates.subarray(3 * v, 3 * v + 3)].map(shortestText).join(' ')}\n`);
  }
  const line = (letter: string, corners: number[]) =>
    out.text(`${letter} ${corners.map((v) => v + 1).join(' ')}\n`);
  for (const role of ['regular', 'singular'] as const) {
    if (options.roles) out.text(`g ${role}\n`);
    mesh.triangles.forEach((corners, t) => mesh.triangleRoles[t] === role && line('f', corners));
    mesh.edges.forEach((corners, e) => mesh.edgeRoles[e] === role && line('l', corners));
  }
  for (const v of mesh.isolated) line('p', [v]);
  return out.done();
}

function unitNormal(corners: number[][]): number[] {
  const [u, v] = [1, 2].map((i) => corners[i].map((x, axis) => x - corners[0][axis]));
  const largest = Math.max(...u.map(Math.abs), ...v.map(Math.abs));
  if (!(largest > 0) || !Number.isFinite(largest)) return [0, 0, 0];
  const [a, b] = [u.map((x) => x / largest), v.map((x) => x / largest)];
  const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = Math.hypot(...normal);
  return length > 0 ? normal.map((x) => x / length) : [0, 0, 0];
}

function stlBytes(mesh: ShapeMesh, options: MeshOptions): Uint8Array<ArrayBuffer> {
  const out = new Bytes(84 + 50 * mesh.triangles.length);
  out.text(title(mesh, options).padEnd(80, ' ').slice(0, 80));
  out.u32(mesh.triangles.length);
  for (const triangle of mesh.triangles) {
    const corners = triangle.map((v) => [...mesh.coordinates.subarray(3 * v, 3 * v + 3)]);
    for (const x of unitNormal(corners)) out.f32(x);
    for (const x of corners.flat()) out.f32(x);
    out.u16(0);
  }
  return out.done();
}

interface Primitive {
  mode: number;
  material: number;
  indices: number[];
}

function primitivesOf(mesh: ShapeMesh): Primitive[] {
  const primitives: Primitive[] = [];
  const add = (simplices: number[][], roles: Role[], mode: number) => {
    for (const role of ['regular', 'singular'] as const) {
      const indices = simplices.filter((_, i) => roles[i] === role).flat();
      if (indices.length > 0)
        primitives.push({ mode, material: role === 'regular' ? 0 : 1, indices });
    }
  };
  add(mesh.triangles, mesh.triangleRoles, 4);
  add(mesh.edges, mesh.edgeRoles, 1);
  if (mesh.isolated.length > 0) primitives.push({ mode: 0, material: 1, indices: mesh.isolated });
  return primitives;
}

function boxOf(mesh: ShapeMesh): { middle: number[]; low: number[]; high: number[] } {
  const box = { middle: [0, 0, 0], low: [0, 0, 0], high: [0, 0, 0] };
  for (let axis = 0; axis < 3 && mesh.rows.length > 0; ++axis) {
    let [low, high] = [Infinity, -Infinity];
    for (let v = 0; v < mesh.rows.length; ++v) {
      low = Math.min(low, mesh.coordinates[3 * v + axis]);
      high = Math.max(high, mesh.coordinates[3 * v + axis]);
    }
    box.middle[axis] = low / 2 + high / 2;
    box.low[axis] = Math.fround(low - box.middle[axis]);
    box.high[axis] = Math.fround(high - box.middle[axis]);
  }
  return box;
}

function glbJson(
  mesh: ShapeMesh,
  options: MeshOptions,
  primitives: Primitive[],
  box: ReturnType<typeof boxOf>,
): string {
  const list = (numbers: number[]) => `[${numbers.map(shortestText).join(',')}]`;
  const alpha2 = Number.isFinite(options.alpha2) ? shortestText(options.alpha2) : 'null';
  const head = `{"asset":{"version":"2.0","generator":"orthoball"},"scene":0,"extras":{"alpha2":${alpha2},"index":${mesh.index}}`;
  if (primitives.length === 0) return `${head},"scenes":[{}]}`;
  const material = (name: string, colour: number[]) =>
    `{"name":"${name}","doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.8,"baseColorFactor":${list(colour)}}}`;
  const [blue, orange] = [
    [0.337, 0.706, 0.914, 1],
    [0.902, 0.624, 0, 1],
  ];
  let offset = 12 * mesh.rows.length;
  const views = [`{"buffer":0,"byteOffset":0,"byteLength":${offset},"target":34962}`];
  for (const { indices } of primitives) {
    views.push(
      `{"buffer":0,"byteOffset":${offset},"byteLength":${4 * indices.length},"target":34963}`,
    );
    offset += 4 * indices.length;
  }
  const drawn = primitives.map(
    ({ mode, material }, i) =>
      `{"attributes":{"POSITION":0},"mode":${mode},"indices":${i + 1},"material":${material}}`,
  );
  const accessors = primitives.map(
    ({ indices }, i) =>
      `{"bufferView":${i + 1},"componentType":5125,"count":${indices.length},"type":"SCALAR"}`,
  );
  return (
    `${head},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":${list(box.middle)}}],` +
    `"materials":[${material('regular', blue)},${material('singular', options.roles ? orange : blue)}],` +
    `"meshes":[{"primitives":[${drawn.join(',')}]}],` +
    `"accessors":[{"bufferView":0,"componentType":5126,"count":${mesh.rows.length},"type":"VEC3","min":${list(box.low)},"max":${list(box.high)}},${accessors.join(',')}],` +
    `"bufferViews":[${views.join(',')}],"buffers":[{"byteLength":${offset}}]}`
  );
}

function glbBytes(mesh: ShapeMesh, options: MeshOptions): Uint8Array<ArrayBuffer> {
  const primitives = primitivesOf(mesh);
  const box = boxOf(mesh);
  const text = new TextEncoder().encode(glbJson(mesh, options, primitives, box));
  const jsonSize = 4 * Math.ceil(text.length / 4);
  const binarySize =
    primitives.length === 0
      ? 0
      : 12 * mesh.rows.length +
        4 * primitives.reduce((sum, { indices }) => sum + indices.length, 0);
  const size = 20 + jsonSize + (binarySize > 0 ? 8 + binarySize : 0);
  const out = new Bytes(size);
  out.text('glTF');
  out.u32(2);
  out.u32(size);
  out.u32(jsonSize);
  out.text('JSON');
  out.text(new TextDecoder().decode(text) + ' '.repeat(jsonSize - text.length));
  if (binarySize === 0) return out.done();
  out.u32(binarySize);
  out.text('BIN\0');
  mesh.coordinates.forEach((x, i) => out.f32(x - box.middle[i % 3]));
  for (const { indices } of primitives) for (const v of indices) out.u32(v);
  return out.done();
}

export function meshBytes(
  mesh: ShapeMesh,
  format: MeshFormat,
  options: MeshOptions,
): Uint8Array<ArrayBuffer> {
  const write = { ply: plyBytes, obj: objBytes, stl: stlBytes, glb: glbBytes }[format];
  return write(mesh, options);
}
