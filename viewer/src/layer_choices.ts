// SPDX-License-Identifier: MIT
//
// The layers that people choose from, with their names and what they are in plain words.

import type { Layer } from './state';
import type { Snapshot } from './types';

export interface LayerChoice {
  layer: Layer;
  text: string;
  title: string;
}

const kSingularParts: LayerChoice[] = [
  {
    layer: 'singular_edges',
    text: 'Singular edges',
    title: 'Edges that bound no triangle of the shape',
  },
  {
    layer: 'singular_vertices',
    text: 'Singular vertices',
    title: 'Vertices without any edge in the shape',
  },
];

const kInSpace: LayerChoice[] = [
  {
    layer: 'regular',
    text: 'Surface',
    title: 'Regular triangles: between the solid part and the outside',
  },
  {
    layer: 'singular_triangles',
    text: 'Singular triangles',
    title: 'Triangles that bound no tetrahedron of the shape',
  },
  ...kSingularParts,
  {
    layer: 'interior',
    text: 'Interior triangles',
    title: 'Between two tetrahedra of the shape: seen where it is clipped, translucent or exploded',
  },
  { layer: 'outlines', text: 'Triangle sides', title: 'A thin line around every triangle' },
];

const kInThePlane: LayerChoice[] = [
  { layer: 'interior', text: 'Triangles', title: 'The solid part of the shape' },
  {
    layer: 'regular',
    text: 'Outline',
    title: 'Regular edges: between the solid part and the outside',
  },
  ...kSingularParts,
  {
    layer: 'outlines',
    text: 'Triangle sides',
    title: 'The edges between triangles of the shape',
  },
];

const kOfMolecules: LayerChoice[] = [
  {
    layer: 'trace',
    text: 'Backbone',
    title: 'Alpha carbons, or phosphorus, joined along the chain',
  },
  { layer: 'sticks', text: 'Bonds', title: 'Atoms that are as near as a covalent bond' },
];

/** Layers of the shape itself. */
export function shapeLayers({ facts }: Snapshot): LayerChoice[] {
  return facts.dimension === 3 ? kInSpace : kInThePlane;
}

/** Layers of what the shape is made of. */
export function otherLayers({ facts, labels }: Snapshot): LayerChoice[] {
  const inSpace = facts.dimension === 3;
  const cells: LayerChoice = {
    layer: 'power_cells',
    text: 'Power cells in the disks',
    title: 'Borders of the power diagram inside the union of disks',
  };
  return [
    {
      layer: 'balls',
      text: inSpace ? 'Union of balls' : 'Union of disks',
      title: `${inSpace ? 'Balls' : 'Disks'} of squared radius weight + alpha2: they grow with alpha, and the shape is their dual`,
    },
    ...(inSpace ? [] : [cells]),
    { layer: 'points', text: 'Input points', title: 'All sites, hidden ones too' },
    {
      layer: 'wireframe',
      text: 'Whole triangulation',
      title: 'All edges of the regular triangulation',
    },
    ...(labels.atom && inSpace ? kOfMolecules : []),
  ];
}
