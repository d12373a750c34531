import type {Design, Triple} from '../design/design';
import type {Pair} from '../words/words';
import type {Finding} from './api';
import type {PlanWishes} from './plan';

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
  /** Foam that is usual around things, mm, by who carries them. */
  walls_mm: Record<PlanWishes['carrier'], number>;
}

/** As the library hands them over: the design of a foam is a JSON text. */
export type DropChoicesText = Omit<DropChoices, 'foams'> & {foams: (Omit<KnownFoam, 'design'> & {design: string})[]};

/** Foams as the library hands them over. */
export type FoamsText = {foams: DropChoicesText['foams']};

export function readFoams({foams}: FoamsText): KnownFoam[] {
  return foams.map((foam) => ({...foam, design: JSON.parse(foam.design) as FoamData}));
}

export function readChoices(choices: DropChoicesText): DropChoices {
  return {...choices, foams: readFoams(choices)};
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
  /** Of mass, design coordinates; not given, one density is assumed. */
  centre: Triple;
  centre_given: boolean;
  /** By side: floor, lid, back, front, left, right. */
  faces: DropOnSide[];
  /** On the lower foam. */
  rest: {sink_mm: number; peak_kpa: number; area_cm2: number} | null;
}

/** Of what squeezes what the drop on a side, or the rest. */
export type Pressing = number | 'rest';

/** What squeezes what, line by line along an axis. */
export interface ContactMap {
  axis: number;
  /** Cells side by side from the space's low faces: rows along axis + 1 and columns along axis + 2 (mod 3), of this size. */
  rows: number;
  columns: number;
  cell_mm: [number, number];
  /** In the design's order. `why`: nothing is known; `columns`: CONTACT_NUMBERS of each column of foam. */
  items: {why: Pair | null; columns: Float32Array<ArrayBuffer>}[];
}

/** row, column, 1 before the item's high end or 0 before its low one, from_mm and to_mm along the axis between which the
 *  foam lies, strain, kPa */
export const CONTACT_NUMBERS = 7;

/** A column of foam that an item squeezes. */
export interface Contact {
  row: number;
  column: number;
  high: boolean;
  from_mm: number;
  to_mm: number;
  strain: number;
  kpa: number;
}

export function contactsOf({columns}: ContactMap['items'][number]): Contact[] {
  return Array.from({length: columns.length / CONTACT_NUMBERS}, (_, i) => {
    const [row, column, high, from_mm, to_mm, strain, kpa] = columns.subarray(i * CONTACT_NUMBERS, (i + 1) * CONTACT_NUMBERS);
    return {row: row!, column: column!, high: high === 1, from_mm: from_mm!, to_mm: to_mm!, strain: strain!, kpa: kpa!};
  });
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
  /** What else follows from drops, of pads and reliefs. */
  fitting: Finding[];
}
