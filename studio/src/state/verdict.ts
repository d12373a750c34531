import type {Finding, Packing} from '../engine/api';
import {wallOn} from '../engine/pieces';
import {mm} from '../words/figures';
import type {Texts} from '../words/texts';
import {gravestFirst, worst} from './findings';

/** What a person must know first: how good the foams are, in a colour and in words. */
export interface Verdict {
  look: 'danger' | 'warning' | 'good';
  text: string;
}

const THIN = /^(no_floor|no_roof|touches_case|thin_(floor|roof|wall)|wall_below_wanted)$/;

/** Where the foam around the objects is thinnest; `side` in the order of `wall_mm`. */
export function thinnestWall(packing: Packing): {wall_mm: number; side: number} {
  const walls = [0, 1, 2, 3, 4, 5].map((side) => wallOn(packing, side) ?? Infinity);
  const wall_mm = Math.min(...walls);
  return {wall_mm, side: walls.indexOf(wall_mm)};
}

/** `untold`: nothing is known of drops, which might be worse than all that was found. */
export function verdictOf(packing: Packing, findings: readonly Finding[], untold: boolean, {status, check}: Pick<Texts, 'status' | 'check'>): Verdict {
  if (!packing.fit) return {look: 'danger', text: status.noFoam};
  const {wall_mm, side} = thinnestWall(packing);
  const where = [mm(wall_mm), status.places[side] ?? ''] as const;
  const grave = worst(findings);
  const first = grave && gravestFirst(findings)[0];
  if (!first) return {look: 'good', text: untold ? status.fitsUndropped(status.fits(...where)) : status.fits(...where)};
  if (THIN.test(first.code)) return {look: grave, text: status.thin(...where)};
  const what = check.codes[first.code] ?? check.severities[grave];
  return {look: grave, text: grave === 'danger' ? what : status.fitsBut(what)};
}
