// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { dataOf, kSamples, orthoball, signatureRows } from '../program';
import { drawn, picture, settled, shownIndex, spectrumSize, Viewer, waitForIndex } from './browser';

const viewer = Viewer.ofThisFile();

describe('trouble', () => {
  const page = () => orthoball('view', kSamples.surface, '-o', '-').toString();

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

  it('is none where the data come in several elements, as large ones do', async () => {
    const text = page();
    const data = dataOf(text);
    const between = '</script>\n<script type="application/gzip">';
    const parts = data.match(/.{1,40000}/g)!.join(between);
    const opened = await viewer.openText(text.replace(data, () => parts));
    expect(await opened.getAttribute('#viewer', 'data-error')).toBeNull();
    await opened.context().close();
  });

  it('of a lost graphics context is waited for, and what was shown comes back', async () => {
    const opened = await viewer.open(kSamples.molecule, { hash: '#colour=element' });
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
    const row = signatureRows(kSamples.molecule, [await spectrumSize(opened)])[0];
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

describe('the end', () => {
  it('leaves nothing behind: no element, no key, no graphics context', async () => {
    const page = await viewer.open(kSamples.surface);
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
