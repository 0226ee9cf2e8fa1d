// SPDX-License-Identifier: MIT
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';

import { dataOf, inFolder, orthoball, signatureRows, sourceFile, spread } from '../program';
import { drawn, goToIndex, picture, settled, shownIndex, Viewer, waitForIndex } from './browser';

const kMolecule = sourceFile('examples/data/bdna_dodecamer.pdb');
const kSurface = sourceFile('examples/data/linked_tori.csv');
const kPlane = sourceFile('examples/data/figure_eight.csv');

let viewer: Viewer;
beforeAll(async () => void (viewer = await Viewer.launch()));
afterEach(() => viewer.expectNoFaults());
afterAll(() => viewer.close());

async function spectrumSize(page: Page): Promise<number> {
  return Number(await page.getByRole('slider', { name: /^alpha/ }).getAttribute('aria-valuemax'));
}

describe.each([
  ['a molecule', kMolecule, 3],
  ['a scan', kSurface, 3],
  ['a planar set', kPlane, 2],
])('of %s', (_, input, dimension) => {
  it('are drawn as many simplices as `orthoball signatures` counts, at 50 indices', async () => {
    const page = await viewer.open(input);
    for (const row of signatureRows(input, spread(await spectrumSize(page), 50))) {
      await goToIndex(page, row.index!);
      const facets = dimension - 1;
      expect({ index: row.index, ...(await drawn(page)) }).toMatchObject({
        index: row.index,
        regular: row[`regular_${facets}`],
        singular_triangles: row.singular_2,
        singular_edges: row.singular_1,
        singular_vertices: row.singular_0,
        ...(dimension === 2 ? { interior: row.interior_2 } : {}),
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

describe('the slider', () => {
  let page: Page;
  beforeAll(async () => void (page = await viewer.open(kSurface)));
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
    const summary = JSON.parse(orthoball('summary', kSurface, '--json').toString());
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
    const line = orthoball('signatures', kSurface, '--alpha', '0.3').toString().split('\n')[1];
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
    const row = signatureRows(kSurface, [3000])[0];
    for (const name of names) {
      await select.selectOption(name);
      const text = await page.locator(`[data-quantity="${name}"]`).first().textContent();
      const number = Number(text!.replace(/,/g, '').replace('−', '-'));
      expect(number, name).toBeCloseTo(row[name]!, row[name]! > 100 ? 1 : 3);
    }
  });
});

describe('looking', () => {
  it('turns, zooms, rolls and resets by mouse and keys', async () => {
    const page = await viewer.open(kSurface);
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
    const page = await viewer.open(kMolecule);
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
    await page.getByLabel('by', { exact: true }).fill('0.5');
    const row = signatureRows(kMolecule, [await shownIndex(page)])[0];
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

  it('says of a picked simplex who it is, with its three values', async () => {
    const page = await viewer.open(kSurface);
    const simplices = orthoball('filter', kSurface, '--json')
      .toString()
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line));
    const box = (await page.locator('canvas').first().boundingBox())!;
    const card = page.getByRole('region', { name: 'What was picked' });
    let found = 0;
    for (let x = 330; x < box.width - 60 && found < 5; x += 37) {
      await page.mouse.click(box.x + x, box.y + 0.45 * box.height);
      await settled(page);
      if ((await card.count()) === 0) continue;
      ++found;
      const rows = [
        ...(await card.locator('li').allTextContents()).join(' ').matchAll(/row (\d+)/g),
      ].map(([, row]) => Number(row));
      const simplex = simplices.find(({ vertices }) => vertices.join() === rows.join());
      const cells = await card.locator('tr').allTextContents();
      const shown = cells.map((text) =>
        text.includes('never') ? null : Number(text.split(/\s+/).at(-1)!.replace(/,/g, '')),
      );
      expect(shown).toEqual([simplex.enters, simplex.regular, simplex.interior]);
    }
    expect(found).toBe(5);
    // It is marked, and a wave runs through what hangs together with it.
    const before = await picture(page);
    await page.keyboard.press('Escape');
    expect(await picture(page)).not.toBe(before);
    await page.locator('canvas').first().focus();
    for (let x = 330; (await card.count()) === 0; x += 31) {
      await page.mouse.click(box.x + x, box.y + 0.45 * box.height);
      await settled(page);
    }
    await card.getByLabel(/^Way of the wave/).fill('0.4');
    expect(await picture(page)).not.toBe(before);
    await page.keyboard.press('Escape');
    expect(await card.count()).toBe(0);
    await page.context().close();
  });

  it('keeps the view in the address, and comes back to it', async () => {
    const page = await viewer.open(kSurface);
    await goToIndex(page, 1234);
    await page.getByRole('combobox', { name: /^Colour by/ }).selectOption('component');
    await page.keyboard.press('d');
    const shown = await picture(page);
    await page.waitForTimeout(400);
    const hash = new URL(page.url()).hash;
    expect(hash).toContain('index=1234');
    const again = await viewer.open(kSurface, { hash });
    await again.mouse.move(0, 0);
    expect(await picture(again)).toBe(shown);
    await page.context().close();
    await again.context().close();
  });
});

describe('in the plane', () => {
  it('disks, their power cells, points and the triangulation are layers', async () => {
    const page = await viewer.open(kPlane, { hash: '#alpha2=0.01' });
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
});

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

describe('saving', () => {
  async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: button }).click(),
    ]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  }

  it.each([
    ['ply', kMolecule],
    ['glb', kSurface],
    ['obj', kPlane],
  ])('the shape as %s gives what the command line gives', async (format, input) => {
    const page = await viewer.open(input);
    const index = Math.round(0.4 * (await spectrumSize(page)));
    await goToIndex(page, index);
    await page.getByLabel('Format of the mesh').selectOption(format);
    const { name, bytes } = await saved(page, 'Save the shape');
    expect(name).toBe(input.replace(/.*\//, '').replace(/\.\w+$/, `.${format}`));
    expect(
      bytes.equals(orthoball('shape', input, '--index', String(index), '--format', format)),
    ).toBe(true);
    await page.context().close();
  });

  it('a picture has the size that was asked for; the table has a row for every index', async () => {
    const page = await viewer.open(kPlane);
    await page.getByLabel('Width of the picture').fill('640');
    await page.getByLabel('Height of the picture').fill('480');
    const before = await picture(page);
    const { bytes } = await saved(page, 'Save picture');
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([640, 480]);
    expect(bytes.length).toBeGreaterThan(5000);
    expect(await picture(page)).toBe(before);
    const table = (await saved(page, 'Save signatures')).bytes.toString();
    expect(table.trim().split('\n').length).toBe(1 + (await spectrumSize(page)));
    await page.context().close();
  });
});

describe('the end', () => {
  it('leaves nothing behind: no element, no key, no graphics context', async () => {
    const page = await viewer.open(kSurface);
    const isLost = await page.evaluate(() => {
      const host = document.getElementById('viewer')!;
      const gl = host.querySelector('canvas')!.getContext('webgl2')!;
      host.dispatchEvent(new Event('orthoball-dispose'));
      return new Promise((resolve) => setTimeout(() => resolve(gl.isContextLost()), 300));
    });
    expect(isLost).toBe(true);
    expect(await page.locator('#viewer').innerHTML()).toBe('');
    const index = await shownIndex(page);
    await page.keyboard.press('ArrowRight');
    await settled(page);
    expect(await shownIndex(page)).toBe(index);
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

describe('trouble', () => {
  const page = () => orthoball('view', kSurface, '-o', '-').toString();

  it.each([
    ['is not there', (data: string) => data && ''],
    ['is cut short', (data: string) => data.slice(0, 4 * Math.floor(data.length / 8))],
    [
      'has a wrong byte',
      (data: string) => data.slice(0, 9000) + (data[9000] === 'A' ? 'B' : 'A') + data.slice(9001),
    ],
    [
      'has a letter that does not belong there',
      (data: string) => `${data.slice(0, 800)}%${data.slice(801)}`,
    ],
  ])('is told where the data %s', async (_, damage) => {
    const text = page();
    const data = dataOf(text);
    const opened = await viewer.openText(text.replace(data, () => damage(data)));
    expect(await opened.getAttribute('#viewer', 'data-error')).toMatch(/damaged|missing/);
    expect(await opened.getByRole('alert').textContent()).toContain('orthoball view');
    await opened.context().close();
  });

  it('of a lost graphics context is waited for, and what was shown comes back', async () => {
    const opened = await viewer.open(kMolecule, { hash: '#colour=element' });
    const before = await picture(opened);
    await opened.evaluate(() => {
      const gl = document.querySelector('canvas')!.getContext('webgl2')!;
      const loss = gl.getExtension('WEBGL_lose_context')!;
      (window as unknown as { loss: typeof loss }).loss = loss;
      loss.loseContext();
    });
    const restore = () =>
      opened.evaluate(() =>
        (window as unknown as { loss: { restoreContext: () => void } }).loss.restoreContext(),
      );
    await opened.getByText('The graphics processor was lost').waitFor();
    await restore();
    await opened.getByText('The graphics processor was lost').waitFor({ state: 'detached' });
    expect(await picture(opened)).toBe(before);
    // What is chosen meanwhile is shown then.
    await opened.evaluate(() =>
      (window as unknown as { loss: { loseContext: () => void } }).loss.loseContext(),
    );
    await opened.getByText('The graphics processor was lost').waitFor();
    await opened.keyboard.press('End');
    await restore();
    const row = signatureRows(kMolecule, [await spectrumSize(opened)])[0];
    await waitForIndex(opened, row.index!);
    expect(await drawn(opened)).toMatchObject({
      regular: row.regular_2,
      singular_triangles: row.singular_2,
    });
    await opened.context().close();
  });

  it('with too many simplices for the graphics processor is told, with what to do', async () => {
    const opened = await viewer.openText(page(), {
      prepare: (p) =>
        p.addInitScript(() => {
          const old = WebGL2RenderingContext.prototype.getParameter;
          WebGL2RenderingContext.prototype.getParameter = function (name) {
            return name === this.MAX_TEXTURE_SIZE ? 1 : (old.call(this, name) as unknown);
          };
        }),
    });
    expect(await opened.getAttribute('#viewer', 'data-error')).toBe('too_large');
    expect(await opened.getByRole('alert').textContent()).toMatch(
      /takes 2,048 at most.*orthoball shape/,
    );
    await opened.context().close();
  });

  it('where WebGL 2 is missing is told; the curves work', async () => {
    const opened = await viewer.openText(page(), {
      prepare: (p) =>
        p.addInitScript(() => {
          const old = HTMLCanvasElement.prototype.getContext;
          HTMLCanvasElement.prototype.getContext = function (
            this: HTMLCanvasElement,
            type: string,
            ...rest: unknown[]
          ) {
            return type === 'webgl2'
              ? null
              : (old as (...a: unknown[]) => unknown).call(this, type, ...rest);
          } as typeof old;
        }),
    });
    expect(await opened.getAttribute('#viewer', 'data-error')).toBe('no_webgl');
    expect(await opened.getByRole('alert').textContent()).toContain('WebGL 2');
    await opened.keyboard.press('End');
    const slider = opened.getByRole('slider', { name: /^alpha/ });
    expect(await slider.getAttribute('aria-valuenow')).toBe(
      await slider.getAttribute('aria-valuemax'),
    );
    await opened.context().close();
  });
});

describe('people', () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

  it.each([
    ['light, in space', kMolecule, '#theme=light&show=balls'],
    ['dark, in space', kSurface, '#theme=dark&picked=2+7'],
    ['in the plane', kPlane, '#theme=light'],
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
    const page = await viewer.openText(orthoball('view', kSurface, '-o', '-'), {
      isFirstVisit: true,
    });
    const hint = page.getByText('Drag to turn');
    await hint.waitFor();
    await page.keyboard.press('ArrowRight');
    await hint.waitFor({ state: 'detached' });
    await page.context().close();
  });

  it('reach every control by the keyboard, and each has a name', async () => {
    const page = await viewer.open(kMolecule);
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
