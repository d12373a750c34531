import type {Design, Triple} from '../design/design';
import type {Pair} from '../words/words';
import type {Finding} from './api';

// What items meet in a drop, as the library estimates it.

export type FoamData = NonNullable<Design['protection']['foam']>;

/** A foam that the library knows figures of. */
export interface KnownFoam {
  design: FoamData;
  title: Pair;
  /** What is known of how it pushes back; null: nothing. */
  curve: Pair | null;
  status: Pair;
  source: string;
}

/** What there is to choose from. */
export interface DropChoices {
  foams: KnownFoam[];
  /** Heights by the packed mass. */
  rules: {name: NonNullable<Design['protection']['rule']>; title: string; verified: boolean}[];
  /** How delicate things are, each by the least G of its band. */
  classes: {name: NonNullable<Design['protection']['fragility']>; g: number; source: string}[];
  /** What is said of a tray. */
  tray: Pair;
}

/** As the library hands them over: the design of a foam is a JSON text. */
export type DropChoicesText = Omit<DropChoices, 'foams'> & {foams: (Omit<KnownFoam, 'design'> & {design: string})[]};

export function readChoices(choices: DropChoicesText): DropChoices {
  return {...choices, foams: choices.foams.map((foam) => ({...foam, design: JSON.parse(foam.design) as FoamData}))};
}

export type Verdict = 'unknown' | 'meets_item' | 'bottoms' | 'thin' | 'over' | 'within' | 'unasked';

/** A drop of an item on a side. */
export interface DropOnSide {
  side: number;
  /** "on its back" */
  fallen: Pair;
  verdict: Verdict;
  sentence: Pair;
  /** What would do. */
  advice: Pair | null;
  /** Where the foam is pressed most. */
  peak_at: Triple;
  low_g: number | null;
  high_g: number | null;
  /** null: no figure, nor are those below. */
  travel_mm: number | null;
  strain: number;
  peak_kpa: number;
  area_cm2: number;
  /** Travel in mm and newtons after each other, as far as the foam's data go; empty where it is not known by itself. */
  force: number[];
}

export interface DroppedItem {
  mass_kg: number | null;
  asked_g: number | null;
  /** By side: floor, lid, back, front, left, right. */
  faces: DropOnSide[];
  /** On the lower foam. */
  rest: {sink_mm: number; peak_kpa: number; area_cm2: number} | null;
}

export interface Drops {
  /** From which height, after what, in which foam; null where that is not known. */
  what: Pair | null;
  drop_mm: number | null;
  gross_kg: number | null;
  /** In the design's order. */
  items: DroppedItem[];
  /** Every side with its worst item, the worst first. */
  worst: {side: number; item: number}[];
  /** What such figures are. */
  claim: Pair;
  notComputed: Pair[];
  /** Those of drops alone. */
  findings: Finding[];
}
