// SPDX-License-Identifier: MIT
//
// What the viewer costs: size of the page, time to open it, and of a step of the slider and a frame, drawn
// in software by Chromium. Prints a table.
//
//   node benchmarks/viewer.mjs PROGRAM [TRIANGLES...]

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { launched } from '../tools/chromium.mjs';

const [program, ...sizes] = process.argv.slice(2);
const kTrianglesOfSite = 13.5;
const kSteps = 24;

/** Uniform points in the unit cube, always the same. */
function points(count) {
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  return Array.from({ length: count }, () =>
    [random(), random(), random()].map((x) => x.toFixed(6)).join(','),
  );
}

/** In the page: steps by keys, each drawn to the end. Milliseconds and bytes a step. */
async function steps({ key, count }) {
  const canvas = document.querySelector('canvas');
  const gl = canvas.getContext('webgl2');
  const host = document.getElementById('viewer');
  const pixel = new Uint8Array(4);
  const drawnFrame = () =>
    new Promise((resolve) =>
      requestAnimationFrame(() => {
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits for the frame
        resolve();
      }),
    );
  await drawnFrame();
  let [bytes, inScript, calls] = [0, 0, 0];
  const begin = performance.now();
  for (let i = 0; i < count; ++i) {
    const before = performance.now();
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    inScript += performance.now() - before;
    await drawnFrame();
    const cost = JSON.parse(host.dataset.cost);
    bytes += cost[0];
    calls = cost[1];
  }
  const all = performance.now() - begin;
  return { frame: all / count, script: inScript / count, bytes: bytes / count, calls };
}

const folder = mkdtempSync(join(tmpdir(), 'orthoball-'));
const browser = await launched();
console.log(
  '| triangles | sites | page | bytes a site | open | drawn | step: script | step: sent | frame, step | frame, turn | draw calls |',
);
console.log('|---|---|---|---|---|---|---|---|---|---|---|');
try {
  for (const triangles of sizes.length > 0 ? sizes.map(Number) : [1e5, 1e6, 3e6]) {
    const sites = Math.round(triangles / kTrianglesOfSite);
    const [input, output] = [join(folder, 'points.csv'), join(folder, 'page.html')];
    writeFileSync(input, points(sites).join('\n'));
    execFileSync(program, ['view', input, '-o', output, '--quiet']);
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    const begin = performance.now();
    await page.goto(`file://${output}`);
    await page.waitForFunction(() => document.getElementById('viewer').dataset.drawn, null, {
      timeout: 300_000,
    });
    const open = performance.now() - begin;
    // Where the boundary is large.
    const last = Number(await page.locator('[role=slider]').getAttribute('aria-valuemax'));
    const middle = String(Math.round(0.55 * last));
    await page.getByLabel('index', { exact: true }).fill(middle);
    await page.keyboard.press('Enter');
    await page.waitForFunction(
      (i) => document.getElementById('viewer').dataset.index === i,
      middle,
    );
    await page.locator('canvas').first().focus();
    const drawn = JSON.parse(await page.getAttribute('#viewer', 'data-drawn'));
    const step = await page.evaluate(steps, { key: 'ArrowRight', count: kSteps });
    const turn = await page.evaluate(steps, { key: 'd', count: kSteps });
    const size = statSync(output).size;
    console.log(
      `| ${triangles.toLocaleString('en')} | ${sites.toLocaleString('en')} | ${(size / 1e6).toFixed(1)} MB | ${Math.round(size / sites)} | ` +
        `${(open / 1000).toFixed(1)} s | ${(drawn.regular + drawn.singular_triangles).toLocaleString('en')} | ${step.script.toFixed(2)} ms | ` +
        `${Math.round(step.bytes).toLocaleString('en')} bytes | ${step.frame.toFixed(1)} ms | ${turn.frame.toFixed(1)} ms | ${step.calls} |`,
    );
    await page.close();
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
