import type {BrickRange, Design, Preset} from '../design/design';
import {firstDesign, forNewObject} from '../design/edit';
import type {Schema} from '../design/options';
import {canRedo, canUndo, Gestures, moved, present, record, startHistory, type History} from '../design/history';
import type {BesideFile, Engine, Failure, Finding, Gap, ObjectInfo, Packing} from '../engine/api';
import {CANCELLED, isFailure} from '../engine/failure';
import {files} from '../words/files';
import {about, type Pair} from '../words/words';
import type {Moment, StoredObject} from './autosave';
import {newId} from './claims';
import {gravestFirst} from './findings';
import {Keeping} from './keeping.svelte';
import {LongWork} from './long_work';
import type {Busy, Content, DisplayMeshes, FileFacts, Problem, Reading, Timing, Work} from './on_the_page';
import {Options} from './options.svelte';
import {Placements} from './placements.svelte';
import {Readings} from './readings';
import {Rest} from './rest.svelte';
import {ShownObject} from './shown_object.svelte';
import type {Works} from './works.svelte';

/** Above this a gap report takes long enough that it is made only when asked for. */
const GAPS_BY_THEMSELVES = 200_000;

/** Refusals that no later change of a control answers: they stay until they are read. */
const LASTING: readonly string[] = ['object', 'project', 'make'];

/** The work on the page: one object, one design, and what the library makes of them. */
export class Studio {
  readonly engine: Engine;
  readonly defaults: Design;
  readonly presets: Preset[];
  readonly bricks: BrickRange;
  readonly options: Options;
  readonly samples: string[];
  readonly version: string;

  /** What the controls show. */
  design: Design = $state.raw({} as Design);
  readonly #object: ShownObject;
  readonly #onDesign: () => void;
  /** The last good one. */
  packing: Packing | null = $state.raw(null);
  timing: Timing | null = $state.raw(null);
  gap: Gap | null = $state.raw(null);
  problem: Problem | null = $state.raw(null);
  /** What searches found. */
  readonly placements = new Placements(this);
  /** Something to know that is nobody's fault; stays until it is read. */
  notice: Pair | null = $state.raw(null);
  busy: Busy | null = $state.raw(null);
  /** The object is only a copy for looking: its foams are made elsewhere. */
  thinned: {name: string; deviation: number} | null = $state.raw(null);
  #history: History<Moment> = $state.raw(startHistory<Moment>({design: {} as Design, object: null}));
  /** The object has no size before its unit is known, and no foams. */
  asksForUnit = $derived(this.object?.sizeProblem != null);
  readonly #gestures = new Gestures();
  /** The person closed that question for now. */
  unitLater = $state(false);
  /** What the way of working adds; null while it is being looked at. */
  workshopFindings: readonly Finding[] | null = $state.raw([]);
  /** All that is known to say about the foams, the worst first. */
  findings = $derived(gravestFirst([...(this.gap ?? this.packing)?.findings ?? [], ...(this.workshopFindings ?? [])]));
  canUndo = $derived(canUndo(this.#history));
  canRedo = $derived(canRedo(this.#history));

  /** The works of this browser; null while there are none to be had. */
  works: Works | null = $state.raw(null);
  #objects = new Map<string, StoredObject>();
  #shown: string | null = $state.raw(null);
  readonly #resting = new Rest();
  #arrival: Promise<boolean> = Promise.resolve(true);
  readonly #readings = new Readings(this);
  readonly #keeping = new Keeping(this, this.#objects, {
    history: () => this.#history,
    becomes: (history) => this.#becomes(history),
    checked: (design) => this.#checked(design),
  });
  readonly #long = new LongWork(this, {
    changes: (design) => this.#changes(design),
    show: (design, control) => this.#show(design, control),
    pack: (design) => this.#pack(design),
    refuse: (control, failed) => this.#refuse(control, failed),
    stopResting: () => this.#stopResting(),
  });

  private constructor(
    engine: Engine,
    facts: Pick<Studio, 'defaults' | 'presets' | 'bricks' | 'samples' | 'version'> & {options: Schema},
    onDesign: () => void,
  ) {
    this.engine = engine;
    this.#onDesign = onDesign;
    this.#object = new ShownObject(engine);
    this.defaults = facts.defaults;
    this.presets = facts.presets;
    this.bricks = facts.bricks;
    this.options = new Options(facts.options, () => this.design);
    this.samples = facts.samples;
    this.version = facts.version;
    this.design = firstDesign(facts.defaults);
    this.#history = startHistory({design: this.design, object: null});
  }

  /** `onDesign` hears of every change of the design while it is made. */
  static async start(engine: Engine, onDesign = () => {}): Promise<Studio> {
    const [defaults, presets, bricks, options, samples, version] = await Promise.all([
      engine.defaultDesign(),
      engine.presets(),
      engine.bricks(),
      engine.options(),
      engine.samples(),
      engine.version(),
    ]);
    const studio = new Studio(engine, {defaults, presets, bricks, options, samples, version}, onDesign);
    await studio.#checked(studio.design);
    return studio;
  }

  /** Which object is on the screen. */
  get shown(): string | null {
    return this.#shown;
  }

  get object(): ObjectInfo | null {
    return this.#object.info;
  }

  get meshes(): DisplayMeshes | null {
    return this.#object.meshes;
  }

  get file(): StoredObject | null {
    return (this.#shown && this.#objects.get(this.#shown)) || null;
  }

  /** The gaps of these foams will be known. */
  get gapComes(): boolean {
    return this.#resting.comes || this.busy?.work === 'gaps';
  }

  /** What the command line is to make: of a thinned object its original, of a file that states its unit in no other. */
  get commanded(): {file: string; design: Design} | null {
    if (!this.object) return null;
    const {object} = this.design;
    const design = this.object.statesUnit ? {...this.design, object: {...object, units: null}} : this.design;
    return {file: this.thinned?.name ?? this.object.file.name, design};
  }

  /** A change by `control`. Refused by the library: its sentence, and everything stays as it was. */
  change(edit: (design: Design) => Design, control: string): void {
    const next = edit(this.design);
    if (JSON.stringify(next) === JSON.stringify(this.design)) return;
    this.#changes(next);
    void this.#show(next, control);
  }

  undo = () => this.#go(-1);
  redo = () => this.#go(1);

  /** Puts a file's content on the screen. `source` may make it first.
   *  Null where it worked; refused or cancelled, everything is as it was. */
  async openObject(
    name: string,
    source: Blob | (() => Promise<Content | Failure>),
    options: {beside?: readonly BesideFile[]; design?: Design | undefined} = {},
  ): Promise<Failure | null> {
    const bytes = source instanceof Blob ? source.size : 0;
    const before = present(this.#history);
    const answer = await this.reading({name, bytes}, async (reading) => {
      const own = {name, converted: false, beside: options.beside ?? []};
      const made = source instanceof Blob ? {...own, content: source} : await source();
      if (reading.cancelled || isFailure(made)) return isFailure(made) ? made : CANCELLED;
      const wanted = options.design ?? forNewObject(this.design, this.defaults, this.presets);
      const failed = await this.#open(made, wanted, reading);
      // A design that this object cannot have is no reason to lose the object.
      const again = failed && options.design && failed.kind !== 'cancelled' && this.#shown !== before.object;
      return again ? this.#open(made, forNewObject(this.design, this.defaults, this.presets), reading) : failed;
    });
    if (!isFailure(answer)) return null;
    await this.#backTo(before);
    return this.#refuse('object', {...answer, error: about(name, answer.error)});
  }

  async #open(given: Content, design: Design, reading: Reading): Promise<Failure | null> {
    const {name, content, converted} = given;
    const info = await this.engine.load(name, content, design.object, given.beside);
    if (reading.cancelled || isFailure(info)) return isFailure(info) ? info : CANCELLED;
    const beside = given.beside?.filter((file) => info.beside.includes(file.name)) ?? [];
    // The checksum is the file's own: the same .gltf may come with another .bin.
    const id = (beside.length === 0 && info.file.sha256) || newId();
    this.#objects.set(id, {id, name, content, converted, beside});
    await this.#switchTo(id, info, design);
    if (reading.cancelled) return CANCELLED;
    const failed = await this.#show(design, '');
    if (reading.cancelled) return CANCELLED;
    if (!failed) this.thinned = null;
    return failed;
  }

  /** Another object is on the screen; nothing of the last one is. */
  async #switchTo(id: string, info: ObjectInfo, design: Design): Promise<void> {
    this.#shown = id;
    this.#changes(design);
    this.packing = null;
    this.gap = null;
    this.unitLater = false;
    await this.#object.loaded(info, design);
  }

  /** Says from the first moment on what is read, with a way out that ends it at once. Other long work, and the reading
   *  before, end first. */
  reading<T>(file: FileFacts, run: (reading: Reading) => Promise<T | Failure>): Promise<T | Failure> {
    this.#stopResting();
    return this.#readings.run(file, this.#long.ended, run);
  }

  /** The moment that was there before a reading which ended in nothing. */
  async #backTo(moment: Moment): Promise<void> {
    const same = this.#shown === moment.object && (!this.object || (this.packing && this.#object.isPreparedFor(moment.design)));
    if (!same) await this.#arrive(moment);
    else this.#changes(moment.design);
  }

  optimize = () => this.#long.optimize();
  fitCase = () => this.#long.fitCase();
  map = () => this.#long.map();
  measureGaps = () => this.#long.measureGaps();

  /** Runs long work of another file's with this page's progress and cancel. */
  long<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T> {
    return this.#long.run(work, run);
  }

  /** Keeps what is on the page from now on; what was there before waits. */
  keepIn = (works: Works) => this.#keeping.in(works);
  /** Brings back what this tab had before it was loaded anew. */
  restore = (works: Works) => this.#keeping.restore(works);
  resume = (id: string) => this.#keeping.resume(id);
  clear = () => this.#keeping.clear();
  saveNow = () => this.#keeping.saveNow();

  refuse(control: string, text: Pair) {
    this.problem = {control, text};
  }

  /** The library had to start anew. */
  restarted(reason: Failure) {
    this.notice = reason.error;
    if (!this.#readings.underWay) this.busy = null;
  }

  /** Another history, with its present on the screen; false, and everything as it was, where that cannot be had. */
  async #becomes(history: History<Moment>): Promise<boolean> {
    const before = this.#history;
    this.#history = history;
    if (await this.#arrive(present(history))) return true;
    this.#history = before;
    await this.#backTo(present(before));
    return false;
  }

  async #go(by: -1 | 1): Promise<void> {
    const before = this.#history;
    const history = moved(before, by);
    if (history.at === before.at) return;
    this.#history = history;
    this.#answered();
    this.#changes(present(history).design);
    // One after the other: each may have to load its object.
    const arrival = (this.#arrival = this.#arrival.then(() => this.#arrive(present(this.#history))));
    if (!(await arrival) && this.#history === history) {
      this.#history = before;
      await this.#backTo(present(before));
    }
    this.#keeping.saveSoon();
  }

  /** Shows a moment of the history, loading its object where that is another one; false where it cannot be had. */
  async #arrive({design, object}: Moment): Promise<boolean> {
    this.#stopResting();
    if (object !== this.#shown) {
      const stored = object === null ? null : this.#objects.get(object);
      if (!stored) {
        this.#showNothing(design);
        if (object !== null) this.refuse('object', files.works.objectGone);
        return true;
      }
      const failed = await this.reading({name: stored.name, bytes: stored.content.size}, async (reading) => {
        const info = await this.engine.load(stored.name, stored.content, design.object, stored.beside);
        if (reading.cancelled || isFailure(info)) return isFailure(info) ? info : CANCELLED;
        await this.#switchTo(stored.id, info, design);
        if (!reading.cancelled) await this.#pack(design);
        return reading.cancelled ? CANCELLED : null;
      });
      if (failed) this.#refuse('object', {...failed, error: about(stored.name, failed.error)});
      if (!failed) this.#rest();
      return !failed;
    }
    this.#changes(design);
    await this.#pack(design);
    this.#rest();
    return true;
  }

  #showNothing(design: Design) {
    this.#changes(design);
    this.#shown = null;
    this.#object.clear();
    this.packing = null;
    this.gap = null;
  }

  /** What the fields show from now on. */
  #changes(design: Design) {
    this.design = design;
    this.#onDesign();
    this.#keeping.note();
  }

  /** A refusal that the next good change answers. */
  #answered() {
    if (this.problem && !LASTING.includes(this.problem.control)) this.problem = null;
  }

  /** Makes the foams of a design; a good one becomes a moment of the history. */
  async #show(design: Design, control: string): Promise<Failure | null> {
    const step = this.#gestures.step(control, performance.now());
    this.#stopResting();
    const failed = await this.#pack(design);
    // A newer change is on its way, or the person went back meanwhile.
    if (failed?.kind === 'cancelled' || this.design !== design) return null;
    if (failed) {
      // What is being typed stays as it is: it may be on its way to a number that can be.
      this.design = present(this.#history).design;
      this.#keeping.note();
      const refused = this.#refuse(control, failed);
      // Prepared for a unit that has no foams, the object would stay as large as that.
      if (present(this.#history).object === this.#shown) await this.#object.prepare(this.design, this.design);
      return refused;
    }
    this.#answered();
    this.#history = record(this.#history, {design, object: this.#shown}, step);
    this.#keeping.saveSoon();
    this.#rest();
    return null;
  }

  async #pack(design: Design): Promise<Failure | null> {
    const input = performance.now();
    if (!this.object) return this.#checked(design);
    const failed = await this.#object.prepare(design, present(this.#history).design);
    if (failed) return failed;
    if (this.object.sizeProblem) {
      this.packing = null;
      this.gap = null;
      return this.#checked(design);
    }
    const packing = await this.engine.pack(design);
    if (isFailure(packing)) return packing;
    this.packing = packing;
    this.options.depend(packing.dependent);
    this.gap = null;
    this.timing = {input, answer_ms: performance.now() - input, library_ms: packing.library_ms};
    return null;
  }

  async #checked(design: Design): Promise<Failure | null> {
    const answer = await this.engine.parseProject(JSON.stringify(design));
    if (isFailure(answer)) return answer;
    this.options.depend(answer.dependent);
    return null;
  }

  #refuse(control: string, failure: Failure): Failure {
    if (failure.kind !== 'cancelled') this.problem = {control, text: failure.error};
    return failure;
  }

  #stopResting() {
    this.#resting.stop();
    if (this.busy?.work === 'gaps') void this.engine.cancel();
  }

  /** What may take its time happens when nobody changes anything. */
  #rest() {
    this.#resting.stop();
    if (!this.object || this.object.triangles > GAPS_BY_THEMSELVES) return;
    this.#resting.begin(this.measureGaps);
  }
}
