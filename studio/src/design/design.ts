// What a person chooses, as the library has it. Lengths in mm, angles in degrees, design coordinates: x is the insertion
// axis and points up, the space is centred at the origin. The design itself is written from the table of options.

import type {Design} from './table';

export type {Design};
export type Triple = [number, number, number];

export type CaseOptions = Design['case'];
export type WorkshopOptions = Design['workshop'];
export type BrickOptions = WorkshopOptions['bricks'];
export type Work = NonNullable<WorkshopOptions['for']>;
export type Relief = NonNullable<Design['fit']['relief']>;
export type Unit = NonNullable<Design['object']['units']>;

/** A case that is known, and how the object lies in it. */
export interface KnownCase {
  name: string;
  /** Height, width, length. */
  inside_mm: Triple;
  lid_mm: number | null;
  divisor: number | null;
  rotation_deg: Triple;
  /** "Peli"; may be empty. */
  maker?: string;
}

/** A foam that is known, with its blocks. */
export interface Preset {
  name: string;
  title: string;
  block_mm: Triple;
  clearance_mm: number;
  /** The most that its blocks can be squeezed, below 0. */
  least_clearance_mm: number;
  density_kg_m3: number | null;
  creep_kpa: number | null;
  rigid: boolean;
  worked: string;
  division: CaseOptions['division'];
  /** Around things, of what is rigid; null: what they meet decides. */
  wall_mm: number | null;
  /** The ways of working that take it where none is chosen. */
  usual_for: Work[];
}

/** The bricks that there are. */
export interface BrickRange {
  /** "2x4", the small ones first. */
  sizes: string[];
  colors: {name: string; css: string}[];
}

export function spaceSize(blocks: Triple, block_mm: Triple): Triple {
  return blocks.map((n, i) => n * (block_mm[i] ?? 0)) as Triple;
}
