// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { describe, expect, it } from 'vitest';

import { kMeshFormats, meshBytes, shortestText } from '../../src/mesh_files';
import { quantitiesOf } from '../../src/quantities';
import { shapeMesh } from '../../src/shape_mesh';
import { signatureParts } from '../../src/signature_table';
import { inFolder, orthoball, snapshotOf, sourceFile, spread } from '../program';

const kInputs = ['bdna_dodecamer.pdb', 'linked_tori.csv', 'figure_eight.csv', 'c60.xyz'];

describe.each(kInputs)('of %s', (name) => {
  const input = sourceFile(`examples/data/${name}`);

  it.each([false, true])(
    'meshes are those of `orthoball shape`, byte for byte (roles: %s)',
    async (roles) => {
      const snapshot = await snapshotOf(input);
      const inSpace = snapshot.facts.dimension === 3;
      for (const index of [0, ...spread(snapshot.spectrum.length, 5)]) {
        const mesh = shapeMesh(snapshot, index);
        for (const format of kMeshFormats.filter((one) => inSpace || one !== 'stl')) {
          const alpha2 = index === 0 ? -Infinity : snapshot.spectrum[index - 1];
          const bytes = Buffer.from(meshBytes(mesh, format, { alpha2, roles }));
          const expected = await inFolder((folder) => {
            const file = join(folder, `mesh.${format}`);
            orthoball(
              'shape',
              input,
              '--index',
              String(index),
              '-o',
              file,
              ...(roles ? ['--roles'] : []),
            );
            return readFileSync(file);
          });
          expect(bytes.length, `${format} at ${index}`).toBe(expected.length);
          if (format === 'stl') expectSameTriangles(bytes, expected);
          else expect(bytes.equals(expected), `${format} at ${index}`).toBe(true);
        }
      }
    },
  );

  it('signatures are those of `orthoball signatures`', async () => {
    const snapshot = await snapshotOf(input);
    const own = signatureParts(snapshot, quantitiesOf(snapshot)).join('').split('\n');
    const lines = orthoball('signatures', input).toString().split('\n');
    expect(own.length).toBe(lines.length);
    expect(own[0]).toBe(lines[0]);
    const area = lines[0].split(',').indexOf('area');
    lines.slice(1).forEach((line, i) => {
      const [cells, ownCells] = [line.split(','), own[i + 1].split(',')];
      if (line !== '') expect(Number(ownCells[area])).toBeCloseTo(Number(cells[area]), 9);
      [cells[area], ownCells[area]] = ['', ''];
      expect(ownCells.join()).toBe(cells.join());
    });
  });
});

/** All but the normals to the bit. */
function expectSameTriangles(bytes: Buffer, expected: Buffer): void {
  expect(bytes.subarray(0, 84).equals(expected.subarray(0, 84))).toBe(true);
  for (let at = 84; at < bytes.length; at += 50) {
    for (let i = 0; i < 3; ++i) {
      expect(bytes.readFloatLE(at + 4 * i)).toBeCloseTo(expected.readFloatLE(at + 4 * i), 6);
    }
    expect(bytes.subarray(at + 12, at + 50).equals(expected.subarray(at + 12, at + 50))).toBe(true);
  }
}

describe('shortestText', () => {
  it.each([
    [0, '0'],
    [-0, '0'],
    [0.1, '0.1'],
    [1e-4, '0.0001'],
    [1.5e-5, '1.5e-05'],
    [123456789012345, '123456789012345'],
    [1e16, '1e+16'],
    [5e-324, '5e-324'],
    [-1.25, '-1.25'],
    [0.30000000000000004, '0.30000000000000004'],
    [-0.00012345678901234567, '-0.00012345678901234567'],
    [9007199254740993, '9007199254740992'],
    [1234567.890123, '1234567.890123'],
  ])('writes %d as the program does', (x, text) => {
    expect(shortestText(x)).toBe(text);
  });
});
