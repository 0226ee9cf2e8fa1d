// SPDX-License-Identifier: MIT
//
// Takes the pictures of the viewer in docs/pictures: node tools/viewer_pictures.mjs PROGRAM

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { launched } from './chromium.mjs';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '..');

const kPictures = [
  {
    name: 'viewer_dna',
    input: 'bdna_dodecamer.pdb',
    theme: 'dark',
    hash: '#show=balls&colour=residue',
    zoom: 0.98,
  },
  {
    name: 'viewer_linked_tori',
    input: 'linked_tori.csv',
    theme: 'light',
    hash: '#colour=component',
    zoom: 1.08,
  },
  {
    name: 'viewer_uneven_torus',
    input: 'uneven_torus.csv',
    options: ['--alpha2', '0.0169025'],
    theme: 'light',
    hash: '#colour=role',
    zoom: 0.72,
  },
  {
    name: 'viewer_uneven_torus_weighted',
    input: 'uneven_torus.csv',
    options: ['--weights', 'density:12', '--alpha2', '0'],
    theme: 'light',
    hash: '#colour=role',
    zoom: 0.72,
  },
];

const [program] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'orthoball-'));
const browser = await launched();
try {
  for (const { name, input, options = [], theme, hash, zoom } of kPictures) {
    const file = join(folder, `${name}.html`);
    const data = join(kRoot, 'examples/data', input);
    execFileSync(program, ['view', data, ...options, '-o', file, '--quiet']);
    const page = await browser.newPage({
      viewport: { width: 1280, height: 800 },
      colorScheme: theme,
    });
    await page.addInitScript(() => localStorage.setItem('orthoball-hint', 'seen'));
    await page.goto(`file://${file}${hash}`);
    await page.waitForFunction(() => document.getElementById('viewer').dataset.drawn);
    await page.mouse.move(640, 300);
    await page.mouse.wheel(0, -Math.log(zoom) / 0.0015);
    await page.mouse.move(0, 0);
    await page.waitForTimeout(1000);
    await page.screenshot({
      path: join(kRoot, `docs/pictures/${name}.jpg`),
      type: 'jpeg',
      quality: 88,
    });
    await page.close();
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
