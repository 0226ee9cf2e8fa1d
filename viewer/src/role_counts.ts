// SPDX-License-Identifier: MIT

import { countAtMost } from './alpha';
import type { Role, Snapshot } from './types';

/** Numbers of simplices by role at any index, each in logarithmic time. */
export class RoleCounts {
  /** [dimension]: the three indices of its simplices, each by itself in ascending order. */
  private readonly sorted: Record<'enters' | 'regular' | 'interior', Uint32Array>[];

  constructor(snapshot: Snapshot) {
    this.sorted = snapshot.simplices.map(({ enters, regular, interior }) => {
      const sorted = enters.slice().sort();
      const isCell = regular === enters;
      return {
        enters: sorted,
        regular: isCell ? sorted : regular.slice().sort(),
        interior: isCell ? sorted : interior.slice().sort(),
      };
    });
  }

  at(index: number, dimension: number): Record<Role, number> {
    const { enters, regular, interior } = this.sorted[dimension];
    const [e, r, i] = [enters, regular, interior].map((indices) => countAtMost(indices, index));
    return { exterior: enters.length - e, singular: e - r, regular: r - i, interior: i };
  }
}
