// SPDX-License-Identifier: MIT

/** Disjoint sets over 0..size - 1. */
export class UnionFind {
  private readonly parent: Uint32Array;

  constructor(size: number) {
    this.parent = new Uint32Array(size);
    for (let i = 0; i < size; ++i) this.parent[i] = i;
  }

  /** The number that stands for the set of `i`. */
  find(i: number): number {
    const { parent } = this;
    while (parent[i] !== i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  unite(i: number, j: number): void {
    const [a, b] = [this.find(i), this.find(j)];
    if (a < b) this.parent[b] = a;
    else this.parent[a] = b;
  }
}
