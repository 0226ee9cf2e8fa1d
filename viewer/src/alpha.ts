// SPDX-License-Identifier: MIT

/** sign(alpha2) sqrt|alpha2|: a length, for people. */
export function alphaFromAlpha2(alpha2: number): number {
  return Math.sign(alpha2) * Math.sqrt(Math.abs(alpha2));
}

/** alpha |alpha|. */
export function alpha2FromAlpha(alpha: number): number {
  return alpha * Math.abs(alpha);
}

/** How many entries of the ascending `values` are <= `value`: the index of an alpha2. */
export function countAtMost(values: ArrayLike<number>, value: number): number {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (values[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The alpha2 of an index of the spectrum; -infinity for 0, the empty complex. */
export function alpha2At(spectrum: Float64Array, index: number): number {
  return index === 0 ? -Infinity : spectrum[index - 1];
}

/** A number in `digits` significant digits, for reading. */
export function shownNumber(x: number, digits = 6): string {
  if (x === -Infinity) return '−∞';
  if (!Number.isFinite(x)) return '∞';
  const size = Math.abs(x);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) {
    return x
      .toExponential(digits - 1)
      .replace(/\.?0+e/, 'e')
      .replace('-', '−');
  }
  if (Number.isInteger(x)) return x.toLocaleString('en').replace('-', '−');
  const decimals = size === 0 ? 0 : Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return x
    .toLocaleString('en', { maximumFractionDigits: Math.min(decimals, 12) })
    .replace('-', '−');
}

/** "1 tunnel", "12 tunnels". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
}
