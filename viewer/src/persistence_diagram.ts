// SPDX-License-Identifier: MIT
//
// Draws lives as points: birth to the right, death upwards, dimensions told apart by colour and shape
// as `orthoball persistence --plot` does. Those alive at the current index lie in a lit quadrant.

import type { Life } from './persistence';

/** [dimension]; of Okabe and Ito. */
const kLifeColours = ['#0072b2', '#d55e00', '#009e73'] as const;
const kLifeColoursOnDark = ['#56b4e9', '#ff9a4d', '#2fd0a0'] as const;

export interface DiagramLook {
  isDark: boolean;
  axis: string;
  text: string;
  quadrant: string;
  marker: string;
}

export function lifeColours(isDark: boolean): readonly string[] {
  return isDark ? kLifeColoursOnDark : kLifeColours;
}

/** Circles, triangles and squares. */
function mark(
  context: CanvasRenderingContext2D,
  dimension: number,
  x: number,
  y: number,
  r: number,
) {
  if (dimension === 0) {
    context.moveTo(x + r, y);
    context.arc(x, y, r, 0, 2 * Math.PI);
  } else if (dimension === 1) {
    context.moveTo(x, y - 1.3 * r);
    context.lineTo(x + 1.2 * r, y + 0.8 * r);
    context.lineTo(x - 1.2 * r, y + 0.8 * r);
    context.closePath();
  } else {
    context.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
  }
}

const kShortest = 0.5; // CSS pixels; shorter lives are not told apart from nothing
const kInset = 4; // that marks at the ends are whole
const kMark = 2.4;
const kFaint = 0.35; // not alive
const kLine = 1.5; // half of a mark on the quadrant's edge is seen
const kMarksAtOnce = 200; // long paths take much longer than many
const kReach = 8; // of the mouse

export class PersistenceDiagram {
  private readonly context: CanvasRenderingContext2D;
  /** Drawn once: what lies behind, and the marks of all lives. */
  private readonly back = document.createElement('canvas');
  private readonly marks = document.createElement('canvas');
  private side = 0;
  private look: DiagramLook | null = null;
  /** Those long enough to be seen, and where they are, CSS pixels. */
  private lives: Life[] = [];
  private x = new Float32Array(0);
  private y = new Float32Array(0);
  private placeOf: (index: number) => number = () => 0;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
  }

  /**
   * Other lives, or another axis, size or look. Returns how many are seen.
   * @param place  [index]: 0..1 along the axis; what is beyond it lies at its end.
   */
  prepare(
    lives: readonly Life[],
    place: (index: number) => number,
    side: number,
    look: DiagramLook,
  ): number {
    const span = side - 2 * kInset;
    this.placeOf = (index) => span * Math.min(1, Math.max(0, place(index)));
    this.side = side;
    this.look = look;
    this.lives = lives.filter(
      ({ birth, death }) =>
        place(birth) <= 1 && this.placeOf(death) - this.placeOf(birth) >= kShortest,
    );
    this.x = Float32Array.from(this.lives, ({ birth }) => kInset + this.placeOf(birth));
    this.y = Float32Array.from(this.lives, ({ death }) => side - kInset - this.placeOf(death));
    const ratio = window.devicePixelRatio;
    for (const canvas of [this.canvas, this.back, this.marks]) {
      canvas.width = canvas.height = Math.round(side * ratio);
      canvas.getContext('2d')!.scale(ratio, ratio);
    }
    this.canvas.style.width = this.canvas.style.height = `${side}px`;
    const context = this.back.getContext('2d')!;
    context.strokeStyle = look.axis;
    context.strokeRect(0.5, 0.5, side - 1, side - 1);
    context.beginPath();
    context.moveTo(0, side);
    context.lineTo(side, 0);
    context.stroke();
    // Where no life is.
    context.fillStyle = look.text;
    context.font = '10.5px system-ui, sans-serif';
    context.textAlign = 'right';
    context.fillText('death ↑', side - 6, side - 20);
    context.fillText('birth →', side - 6, side - 7);
    this.drawMarks(this.marks.getContext('2d')!);
    return this.lives.length;
  }

  // One mark is drawn of those that would lie on each other: there may be a million.
  private drawMarks(context: CanvasRenderingContext2D): void {
    const across = 2 * this.side;
    const isTaken = [0, 1, 2].map(() => new Uint8Array(across * across));
    const places = [0, 1, 2].map(() => [] as number[]);
    this.lives.forEach(({ dimension }, i) => {
      const cell = Math.floor(2 * this.y[i]) * across + Math.floor(2 * this.x[i]);
      if (isTaken[dimension][cell]) return;
      isTaken[dimension][cell] = 1;
      places[dimension].push(i);
    });
    lifeColours(this.look!.isDark).forEach((colour, dimension) => {
      context.fillStyle = colour;
      const all = places[dimension];
      for (let first = 0; first < all.length; first += kMarksAtOnce) {
        context.beginPath();
        for (const i of all.slice(first, first + kMarksAtOnce))
          mark(context, dimension, this.x[i], this.y[i], kMark);
        context.fill();
      }
    });
  }

  /** @param marked  the one under the mouse, and that which was chosen. */
  draw(index: number, marked: readonly (Life | null)[]): void {
    const { context, side, look } = this;
    if (!look) return;
    context.clearRect(0, 0, side, side);
    const [x, y] = [kInset + this.placeOf(index), side - kInset - this.placeOf(index)];
    context.fillStyle = look.quadrant;
    context.fillRect(0, 0, x, y);
    context.drawImage(this.back, 0, 0, side, side);
    context.globalAlpha = kFaint;
    context.drawImage(this.marks, 0, 0, side, side);
    context.globalAlpha = 1;
    // Alive is what lies in the quadrant, whatever the number.
    context.save();
    context.beginPath();
    context.rect(0, 0, x + kLine, y + kLine);
    context.clip();
    context.drawImage(this.marks, 0, 0, side, side);
    context.restore();
    context.strokeStyle = look.marker;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, y);
    context.lineTo(0, y);
    context.stroke();
    for (const life of marked) {
      const at = life ? this.lives.indexOf(life) : -1;
      if (at < 0) continue;
      context.beginPath();
      context.arc(this.x[at], this.y[at], 6, 0, 2 * Math.PI);
      context.stroke();
    }
  }

  /** The life nearest to a place, CSS pixels from the left and the top, within a few; null for none. */
  nearest(x: number, y: number): Life | null {
    let best: Life | null = null;
    let least = kReach;
    this.lives.forEach((life, i) => {
      const distance = Math.hypot(this.x[i] - x, this.y[i] - y);
      if (distance < least) [best, least] = [life, distance];
    });
    return best;
  }
}
