import type {Packing} from '../engine/api';
import {kindOf} from '../engine/pieces';
import type {Texts} from '../words/texts';

/** What a piece of foam is called, counted from the lowest, which is 0. */
export function pieceName(packing: Pick<Packing, 'partingLevels'>, piece: number, t: Texts['pieces']): string {
  const kind = kindOf(packing, piece);
  return kind === 'middle' ? t.middle(piece) : t[kind];
}
