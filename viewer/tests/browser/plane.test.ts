// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { kSamples } from '../program';
import { picture, pixelsAround, Viewer } from './browser';

const viewer = Viewer.ofThisFile();

describe('in the plane', () => {
  it('disks, their power cells, points and the triangulation are layers', async () => {
    const page = await viewer.open(kSamples.plane, { hash: '#alpha2=0.01' });
    const seen = new Set([await picture(page)]);
    for (const name of [
      'Union of disks',
      'Power cells in the disks',
      'Triangles',
      'Outline',
      'Input points',
      'Whole triangulation',
      'Triangle sides',
      'Triangles',
    ]) {
      await page.getByLabel(name, { exact: true }).click();
      if (name !== 'Triangle sides') seen.add(await picture(page)); // triangles are hidden then
    }
    expect(seen.size).toBe(8);
    await page.keyboard.press('+');
    seen.add(await picture(page));
    expect(seen.size).toBe(9);
    await page.context().close();
  });

  it('holes are filled with colours of their own', async () => {
    for (const [x, [red, green, blue]] of [
      [-0.417, [86, 160, 215]],
      [0.417, [230, 159, 0]],
    ] as const) {
      const hash = `#index=2600&colour=void&background=black&camera=${x}+0+0+0+0+0+1+1`;
      const page = await viewer.open(kSamples.plane, { hash });
      const box = (await page.locator('canvas').first().boundingBox())!;
      const [middle, half] = [box.x + (box.width + 286) / 2, box.y + box.height / 2];
      const pixel = await pixelsAround(page, middle, half, 0);
      // As translucent as the triangles of the shape.
      [red, green, blue].forEach((c, i) => expect(pixel[i] / c || 0).toBeCloseTo(c && 0.75, 1));
      await page.context().close();
    }
  });

  it('a disk is picked where it is not behind another', async () => {
    const page = await viewer.open(kSamples.plane, { hash: '#show=balls&alpha2=0.05' });
    const box = (await page.locator('canvas').first().boundingBox())!;
    const card = page.getByRole('region', { name: 'What was picked' });
    const rows = new Set<string>();
    for (let x = 500; x < 620; x += 10) {
      await page.mouse.click(box.x + x, box.y + box.height / 2);
      if ((await card.count()) === 0) continue;
      expect(await card.getByRole('heading').textContent()).toContain('Vertex');
      rows.add((await card.locator('li').textContent())!.trim());
    }
    expect(rows.size).toBeGreaterThan(3);
    await page.context().close();
  });
});
