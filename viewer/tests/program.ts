// SPDX-License-Identifier: MIT
//
// The program, and pages that it makes, for tests.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

import { bytesFromBase64, gunzipped, readSnapshot } from '../src/snapshot';
import type { Snapshot } from '../src/types';

const kRoot = resolve(import.meta.dirname, '../..');

/** A file of the source tree. */
export function sourceFile(name: string): string {
  return join(kRoot, name);
}

/** A file of the shared data, which may lie beside the source tree. */
export function sharedFile(name: string): string {
  return join(kRoot, '../shared/data', name);
}

/** Whether the shared data are there; says so where not. */
export const hasSharedData = existsSync(sharedFile(''));
if (!hasSharedData) console.warn('tests of files in ../shared/data are skipped: it is not there');

export const kSamples = {
  molecule: sourceFile('examples/data/bdna_dodecamer.pdb'),
  surface: sourceFile('examples/data/linked_tori.csv'),
  plane: sourceFile('examples/data/figure_eight.csv'),
};

/** What the program prints. */
export function orthoball(...args: string[]): Buffer {
  const program = process.env.ORTHOBALL_PROGRAM;
  if (!program) throw new Error('ORTHOBALL_PROGRAM is not set: the path of the program to test');
  return execFileSync(program, [...args, '--quiet'], { maxBuffer: 1 << 30 });
}

/** Calls `use` with a folder that is removed afterwards. */
export async function inFolder<T>(use: (folder: string) => T | Promise<T>): Promise<T> {
  const folder = mkdtempSync(join(tmpdir(), 'orthoball-'));
  try {
    return await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The data of a page. */
export function dataOf(page: string): string {
  const begin = page.indexOf('id="snapshot">') + 'id="snapshot">'.length;
  return page.slice(begin, page.indexOf('</script>', begin)).trim();
}

/** The snapshot that the program makes of an input. */
export async function snapshotOf(input: string, ...args: string[]): Promise<Snapshot> {
  const page = orthoball('view', input, '-o', '-', ...args).toString();
  return readSnapshot(await gunzipped(bytesFromBase64([dataOf(page)])));
}

/** A row of `orthoball signatures --json`, by the names that the columns of the CSV have. */
export type SignatureRow = Record<string, number | null>;

export function signatureRows(
  input: string,
  indices: readonly number[],
  ...args: string[]
): SignatureRow[] {
  const rows = JSON.parse(
    orthoball('signatures', input, '--index', indices.join(','), '--json', ...args).toString(),
  ) as Record<string, number | null | number[]>[];
  return rows.map((row) =>
    Object.fromEntries(
      Object.entries(row).flatMap(([name, value]): [string, number | null][] =>
        Array.isArray(value) ? value.map((number, k) => [`${name}_${k}`, number]) : [[name, value]],
      ),
    ),
  );
}

/** `count` indices spread over 1..size, both ends among them. */
export function spread(size: number, count: number): number[] {
  const indices = Array.from(
    { length: count },
    (_, i) => 1 + Math.round((i * (size - 1)) / (count - 1)),
  );
  return [...new Set(indices)];
}

export function textOf(name: string): string {
  return readFileSync(sourceFile(name), 'utf8');
}
