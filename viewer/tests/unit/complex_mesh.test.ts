// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { ComplexMesh, kTriangle, type SimplexList } from '../../src/complex_mesh';
import { roleAt, type Role, type Simplices } from '../../src/types';

/** Random triangles with random intervals, empty ones and endless ones among them. */
function someTriangles(count: number, size: number): Simplices {
  let state = 7;
  const random = (below: number) => (state = (state * 48271) % 2147483647) % below;
  const three = Array.from({ length: count }, () => {
    const indices = [1 + random(size), 1 + random(size), 1 + random(size)].sort((a, b) => a - b);
    if (random(5) === 0) indices[2] = size + 1;
    if (random(7) === 0) indices[1] = indices[2];
    if (random(4) === 0) indices[1] = indices[0];
    return indices;
  });
  const column = (k: number) => Uint32Array.from(three, (indices) => indices[k]);
  return {
    dimension: 2,
    count,
    corners: Uint32Array.from({ length: 3 * count }, (_, i) => i),
    enters: column(0),
    regular: column(1),
    interior: column(2),
  };
}

const kRoles: Role[] = ['singular', 'regular', 'interior'];

function listed(list: SimplexList): number[] {
  return [...list.simplices.subarray(0, list.size)].sort((a, b) => a - b);
}

describe('ComplexMesh', () => {
  const size = 60;
  const triangles = someTriangles(500, size);
  const walk = [1, 2, 3, 40, 39, 60, 0, 17, 17, 18, 5, 59, 60, 1, 30];

  it('lists the simplices of every role wherever it goes', () => {
    const mesh = new ComplexMesh(triangles, kTriangle, size + 1, kRoles);
    for (const index of walk) {
      mesh.moveTo(index);
      for (const role of kRoles) {
        const expected = Array.from({ length: 500 }, (_, i) => i).filter(
          (i) => roleAt(triangles, i, index) === role,
        );
        expect(listed(mesh.list(role)), `${role} at ${index}`).toEqual(expected);
      }
    }
  });

  it('has an index buffer without gaps, and tells all that changed in it', () => {
    const mesh = new ComplexMesh(triangles, kTriangle, size + 1, kRoles);
    const copies = new Map(
      kRoles.map((role) => [role, new Uint32Array(mesh.list(role).elements.length)]),
    );
    for (const index of walk) {
      mesh.moveTo(index);
      for (const role of kRoles) {
        const list = mesh.list(role);
        const copy = copies.get(role)!; // what a graphics processor would have
        for (const { start, count } of list.takeChanges()) {
          copy.set(list.elements.subarray(start, start + count), start);
        }
        const drawn = copy.subarray(0, 3 * list.size);
        const expected = [...list.simplices.subarray(0, list.size)].flatMap((t) => [
          3 * t,
          3 * t + 1,
          3 * t + 2,
        ]);
        expect([...drawn]).toEqual(expected);
      }
    }
  });

  it('looks at what changes only, and sends a few blocks of it', () => {
    const many = someTriangles(40_000, 10_000);
    const mesh = new ComplexMesh(many, kTriangle, 10_001, kRoles);
    mesh.moveTo(5000);
    for (const role of kRoles) mesh.list(role).takeChanges();
    expect(mesh.moveTo(5001)).toBeLessThan(60);
    let elements = 0;
    for (const role of kRoles)
      for (const { count } of mesh.list(role).takeChanges()) elements += count;
    expect(elements).toBeGreaterThan(0);
    expect(elements).toBeLessThan(60 * 256 * 3);
  });

  it('knows the drawn roles only', () => {
    const mesh = new ComplexMesh(triangles, kTriangle, size + 1, ['regular']);
    mesh.moveTo(30);
    expect(mesh.list('regular').size).toBeGreaterThan(0);
    expect(() => mesh.list('interior')).toThrow('not listed');
  });
});
