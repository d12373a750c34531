import type {Triple} from '../design/design';
import type {Finding} from './api';
import type {ReliefOffer} from './fit';

// How much room there is around items, and what else takes a while to be told.

export interface GapPart {
  widest_mm: number;
  widest_error_mm: number;
  widest_at: Triple;
  step_mm3: number;
  undercut_mm3: number | null;
}
/** Of one layer, and of what the foam below and above it faces; above a tray there is no gap. */
export interface LayerGap extends GapPart {
  lower: GapPart;
  upper: GapPart;
  /** Mean depths in mm, four a column: steps and undercuts of the lower half, then of the upper. */
  columns: Float32Array<ArrayBuffer>;
}
/** Of all layers together, and of each, the lowest first. */
export interface Gap extends GapPart {
  layers: LayerGap[];
  bearing: Bearing;
  /** What would do more in its drop on the floor than all of its foam; null: nothing, or no drop is looked at. */
  relief: ReliefOffer | null;
  /** All of the packing, with what only this shows. */
  findings: Finding[];
}

/** What all items lie on, on the foam below them and on that above, once they have sunk `sinking_mm` into it. */
export interface Bearing {
  sinking_mm: number[];
  lower_mm2: number[];
  upper_mm2: number[];
  /** Of the foam below; null where the mass or the area is not there. */
  static_kpa: (number | null)[];
  creep_kpa: number | null;
}
