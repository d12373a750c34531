import type {
  Design,
  DirectionMap,
  DisplayMesh,
  Engine,
  Failure,
  FoundPlacement,
  Gap,
  ObjectInfo,
  Packing,
  Preset,
} from '../engine/api';
import {isFailure} from '../engine/failure';
import {makeLine} from '../engine/make_line';
import type {Autosave, Moment, StoredObject} from './autosave';
import {completed, forNewObject, withPlacement, withSpace} from './edit';
import {canRedo, canUndo, moved, present, record, startHistory, type History} from './history';

/** Drawn while something moves, and when it stands still. */
const MOVING_TRIANGLES = 10_000;
const STILL_TRIANGLES = 100_000;
/** Above this a gap report takes long enough that it is made only when asked for. */
const GAPS_BY_THEMSELVES = 200_000;
const REST_MS = 900;
const SAVE_MS = 250;

/** A sentence for the person and the control that it stands beside. */
export interface Problem {
  control: string;
  text: string;
}

export type Work = 'start' | 'read' | 'gaps' | 'search' | 'map' | 'make';
/** What takes long just now. `fraction`: 0 to 1 where it is known. */
export interface Busy {
  work: Work;
  fraction: number | null;
  cancel: (() => void) | null;
}

export interface DisplayMeshes {
  moving: DisplayMesh;
  still: DisplayMesh;
}

/** From an input to its new foams. */
export interface Timing {
  /** When the change was made, as performance.now() tells. */
  input: number;
  /** Until the foams were back on the page. */
  answer_ms: number;
  library_ms: number;
}

/** The work on the page: one object, one design, and what the library makes of them. */
export class Studio {
  readonly engine: Engine;
  readonly #autosave: Autosave | null;
  readonly defaults: Design;
  readonly presets: Preset[];
  readonly samples: string[];
  readonly version: string;

  /** What the controls show. */
  design: Design = $state.raw({} as Design);
  object: ObjectInfo | null = $state.raw(null);
  meshes: DisplayMeshes | null = $state.raw(null);
  /** The last good one. */
  packing: Packing | null = $state.raw(null);
  timing: Timing | null = $state.raw(null);
  gap: Gap | null = $state.raw(null);
  problem: Problem | null = $state.raw(null);
  /** What the last search and the last map found; see knowsPlacementsOf(). */
  #placements: {of: string; blocks: Design['space']['blocks']; distinct: FoundPlacement[]; map: DirectionMap | null} | null = $state.raw(null);
  /** Something to know that is nobody's fault; stays until it is read. */
  notice: string | null = $state.raw(null);
  busy: Busy | null = $state.raw(null);
  /** The object is only a copy for looking: its foams are made elsewhere. */
  thinned: {name: string; deviation: number} | null = $state.raw(null);
  #history: History<Moment> = $state.raw(startHistory<Moment>({design: {} as Design, object: null}));
  canUndo = $derived(canUndo(this.#history));
  canRedo = $derived(canRedo(this.#history));

  #objects = new Map<string, StoredObject>();
  #shown: string | null = null;
  #saving: ReturnType<typeof setTimeout> | undefined;
  #resting: ReturnType<typeof setTimeout> | undefined;
  #meshesOf = 0;
  #arrival: Promise<void> = Promise.resolve();
  /** Settles when the last long work has ended. */
  #work: Promise<void> = Promise.resolve();

  private constructor(
    engine: Engine,
    autosave: Autosave | null,
    facts: {defaults: Design; presets: Preset[]; samples: string[]; version: string},
  ) {
    this.engine = engine;
    this.#autosave = autosave;
    this.defaults = facts.defaults;
    this.presets = facts.presets;
    this.samples = facts.samples;
    this.version = facts.version;
    this.design = {...facts.defaults, space: {...facts.defaults.space, blocks: 'auto'}};
    this.#history = startHistory({design: this.design, object: null});
  }

  static async start(engine: Engine, autosave: Autosave | null): Promise<Studio> {
    const [defaults, presets, samples, version] = await Promise.all([
      engine.defaultDesign(),
      engine.presets(),
      engine.samples(),
      engine.version(),
    ]);
    return new Studio(engine, autosave, {defaults, presets, samples, version});
  }

  get file(): StoredObject | null {
    return (this.#shown && this.#objects.get(this.#shown)) || null;
  }

  get makeLine(): string {
    return makeLine(this.thinned?.name ?? this.object?.file.name ?? 'object.stl', this.design, this.defaults);
  }

  /** A change by `control`. Refused by the library: its sentence, and everything stays as it was. */
  change(edit: (design: Design) => Design, control: string): void {
    const next = edit(this.design);
    if (JSON.stringify(next) === JSON.stringify(this.design)) return;
    this.design = next;
    void this.#show(next, control);
  }

  undo = () => this.#go(-1);
  redo = () => this.#go(1);

  /** Puts a file's content on the screen. Null where it worked. */
  async openObject(
    name: string,
    content: Blob,
    options: {converted?: boolean; design?: Design} = {},
  ): Promise<Failure | null> {
    this.#stopResting();
    // A search or an export of the last object ends first, and leaves the design alone.
    if (this.busy) await this.engine.cancel();
    await this.#work;
    this.busy = {work: 'read', fraction: null, cancel: null};
    const design = options.design ?? forNewObject(this.design, this.defaults);
    const info = await this.engine.load(name, content, design.object);
    this.busy = null;
    if (isFailure(info)) return this.#refuse('object', {...info, error: named(name, info.error)});
    const id = info.file.sha256 || crypto.randomUUID();
    this.thinned = null;
    this.#objects.set(id, {id, name, content, converted: options.converted ?? false});
    this.#shown = id;
    this.design = design;
    this.packing = null;
    await this.#objectIs(info);
    const failed = await this.#show(design, '');
    // A design that this object cannot have is no reason to lose the object.
    return failed && options.design ? this.openObject(name, content, {converted: options.converted}) : failed;
  }

  /** Looks for the placement that cuts the least foam away, and shows the best so far on the way. */
  optimize(): Promise<void> {
    this.#work = this.#search();
    return this.#work;
  }

  /** Of the present object and foam, wherever the object lies. */
  get placements() {
    return this.#placements?.of === this.#foundFor() ? this.#placements : null;
  }

  /** Puts the object where a search or a map found it. */
  take({rotation_deg, offset_mm}: Design['placement'], control: string): void {
    const blocks = this.#placements?.blocks ?? this.design.space.blocks;
    this.change((design) => withSpace(withPlacement(design, {rotation_deg, offset_mm}), blocks), control);
  }

  /** The fewest blocks that hold the object and its walls, and the placement for them. */
  fitCase(): Promise<void> {
    this.#work = this.#fitCase();
    return this.#work;
  }

  async #fitCase(): Promise<void> {
    const start = this.design;
    const fitted = await this.#long('search', (onProgress) => this.engine.fitCase(start, onProgress));
    if (isFailure(fitted)) {
      this.#refuse('optimize', fitted);
      return;
    }
    this.design = fitted.design;
    await this.#show(this.design, 'optimize');
  }

  /** Colours all directions by what they cut, better and better. */
  map(): Promise<void> {
    this.#work = this.#map();
    return this.#work;
  }

  async #map(): Promise<void> {
    const design = this.design;
    this.#stopResting();
    this.busy = {work: 'map', fraction: 0, cancel: () => void this.engine.cancel()};
    const grown = (map: DirectionMap) => {
      if (this.busy?.work === 'map') this.busy = {...this.busy, fraction: map.fraction};
      this.#found({map});
    };
    const map = await this.engine.directions(design, grown);
    this.busy = null;
    if (isFailure(map)) this.#refuse('optimize', map);
    else grown(map);
  }

  #found(news: {distinct?: FoundPlacement[]; map?: DirectionMap}): void {
    const {distinct = [], map = null} = this.placements ?? {};
    const blocks = this.packing?.blocks ?? this.design.space.blocks;
    this.#placements = {of: this.#foundFor(), blocks, distinct, map, ...news};
  }

  /** All that placements depend on, but for the number of blocks where the space follows the object. */
  #foundFor(): string {
    const {object, space, cut} = this.design;
    return JSON.stringify([this.#shown, object, space.block_mm, space.wall_mm, cut]);
  }

  async #search(): Promise<void> {
    const start = this.design;
    this.#stopResting();
    this.busy = {work: 'search', fraction: 0, cancel: () => void this.engine.cancel()};
    const blocks = this.packing?.blocks ?? start.space.blocks;
    let shown = '';
    const best = await this.engine.search(start, (step) => {
      if (this.busy?.work !== 'search') return;
      this.busy = {...this.busy, fraction: step.fraction};
      const next = withSpace(withPlacement(start, step), blocks);
      if (JSON.stringify(next.placement) === shown) return;
      shown = JSON.stringify(next.placement);
      this.design = next;
      void this.#pack(next);
    });
    this.busy = null;
    if (isFailure(best)) {
      this.design = start;
      this.#refuse('optimize', best);
    } else {
      this.design = await this.#asFound(withPlacement(start, best), best.cut_blocks, blocks);
      this.#found({distinct: best.distinct});
    }
    await this.#show(this.design, 'optimize');
  }

  /** A space that is fitted anew may begin half a block elsewhere and cut more: then the search's own stays. */
  async #asFound(design: Design, cut_blocks: number, blocks: Design['space']['blocks']): Promise<Design> {
    const packing = await this.engine.pack(design);
    const asGood = !isFailure(packing) && packing.fit !== null && packing.fit.cut_blocks <= cut_blocks;
    return asGood ? design : withSpace(design, blocks);
  }

  async measureGaps(): Promise<void> {
    if (!this.packing?.fit || this.busy) return;
    const packing = this.packing;
    this.busy = {work: 'gaps', fraction: 0, cancel: () => void this.engine.cancel()};
    const gap = await this.engine.gaps((fraction) => {
      if (this.busy?.work === 'gaps') this.busy = {...this.busy, fraction};
    });
    if (this.busy?.work === 'gaps') this.busy = null;
    if (!isFailure(gap) && packing === this.packing) this.gap = gap;
    else if (isFailure(gap) && gap.kind !== 'cancelled') this.#refuse('check', gap);
  }

  /** Runs long work of another file's with this page's progress and cancel. */
  long<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T> {
    const answer = this.#long(work, run);
    this.#work = answer.then(() => {});
    return answer;
  }

  async #long<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T> {
    this.#stopResting();
    this.busy = {work, fraction: 0, cancel: () => void this.engine.cancel()};
    const answer = await run((fraction) => {
      if (this.busy?.work === work) this.busy = {...this.busy, fraction};
    });
    this.busy = null;
    return answer;
  }

  /** What the last session left, if anything. */
  async restore(): Promise<void> {
    const saved = await this.#autosave?.load().catch(() => null);
    if (!saved) return;
    for (const object of saved.objects) this.#objects.set(object.id, object);
    // Designs of another version may say less, or other things, than this one's.
    const moments = saved.work.history.moments.map((at) => ({...at, design: completed(at.design, this.defaults)}));
    const history = {...saved.work.history, moments, control: ''};
    const moment = present(history);
    const checked = await this.engine.parseProject(JSON.stringify(moment.design));
    if (isFailure(checked)) return;
    this.#history = history;
    await this.#arrive(moment);
  }

  /** Forgets everything, on the screen and in the browser. */
  async clear(): Promise<void> {
    await this.#autosave?.clear();
    location.reload();
  }

  refuse(control: string, text: string) {
    this.problem = {control, text};
  }

  /** The library had to start anew. */
  restarted(reason: Failure) {
    this.notice = reason.error;
    this.busy = null;
  }

  saveNow = (): Promise<void> => {
    clearTimeout(this.#saving);
    const write = this.#autosave?.save({history: $state.snapshot(this.#history)}, this.#objects.values());
    return write?.catch((reason: unknown) => this.#refuseSaving(reason)) ?? Promise.resolve();
  };

  async #go(by: -1 | 1): Promise<void> {
    const history = moved(this.#history, by);
    if (history.at === this.#history.at) return;
    this.#history = history;
    this.problem = null;
    this.design = present(history).design;
    // One after the other: each may have to load its object.
    this.#arrival = this.#arrival.then(() => this.#arrive(present(this.#history)));
    await this.#arrival;
    this.#saveSoon();
  }

  /** Shows a moment of the history, loading its object where that is another one. */
  async #arrive({design, object}: Moment): Promise<void> {
    this.#stopResting();
    this.design = design;
    if (object !== this.#shown) {
      const stored = object === null ? null : this.#objects.get(object);
      this.packing = null;
      this.#shown = stored ? object : null;
      if (!stored) {
        this.object = null;
        this.meshes = null;
        return;
      }
      this.busy = {work: 'read', fraction: null, cancel: null};
      const info = await this.engine.load(stored.name, stored.content, design.object);
      this.busy = null;
      if (isFailure(info)) return void this.#refuse('object', info);
      await this.#objectIs(info);
    }
    await this.#pack(design);
    this.#rest();
  }

  /** Makes the foams of a design; a good one becomes a moment of the history. */
  async #show(design: Design, control: string): Promise<Failure | null> {
    this.#stopResting();
    const failed = await this.#pack(design);
    // A newer change is on its way, or the person went back meanwhile.
    if (failed?.kind === 'cancelled' || this.design !== design) return null;
    if (failed) {
      this.design = present(this.#history).design;
      return this.#refuse(control, failed);
    }
    this.problem = null;
    this.#history = record(this.#history, {design, object: this.#shown}, control, performance.now());
    this.#saveSoon();
    this.#rest();
    return null;
  }

  async #pack(design: Design): Promise<Failure | null> {
    const input = performance.now();
    if (!this.object) return this.#checked(design);
    if (JSON.stringify(design.object) !== this.#preparedFor) {
      const info = await this.engine.reprepare(design);
      if (isFailure(info)) return info;
      await this.#objectIs(info);
    }
    if (this.object.sizeProblem) return this.#checked(design);
    const packing = await this.engine.pack(design);
    if (isFailure(packing)) return packing;
    this.packing = packing;
    this.gap = null;
    const answer_ms = performance.now() - input;
    this.timing = {input, answer_ms, library_ms: packing.library_ms};
    return null;
  }

  #preparedFor = '';

  async #objectIs(info: ObjectInfo): Promise<void> {
    this.object = info;
    this.#preparedFor = JSON.stringify(this.design.object);
    const turn = ++this.#meshesOf;
    const moving = await this.engine.displayMesh(MOVING_TRIANGLES);
    if (turn !== this.#meshesOf) return;
    this.meshes = {moving, still: moving};
    void this.engine.displayMesh(STILL_TRIANGLES).then((still) => {
      if (turn === this.#meshesOf) this.meshes = {moving, still};
    });
  }

  async #checked(design: Design): Promise<Failure | null> {
    const answer = await this.engine.parseProject(JSON.stringify(design));
    return isFailure(answer) ? answer : null;
  }

  #refuse(control: string, failure: Failure): Failure {
    if (failure.kind !== 'cancelled') this.problem = {control, text: failure.error};
    return failure;
  }

  #refuseSaving(reason: unknown) {
    this.notice = `This browser cannot keep the work (${reason instanceof Error ? reason.message : String(reason)}): save the project.`;
  }

  #saveSoon() {
    clearTimeout(this.#saving);
    this.#saving = setTimeout(this.saveNow, SAVE_MS);
  }

  #stopResting() {
    clearTimeout(this.#resting);
    if (this.busy?.work === 'gaps') void this.engine.cancel();
  }

  /** What may take its time happens when nobody changes anything. */
  #rest() {
    clearTimeout(this.#resting);
    if (!this.object || this.object.triangles > GAPS_BY_THEMSELVES) return;
    this.#resting = setTimeout(() => void this.measureGaps(), REST_MS);
  }
}

/** The library speaks of a file's content; a person may have several. */
function named(name: string, sentence: string): string {
  return sentence.includes(name) ? sentence : `${name}: ${sentence}`;
}
