import type {Packing} from '../engine/api';

/** How far the outermost pieces go apart, as a share of the space's height: those of a stack need less. */
const WIDE_OPEN = 1.8;
const STACK_WIDE_OPEN = 1.5;

/** Where things are drawn while the foams are opened: mm along x from where they lie. */
export interface Apart {
  /** `number`: from the lowest, which is 0. */
  piece(number: number): number;
  /** Of the items of a layer; the lowest is 1. */
  layer(number: number): number;
  /** Where all of it begins and ends, mm along x. */
  low: number;
  high: number;
}

/** All pieces as far from each other, with the items of each layer halfway between those around it. `opening`: 0 to 1. */
export function apart({blocks, block_mm, partingLevels, items, open}: Packing, opening: number): Apart {
  const height = blocks[0] * block_mm[0];
  const layers = Math.max(partingLevels.length, ...items.map(({layer}) => layer));
  const step = (height * (layers > 1 ? STACK_WIDE_OPEN : WIDE_OPEN) * opening) / layers;
  const piece = (number: number) => (number - layers / 2) * step;
  const layer = (number: number) => piece(number - 0.5);
  return {piece, layer, low: piece(0) - height / 2, high: (open ? layer(layers) : piece(layers)) + height / 2};
}
