// SPDX-License-Identifier: MIT
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

import { kSamples, orthoball, signatureRows } from '../program';
import { goToIndex, settled, shownIndex, spectrumSize, Viewer, waitForIndex } from './browser';

const viewer = Viewer.ofThisFile();

describe('the slider', () => {
  let page: Page;
  beforeAll(async () => void (page = await viewer.open(kSamples.surface)));
  afterAll(() => page.context().close());

  it('steps to the next event by the arrow keys, and far by Home and End', async () => {
    const start = await shownIndex(page);
    await page.keyboard.press('ArrowRight');
    await waitForIndex(page, start + 1);
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await waitForIndex(page, start - 1);
    await page.keyboard.press('Shift+ArrowRight');
    await waitForIndex(page, start + 9);
    await page.keyboard.press('End');
    await waitForIndex(page, await spectrumSize(page));
    await page.keyboard.press('Home');
    await waitForIndex(page, 1);
  });

  it('goes to notable alphas by Page Up and by their marks', async () => {
    const summary = JSON.parse(orthoball('summary', kSamples.surface, '--json').toString());
    const indexOf = (name: string): number =>
      summary.notable.find((n: { name: string }) => n.name === name).index;
    await goToIndex(page, indexOf('gap_0'));
    await page.locator('canvas').first().focus();
    await page.keyboard.press('PageUp');
    await waitForIndex(page, indexOf('gap_1'));
    await page.keyboard.press('PageDown');
    await waitForIndex(page, indexOf('gap_0'));
    await page.getByRole('button', { name: /^all vertices in cells/ }).click();
    await waitForIndex(page, indexOf('all_vertices_in_cells'));
  });

  it('goes where a curve is clicked, and follows a drag', async () => {
    const box = (await page.locator('.plot').last().boundingBox())!;
    const at = async (share: number): Promise<number> => {
      await page.mouse.move(box.x + share * box.width, box.y + 20);
      await settled(page);
      return shownIndex(page);
    };
    await at(0.2);
    await page.mouse.down();
    const [first, second, third] = [await at(0.25), await at(0.5), await at(0.9)];
    await page.mouse.up();
    expect(first).toBeLessThan(second);
    expect(second).toBeLessThan(third);
    expect(await at(0.3)).toBe(third);
  });

  it('is put where the number typed for alpha belongs', async () => {
    await page.getByLabel('alpha', { exact: true }).fill('0.3');
    await page.keyboard.press('Enter');
    const line = orthoball('signatures', kSamples.surface, '--alpha', '0.3')
      .toString()
      .split('\n')[1];
    await waitForIndex(page, Number(line.split(',')[0]));
    const slider = page.getByRole('slider', { name: /^alpha/ });
    expect(await slider.getAttribute('aria-valuetext')).toBe(
      'alpha 0.3, 2 components, 4 tunnels, 2 voids',
    );
  });

  it('sends little for a step, and tells what it cost', async () => {
    await goToIndex(page, 4000);
    await page.locator('canvas').first().focus();
    await page.keyboard.press('ArrowRight');
    await waitForIndex(page, 4001);
    const [bytes, drawCalls, milliseconds] = JSON.parse(
      (await page.getAttribute('#viewer', 'data-cost'))!,
    );
    expect(bytes).toBeGreaterThan(0);
    expect(bytes).toBeLessThan(40_000);
    expect(drawCalls).toBeLessThan(10);
    expect(milliseconds).toBeGreaterThan(0);
  });

  it('offers every signature, along three axes', async () => {
    for (const axis of ['index', 'alpha2', 'alpha']) {
      await page.getByLabel('along').selectOption(axis);
      await goToIndex(page, 3000);
      await page.locator('.marker').waitFor({ timeout: 5000 });
    }
    await page.getByRole('button', { name: 'log', exact: true }).click();
    const select = page.getByLabel('Quantity of curve 1');
    const names = await select
      .locator('option')
      .evaluateAll((all) => all.map((o) => (o as HTMLOptionElement).value));
    const row = signatureRows(kSamples.surface, [3000])[0];
    for (const name of names) {
      await select.selectOption(name);
      const text = await page.locator(`[data-quantity="${name}"]`).first().textContent();
      const number = Number(text!.replace(/,/g, '').replace('−', '-'));
      expect(number, name).toBeCloseTo(row[name]!, row[name]! > 100 ? 1 : 3);
    }
  });
});
