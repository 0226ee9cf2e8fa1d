// SPDX-License-Identifier: MIT
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';

import { inFolder, kSamples, orthoball } from '../program';
import { picture, pixelsAround, settled, Viewer } from './browser';

const viewer = Viewer.ofThisFile();

interface Simplex {
  dimension: number;
  vertices: number[];
  enters: number;
  regular: number | null;
  interior: number | null;
}

function filterOf(input: string): Simplex[] {
  const lines = orthoball('filter', input, '--json').toString().trim().split('\n');
  return lines.map((line) => JSON.parse(line) as Simplex);
}

const cardOf = (page: Page) => page.getByRole('region', { name: 'What was picked' });

/** Whether the colour of what was picked, which lies above everything, is seen at a place. */
async function isMarked(page: Page, x: number, y: number, reach: number): Promise<boolean> {
  const pixels = await pixelsAround(page, x, y, reach);
  for (let i = 0; i < pixels.length; i += 4) {
    const [red, green, blue] = pixels.slice(i, i + 3);
    if (red - green > 70 && red > blue && blue > green) return true;
  }
  return false;
}

/** Clicks at places of a row of the canvas, until so many simplices were found there. */
async function pickAlong(page: Page, wanted: number, height = 0.45): Promise<Simplex[]> {
  const box = (await page.locator('canvas').first().boundingBox())!;
  const found: Simplex[] = [];
  for (let x = 330; x < box.width - 60 && found.length < wanted; x += 23) {
    const place = [box.x + x, box.y + height * box.height] as const;
    await page.keyboard.press('Escape');
    await page.mouse.click(...place);
    await settled(page);
    const card = cardOf(page);
    if ((await card.count()) === 0) continue;
    const rows = (await card.locator('li').allTextContents()).join(' ').matchAll(/row (\d+)/g);
    const vertices = [...rows].map(([, row]) => Number(row));
    const reach = vertices.length > 2 ? 3 : 6; // slivers at the rim; edges and points are wide
    expect(await isMarked(page, ...place, reach), `at ${x} is something else`).toBe(true);
    const cells = await card.locator('tr').allTextContents();
    const [enters, regular, interior] = cells.map((text) =>
      text.includes('never') ? null : Number(text.split(/\s+/).at(-1)!.replace(/,/g, '')),
    );
    found.push({ dimension: vertices.length - 1, vertices, enters: enters!, regular, interior });
  }
  expect(found.length).toBe(wanted);
  return found;
}

/** Each of these is in the filter, with the three indices that were shown. */
function expectInFilter(found: Simplex[], filter: Simplex[]): void {
  for (const { vertices, enters, regular, interior } of found) {
    const simplex = filter.find((other) => other.vertices.join() === vertices.join());
    expect(simplex).toMatchObject({ enters, regular, interior });
  }
}

describe('picking', () => {
  const surface = () => filterOf(kSamples.surface);

  it.each([
    ['', ''],
    ['without perspective, before the eye', '#projection=orthographic&camera=0+0+-3+0+0+0+1+0.9'],
    ['of what a plane leaves', '#clipAxis=view&clipPlace=0.1&show=regular+singular_triangles'],
    ['of components apart', '#explosion=0.4'],
    ['of all edges of the triangulation', '#show=wireframe&index=1'],
  ])('says who it is, with its three values: %s', async (_, hash) => {
    const page = await viewer.open(kSamples.surface, { hash });
    expectInFilter(await pickAlong(page, 5), surface());
    await page.context().close();
  });

  it.each([
    ['vertices', 0, 3],
    ['edges', 1, 4],
    ['triangles', 2, 5],
    ['tetrahedra', 3, 4],
  ])('of %s that have moved apart', async (part, dimension, wanted) => {
    const page = await viewer.open(kSamples.molecule, {
      hash: `#explodedPart=${part}&explosion=0.3&alpha2=9`,
    });
    const found = await pickAlong(page, wanted);
    expect(new Set(found.map((simplex) => simplex.dimension))).toEqual(new Set([dimension]));
    expectInFilter(found, filterOf(kSamples.molecule));
    await page.context().close();
  });

  it.each([
    ['whole', '#show=balls'],
    ['cut open', '#show=balls&clipAxis=view&clipPlace=0.05'],
    ['by its bonds', '#show=sticks'],
  ])('of atoms: %s', async (_, hash) => {
    const page = await viewer.open(kSamples.molecule, { hash });
    const found = await pickAlong(page, 3);
    expect(found.every(({ dimension }) => dimension === 0)).toBe(true);
    expect(await cardOf(page).locator('b').first().textContent()).toMatch(/of D[ACGT] \d+, chain/);
    expectInFilter(found, filterOf(kSamples.molecule));
    await page.context().close();
  });

  it('marks what was picked, and sends a wave from there', async () => {
    const page = await viewer.open(kSamples.surface);
    await pickAlong(page, 1);
    const marked = await picture(page);
    await cardOf(page)
      .getByLabel(/^Way of the wave/)
      .fill('0.4');
    const waving = await picture(page);
    await page.keyboard.press('Escape');
    expect(await cardOf(page).count()).toBe(0);
    expect(new Set([marked, waving, await picture(page)]).size).toBe(3);
    await page.locator('canvas').first().focus();
    await page.keyboard.press('Enter'); // what is in the middle: nothing, or something
    await page.context().close();
  });

  it('of hidden and equal sites tells that they are', async () => {
    await inFolder(async (folder) => {
      const input = join(folder, 'balls.csv');
      writeFileSync(input, 'x,y,r\n0,0,2\n0.1,0,0.5\n5,0,1\n0,5,1\n5,0,1\n');
      const args = ['--dimension', '2', '--radius-column', 'r'];
      // Every site is found where it is: scene units from the middle of their box.
      for (const [x, y, text] of [
        [-0.7071, -0.7071, 'row 0, line 2'],
        [-0.6788, -0.7071, 'row 1, line 3'],
        [0.7071, -0.7071, 'row 2, line 4 and equal to it: 4'],
        [-0.7071, 0.7071, 'row 3, line 5'],
      ] as const) {
        const hash = `#show=points&camera=${x}+${y}+0+0+0+0+1+0.5`;
        const page = await viewer.open(input, { args, hash });
        await page.locator('canvas').first().focus();
        await page.keyboard.press('Enter');
        await cardOf(page).waitFor();
        const shown = (await cardOf(page).locator('ul').textContent())!;
        expect(shown.replace(/\s+/g, ' ').trim()).toBe(text);
        const isHidden = (await cardOf(page).textContent())!.includes('its power cell is empty');
        expect(isHidden).toBe(text.startsWith('row 1,'));
        await page.context().close();
      }
    });
  });
});
