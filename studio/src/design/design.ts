// What a person chooses, as the library has it. Lengths in mm, angles in degrees, design coordinates: x is the insertion
// axis and points up, the space is centred at the origin.

export type Triple = [number, number, number];

/** Everything that a user chooses: the `design` of a project file, field for field (snug/design/design.h). */
export interface Design {
  object: {
    units: Unit | null;
    scale: number;
    longest_mm: number | null;
    cap: boolean;
    /** Of a cloud's points; 0: from their spacing. */
    point_radius_mm: number;
    /** The plane: a direction to what is kept, and how far along it the plane lies. */
    clean: {drop_parts: number[]; drop_below_mm: number; cut_plane: [number, number, number, number] | null};
  };
  space: {preset: string; blocks: Triple | 'auto'; block_mm: Triple; wall_mm: number | number[] | null};
  placement: {rotation_deg: Triple; offset_mm: Triple};
  /** Clearance: one number, or x, y, z of the lower foam and then of the upper. */
  cut: {clearance_mm: number | number[]; liner_mm: number; cut_on_touch: boolean};
  fit: {least_rib_mm: number; notches: Notches | null; creep_kpa: number | null};
  parting: {level: number | 'auto'};
  output: {formats: ('stl' | 'ply')[]};
  case: CaseOptions;
  search: {
    weights: Record<string, number>;
    upright: string | null;
    case: 'volume' | 'billed-weight';
    billed_divisor: number;
    seed: number;
  };
  workshop: WorkshopOptions;
}

/** The case that the foam is made for: sizes are height, width, length inside. */
export interface CaseOptions {
  name: string;
  inside_mm: Triple | null;
  play_mm: number;
  lid_mm: number | null;
  corner_radius_mm: number;
  base_mm: [number, number] | null;
  top_mm: [number, number] | null;
  divisor: number | null;
  division: 'none' | 'across' | 'all';
}

export type Work = 'sponge' | 'sheets' | 'print' | 'bricks' | 'mill' | 'mould';
export interface WorkshopOptions {
  /** The way of working; null: the foams' own files alone. */
  for: Work | null;
  paper: 'a4' | 'letter' | 'a3';
  price_per_litre: number | null;
  currency: string;
  mass_kg: number | null;
  density_kg_m3: number | null;
  sheets: {
    thickness_mm: number | null;
    stock_mm: [number, number];
    kerf_mm: number;
    dowel_mm: number;
    dowels: number;
    [more: string]: unknown;
  };
  print: {bed_mm: Triple; dowels: boolean; dowel_diameter_mm: number; [more: string]: unknown};
  bricks: BrickOptions;
  mill: MillOptions;
  mould: {wall_mm: number; rim_mm: number; draft_deg: number};
}

/** Toy bricks on a pitch of 8 mm (snug/design/brick_options.h). */
export interface BrickOptions {
  unit: 'auto' | 'brick' | 'plate';
  /** Sizes to build with, "2x4"; none: all. */
  family: string[];
  lower_color: string;
  lid_color: string;
  /** Pieces that there are by size; sizes that are not named do not run out. */
  stock: Record<string, number>;
  rim: 'studs' | 'tiles';
  /** Newtons that one contact point of a stud holds. */
  capacity_n: number;
}

/** A flat cutter (snug/design/mill_options.h). */
export interface MillOptions {
  cutter_mm: number;
  flute_mm: number;
  /** null: half the cutter. */
  step_down_mm: number | null;
  /** Share of the cutter's diameter. */
  stepover: number;
  feed_mm_min: number;
  plunge_mm_min: number;
  spindle_rpm: number;
  safe_mm: number;
  /** 0: no registration pins. */
  pin_mm: number;
  origin: 'corner' | 'centre';
}

/** Two recesses beside the object for the fingers that lift it. */
export interface Notches {
  width_mm: number;
  depth_mm: number;
  room_mm: number;
  axis: 'y' | 'z' | null;
  first_mm: number | null;
  second_mm: number | null;
}
export type Unit = 'mm' | 'cm' | 'm' | 'in';

/** A case that is known, and how the object lies in it. */
export interface KnownCase {
  name: string;
  /** Height, width, length. */
  inside_mm: Triple;
  lid_mm: number | null;
  divisor: number | null;
  rotation_deg: Triple;
}

/** A foam that is known, with its blocks. */
export interface Preset {
  name: string;
  title: string;
  block_mm: Triple;
  clearance_mm: number;
  density_kg_m3: number | null;
  creep_kpa: number | null;
  rigid: boolean;
  worked: string;
  division: 'none' | 'across' | 'all';
}
