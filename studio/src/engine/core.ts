import type {BrickRange, Design, Preset} from '../design/design';
import type {ObjectUse} from '../design/moment';
import type {Dependent, Schema} from '../design/options';
import type {Solid} from '../design/shape';
import type {
  Arrangement,
  ArrangeStep,
  BesideFile,
  CaseRanking,
  SearchResult,
  SearchStep,
  DirectionMap,
  DisplayMesh,
  Failure,
  Loading,
  ObjectFile,
  ObjectInfo,
  OnProgress,
  OutputFile,
  PackedProject,
  Packing,
  Project,
  WorkshopFigures,
} from './api';
import {simplified} from './display_mesh';
import {readChoices, readFoams, type ContactMap, type DropChoices, type Drops, type KnownFoam, type Pressing} from './drops';
import {brokenModule, isFailure} from './failure';
import {readWith, type FileTools} from './file_tools';
import type {Gap} from './gap';
import {arranged, designOf, listeners, throttled} from './listeners';
import type {GivenObject, Pack, Session, SnugModule} from './module';
import {readProposals, type PlanWishes, type Proposal} from './plan';
import {newId} from './new_id';
import {sha256} from './sha256';
import type {ZoneResults} from './zones';

/** More than anybody measures. */
const MOST_OF_SHAPE = 100_000;
const NO_FILE: ObjectFile = {name: '', bytes: 0, sha256: ''};

/** What a core calls and does not know: readers and writers that are no part of the library. */
export interface CoreParts {
  toolsFor(beside: readonly BesideFile[]): FileTools;
  /** The files of a pack as a maker has them. */
  packFiles(pack: Pack): Promise<OutputFile[]>;
}

interface Loaded {
  /** That the session knows it by. */
  number: number;
  file: ObjectFile;
  beside: string[];
}

type Objects = readonly ObjectUse[];

/** What runs in a worker: objects and the library. After a Failure of kind `memory` it is of no more use. */
export class EngineCore {
  readonly #snug: SnugModule;
  readonly #session: Session;
  readonly #parts: CoreParts;
  /** By what they are called, the one that was loaded last at the end. */
  readonly #loaded = new Map<string, Loaded>();
  #numbers = 0;
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

  async dropChoices(): Promise<DropChoices> {
    return readChoices(this.#snug.protectionChoices());
  }

  async parseFoams(text: string): Promise<KnownFoam[] | Failure> {
    const answer = guarded(() => this.#snug.parseFoams(text));
    return isFailure(answer) ? answer : readFoams(answer);
  }

  async parseShape(text: string): Promise<{solids: Solid[]} | Failure> {
    return guarded(() => this.#snug.parseShape(text));
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
    {joins = false, id}: Loading = {},
  ): Promise<ObjectInfo | Failure> {
    const bytes = new Uint8Array(await content.arrayBuffer());
    const design = await this.#designOf(object);
    const box = this.#parts.toolsFor(beside);
    const number = ++this.#numbers;
    const info = await readWith(box, () => guarded(() => this.#session.load(number, bytes, name, design, box.tools)));
    if (isFailure(info)) return info;
    this.#stepping++;
    const shape = /\.shape$/i.test(name) && bytes.length <= MOST_OF_SHAPE ? {shape: new TextDecoder().decode(bytes)} : {};
    const file = {name: withoutFolders(name), bytes: bytes.length, sha256: await sha256(bytes), ...shape};
    // The checksum is the file's own: the same .gltf may come with another .bin.
    const called = id ?? ((box.used.length === 0 && file.sha256) || newId());
    if (!joins) this.#loaded.clear();
    this.#loaded.delete(called);
    this.#loaded.set(called, {number, file, beside: box.used});
    this.#forgetOthers();
    return {id: called, file, beside: box.used, ...info};
  }

  async keep(ids: readonly string[]): Promise<void> {
    for (const id of [...this.#loaded.keys()]) if (!ids.includes(id)) this.#loaded.delete(id);
    this.#forgetOthers();
  }

  #forgetOthers() {
    guarded(() => this.#session.keep([...this.#loaded.values()].map(({number}) => number)));
  }

  /** As a rule the one that was loaded last; number 0 where there is none. */
  #object(id = [...this.#loaded.keys()].at(-1)): Loaded & {id: string} {
    const loaded = id === undefined ? undefined : this.#loaded.get(id);
    return {id: id ?? '', ...(loaded ?? {number: 0, file: NO_FILE, beside: []})};
  }

  async #designOf(object: Design['object']): Promise<string> {
    return JSON.stringify({...(await this.defaultDesign()), object});
  }

  /** For the session. */
  async #given(objects: Objects = [{id: this.#object().id, own: null}]): Promise<GivenObject[]> {
    return Promise.all(
      objects.map(async ({id, own}) => {
        const {number, file} = this.#object(id);
        return {number, ...file, own: own && (await this.#designOf(own))};
      }),
    );
  }

  async reprepare(design: Design, id?: string): Promise<ObjectInfo | Failure> {
    const {number, ...known} = this.#object(id);
    const info = guarded(() => this.#session.describe(number, JSON.stringify(design)));
    return isFailure(info) ? info : {...known, ...info};
  }

  async displayMesh(mostTriangles: number, id?: string): Promise<DisplayMesh | Failure> {
    const mesh = guarded(() => this.#session.mesh(this.#object(id).number));
    if (isFailure(mesh)) return mesh;
    return simplified(mesh, mostTriangles).catch(brokenModule);
  }

  async parseProject(text: string): Promise<Project | Failure> {
    const project = isDesignAlone(text) ? this.#snug.projectText(text, unnamedObjects(text)) : {text};
    if (isFailure(project)) return project;
    const parsed = guarded(() => this.#snug.parseProject(project.text));
    if (isFailure(parsed)) return parsed;
    const objects = parsed.objects.map(({own, ...file}: ObjectFile & {own: string | null}) => ({
      ...(project.text === text ? file : NO_FILE),
      own: own === null ? null : (JSON.parse(own) as Design).object,
    }));
    return {objects, design: JSON.parse(parsed.design) as Design, dependent: JSON.parse(parsed.dependent) as Dependent};
  }

  async packedProject(zip: Blob): Promise<PackedProject | Failure> {
    const bytes = new Uint8Array(await zip.arrayBuffer());
    const box = this.#parts.toolsFor([]);
    return readWith(box, () => guarded(() => this.#snug.packedProject(bytes, box.tools)));
  }

  async projectText(design: Design, objects?: Objects): Promise<{text: string} | Failure> {
    const given = await this.#given(objects);
    return guarded(() => this.#snug.projectText(JSON.stringify(design), given));
  }

  /** `file`: one for each object. */
  async commandLine(
    file: string | readonly string[],
    design: Design,
    language = 'en',
    objects?: Objects,
  ): Promise<{text: string} | Failure> {
    const files = [file].flat();
    const given = (await this.#given(objects)).map((object, i) => ({...object, name: files[i] ?? ''}));
    return guarded(() => this.#snug.commandLine(JSON.stringify(design), given, language));
  }

  async pack(design: Design, objects?: Objects): Promise<Packing | Failure> {
    const given = await this.#given(objects);
    const packing = guarded(() => this.#session.pack(JSON.stringify(design), given));
    return isFailure(packing) ? packing : {...packing, dependent: JSON.parse(packing.dependent) as Dependent};
  }

  /** Of the last packing. Blocks its thread until it is done. */
  async gaps(onProgress?: OnProgress): Promise<Gap | Failure> {
    return guarded(() => this.#session.gaps(throttled(onProgress)));
  }

  async drops(): Promise<Drops | Failure> {
    return guarded(() => this.#session.drops());
  }

  async contacts(pressing: Pressing): Promise<ContactMap | Failure> {
    return guarded(() => this.#session.contacts(pressing === 'rest' ? null : pressing));
  }

  /** Blocks its thread until it is done. */
  async protectingWalls(design: Design, onProgress?: OnProgress, objects?: Objects): Promise<{design: Design} | Failure> {
    const given = await this.#given(objects);
    return designOf(guarded(() => this.#session.protectingWalls(JSON.stringify(design), given, throttled(onProgress))));
  }

  async plan(design: Design, wishes: PlanWishes, language: string, onProgress?: OnProgress, objects?: Objects): Promise<Proposal[] | Failure> {
    const given = await this.#given(objects);
    return readProposals(guarded(() => this.#session.plan(JSON.stringify(design), given, wishes, language, throttled(onProgress))));
  }

  async zones(): Promise<ZoneResults | Failure> {
    return guarded(() => this.#session.zones());
  }

  /** Of the last packing. Builds the search tree of the object at the first call. */
  async distances(points: Float32Array): Promise<Float32Array<ArrayBuffer> | Failure> {
    return guarded(() => this.#session.distances(points));
  }

  /** Step by step, so that cancel() and everything else is heard in between. */
  async search(
    design: Design,
    onStep: (step: SearchStep) => void,
    objects?: Objects,
  ): Promise<SearchResult | Failure> {
    const text = JSON.stringify(design);
    const given = await this.#given(objects);
    const end = await this.#stepwise(
      () => this.#session.startSearch(text, given),
      () => this.#session.searchStep(),
      onStep,
    );
    if (isFailure(end)) return end;
    const distinct = guarded(() => this.#session.distinct());
    return isFailure(distinct) ? distinct : {...end, distinct};
  }

  async fitCase(design: Design, onProgress?: OnProgress, objects?: Objects): Promise<{design: Design} | Failure> {
    const given = await this.#given(objects);
    return designOf(guarded(() => this.#session.fitCase(JSON.stringify(design), given, throttled(onProgress))));
  }

  /** Blocks its thread until it is done. */
  async arrange(
    design: Design,
    onStep: (step: ArrangeStep) => void,
    objects?: Objects,
  ): Promise<Arrangement | Failure> {
    const given = await this.#given(objects);
    const {progress, better} = listeners(onStep);
    return arranged(guarded(() => this.#session.arrange(JSON.stringify(design), given, progress, better)));
  }

  async fill(
    design: Design,
    item: number,
    onStep: (step: ArrangeStep) => void,
    objects?: Objects,
  ): Promise<Arrangement | Failure> {
    const given = await this.#given(objects);
    const {progress, better} = listeners(onStep);
    return arranged(guarded(() => this.#session.fill(JSON.stringify(design), given, item, progress, better)));
  }

  async directions(
    design: Design,
    onStep: (map: DirectionMap) => void,
    objects?: Objects,
  ): Promise<DirectionMap | Failure> {
    const text = JSON.stringify(design);
    const given = await this.#given(objects);
    return this.#stepwise(
      () => this.#session.startMap(text, given),
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

  async rankCases(design: Design, objects?: Objects): Promise<CaseRanking | Failure> {
    const given = await this.#given(objects);
    return guarded(() => this.#session.rankCases(JSON.stringify(design), given));
  }

  async workshopFigures(design: Design, objects?: Objects): Promise<WorkshopFigures | Failure> {
    const given = await this.#given(objects);
    return guarded(() => this.#session.workshopFigures(JSON.stringify(design), given));
  }

  async outputFiles(
    design: Design,
    language = 'en',
    onProgress?: OnProgress,
    objects?: Objects,
  ): Promise<OutputFile[] | Failure> {
    const given = await this.#given(objects);
    const text = JSON.stringify(design);
    const made = guarded(() => this.#session.outputFiles(text, given, language, throttled(onProgress)));
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

function withoutFolders(name: string): string {
  return name.slice(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
}

function isDesignAlone(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value !== 'object' || value === null || 'snug' in value || 'design' in value) return false;
    return ['space', 'placement', 'items', 'cut', 'parting', 'output'].some((name) => name in value);
  } catch {
    return false;
  }
}

/** As many as the items of a design are of; one where it says nothing of them. */
function unnamedObjects(design: string): GivenObject[] {
  const {items = []} = JSON.parse(design) as {items?: {object?: number}[]};
  const most = Math.max(0, ...items.map(({object}) => object ?? 0));
  return Array.from({length: Math.min(most, 999) + 1}, () => ({...NO_FILE, name: 'unnamed', number: 0, own: null}));
}

function afterWaitingMessages(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
