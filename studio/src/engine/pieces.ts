import type {Packing, Runs} from './api';

// What follows from where the pieces of foam lie, which stand on each other with a layer of items between each two.

/** Below all layers, between two of them, or above all. A tray has no upper one. */
export type PieceKind = 'lower' | 'middle' | 'upper';

type Lying = Pick<Packing, 'partingLevels' | 'open'>;

/** `piece`: counted from the lowest, which is 0. */
export function kindOf({partingLevels}: Pick<Packing, 'partingLevels'>, piece: number): PieceKind {
  if (piece === 0) return 'lower';
  return piece < partingLevels.length ? 'middle' : 'upper';
}

/** Which kinds there are; of foams that there are not yet those of one layer. */
export function kindsOf(packing: Lying | null): PieceKind[] {
  const several = packing !== null && packing.partingLevels.length > 1;
  return ['lower', ...(several ? (['middle'] as const) : []), ...(packing?.open ? [] : (['upper'] as const))];
}

/** Where the foam ends, in blocks from -x: at the top of the space, or at the surface of a tray. */
export function topOf({blocks, partingLevels, open}: Lying & Pick<Packing, 'blocks'>): number {
  return open ? (partingLevels.at(-1) ?? 0) : blocks[0];
}

/** The piece that keeps a block, counted from the lowest; -1: none. */
export function pieceAt({pieces}: Pick<Packing, 'pieces'>, column: number, level: number): number {
  // Asked for millions of blocks at once.
  for (let piece = 0; piece < pieces.length; piece++) if (isWithin(pieces[piece]!, column, level)) return piece;
  return -1;
}

/** Whether a block is there, for foam to be cut from. */
export function isThere(packing: Packing, column: number, level: number): boolean {
  return level < topOf(packing) && isWithin(packing.exists, column, level);
}

function isWithin({first, end}: Runs, column: number, level: number): boolean {
  return level >= (first[column] ?? 0) && level < (end[column] ?? 0);
}

export function isCut(packing: Packing, column: number, level: number): boolean {
  return isThere(packing, column, level) && pieceAt(packing, column, level) < 0;
}

/** How thick the foam is on a side, in the order of `wall_mm`; null above a tray, which is open there. */
export function wallOn({fit, open}: Pick<Packing, 'fit' | 'open'>, side: number): number | null {
  return open && side === 1 ? null : (fit?.wall_mm[side] ?? null);
}
