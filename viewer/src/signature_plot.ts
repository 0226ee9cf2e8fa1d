// SPDX-License-Identifier: MIT
//
// One signature as a curve against alpha. The only file that knows uPlot.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

import { shownNumber } from './alpha';
import { indicesBetween, stepCurve } from './step_curve';

export interface PlotLook {
  curve: string;
  fill: string;
  grid: string;
  text: string;
}

export interface PlotData {
  /** [index], ascending. */
  x: Float64Array;
  /** [index] */
  y: ArrayLike<number>;
  isLog: boolean;
  /** Whether values are logarithmic as well: beyond `unit`, and below it linear down to 0. */
  areValuesLog: boolean;
  unit: number;
  /** What is seen of x. */
  range: [number, number];
  /** Whether the axis has its numbers. */
  hasAxis: boolean;
}

/** As short as the place beside the axis needs it: "2M" for two millions. */
function axisNumber(y: number): string {
  return Math.abs(y) < 1e5 ? shownNumber(y, 4) : y.toLocaleString('en', { notation: 'compact' });
}

/** 0 and a few powers of ten on either side of it that lie within a range. */
function powers(unit: number, low: number, high: number, most = 2): number[] {
  const reach = Math.max(high, -low);
  const [first, last] = [unit, reach].map((y) => Math.floor(Math.log10(y) + 1e-9));
  const step = Math.max(1, Math.ceil((last - first) / most));
  const splits = [0];
  for (let k = last; k > first; k -= step) splits.push(10 ** k, -(10 ** k));
  return splits.filter((y) => y >= low && y <= high).sort((a, b) => a - b);
}

const kHeadroom = 0.06; // above the curve
const kFont = '11px system-ui, sans-serif';

/** Whether a logarithmic axis can be a true one. */
function isPositive(data: PlotData): boolean {
  return data.range[0] > 0;
}

/** A curve in a box of its own, and where on it a place of the page lies. */
export class SignaturePlot {
  private plot: uPlot | null = null;
  private data: PlotData | null = null;
  private look: PlotLook | null = null;

  /** @param drawn  called whenever places may have become others. */
  constructor(
    private readonly host: HTMLElement,
    private readonly drawn: () => void,
  ) {}

  show(data: PlotData, look: PlotLook): void {
    this.plot?.destroy();
    this.data = data;
    this.look = look;
    const width = Math.max(50, this.host.clientWidth);
    const height = Math.max(30, this.host.clientHeight);
    const distr = !data.isLog ? 1 : isPositive(data) ? 3 : 4;
    const asinh = Math.max(1e-12, (data.range[1] - data.range[0]) / 1000);
    const place =
      distr === 1
        ? (x: number) => x
        : distr === 3
          ? Math.log
          : (x: number) => Math.asinh(x / asinh);
    const [first, last] = indicesBetween(data.x, ...data.range);
    const columns = Math.round(width * window.devicePixelRatio);
    const curve = stepCurve(data.x, data.y, first, last, place, columns);
    if (curve.x.length > 0 && curve.x[curve.x.length - 1] < data.range[1]) {
      curve.x.push(data.range[1]);
      curve.y.push(curve.y[curve.y.length - 1]);
    }
    const axis = (isShown: boolean) => ({
      show: isShown,
      stroke: look.text,
      font: kFont,
      grid: { stroke: look.grid, width: 1 },
      ticks: { show: false },
    });
    this.plot = new uPlot(
      {
        width,
        height,
        legend: { show: false },
        cursor: { show: false },
        hooks: { draw: [() => this.drawn()] },
        padding: [6, 14, data.hasAxis ? 0 : 5, 0],
        scales: {
          x: { time: false, distr, asinh, range: () => data.range } as uPlot.Scale,
          y: {
            distr: data.areValuesLog ? 4 : 1,
            asinh: data.unit,
            range: (_, low, high) =>
              low === high
                ? [low - 1, high + 1]
                : [Math.min(0, low), high + kHeadroom * (high - low)],
          },
        },
        series: [{}, { stroke: look.curve, fill: look.fill, width: 1.5, points: { show: false } }],
        axes: [
          {
            ...axis(data.hasAxis),
            size: 24,
            gap: 2,
            space: 60,
            ...(distr === 4 ? { splits: () => powers(asinh, ...data.range, 6) } : {}),
            values: (_, splits) => splits.map((x) => (x === null ? null : shownNumber(x, 4))),
          },
          {
            ...axis(true),
            size: 52,
            gap: 4,
            space: 22,
            ...(data.areValuesLog
              ? { splits: (_, __, low, high) => powers(data.unit, low, high) }
              : {}),
            values: (_, splits) => splits.map((y) => (y === null ? null : axisNumber(y))),
          },
        ],
      },
      [curve.x, curve.y],
      this.host,
    );
  }

  /** Again, for another size. */
  resize(): void {
    if (this.data && this.look) this.show(this.data, this.look);
  }

  /** CSS pixels from the left of the host to a value of x; NaN where it is not seen. */
  placeOf(x: number): number {
    if (!this.plot || !this.data) return NaN;
    const [from, to] = this.data.range;
    if (x < from || x > to) return NaN;
    return this.plot.valToPos(x, 'x') + this.plot.bbox.left / window.devicePixelRatio;
  }

  /** The value of x at so many CSS pixels from the left of the host, within what is seen. */
  valueAt(pixels: number): number {
    if (!this.plot || !this.data) return NaN;
    const value = this.plot.posToVal(pixels - this.plot.bbox.left / window.devicePixelRatio, 'x');
    return Math.min(this.data.range[1], Math.max(this.data.range[0], value));
  }

  dispose(): void {
    this.plot?.destroy();
    this.plot = null;
  }
}
