import type {Triple} from '../../src/design/design';
import type {Packing} from '../../src/engine/api';
import {numbers, piecesPacking, type Run} from './packing';

/** Pieces around `layers` layers in a case that shortens columns, all at random: each begins above what the layer below it
 *  cuts, and may keep nothing. */
export function layeredPacking(seed: number, layers: number, open: boolean): Packing {
  const number = numbers(seed);
  const blocks: Triple = [4 + number(9), 1 + number(6), 1 + number(6)];
  const block_mm: Triple = [1 + number(20), 1 + number(20), 1 + number(20)];
  const [nx, ny, nz] = blocks;
  const surface = open ? 2 + number(nx - 1) : nx;
  const exists: Run[] = [];
  const pieces: Run[][] = Array.from({length: layers + (open ? 0 : 1)}, () => []);
  for (let column = 0; column < ny * nz; column++) {
    const low = number(3);
    exists.push([low, nx - number(2)]);
    const top = Math.min(exists[column]![1], surface);
    let from = low;
    pieces.forEach((kept, piece) => {
      const to = piece === layers ? top : Math.min(from + number(4), top);
      kept.push(to > from ? [from, to] : [0, 0]);
      from = Math.min(to + number(3), top);
    });
  }
  return piecesPacking(blocks, block_mm, pieces, exists, open ? surface : undefined);
}
