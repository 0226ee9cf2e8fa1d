// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { livesOf, longestLives, middleOf } from '../../src/persistence';
import { usefulRange } from '../../src/plot_range';
import { axisValues } from '../../src/state';
import { kSamples, snapshotOf } from '../program';
import { goToIndex, settled, shownIndex, Viewer, waitForIndex } from './browser';

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
