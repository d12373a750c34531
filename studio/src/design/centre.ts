import type {Triple} from './design';

/** Where a place of the case lies in the coordinates of an item's file, mm, in tenths. `placement`: column-major 4 x 4, a
 *  turn and a shift; `origin`: where the object's (0, 0, 0) lies in its file. */
export function inFile(place: Triple, placement: readonly number[], origin: Triple): Triple {
  const from = place.map((mm, axis) => mm - placement[12 + axis]!);
  const along = (axis: number) => from.reduce((sum, mm, i) => sum + mm * placement[4 * axis + i]!, origin[axis]!);
  return [0, 1, 2].map((axis) => Math.round(along(axis) * 10) / 10) as Triple;
}
