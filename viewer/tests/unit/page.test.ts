// SPDX-License-Identifier: MIT
import { gzipSync } from 'node:zlib';

import { describe, expect, it } from 'vitest';

import { dataOf, orthoball, sourceFile, textOf } from '../program';

describe('the page', () => {
  const page = orthoball('view', sourceFile('examples/data/c60.xyz'), '-o', '-').toString();

  it('has less than 250 kB beside the data, packed', () => {
    expect(gzipSync(page.replace(dataOf(page), '')).length).toBeLessThan(250_000);
  });

  it('carries the notices of what it is made of', () => {
    for (const name of ['three.js authors', 'Svelte Contributors', 'Leon Sorokin']) {
      expect(page).toContain(name);
    }
  });
});

describe('the lockfile', () => {
  it('names no place to get packages from, and each by its content', () => {
    const { packages } = JSON.parse(textOf('viewer/package-lock.json')) as {
      packages: Record<string, { resolved?: string; integrity?: string }>;
    };
    for (const [name, entry] of Object.entries(packages)) {
      expect(entry.resolved, name).toBeUndefined();
      if (name !== '') expect(entry.integrity, name).toMatch(/^sha512-/);
    }
  });
});
