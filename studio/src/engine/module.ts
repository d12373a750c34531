// The library as WebAssembly, as wasm/ binds it. Designs and projects pass as JSON texts. The npm package has these types, too.

import type {BrickRange, Preset} from '../design/design';
import type {Solid} from '../design/shape';
import type {
  ArrangedText,
  CaseRanking,
  DirectionMap,
  DisplayMesh,
  Failure,
  FoundPlacement,
  ObjectInfo,
  OutputFile,
  PackedProject,
  Packing,
  SearchStep,
  WorkshopFigures,
} from './api';
import type {ContactMap, DropChoicesText, Drops, FoamsText} from './drops';
import type {Gap} from './gap';
import type {PlanWishes, ProposalTexts} from './plan';
import type {ZoneResults} from './zones';

/** Hears how far it is, 0 to 1; false ends it. */
export type Progress = ((fraction: number) => boolean) | null;
/** Hears each better design. */
export type BetterDesign = ((design: string) => void) | null;
/** One at least, the best first. */
export type ArrangementText = {choices: ArrangedText[]};
export type Made = {files: OutputFile[]; report: string; pack?: Pack};

export interface Pack {
  files: OutputFile[];
  /** `pages`: a JSON text, see snug/drawing/drawing_json.h. */
  documents: {name: string; title: string; trueSize: boolean; pages: string}[];
  containers: {name: string; members: OutputFile[]}[];
}

/** What the library asks for while it reads a scene. null: there is no answer; none of them throws. */
export interface SceneTools {
  /** `name`: without its folders. */
  beside?: (name: string) => Uint8Array | null;
  /** Raw DEFLATE. */
  inflate?: (packed: Uint8Array, most: number) => Uint8Array | null;
  /** `packed` lies in the library's memory, as it does for all of them: copied before anything else is done. */
  meshopt?: (packed: Uint8Array, count: number, stride: number, mode: string) => Uint8Array | null;
  draco?: (
    packed: Uint8Array,
    attributes: {id: number; components: number}[],
  ) => {attributes: Float32Array[]; corners: Uint32Array} | null;
}

/** An object that a design's items are of. `own`: a design's JSON text. */
export interface GivenObject {
  number: number;
  name: string;
  bytes: number;
  sha256: string;
  shape?: string;
  own: string | null;
}

/** Keeps objects between calls. Failures change nothing. */
export interface Session {
  load(number: number, bytes: Uint8Array, name: string, design: string, tools: SceneTools | null): Omit<ObjectInfo, 'id' | 'file' | 'beside'> | Failure;
  keep(numbers: number[]): void;
  describe(number: number, design: string): Omit<ObjectInfo, 'id' | 'file' | 'beside'> | Failure;
  mesh(number: number): Omit<DisplayMesh, 'deviation'>;
  /** `dependent`: a JSON text. */
  pack(design: string, objects: GivenObject[]): (Omit<Packing, 'dependent'> & {dependent: string}) | Failure;
  gaps(progress: Progress): Gap | Failure;
  drops(): Drops | Failure;
  /** On a side, 0 to 5; null: at rest. */
  contacts(side: number | null): ContactMap | Failure;
  protectingWalls(design: string, objects: GivenObject[], progress: Progress): {design: string} | Failure;
  plan(design: string, objects: GivenObject[], wishes: PlanWishes, language: string, progress: Progress): ProposalTexts | Failure;
  zones(): ZoneResults | Failure;
  distances(points: Float32Array): Float32Array<ArrayBuffer> | Failure;
  startSearch(design: string, objects: GivenObject[]): (SearchStep & {ended: boolean}) | Failure;
  searchStep(): (SearchStep & {ended: boolean}) | Failure;
  distinct(): FoundPlacement[];
  fitCase(design: string, objects: GivenObject[], progress: Progress): {design: string} | Failure;
  arrange(design: string, objects: GivenObject[], progress: Progress, better: BetterDesign): ArrangementText | Failure;
  fill(design: string, objects: GivenObject[], item: number, progress: Progress, better: BetterDesign): ArrangementText | Failure;
  startMap(design: string, objects: GivenObject[]): (DirectionMap & {ended: boolean}) | Failure;
  mapStep(): (DirectionMap & {ended: boolean}) | Failure;
  rankCases(design: string, objects: GivenObject[]): CaseRanking | Failure;
  workshopFigures(design: string, objects: GivenObject[]): WorkshopFigures | Failure;
  outputFiles(design: string, objects: GivenObject[], language: string, progress: Progress): Made | Failure;
  delete(): void;
}

export interface SnugModule {
  version(): string;
  defaultDesign(): string;
  presets(): Preset[];
  bricks(): BrickRange;
  /** A foam's `design`: a JSON text. */
  protectionChoices(): DropChoicesText;
  /** The same of a foams.json, see snug/design/known_foams.h. */
  parseFoams(text: string): FoamsText | Failure;
  /** Of an object from measurements. */
  parseShape(text: string): {solids: Solid[]} | Failure;
  samples(): string[];
  sampleFile(name: string): OutputFile | Failure;
  parseProject(text: string): {objects: Omit<GivenObject, 'number'>[]; design: string; dependent: string} | Failure;
  packedProject(zip: Uint8Array, tools: SceneTools): PackedProject | Failure;
  projectText(design: string, objects: GivenObject[]): {text: string} | Failure;
  /** The `snug make` that gives this design from the objects' files. */
  commandLine(design: string, objects: GivenObject[], language: string): {text: string} | Failure;
  /** A JSON text: every option's path with its kind, range, unit, step, words and default, see
   *  snug/design/options_schema.h. */
  optionsSchema(): string;
  make(object: Uint8Array, project: string, tools: SceneTools | null, language: string): Made | Failure;
  Session: new () => Session;
}
