import type {Triple} from '../design/design';
import type {Cell, Spot} from '../state/view.svelte';

/** What lies under a pointer; of the object its part, 0 where it is one alone. */
export interface Picked {
  own: Triple | null;
  cell: Cell | null;
  item: number | null;
  part: number;
  spot: Spot | null;
}

export const NOTHING: Picked = {own: null, cell: null, item: null, part: 0, spot: null};
