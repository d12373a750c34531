// The WebAssembly module that wasm/ builds. Designs and projects pass as JSON texts.

declare module 'snug-wasm/snug.mjs' {
  import type {BrickRange, Preset} from '../design/design';
  import type {
    CaseRanking,
    DirectionMap,
    DisplayMesh,
    Failure,
    FoundPlacement,
    Gap,
    ObjectFile,
    ObjectInfo,
    OutputFile,
    Packing,
    SearchStep,
    WorkshopFigures,
  } from './api';

  type Progress = ((fraction: number) => boolean) | null;
  type Made = {files: OutputFile[]; report: string; pack?: Pack};
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

  /** Keeps the object between calls. Failures change nothing. */
  export interface Session {
    load(bytes: Uint8Array, name: string, design: string, tools: SceneTools | null): Omit<ObjectInfo, 'file' | 'beside'> | Failure;
    describe(design: string): Omit<ObjectInfo, 'file' | 'beside'> | Failure;
    mesh(): Omit<DisplayMesh, 'deviation'>;
    /** `dependent`: a JSON text. */
    pack(design: string): (Omit<Packing, 'dependent'> & {dependent: string}) | Failure;
    gaps(progress: Progress): Gap | Failure;
    distances(points: Float32Array): Float32Array<ArrayBuffer> | Failure;
    startSearch(design: string): (SearchStep & {ended: boolean}) | Failure;
    searchStep(): (SearchStep & {ended: boolean}) | Failure;
    distinct(): FoundPlacement[];
    fitCase(design: string, progress: Progress): {design: string} | Failure;
    startMap(design: string): (DirectionMap & {ended: boolean}) | Failure;
    mapStep(): (DirectionMap & {ended: boolean}) | Failure;
    rankCases(design: string): CaseRanking | Failure;
    workshopFigures(project: string): WorkshopFigures | Failure;
    outputFiles(project: string, language: string, progress: Progress): Made | Failure;
    delete(): void;
  }

  export interface SnugModule {
    version(): string;
    defaultDesign(): string;
    presets(): Preset[];
    bricks(): BrickRange;
    samples(): string[];
    sampleFile(name: string): OutputFile | Failure;
    parseProject(text: string): {object: ObjectFile; design: string; dependent: string} | Failure;
    projectText(design: string, name: string, bytes: number, sha256: string): {text: string} | Failure;
    /** The `snug make` that gives this design from the file. */
    commandLine(file: string, design: string, language: string): {text: string} | Failure;
    /** A JSON text: every option's path with its kind, range, unit, step, words and default, see
     *  snug/design/options_schema.h. */
    optionsSchema(): string;
    make(object: Uint8Array, project: string, tools: SceneTools | null, language: string): Made | Failure;
    Session: new () => Session;
  }

  export default function createSnug(options: {
    wasmBinary?: Uint8Array;
    locateFile?: (path: string) => string;
  }): Promise<SnugModule>;
}
