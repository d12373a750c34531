import type {Relief, Triple} from '../design/design';
import type {Pair} from '../words/words';
import type {Finding} from './api';

// What beside pockets makes items fit.

/** A pad of sheet foam that fills what block steps leave. */
export interface PackedPad {
  /** By its number in the packing. */
  item: number;
  /** That it lies on or, above its item, hangs under; the lowest is 0. */
  piece: number;
  above: boolean;
  /** Design coordinates. */
  box: {min: Triple; max: Triple};
  /** Where it lies and how large it is, as the packing sheet lists it. */
  text: Pair;
}

/** Islands under an only item, and what they would do. */
export interface ReliefOffer extends Relief {
  finding: Finding;
}
