// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import { describe, expect, it } from 'vitest';

import { kSamples, orthoball } from '../program';
import { Viewer } from './browser';

const viewer = Viewer.ofThisFile();

describe('people', () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

  it.each([
    ['light, in space', kSamples.molecule, '#theme=light&show=balls'],
    ['dark, in space', kSamples.surface, '#theme=dark&picked=2+7'],
    ['in the plane', kSamples.plane, '#theme=light'],
  ])('find nothing in their way: %s', async (_, input, hash) => {
    const page = await viewer.open(input, { hash });
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() =>
      (
        window as unknown as {
          axe: {
            run: () => Promise<{
              violations: {
                id: string;
                impact: string;
                nodes: { html: string; failureSummary: string }[];
              }[];
            }>;
          };
        }
      ).axe.run(),
    );
    const serious = violations.filter(
      ({ impact }) => impact === 'serious' || impact === 'critical',
    );
    expect(
      serious.map(({ id, nodes }) => [id, nodes.map((n) => `${n.html} ${n.failureSummary}`)]),
    ).toEqual([]);
    await page.context().close();
  });

  it('are told at their first visit what to do, until they do it', async () => {
    const page = await viewer.openText(orthoball('view', kSamples.surface, '-o', '-'), {
      isFirstVisit: true,
    });
    const hint = page.getByText('Drag to turn');
    await hint.waitFor();
    await page.keyboard.press('ArrowRight');
    await hint.waitFor({ state: 'detached' });
    await page.context().close();
  });

  it('reach every control by the keyboard, and each has a name', async () => {
    const page = await viewer.open(kSamples.molecule);
    const unnamed = await page
      .locator('button, select, input')
      .evaluateAll((all) =>
        (all as HTMLElement[])
          .filter(
            (e) =>
              e.tabIndex < 0 ||
              !(
                e.getAttribute('aria-label') ||
                e.title ||
                e.closest('label') ||
                e.textContent?.trim()
              ),
          )
          .map((e) => e.outerHTML),
      );
    expect(unnamed).toEqual([]);
    await page.context().close();
  });
});
