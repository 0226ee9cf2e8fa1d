// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { livesOf, longestLives, middleOf } from '../../src/persistence';
import { usefulRange } from '../../src/plot_range';
import { representativeOf } from '../../src/representative';
import { axisValues } from '../../src/state';
import { kSamples, snapshotOf } from '../program';
import { drawn, goToIndex, pixelsAround, settled, shownIndex, Viewer, waitForIndex } from './browser';

const viewer = Viewer.ofThisFile();

describe('the persistence diagram', () => {
  it('leads to the birth of a life with what begins it, and to its middle', async () => {
    const snapshot = await snapshotOf(kSamples.surface);
    const x = axisValues(snapshot, 'alpha');
    const [life] = longestLives(livesOf(snapshot), x, 2, 1);
    const page = await viewer.open(kSamples.surface);
    const list = page.getByLabel('Go to one of the longest lives');
    const card = page.getByRole('region', { name: 'What was picked' });
    await list.selectOption('2 0');
    await waitForIndex(page, life.birth);
    expect(await card.getByRole('heading').textContent()).toContain('Triangle');
    await list.selectOption('2 0');
    await waitForIndex(page, middleOf(life, x));
    // The same by a click where it lies: along both axes as the curves have it.
    await goToIndex(page, 100);
    const canvas = page.locator('canvas').last();
    const { width, height } = (await canvas.boundingBox())!;
    expect(width).toBe(height);
    const [from, to] = usefulRange(snapshot, 'alpha');
    const along = (index: number) => 4 + ((x[index] - from) / (to - from)) * (width - 8);
    const position = { x: along(life.birth), y: height - along(life.death) };
    await canvas.hover({ position });
    await page.getByText(/^void, α 0.14\d* to 0.50\d*$/).waitFor();
    await canvas.click({ position });
    await waitForIndex(page, life.birth);
    await page.context().close();
  });

  it('shows what makes a class, and finds the class of what is picked', async () => {
    const snapshot = await snapshotOf(kSamples.surface);
    const x = axisValues(snapshot, 'alpha');
    const lives = livesOf(snapshot);
    const page = await viewer.open(kSamples.surface);
    const list = page.getByLabel('Go to one of the longest lives');
    const canvas = page.locator('canvas').last();
    const wait = (layer: string, count: number | undefined) =>
      expect.poll(async () => (await drawn(page))[layer], { timeout: 20_000 }).toBe(count);
    for (const k of [0, 1, 2]) {
      const [life] = longestLives(lives, x, k, 1);
      await list.selectOption(`${k} 0`);
      await list.selectOption(`${k} 0`);
      await waitForIndex(page, middleOf(life, x));
      const made = representativeOf(snapshot, life, middleOf(life, x));
      expect(made[k].length).toBeGreaterThan(0);
      for (const j of [0, 1, 2]) await wait(`class_${j}`, made[j].length);
      expect(await canvas.getAttribute('data-chosen')).toBe(`${k} ${life.begun}`);
    }
    await page.keyboard.press('Escape');
    await wait('class_2', undefined);
    expect(await canvas.getAttribute('data-chosen')).toBe('');
    // From an edge of a cycle to its tunnel, by the link of a view.
    const [tunnel] = longestLives(lives, x, 1, 1);
    const [, [edge]] = representativeOf(snapshot, tunnel, middleOf(tunnel, x));
    await page.context().close();
    const again = await viewer.open(kSamples.surface, {
      hash: `#index=${middleOf(tunnel, x)}&picked=1 ${edge}`,
    });
    const row = again.getByRole('button', { name: 'tunnel', exact: true }).first();
    await row.click();
    expect(await row.getAttribute('aria-pressed')).toBe('true');
    const chosen = again.locator('canvas').last();
    expect(await chosen.getAttribute('data-chosen')).toBe(`1 ${tunnel.begun}`);
    await again.waitForTimeout(400);
    expect(new URL(again.url()).hash).toContain(`class=1+${tunnel.begun}`);
    await again.context().close();
  });

  it('is led to by a click on a cycle in the scene', async () => {
    const snapshot = await snapshotOf(kSamples.surface);
    const x = axisValues(snapshot, 'alpha');
    const [tunnel] = longestLives(livesOf(snapshot), x, 1, 1);
    const page = await viewer.open(kSamples.surface, {
      hash: `#index=${middleOf(tunnel, x)}&show=points&class=1 ${tunnel.begun}`,
    });
    await settled(page);
    const box = (await page.locator('canvas').first().boundingBox())!;
    // Right of the middle, where the cycle is.
    const middle = Math.round(box.x + 0.75 * box.width);
    const centre = Math.round(box.y + 0.53 * box.height);
    const reach = 70;
    const pixels = await pixelsAround(page, middle, centre, reach);
    const places: [number, number][] = [];
    for (let i = 0; i < pixels.length / 4; ++i) {
      const [red, green, blue] = pixels.slice(4 * i, 4 * i + 3);
      const isOfClass = red > 190 && green > 70 && green < 125 && blue < 50;
      const side = 2 * reach + 1;
      const place: [number, number] = [i % side, Math.floor(i / side)];
      if (isOfClass) places.push([middle - reach + place[0], centre - reach + place[1]]);
    }
    expect(places.length).toBeGreaterThan(100);
    await page.keyboard.press('Escape');
    const chart = page.locator('canvas').last();
    expect(await chart.getAttribute('data-chosen')).toBe('');
    let chosen = '';
    for (let i = 0; i < 60 && chosen === ''; ++i) {
      await page.mouse.click(...places[Math.floor((i * places.length) / 60)]);
      chosen = (await chart.getAttribute('data-chosen'))!;
    }
    expect(chosen).toBe(`1 ${tunnel.begun}`);
    await page.context().close();
  });

  it('shows those alive in another way than others, and goes away', async () => {
    const page = await viewer.open(kSamples.plane, { hash: '#index=100' });
    const canvas = page.locator('canvas').last();
    const seen = new Set<string>();
    for (const index of [100, 1500, 2783]) {
      await goToIndex(page, index);
      await settled(page);
      seen.add((await canvas.screenshot()).toString('base64'));
    }
    await page.getByRole('button', { name: 'log', exact: true }).click();
    await settled(page);
    seen.add((await canvas.screenshot()).toString('base64'));
    expect(seen.size).toBe(4);
    expect(await canvas.getAttribute('aria-label')).toContain('1 component, 2 holes');
    await page.getByRole('button', { name: 'persistence' }).click();
    const panel = { name: 'Persistence' };
    expect(await page.getByRole('region', panel).count()).toBe(0);
    await page.waitForTimeout(400);
    const hash = new URL(page.url()).hash;
    const again = await viewer.open(kSamples.plane, { hash });
    expect(await again.getByRole('region', panel).count()).toBe(0);
    expect(await shownIndex(again)).toBe(2783);
    await page.context().close();
    await again.context().close();
  });
});
