// SPDX-License-Identifier: MIT
//
// What the canvas needs to know of the page's colours; the page's own are in app.css.

import type { Rgb } from './palette';
import type { PlotLook } from './signature_plot';
import type { State } from './state';

export type ThemeName = 'light' | 'dark';

export interface Look {
  plot: PlotLook;
  isDark: boolean;
  /** CSS, behind the shape. */
  background: string;
  /** One colour for pictures. */
  plain: string;
  /** What far parts of the shape fade to. */
  fog: Rgb;
}

const kPlots: Record<ThemeName, PlotLook> = {
  light: {
    curve: '#2f78bf',
    fill: 'rgba(47, 120, 191, 0.13)',
    grid: 'rgba(30, 40, 60, 0.07)',
    text: '#596273',
  },
  dark: {
    curve: '#6fb2ec',
    fill: 'rgba(111, 178, 236, 0.16)',
    grid: 'rgba(220, 230, 250, 0.08)',
    text: '#a3acba',
  },
};

export function lookOf(theme: ThemeName, background: State['background']): Look {
  const plot = kPlots[theme];
  if (background === 'white')
    return { plot, isDark: false, background: '#ffffff', plain: '#ffffff', fog: [255, 255, 255] };
  if (background === 'black')
    return { plot, isDark: true, background: '#000000', plain: '#000000', fog: [0, 0, 0] };
  const isDark = theme === 'dark';
  return {
    plot,
    isDark,
    background: 'radial-gradient(120% 120% at 50% 20%, var(--stage-top), var(--stage-bottom))',
    plain: isDark ? '#151a22' : '#f5f7fa',
    fog: isDark ? [21, 26, 34] : [240, 243, 247],
  };
}
