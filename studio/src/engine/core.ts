import type {Pack, SceneTools, Session, SnugModule} from 'snug-wasm/snug.mjs';
import type {BrickRange, Design, Preset} from '../design/design';
import type {Dependent, Schema} from '../design/options';
import type {
  BesideFile,
  CaseRanking,
  SearchResult,
  SearchStep,
  DirectionMap,
  DisplayMesh,
  Failure,
  Gap,
  ObjectFile,
  ObjectInfo,
  OnProgress,
  OutputFile,
  Packing,
  Project,
  WorkshopFigures,
} from './api';
import {simplified} from './display_mesh';
import {brokenModule, isFailure} from './failure';
import {sha256} from './sha256';

// Often enough for a progress bar.
const PROGRESS_EVERY_MS = 50;

/** The tools for one file: what the library asks for in the middle of reading it. */
export interface FileTools {
  readonly tools: SceneTools;
  /** Names of the files beside it that were asked for and are there. */
  readonly used: string[];
  /** Fetches what was asked for and not at hand, after which another try may go better; false where that was nothing. */
  fetchMissing(): Promise<boolean>;
}

/** What a core calls and does not know: readers and writers that are no part of the library. */
export interface CoreParts {
  toolsFor(beside: readonly BesideFile[]): FileTools;
  /** The files of a pack as a maker has them. */
  packFiles(pack: Pack): Promise<OutputFile[]>;
}

/** What runs in a worker: one object and the library. After a Failure of kind `memory` it is of no more use. */
export class EngineCore {
  readonly #snug: SnugModule;
  readonly #session: Session;
  readonly #parts: CoreParts;
  #file: Promise<ObjectFile> = Promise.resolve({name: '', bytes: 0, sha256: ''});
  #beside: string[] = [];
  #stepping = 0;

  constructor(snug: SnugModule, parts: CoreParts) {
    this.#snug = snug;
    this.#parts = parts;
    this.#session = new snug.Session();
  }

  async version(): Promise<string> {
    return this.#snug.version();
  }

  async defaultDesign(): Promise<Design> {
    return JSON.parse(this.#snug.defaultDesign()) as Design;
  }

  async presets(): Promise<Preset[]> {
    return this.#snug.presets();
  }

  async bricks(): Promise<BrickRange> {
    return this.#snug.bricks();
  }

  async options(): Promise<Schema> {
    return JSON.parse(this.#snug.optionsSchema()) as Schema;
  }

  async samples(): Promise<string[]> {
    return this.#snug.samples();
  }

  async sampleFile(name: string): Promise<OutputFile | Failure> {
    return guarded(() => this.#snug.sampleFile(name));
  }

  async load(
    name: string,
    content: Blob,
    object: Design['object'],
    beside: readonly BesideFile[] = [],
  ): Promise<ObjectInfo | Failure> {
    const bytes = new Uint8Array(await content.arrayBuffer());
    const design = JSON.stringify({...(await this.defaultDesign()), object});
    const box = this.#parts.toolsFor(beside);
    const read = () => guarded(() => this.#session.load(bytes, name, design, box.tools));
    let info = read();
    while (isFailure(info) && info.kind === 'input' && (await box.fetchMissing())) info = read();
    if (isFailure(info)) return info;
    this.#beside = box.used;
    this.#stepping++;
    this.#file = sha256(bytes).then((hash) => ({name: withoutFolders(name), bytes: bytes.length, sha256: hash}));
    return {file: await this.#file, beside: this.#beside, ...info};
  }

  async reprepare(design: Design): Promise<ObjectInfo | Failure> {
    const info = guarded(() => this.#session.describe(JSON.stringify(design)));
    return isFailure(info) ? info : {file: await this.#file, beside: this.#beside, ...info};
  }

  async displayMesh(mostTriangles: number): Promise<DisplayMesh | Failure> {
    const mesh = guarded(() => this.#session.mesh());
    if (isFailure(mesh)) return mesh;
    return simplified(mesh, mostTriangles).catch(brokenModule);
  }

  async parseProject(text: string): Promise<Project | Failure> {
    const project = isDesignAlone(text) ? this.#snug.projectText(text, 'unnamed', 0, '') : {text};
    if (isFailure(project)) return project;
    const parsed = guarded(() => this.#snug.parseProject(project.text));
    if (isFailure(parsed)) return parsed;
    const object = project.text === text ? parsed.object : {name: '', bytes: 0, sha256: ''};
    return {object, design: JSON.parse(parsed.design) as Design, dependent: JSON.parse(parsed.dependent) as Dependent};
  }

  async projectText(design: Design): Promise<{text: string} | Failure> {
    const {name, bytes, sha256: hash} = await this.#file;
    return guarded(() => this.#snug.projectText(JSON.stringify(design), name, bytes, hash));
  }

  async commandLine(file: string, design: Design, language = 'en'): Promise<{text: string} | Failure> {
    return guarded(() => this.#snug.commandLine(file, JSON.stringify(design), language));
  }

  async pack(design: Design): Promise<Packing | Failure> {
    const packing = guarded(() => this.#session.pack(JSON.stringify(design)));
    return isFailure(packing) ? packing : {...packing, dependent: JSON.parse(packing.dependent) as Dependent};
  }

  /** Of the last packing. Blocks its thread until it is done. */
  async gaps(onProgress?: OnProgress): Promise<Gap | Failure> {
    return guarded(() => this.#session.gaps(throttled(onProgress)));
  }

  /** Of the last packing. Builds the search tree of the object at the first call. */
  async distances(points: Float32Array): Promise<Float32Array<ArrayBuffer> | Failure> {
    return guarded(() => this.#session.distances(points));
  }

  /** Step by step, so that cancel() and everything else is heard in between. */
  async search(design: Design, onStep: (step: SearchStep) => void): Promise<SearchResult | Failure> {
    const text = JSON.stringify(design);
    const end = await this.#stepwise(
      () => this.#session.startSearch(text),
      () => this.#session.searchStep(),
      onStep,
    );
    if (isFailure(end)) return end;
    const distinct = guarded(() => this.#session.distinct());
    return isFailure(distinct) ? distinct : {...end, distinct};
  }

  async fitCase(design: Design, onProgress?: OnProgress): Promise<{design: Design} | Failure> {
    const fitted = guarded(() => this.#session.fitCase(JSON.stringify(design), throttled(onProgress)));
    return isFailure(fitted) ? fitted : {design: JSON.parse(fitted.design) as Design};
  }

  async directions(design: Design, onStep: (map: DirectionMap) => void): Promise<DirectionMap | Failure> {
    const text = JSON.stringify(design);
    return this.#stepwise(
      () => this.#session.startMap(text),
      () => this.#session.mapStep(),
      onStep,
    );
  }

  async #stepwise<T extends object>(
    begin: () => (T & {ended: boolean}) | Failure,
    goOn: () => (T & {ended: boolean}) | Failure,
    onStep: (step: T) => void,
  ): Promise<T | Failure> {
    const mine = ++this.#stepping;
    let step = guarded(begin);
    if (isFailure(step)) return step;
    onStep(told(step));
    while (!step.ended) {
      await afterWaitingMessages();
      if (mine !== this.#stepping) break;
      const next = guarded(goOn);
      if (isFailure(next)) return next.kind === 'cancelled' ? told(step) : next;
      step = next;
      onStep(told(step));
    }
    return told(step);
  }

  /** Ends the search or the map after its step. */
  async cancel(): Promise<void> {
    this.#stepping++;
  }

  async rankCases(design: Design): Promise<CaseRanking | Failure> {
    return guarded(() => this.#session.rankCases(JSON.stringify(design)));
  }

  async workshopFigures(design: Design): Promise<WorkshopFigures | Failure> {
    const project = await this.projectText(design);
    return isFailure(project) ? project : guarded(() => this.#session.workshopFigures(project.text));
  }

  async outputFiles(design: Design, language = 'en', onProgress?: OnProgress): Promise<OutputFile[] | Failure> {
    const project = await this.projectText(design);
    if (isFailure(project)) return project;
    const made = guarded(() => this.#session.outputFiles(project.text, language, throttled(onProgress)));
    if (isFailure(made)) return made;
    const files = [...made.files, {name: 'report.json', bytes: new TextEncoder().encode(made.report)}];
    if (!made.pack) return files;
    return [...files, ...(await this.#parts.packFiles(made.pack))];
  }
}

/** The library has no exceptions: what is thrown means that the module itself stopped. */
function guarded<T>(call: () => T): T | Failure {
  try {
    return call();
  } catch (reason) {
    return brokenModule(reason);
  }
}

function told<T extends object>({ended: _, ...step}: T & {ended: boolean}): T {
  return step as unknown as T;
}

function throttled(onProgress?: OnProgress): ((fraction: number) => boolean) | null {
  if (!onProgress) return null;
  let told = performance.now();
  return (fraction) => {
    const now = performance.now();
    if (now - told >= PROGRESS_EVERY_MS) {
      told = now;
      onProgress(fraction);
    }
    return true;
  };
}

function withoutFolders(name: string): string {
  return name.slice(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
}

function isDesignAlone(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value !== 'object' || value === null || 'snug' in value || 'design' in value) return false;
    return ['space', 'placement', 'cut', 'parting', 'output'].some((name) => name in value);
  } catch {
    return false;
  }
}

function afterWaitingMessages(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
