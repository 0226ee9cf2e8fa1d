// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { kSamples, signatureRows } from '../program';
import { difference, drawn, goToIndex, picture, shownIndex, Viewer } from './browser';

const viewer = Viewer.ofThisFile();

describe('looking', () => {
  it('turns, zooms, rolls and resets by mouse and keys', async () => {
    const page = await viewer.open(kSamples.surface);
    const start = await picture(page);
    const seen = new Set([start]);
    const box = (await page.locator('canvas').first().boundingBox())!;
    await page.mouse.move(box.x + 500, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 600, box.y + 330);
    await page.mouse.up();
    seen.add(await picture(page));
    for (const key of ['d', '+', 'q', 'W']) {
      await page.keyboard.press(key);
      seen.add(await picture(page));
    }
    await page.mouse.wheel(0, -200);
    seen.add(await picture(page));
    expect(seen.size).toBe(7);
    await page.keyboard.press('0');
    await page.mouse.move(0, 0);
    expect(await picture(page)).toBe(start);
    await page.context().close();
  });

  it('shows each layer and look differently', async () => {
    const page = await viewer.open(kSamples.molecule);
    const plain = await picture(page);
    const seen = new Set([plain]);
    let count = 1;
    const see = async (what: string) => {
      seen.add(await picture(page));
      expect(seen.size, `${what} changes nothing`).toBe(++count);
    };
    const toggles = [
      'Surface',
      'Singular triangles',
      'Input points',
      'Whole triangulation',
      'Backbone',
      'Bonds',
      'Union of balls',
    ];
    for (const name of toggles) {
      await page.getByLabel(name, { exact: true }).click();
      await see(name);
    }
    for (const name of [
      'Input points',
      'Whole triangulation',
      'Backbone',
      'Bonds',
      'Singular triangles',
      'Surface',
    ]) {
      await page.getByLabel(name, { exact: true }).click();
    }
    await page.getByLabel('Union of balls').click();
    for (const colour of ['component', 'dimension', 'void', 'element', 'residue', 'chain']) {
      await page.getByRole('combobox', { name: /^Colour by/ }).selectOption(colour);
      await page.getByRole('list', { name: `Legend: colour by ${colour}` }).waitFor();
      seen.add(await picture(page));
    }
    expect(seen.size).toBeGreaterThan(count + 4); // one chain may look as one component does
    await page.getByRole('combobox', { name: /^Colour by/ }).selectOption('role');
    count = seen.size;
    await page.getByLabel('Projection').selectOption('orthographic');
    await see('orthographic');
    await page.getByLabel('Clip').selectOption('x');
    await see('clip');
    await page.getByLabel('Plane at').fill('0.2');
    await see('clip plane');
    await page.getByLabel('Clip').selectOption('off');
    await page.getByLabel('Apart by', { exact: true }).fill('0.5');
    const row = signatureRows(kSamples.molecule, [await shownIndex(page)])[0];
    for (const [k, part] of ['vertices', 'edges', 'triangles', 'tetrahedra'].entries()) {
      await page.getByLabel('Explode').selectOption(part);
      await see(part);
      const all = row[`singular_${k}`]! + row[`regular_${k}`]! + row[`interior_${k}`]!;
      expect(await drawn(page)).toEqual({ [`apart_${k}`]: all });
    }
    await page.getByLabel('Explode').selectOption('components');
    await page.getByLabel('Opacity').fill('0.4');
    await see('opacity');
    await page.getByLabel('Theme').selectOption('dark');
    await see('dark');
    await page.getByLabel('Background').selectOption('white');
    await see('white');
    await page.context().close();
  });

  it('keeps the view in the address, and comes back to it', async () => {
    const page = await viewer.open(kSamples.surface);
    await goToIndex(page, 1234);
    await page.getByRole('combobox', { name: /^Colour by/ }).selectOption('component');
    await page.locator('canvas').first().focus();
    await page.keyboard.press('d');
    const shown = await picture(page);
    await page.waitForTimeout(400);
    const hash = new URL(page.url()).hash;
    expect(hash).toContain('index=1234');
    expect(hash).toContain('camera=');
    const again = await viewer.open(kSamples.surface, { hash });
    await again.mouse.move(0, 0);
    // Where edges are equally near, the one drawn last is seen: that differs.
    expect(await difference(page, shown, await picture(again))).toBeLessThan(1e-4);
    await page.keyboard.press('d');
    expect(await difference(page, shown, await picture(page))).toBeGreaterThan(1e-3);
    await page.context().close();
    await again.context().close();
  });
});
