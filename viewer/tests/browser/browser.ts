// SPDX-License-Identifier: MIT
//
// Pages that the program makes, opened from disk in Chromium, which draws in software.

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { chromium, type Browser, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, inject } from 'vitest';

import { orthoball } from '../program';

export class Viewer {
  private readonly faults: string[] = [];
  private browser!: Browser;
  private folder = '';
  private pages = 0;

  /** For the tests of a file, which fail where a page has faults. */
  static ofThisFile(): Viewer {
    const viewer = new Viewer();
    beforeAll(() => viewer.begin());
    afterEach(() => viewer.expectNoFaults());
    afterAll(() => viewer.end());
    return viewer;
  }

  private async begin(): Promise<void> {
    this.browser = await chromium.connect(inject('chromium'));
    this.folder = mkdtempSync(join(tmpdir(), 'orthoball-'));
  }

  private async end(): Promise<void> {
    await this.browser.close(); // the connection; others go on with the program
    rmSync(this.folder, { recursive: true });
  }

  /** Opens the page that the program makes of an input, and waits until it shows something. */
  async open(
    input: string,
    { args = [], hash = '' }: { args?: string[]; hash?: string } = {},
  ): Promise<Page> {
    return this.openText(orthoball('view', input, '-o', '-', ...args), { hash });
  }

  /** The same of a page's text. @param prepare  what to do before any script of the page runs. */
  async openText(
    text: Buffer | string,
    {
      hash = '',
      isFirstVisit = false,
      prepare = async () => {},
    }: { hash?: string; isFirstVisit?: boolean; prepare?: (page: Page) => Promise<unknown> } = {},
  ): Promise<Page> {
    const path = join(this.folder, `page-${this.pages++}.html`);
    writeFileSync(path, text);
    const context = await this.browser.newContext({ viewport: { width: 1100, height: 720 } });
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    page.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url())) this.faults.push(`asked for ${request.url()}`);
    });
    page.on('pageerror', (error) => this.faults.push(`threw ${error.message}`));
    page.on('console', (message) => {
      // Software rendering is slow at reading pixels back, and says so.
      if (message.type() === 'error') this.faults.push(`said ${message.text()}`);
    });
    if (!isFirstVisit)
      await page.addInitScript(() => localStorage.setItem('orthoball-hint', 'seen'));
    await prepare(page);
    await page.goto(`file://${path}${hash}`);
    await page.waitForFunction(() => {
      const data = document.getElementById('viewer')!.dataset;
      return data.drawn !== undefined || data.error !== undefined;
    });
    return page;
  }

  /** No page asked the network for anything, threw, or complained; forgets what they did. */
  private expectNoFaults(): void {
    expect(this.faults.splice(0)).toEqual([]);
  }

  /** What a click on a button saves. */
  async saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: button }).click(),
    ]);
    const path = join(this.folder, 'saved');
    await download.saveAs(path);
    return { name: download.suggestedFilename(), bytes: readFileSync(path) };
  }
}

/** How many simplices the last frame had, by layer. */
export async function drawn(page: Page): Promise<Record<string, number>> {
  return JSON.parse((await page.getAttribute('#viewer', 'data-drawn'))!) as Record<string, number>;
}

export async function shownIndex(page: Page): Promise<number> {
  return Number(await page.getAttribute('#viewer', 'data-index'));
}

export async function spectrumSize(page: Page): Promise<number> {
  return Number(await page.getByRole('slider', { name: /^alpha/ }).getAttribute('aria-valuemax'));
}

/** Waits for a frame at an index. */
export async function waitForIndex(page: Page, index: number): Promise<void> {
  await page.waitForFunction(
    (wanted) => document.getElementById('viewer')!.dataset.index === String(wanted),
    index,
  );
}

/** Types an index. */
export async function goToIndex(page: Page, index: number): Promise<void> {
  const input = page.getByLabel('index', { exact: true });
  await input.fill(String(index));
  await input.press('Enter');
  await waitForIndex(page, index);
}

/** Waits until what was done has been drawn, also what the page puts off for a moment. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise((resolve) =>
        setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(resolve)), 100),
      ),
  );
}

/** The shape as it is drawn now, without what lies above it: a text, equal for equal pictures. */
export async function picture(page: Page): Promise<string> {
  await settled(page);
  const style =
    '.overlay, .buttons, .hint { visibility: hidden !important } canvas { outline: 0 !important }';
  const shot = await page.locator('canvas').first().screenshot({ style });
  return shot.toString('base64');
}

/** [4 * pixel + channel]: what the page shows within so many pixels of a place. */
export async function pixelsAround(
  page: Page,
  x: number,
  y: number,
  reach: number,
): Promise<number[]> {
  const [left, top, side] = [Math.round(x) - reach, Math.round(y) - reach, 2 * reach + 1];
  const shot = await page.screenshot({ clip: { x: left, y: top, width: side, height: side } });
  return page.evaluate(
    async ({ png, size }) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const context = document.createElement('canvas').getContext('2d')!;
      context.drawImage(image, 0, 0);
      return [...context.getImageData(0, 0, size, size).data];
    },
    { png: shot.toString('base64'), size: side },
  );
}

/** How much two pictures differ: the mean of their numbers' differences, as a share of the largest. */
export function difference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async (pngs) => {
      let context: CanvasRenderingContext2D | null = null;
      let [width, height] = [1, 1];
      for (const png of pngs) {
        const image = new Image();
        image.src = `data:image/png;base64,${png}`;
        await image.decode();
        if (!context) {
          const canvas = document.createElement('canvas');
          [width, height] = [canvas.width, canvas.height] = [image.width, image.height];
          context = canvas.getContext('2d')!;
        } else {
          context.globalCompositeOperation = 'difference';
        }
        context.drawImage(image, 0, 0);
      }
      let sum = 0;
      const { data } = context!.getImageData(0, 0, width, height);
      data.forEach((x, i) => (sum += i % 4 < 3 ? x : 0));
      return sum / (3 * 255 * width * height);
    },
    [one, other],
  );
}
