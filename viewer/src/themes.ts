// SPDX-License-Identifier: MIT
//
// What the canvas needs to know of the page's colours; the page's own are in app.css.

import type { Rgb } from './palette';
import type { DiagramLook } from './persistence_diagram';
import type { PlotLook } from './signature_plot';
import type { State } from './state';

export type ThemeName = 'light' | 'dark';

export interface Look {
  plot: PlotLook;
  diagram: DiagramLook;
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

const kDiagrams: Record<ThemeName, DiagramLook> = {
  light: {
    isDark: false,
    axis: '#c9cfd8',
    text: '#596273',
    quadrant: 'rgba(213, 94, 0, 0.07)',
    marker: '#d55e00',
  },
  dark: {
    isDark: true,
    axis: '#3a4250',
    text: '#a3acba',
    quadrant: 'rgba(255, 154, 77, 0.1)',
    marker: '#ff9a4d',
  },
};

export function lookOf(theme: ThemeName, background: State['background']): Look {
  const page = { plot: kPlots[theme], diagram: kDiagrams[theme] };
  if (background === 'white')
    return {
      ...page,
      isDark: false,
      background: '#ffffff',
      plain: '#ffffff',
      fog: [255, 255, 255],
    };
  if (background === 'black')
    return { ...page, isDark: true, background: '#000000', plain: '#000000', fog: [0, 0, 0] };
  const isDark = theme === 'dark';
  return {
    ...page,
    isDark,
    background: 'radial-gradient(120% 120% at 50% 20%, var(--stage-top), var(--stage-bottom))',
    plain: isDark ? '#151a22' : '#f5f7fa',
    fog: isDark ? [21, 26, 34] : [240, 243, 247],
  };
}
