import type {Pair} from '../words/words';
import type {Finding} from './api';

/** What becomes of a place that foam keeps away from. */
export interface ZoneResult {
  item: number;
  /** From 1, within its item. */
  number: number;
  /** For its sake alone. */
  cut_blocks: number;
  /** The library's sentence. */
  text: Pair;
  /** A drop brings foam or the case too near, or presses it more than it bears. */
  reached: boolean;
  pressed: boolean;
}

export interface ZoneResults {
  zones: ZoneResult[];
  /** Those of zones alone. */
  findings: Finding[];
}
