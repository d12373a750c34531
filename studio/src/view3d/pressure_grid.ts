import type {Packing} from '../engine/api';
import {contactsOf, type ContactMap} from '../engine/drops';
import type {MostPressed} from '../state/contacts.svelte';

// What squeezes what, as the shaders look it up: four numbers for each line through the space.

export interface PressureGrid {
  axis: number;
  /** Where the cells begin along axis + 1 and axis + 2 (mod 3), and how large they are, mm. */
  first: readonly [number, number];
  cell: readonly [number, number];
  rows: number;
  columns: number;
  layers: number;
  /** Columns side by side, rows behind each other, layers behind these. */
  texels: Float32Array<ArrayBuffer>;
}

function emptyGrid({axis, rows, columns, cell_mm}: ContactMap, {blocks, block_mm}: Packing, layers: number): PressureGrid {
  const begin = (along: number) => (-blocks[along % 3]! * block_mm[along % 3]!) / 2;
  const first = [begin(axis + 1), begin(axis + 2)] as const;
  return {axis, first, cell: cell_mm, rows, columns, layers, texels: new Float32Array(rows * columns * layers * 4)};
}

/** Of an item: how much its low end is pressed, as a share of the most, and where that end lies; the same of its high
 *  end. */
export function itemGrid(map: ContactMap, packing: Packing, item: number, {kpa: most}: MostPressed): PressureGrid {
  const grid = emptyGrid(map, packing, 1);
  for (const {row, column, high, from_mm, to_mm, kpa} of contactsOf(map.items[item]!))
    grid.texels.set([kpa / Math.max(most, 1e-9), high ? from_mm : to_mm], (row * map.columns + column) * 4 + (high ? 2 : 0));
  return grid;
}

/** Of the foam: how much a column of it is squeezed, as a share of the most, and between which places it lies; of
 *  several on one line each in a layer of its own. What two items squeeze counts by the one that does so more. */
export function foamGrid(map: ContactMap, packing: Packing, {strain: most}: MostPressed): PressureGrid {
  const all = new Map<string, {cell: number; share: number; from: number; to: number}>();
  for (const {row, column, from_mm: from, to_mm: to, strain} of map.items.flatMap(contactsOf)) {
    const cell = row * map.columns + column;
    const [key, share] = [`${cell} ${from}`, strain / Math.max(most, 1e-9)];
    if (share > (all.get(key)?.share ?? 0)) all.set(key, {cell, share, from, to});
  }
  const used = new Uint8Array(map.rows * map.columns);
  const placed = [...all.values()].map((column) => ({...column, layer: used[column.cell]!++}));
  const grid = emptyGrid(map, packing, placed.reduce((count, {layer}) => Math.max(count, layer + 1), 1));
  for (const {cell, share, from, to, layer} of placed) grid.texels.set([share, from, to, 0], (layer * used.length + cell) * 4);
  return grid;
}
