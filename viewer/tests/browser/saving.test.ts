// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';

import { kSamples, orthoball } from '../program';
import { goToIndex, picture, spectrumSize, Viewer } from './browser';

const viewer = Viewer.ofThisFile();

describe('saving', () => {
  it.each([
    ['ply', kSamples.molecule],
    ['glb', kSamples.surface],
    ['obj', kSamples.plane],
  ])('the shape as %s gives what the command line gives', async (format, input) => {
    const page = await viewer.open(input);
    const index = Math.round(0.4 * (await spectrumSize(page)));
    await goToIndex(page, index);
    await page.getByLabel('Format of the mesh').selectOption(format);
    const { name, bytes } = await viewer.saved(page, 'Save the shape');
    expect(name).toBe(input.replace(/.*\//, '').replace(/\.\w+$/, `.${format}`));
    expect(
      bytes.equals(orthoball('shape', input, '--index', String(index), '--format', format)),
    ).toBe(true);
    await page.context().close();
  });

  it('a picture has the size that was asked for; the table has a row for every index', async () => {
    const page = await viewer.open(kSamples.plane);
    await page.getByLabel('Width of the picture').fill('640');
    await page.getByLabel('Height of the picture').fill('480');
    const before = await picture(page);
    const { bytes } = await viewer.saved(page, 'Save picture');
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([640, 480]);
    expect(bytes.length).toBeGreaterThan(5000);
    expect(await picture(page)).toBe(before);
    const table = (await viewer.saved(page, 'Save signatures')).bytes.toString();
    expect(table.trim().split('\n').length).toBe(1 + (await spectrumSize(page)));
    await page.context().close();
  });
});
