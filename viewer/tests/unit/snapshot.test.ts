// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { alphaFromAlpha2 } from '../../src/alpha';
import { quantitiesOf } from '../../src/quantities';
import { bytesFromBase64, readSnapshot, SnapshotError } from '../../src/snapshot';
import { kArrays } from '../../src/types';
import { orthoball, signatureRows, snapshotOf, sourceFile, spread, textOf } from '../program';

const kInputs = ['bdna_dodecamer.pdb', 'linked_tori.csv', 'figure_eight.csv', 'c60.xyz'].map(
  (name) => sourceFile(`examples/data/${name}`),
);

/** Rows of the tables of the description: names in backticks, then the other cells. */
function described(heading: string): string[][] {
  const text = textOf('docs/file_formats/snapshot.md')
    .split(`\n## ${heading}\n`)[1]
    .split('\n## ')[0];
  return [...text.matchAll(/^\| `(\w+)` \|(.*)\|$/gm)].map(([, name, rest]) => [
    name,
    ...rest.split(' | ').map((cell) => cell.trim()),
  ]);
}

describe('the description of snapshots', () => {
  it('lists the arrays that the viewer knows, with their types', () => {
    const arrays = described('The arrays').map(([name, type]) => [name, type.split(' or ')]);
    expect(Object.fromEntries(arrays)).toEqual(kArrays);
  });

  it('lists the members of the header that a program writes', async () => {
    const { facts } = await snapshotOf(kInputs[0]);
    expect(Object.keys(facts).sort()).toEqual(
      described('The header')
        .map(([name]) => name)
        .sort(),
    );
  });
});

describe.each(kInputs)('the snapshot of %s', (input) => {
  it('has every simplex of `orthoball filter` with its three indices', async () => {
    const snapshot = await snapshotOf(input);
    const never = snapshot.spectrum.length + 1;
    const own = new Map<string, number[]>();
    for (const { dimension, count, corners, enters, regular, interior } of snapshot.simplices) {
      for (let i = 0; i < count; ++i) {
        const vertices = corners.subarray((dimension + 1) * i, (dimension + 1) * (i + 1));
        const rows = [...vertices].map((v) => snapshot.vertexRows[v]).sort((a, b) => a - b);
        own.set(rows.join(' '), [enters[i], regular[i], interior[i]]);
      }
    }
    const lines = orthoball('filter', input, '--json').toString().trim().split('\n');
    expect(own.size).toBe(lines.length);
    for (const line of lines) {
      const simplex = JSON.parse(line);
      const { enters, regular, interior } = simplex;
      expect(own.get(simplex.vertices.join(' '))).toEqual([
        enters,
        regular ?? never,
        interior ?? never,
      ]);
      expect(snapshot.spectrum[enters - 1]).toBe(simplex.alpha2);
    }
  });

  it('has the numbers of `orthoball signatures`', async () => {
    const snapshot = await snapshotOf(input);
    const quantities = quantitiesOf(snapshot);
    const rows = signatureRows(input, spread(snapshot.spectrum.length, 50));
    for (const row of rows) {
      const index = row.index!;
      expect(snapshot.spectrum[index - 1]).toBe(row.alpha2);
      expect(alphaFromAlpha2(snapshot.spectrum[index - 1])).toBe(row.alpha);
      for (const { name, values } of quantities) {
        expect(row[name], `${name} of ${input}`).not.toBeUndefined();
        // The area of both sides is added up here, of two rounded numbers.
        if (name === 'area') expect(values()[index]).toBeCloseTo(row[name]!, 9);
        else expect([index, name, values()[index]]).toEqual([index, name, row[name]]);
      }
    }
  });
});

describe('bytesFromBase64', () => {
  it('puts a text together that comes in any parts', () => {
    const text = Buffer.from(Uint8Array.from({ length: 1000 }, (_, i) => (i * 7) % 256));
    for (const size of [1, 2, 3, 5, 64, 2000]) {
      const parts = text.toString('base64').match(new RegExp(`.{1,${size}}`, 'g'))!;
      expect(Buffer.from(bytesFromBase64(parts)).equals(text), `in parts of ${size}`).toBe(true);
    }
    expect(bytesFromBase64(['QU', 'I', '='])).toEqual(Uint8Array.from([65, 66]));
    expect(() => bytesFromBase64(['QUI'])).toThrow('cut short');
    expect(() => bytesFromBase64(['QU', '?='])).toThrow('do not belong');
  });
});

describe('readSnapshot', () => {
  it('says that other bytes are damaged', () => {
    const read = (bytes: Uint8Array<ArrayBuffer>) => () => readSnapshot(bytes);
    expect(read(new Uint8Array(0))).toThrow(SnapshotError);
    expect(read(new TextEncoder().encode('OBsnap9\n and more'))).toThrow('another version');
    expect(read(new TextEncoder().encode('OBsnap1\n\x40\0\0\0\0\0\0\0{"arrays":[]}'))).toThrow(
      'damaged',
    );
  });
});
