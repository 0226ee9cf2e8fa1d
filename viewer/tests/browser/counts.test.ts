// SPDX-License-Identifier: MIT
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { describe, expect, it } from 'vitest';

import { hasSharedData, inFolder, kSamples, sharedFile, signatureRows, spread } from '../program';
import { drawn, goToIndex, spectrumSize, Viewer, waitForIndex } from './browser';

const viewer = Viewer.ofThisFile();

// Of proteins balls are seen first.
const kAllLayers = '#show=regular+singular_triangles+singular_edges+singular_vertices+interior';

interface Input {
  name: string;
  input: string;
  dimension: number;
  args?: string[];
}
const kOurs: Input[] = [
  { name: 'a molecule', input: kSamples.molecule, dimension: 3 },
  { name: 'a surface', input: kSamples.surface, dimension: 3 },
  { name: 'a planar set', input: kSamples.plane, dimension: 2 },
];
const kShared: Input[] = [
  { name: 'a protein', input: sharedFile('mol/1tim.pdb'), dimension: 3 },
  { name: 'a scan', input: sharedFile('cloud/bunny.off'), dimension: 3 },
  {
    name: 'places on a map',
    input: sharedFile('gis/airports.csv'),
    dimension: 2,
    args: ['--columns', 'longitude,latitude'],
  },
];

describe.each(hasSharedData ? [...kOurs, ...kShared] : kOurs)('of $name', (one) => {
  const { input, dimension, args = [] } = one;
  it('are drawn as many simplices as `orthoball signatures` counts, at 50 indices', async () => {
    const page = await viewer.open(input, { args, hash: kAllLayers });
    for (const row of signatureRows(input, spread(await spectrumSize(page), 50), ...args)) {
      await goToIndex(page, row.index!);
      const facets = dimension - 1;
      expect({ index: row.index, ...(await drawn(page)) }).toMatchObject({
        index: row.index,
        regular: row[`regular_${facets}`],
        singular_triangles: row.singular_2,
        singular_edges: row.singular_1,
        singular_vertices: row.singular_0,
        interior: row.interior_2,
      });
      const betti = await page.locator('[data-betti]').getAttribute('data-betti');
      expect(betti).toBe(
        [0, 1, 2]
          .slice(0, dimension)
          .map((k) => row[`betti_${k}`])
          .join(' '),
      );
    }
    await page.context().close();
  });
});

describe('degenerate input', () => {
  it.each([
    ['no site', 'x,y,z\n', 0],
    ['one site', 'x,y,z\n1,2,3\n', 1],
    ['equal sites', 'x,y,z\n1,2,3\n1,2,3\n', 1],
    ['a line', 'x,y,z\n0,0,0\n1,1,1\n2,2,2\n4,4,4\n', 4],
    ['a plane in space', 'x,y,z\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n5,5,1\n', 5],
    ['one site in the plane', 'x,y\n1,2\n', 1],
    ['a line in the plane', 'x,y\n0,0\n1,1\n3,3\n', 3],
    ['far apart', 'x,y,z\n0,0,0\n1e-9,0,0\n0,1e9,0\n0,0,1e12\n1e12,1,1\n', 5],
  ])('of %s is shown, and every layer', async (_, text, vertices) => {
    await inFolder(async (folder) => {
      const input = join(folder, 'points.csv');
      writeFileSync(input, text);
      const page = await viewer.open(input, { args: ['--allow-empty'], hash: '#index=1' });
      expect(await page.getAttribute('#viewer', 'data-error')).toBeNull();
      for (const box of await page.getByRole('checkbox').all()) await box.click();
      await page.keyboard.press('End');
      await waitForIndex(page, await spectrumSize(page));
      const colour = page.getByRole('combobox', { name: /^Colour by/ });
      for (const option of await colour.locator('option').all()) {
        await colour.selectOption((await option.getAttribute('value'))!);
      }
      await page.getByText('Counts by role').click();
      const first = page.locator('details tbody tr').first();
      await first.waitFor();
      const row = await first.locator('td').allTextContents();
      expect(row.reduce((sum, count) => sum + Number(count), 0)).toBe(vertices);
      await page.context().close();
    });
  });
});
