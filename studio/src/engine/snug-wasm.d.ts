// The WebAssembly module that wasm/ builds. Designs and projects pass as JSON texts.

declare module 'snug-wasm/snug.mjs' {
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
    Preset,
    SearchStep,
    WorkshopFigures,
  } from './api';

  type Progress = ((fraction: number) => boolean) | null;
  type Made = {files: OutputFile[]; report: string; pack?: Pack};
  export interface Pack {
    files: OutputFile[];
    /** `pages`: a JSON text, see snug/fabricate/drawing_json.h. */
    documents: {name: string; title: string; trueSize: boolean; pages: string}[];
    containers: {name: string; members: OutputFile[]}[];
  }

  /** Keeps the object between calls. Failures change nothing. */
  export interface Session {
    load(bytes: Uint8Array, name: string, design: string): Omit<ObjectInfo, 'file'> | Failure;
    describe(design: string): Omit<ObjectInfo, 'file'> | Failure;
    mesh(): Omit<DisplayMesh, 'deviation'>;
    pack(design: string): Packing | Failure;
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
    outputFiles(project: string, progress: Progress): Made | Failure;
    delete(): void;
  }

  export interface SnugModule {
    version(): string;
    defaultDesign(): string;
    presets(): Preset[];
    samples(): string[];
    sampleFile(name: string): OutputFile | Failure;
    parseProject(text: string): {object: ObjectFile; design: string} | Failure;
    projectText(design: string, name: string, bytes: number, sha256: string): {text: string} | Failure;
    make(object: Uint8Array, project: string): Made | Failure;
    Session: new () => Session;
  }

  export default function createSnug(options: {
    wasmBinary?: Uint8Array;
    locateFile?: (path: string) => string;
  }): Promise<SnugModule>;
}
