// SPDX-License-Identifier: MIT
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { describe, expect, it } from 'vitest';

import { inFolder, signatureRows } from '../program';
import { drawn, goToIndex, shownIndex, spectrumSize, Viewer, waitForIndex } from './browser';

const viewer = Viewer.ofThisFile();

describe('a large set', () => {
  /** So many atoms in a ball, a grid moved at random, always the same. */
  function manyAtoms(side: number): string {
    let state = 12345;
    const random = () => (state = (state * 48271) % 2147483647) / 2147483647 - 0.5;
    const atoms: string[] = [];
    for (let i = 0; i < side ** 3; ++i) {
      const grid = [i % side, Math.floor(i / side) % side, Math.floor(i / side ** 2)];
      const place = grid.map((c) => (1.6 * (c - side / 2) + random()).toFixed(3));
      if (Math.hypot(...grid.map((c) => c - side / 2)) < side / 2)
        atoms.push(`${'CNO'[i % 3]} ${place.join(' ')}`);
    }
    return `${atoms.length}\n\n${atoms.join('\n')}\n`;
  }

  it('of 200,000 atoms is shown, and a step costs what changes', async () => {
    await inFolder(async (folder) => {
      const input = join(folder, 'large.xyz');
      writeFileSync(input, manyAtoms(73));
      const page = await viewer.open(input);
      expect(Object.keys(await drawn(page)).sort()).toEqual(['regular_balls', 'singular_balls']);
      await page.getByLabel('Surface', { exact: true }).click();
      await page.getByLabel('Singular triangles', { exact: true }).click();
      const size = await spectrumSize(page);
      expect(size).toBeGreaterThan(1_048_576); // measures are rounded to 24 bits
      for (const row of signatureRows(input, [await shownIndex(page), Math.round(size / 2)])) {
        await goToIndex(page, row.index!);
        expect(await drawn(page)).toMatchObject({
          regular: row.regular_2,
          singular_triangles: row.singular_2,
        });
        const shown = await page.locator('dd').first().getAttribute('data-value');
        expect(Math.abs(Number(shown) / row.volume! - 1)).toBeLessThan(1e-7);
      }
      await page.locator('canvas').first().focus();
      const index = await shownIndex(page);
      await page.keyboard.press('ArrowRight');
      await waitForIndex(page, index + 1);
      const [bytes] = JSON.parse((await page.getAttribute('#viewer', 'data-cost'))!);
      expect(bytes).toBeLessThan(60_000);
      await page.context().close();
    });
  }, 240_000);
});
