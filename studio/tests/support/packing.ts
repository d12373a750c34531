import type {Triple} from '../../src/design/design';
import type {Packing, Runs} from '../../src/engine/api';

/** Blocks of a column, first to below end. */
export type Run = readonly [first: number, end: number];

export function runsOf(runs: readonly Run[]): Runs {
  return {first: Int16Array.from(runs, ([first]) => first), end: Int16Array.from(runs, ([, end]) => end)};
}

/** A packing whose pieces keep these blocks, and nothing else that a test would look at. `surface`: of a tray. */
export function piecesPacking(blocks: Triple, block_mm: Triple, pieces: readonly (readonly Run[])[], exists: readonly Run[], surface?: number): Packing {
  const open = surface !== undefined;
  const layers = pieces.length - (open ? 0 : 1);
  return {
    dependent: {},
    blocks,
    block_mm,
    exists: runsOf(exists),
    pieces: pieces.map(runsOf),
    open,
    partingLevels: Array<number>(layers).fill(surface ?? 0),
    items: [
      {
        name: '',
        object: 0,
        layer: 1,
        rotation_deg: [0, 0, 0],
        offset_mm: [0, 0, 0],
        placement: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        bounds: {min: [0, 0, 0], max: [0, 0, 0]},
        settled_mm: 0,
      },
    ],
    pads: [],
    fit: {pieces: pieces.map(() => ({blocks: 0, parts: 0})), cut_blocks: 0, volume_mm3: 0, fill_ratio: 0, wall_mm: []},
    findings: [],
    library_ms: 0,
  };
}

/** Of one layer. `lower`, `upper`: how high the pieces reach in each column, each from its own side. */
export function packingOf(blocks: Triple, block_mm: Triple, lower: number[], upper: number[], exists: readonly Run[] = lower.map(() => [0, blocks[0]])): Packing {
  const none = [0, 0] as const;
  const kept = [
    lower.map((height, i): Run => (height > 0 ? [exists[i]![0], height] : none)),
    upper.map((height, i): Run => (height > 0 ? [blocks[0] - height, exists[i]![1]] : none)),
  ];
  return piecesPacking(blocks, block_mm, kept, exists);
}

/** Whole numbers from 0 to below `end`, the same on every run. */
export function numbers(seed: number): (end: number) => number {
  let state = seed;
  return (end) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * end);
  };
}
