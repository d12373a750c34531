import type {Triple} from '../../src/design/design';
import type {Packing} from '../../src/engine/api';

/** A packing with these kept blocks, and nothing else that a test would look at. */
export function packingOf(blocks: Triple, block_mm: Triple, lower: number[], upper: number[]): Packing {
  return {
    dependent: {},
    blocks,
    block_mm,
    lower: Uint16Array.from(lower),
    upper: Uint16Array.from(upper),
    cutFirst: new Int16Array(lower.length),
    cutEnd: new Int16Array(lower.length),
    existsFirst: new Int16Array(lower.length),
    existsEnd: new Int16Array(lower.length).fill(blocks[0]),
    partingLevel: 0,
    items: [
      {
        name: '',
        object: 0,
        rotation_deg: [0, 0, 0],
        offset_mm: [0, 0, 0],
        placement: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        bounds: {min: [0, 0, 0], max: [0, 0, 0]},
      },
    ],
    fit: {lower_blocks: 0, upper_blocks: 0, cut_blocks: 0, volume_mm3: 0, fill_ratio: 0, wall_mm: []},
    findings: [],
    library_ms: 0,
  };
}

/** Whole numbers from 0 to below `end`, the same on every run. */
export function numbers(seed: number): (end: number) => number {
  let state = seed;
  return (end) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * end);
  };
}
