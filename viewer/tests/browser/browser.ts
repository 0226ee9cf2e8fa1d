// SPDX-License-Identifier: MIT
//
// Pages that the program makes, opened from disk in Chromium, which draws in software.

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { chromium, type Browser, type Page } from 'playwright-core';
import { expect } from 'vitest';

import { orthoball } from '../program';

export class Viewer {
  private constructor(
    private readonly browser: Browser,
    private readonly folder: string,
  ) {}
  private readonly faults: string[] = [];

  static async launch(): Promise<Viewer> {
    const browser = await chromium.launch({
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: [
        '--no-sandbox',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
        '--disable-background-networking',
      ],
    });
    return new Viewer(browser, mkdtempSync(join(tmpdir(), 'orthoball-')));
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
  private pages = 0;

  /** No page asked the network for anything, threw, or complained; forgets what they did. */
  expectNoFaults(): void {
    expect(this.faults.splice(0)).toEqual([]);
  }

  async close(): Promise<void> {
    await this.browser.close();
    rmSync(this.folder, { recursive: true });
  }
}

/** How many simplices the last frame had, by layer. */
export async function drawn(page: Page): Promise<Record<string, number>> {
  return JSON.parse((await page.getAttribute('#viewer', 'data-drawn'))!) as Record<string, number>;
}

export async function shownIndex(page: Page): Promise<number> {
  return Number(await page.getAttribute('#viewer', 'data-index'));
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
