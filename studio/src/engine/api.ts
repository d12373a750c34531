// What the page and the worker say to each other. The worker holds the library (WebAssembly) and the object;
// the page holds the design, in whose units and coordinates all of this is.

import type {BrickRange, Design, KnownCase, Preset, Triple} from '../design/design';
import type {ObjectUse} from '../design/moment';
import type {Dependent, Schema} from '../design/options';
import type {Solid} from '../design/shape';
import type {Pair} from '../words/words';
import type {ContactMap, DropChoices, Drops, KnownFoam, Pressing} from './drops';
import type {PackedPad} from './fit';
import type {Gap} from './gap';
import type {PlanWishes, Proposal} from './plan';
import type {ZoneResults} from './zones';

/** A file that came with the object. */
export interface BesideFile {
  name: string;
  content: Blob;
}

/** A known case and how the object goes in. */
export interface RankedCase extends KnownCase {
  kind: string;
  /** Of the case by the object with its walls, 0 to 1. */
  fill: number;
  billed_kg: number | null;
  price: number | null;
  lacking_mm: number[];
}

export interface CaseRanking {
  fitting: RankedCase[];
  nearest: RankedCase | null;
  leastInside: Triple;
}

/** What a way of working takes. */
export interface WorkshopFigures {
  figures: {label: Pair; value: Pair}[];
  findings: Finding[];
}

/** A sentence of the library for the person, and where it belongs. */
export interface Failure {
  error: Pair;
  kind: 'usage' | 'input' | 'does_not_fit' | 'output' | 'cancelled' | 'memory';
}

export interface ObjectFile {
  name: string;
  bytes: number;
  sha256: string;
  /** All of its text, where it is made of measurements. */
  shape?: string;
}

/** `own`: what was chosen for this object alone. */
export interface ProjectObject extends ObjectFile {
  own: Design['object'] | null;
}

export interface Project {
  /** One at least; of a design alone one without a name. */
  objects: ProjectObject[];
  design: Design;
  dependent: Dependent;
}

/** What a zip has of a pack: the text of its project, null where it is none, and whether the object is in it, too. */
export interface PackedProject {
  text: string | null;
  whole: boolean;
}

/** A separate part of the object as it was read, numbered from 1; `share` of the surface's area. */
export interface ObjectPart {
  number: number;
  triangles: number;
  size_mm: Triple;
  share: number;
  dropped: boolean;
}

export interface ObjectInfo {
  /** What it is called from now on: by its content where that is all there is to it. */
  id: string;
  file: ObjectFile;
  /** Names of the files beside it that it was read with, such as a .gltf's .bin. */
  beside: string[];
  vertices: number;
  triangles: number;
  /** In the unit of the file. */
  fileSize: Triple;
  /** The format says which unit its lengths are in, so none can be chosen: fileSize is in mm. */
  statesUnit: boolean;
  /** What the design makes of it; null while the size is implausible and no unit is chosen. */
  size_mm: Triple | null;
  /** Where its (0, 0, 0) lies in the coordinates of its file, mm; null while size_mm is. */
  origin_mm: Triple | null;
  /** Why size_mm is null: the library's sentence. */
  sizeProblem: Pair | null;
  /** Points without triangles: `vertices` counts them, and whether they are closed, volume and parts are not known. */
  cloud: boolean;
  watertight: boolean;
  volume_mm3: number | null;
  holes: number;
  /** The largest first, at most 1000; none while size_mm is null. */
  parts: ObjectPart[];
  partCount: number;
}

/** A simplified copy for drawing, in the object's own coordinates in mm (before the placement); in the unit of
 *  the file while ObjectInfo.size_mm is null. */
export interface DisplayMesh {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  /** Of each vertex the number of its part; null where there is one alone. */
  parts?: Uint32Array<ArrayBuffer> | null;
  /** How far the copy lies from the original, as the simplifier estimates it, in the same unit; 0 if it is the
   *  original. */
  deviation: number;
}

export interface Finding {
  severity: 'danger' | 'warning' | 'note';
  code: string;
  message: Pair;
  where: Triple | null;
  /** The items that it is of, or that it names, by their numbers in the packing. */
  items?: readonly number[];
}

/** An item as it lies in the case. */
export interface PackedItem {
  /** Its own, or its object's, told apart from others of the same name. */
  name: string;
  /** The number of its object. */
  object: number;
  /** Of the layers that stand on each other; the lowest is 1. */
  layer: number;
  rotation_deg: Triple;
  /** As it came out, chosen or not. */
  offset_mm: Triple;
  /** Column-major 4 x 4: from the object's own mm to design coordinates. */
  placement: number[];
  /** Of the placed object, design coordinates. */
  bounds: {min: Triple; max: Triple};
  /** How far it was lowered onto its foam. */
  settled_mm: number;
}

/** Of each column, j (y) over k (z): a run of blocks, counted from -x; none where first >= end. */
export interface Runs {
  first: Int16Array<ArrayBuffer>;
  end: Int16Array<ArrayBuffer>;
}

export interface Packing {
  blocks: Triple;
  block_mm: Triple;
  /** The blocks that there are; not all where a case is rounded or leans. */
  exists: Runs;
  /** What the pieces of foam keep, the lowest first: L layers of items lie between L + 1 of them. A tray has no uppermost
   *  one, and there are none at all if an item leaves the space. */
  pieces: Runs[];
  /** A tray: its foam ends at the uppermost parting level, and above that nothing is kept and nothing cut. */
  open: boolean;
  /** Of each layer, the lowest first: where the pieces around it meet beside its items, in blocks from -x. */
  partingLevels: number[];
  /** In the design's order. */
  items: PackedItem[];
  /** In the order of their numbers. */
  pads: PackedPad[];
  fit: {
    /** As Packing.pieces. `parts`: of foam that do not share a block's face. */
    pieces: {blocks: number; parts: number}[];
    cut_blocks: number;
    volume_mm3: number;
    fill_ratio: number;
    wall_mm: number[]; // -x, +x, -y, +y, -z, +z
  } | null;
  findings: Finding[];
  /** What follows from the design's choices for its other ones. */
  dependent: Dependent;
  /** Time inside the library for this packing. */
  library_ms: number;
}

/** A placement and what it cuts. */
export interface FoundPlacement {
  rotation_deg: Triple;
  offset_mm: Triple;
  cut_blocks: number;
}

/** Where a search stands: at the best so far. */
export interface SearchStep extends FoundPlacement {
  fill_ratio: number;
  /** How much of the search is done, 0 to 1. */
  fraction: number;
}

/** What a search ends with. */
export interface SearchResult extends SearchStep {
  /** The best few placements that differ, the best first. */
  distinct: FoundPlacement[];
}

/** Items where they were put, and the space that they take. */
export interface Arranged {
  design: Design;
  volume_mm3: number;
  /** No arrangement needs less; null where that is not known. */
  lower_bound_mm3: number | null;
  layers: number;
  /** Of the case, or of all blocks. */
  size_mm: Triple;
  /** Of each item, its layer and what it takes up, design coordinates. */
  plan: {layer: number; min: Triple; max: Triple}[];
}

/** As the library hands it over: the design is a JSON text. */
export type ArrangedText = Omit<Arranged, 'design'> & {design: string};

/** The best that was found, and what there is to choose from: it, and some that differ; nothing after cancel(). */
export interface Arrangement {
  design: Design;
  choices: Arranged[];
}

/** How far an arrangement is, and the best design since the last step. */
export interface ArrangeStep {
  fraction: number;
  better: Design | null;
}

/** What is cut by direction of insertion, at the best turn and offset so far, exactly; finer with every pass. Where the
 *  design leaves the number of blocks open, each placement has the space that is fitted to it. Directions in which the
 *  object does not fit with its walls are left out. */
export interface DirectionMap {
  /** Unit vectors of the object's own, x, y, z after each other; the opposite ones cut the same. */
  directions: Float32Array<ArrayBuffer>;
  cut_blocks: Float32Array<ArrayBuffer>;
  rotations_deg: Float64Array<ArrayBuffer>;
  offsets_mm: Float64Array<ArrayBuffer>;
  /** 0 to 1 */
  fraction: number;
}

export interface OutputFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** Is told how much of long work is done, 0 to 1. */
export type OnProgress = (fraction: number) => void;

/** How an object is loaded. */
export interface Loading {
  /** The objects that are there stay; as a rule the new one takes the place of all. */
  joins?: boolean;
  /** What it is called, where that was said before. */
  id?: string;
}

/** Calls may overlap: pack() answers while gaps(), search() and outputFiles() go on. `objects`: those that the design's
 *  items are of; as a rule the one that was loaded last. */
export interface Engine {
  version(): Promise<string>;
  defaultDesign(): Promise<Design>;
  presets(): Promise<Preset[]>;
  bricks(): Promise<BrickRange>;
  dropChoices(): Promise<DropChoices>;
  /** Foams of a person's own, from the text of a foams.json. */
  parseFoams(text: string): Promise<KnownFoam[] | Failure>;
  /** What a .shape file is made of. */
  parseShape(text: string): Promise<{solids: Solid[]} | Failure>;
  /** The table of options. */
  options(): Promise<Schema>;
  /** The objects that Snug generates itself, by name. */
  samples(): Promise<string[]>;
  /** One of them as a file for load(), the same bytes as `snug sample NAME -o NAME.ply`. */
  sampleFile(name: string): Promise<OutputFile | Failure>;
  /** Reads, measures and keeps the object (every format that the library reads); a failed load keeps what was there. An
   *  implausible size is no failure: size_mm is null then, and pack() says why it cannot. `bytes` stays the caller's;
   *  `beside`: files that a scene may need, such as a .gltf's .bin. */
  load(
    name: string,
    bytes: ArrayBuffer | Blob,
    object: Design['object'],
    beside?: readonly BesideFile[],
    how?: Loading,
  ): Promise<ObjectInfo | Failure>;
  /** Forgets all other objects. */
  keep(ids: readonly string[]): Promise<void>;
  /** Ends load() and everything else that objects are asked for, at once: they give a Failure of kind `cancelled`, and
   *  what was there before is read again. */
  stopReading(): Promise<void>;
  /** Applies other object options (units, scale, cap) to an object, as a rule the one that was loaded last. pack() does
   *  so by itself, too; this tells what they made of it. */
  reprepare(design: Design, id?: string): Promise<ObjectInfo | Failure>;
  /** Cached until the object changes. */
  displayMesh(mostTriangles: number, id?: string): Promise<DisplayMesh>;
  /** Validates a whole project text, or a design alone (then the object has no name). */
  parseProject(text: string): Promise<Project | Failure>;
  /** Of a zip that was a pack. */
  packedProject(zip: Blob): Promise<PackedProject | Failure>;
  /** Rejects a design that parseProject() would refuse, with the library's sentence. */
  projectText(design: Design, objects?: readonly ObjectUse[]): Promise<string>;
  /** The `snug make` that gives this design from the file, or from one for each object; a Failure for a design that
   *  parseProject() would refuse. `language`: of what it makes, "en" or "ja". */
  commandLine(file: string | readonly string[], design: Design, language?: string, objects?: readonly ObjectUse[]): Promise<string | Failure>;
  /** While one packing is being made only the newest waiting request survives; the others get a Failure of kind
   *  `cancelled`. */
  pack(design: Design, objects?: readonly ObjectUse[]): Promise<Packing | Failure>;
  /** Of the last packing. Cancelled by cancel(). */
  gaps(onProgress?: OnProgress): Promise<Gap | Failure>;
  /** What the items of the last packing meet in a drop. */
  drops(): Promise<Drops | Failure>;
  /** What squeezes what then. */
  contacts(pressing: Pressing): Promise<ContactMap | Failure>;
  /** The design with the walls that hold what it asks for in a drop. Cancelled by cancel(). */
  protectingWalls(
    design: Design,
    onProgress?: OnProgress,
    objects?: readonly ObjectUse[],
  ): Promise<{design: Design} | Failure>;
  /** Three whole proposals: the smallest, the one with most margin, the cheapest. Cancelled by cancel(). */
  plan(
    design: Design,
    wishes: PlanWishes,
    language: string,
    onProgress?: OnProgress,
    objects?: readonly ObjectUse[],
  ): Promise<Proposal[] | Failure>;
  /** What becomes of the places of the last packing that foam keeps away from. */
  zones(): Promise<ZoneResults | Failure>;
  /** How far points (x, y, z after each other, design coordinates) lie from the surface of the objects in the last
   *  packing. */
  distances(points: Float32Array<ArrayBuffer>): Promise<Float32Array<ArrayBuffer> | Failure>;
  /** The placement of one item that cuts the least foam away: every rotation, and offsets of up to half a block; the
   *  space and its walls stay those of the start. `onStep` hears where it stands several times a second. After cancel()
   *  the best so far is returned. */
  search(
    design: Design,
    onStep: (step: SearchStep) => void,
    objects?: readonly ObjectUse[],
  ): Promise<SearchResult | Failure>;
  /** The design with the fewest blocks that hold the one item and its walls, however it is turned. Cancelled by
   *  cancel(). */
  fitCase(
    design: Design,
    onProgress?: OnProgress,
    objects?: readonly ObjectUse[],
  ): Promise<{design: Design} | Failure>;
  /** All items that are not locked, where they take the least room: in the case or the blocks that are given, or in as few
   *  as go. `onStep` hears every better design. After cancel() that is what is returned. */
  arrange(
    design: Design,
    onStep: (step: ArrangeStep) => void,
    objects?: readonly ObjectUse[],
  ): Promise<Arrangement | Failure>;
  /** As many of one item as go into the given space, beside the others. As arrange(). */
  fill(
    design: Design,
    item: number,
    onStep: (step: ArrangeStep) => void,
    objects?: readonly ObjectUse[],
  ): Promise<Arrangement | Failure>;
  /** The map of directions for one item in the design's space; `onStep` hears it grow. Ended by cancel(), it is what it
   *  is. */
  directions(
    design: Design,
    onStep: (map: DirectionMap) => void,
    objects?: readonly ObjectUse[],
  ): Promise<DirectionMap | Failure>;
  /** Ends gaps(), search(), arrange(), directions() and outputFiles(), whichever runs; the first and the last then give a Failure of kind
   *  `cancelled`. */
  cancel(): Promise<void>;
  /** The known cases that hold the items as they are placed, the best fill first. */
  rankCases(design: Design, objects?: readonly ObjectUse[]): Promise<CaseRanking | Failure>;
  /** What the design's way of working takes; its pack comes with outputFiles(). */
  workshopFigures(design: Design, objects?: readonly ObjectUse[]): Promise<WorkshopFigures | Failure>;
  /** Everything that `snug make` writes for this design, byte for byte (report.json's timing_ms, PDF and zip aside).
   *  `language`: of pages, preview and report, "en" or "ja". Cancelled by cancel(). */
  outputFiles(
    design: Design,
    language?: string,
    onProgress?: OnProgress,
    objects?: readonly ObjectUse[],
  ): Promise<OutputFile[] | Failure>;
}
