import type {BrickRange, Design, Preset, Triple} from '../design/design';
import {firstDesign} from '../design/edit';
import {beforeCentring, centring, focused, idsOf, momentOf, unfocused, type Moment} from '../design/moment';
import {canRedo, canUndo, Gestures, moved, present, record, startHistory, type History} from '../design/history';
import type {Engine, Failure, Finding, ObjectInfo, PackedItem, Packing, Project} from '../engine/api';
import type {Gap} from '../engine/gap';
import {isFailure} from '../engine/failure';
import {files} from '../words/files';
import type {Pair} from '../words/words';
import {Arrangements} from './arrangements.svelte';
import type {StoredObject} from './autosave';
import {commanded, type Commanded} from './commanded';
import {DropsOnScreen} from './drops.svelte';
import {factsOf, type Facts} from './facts';
import {gravestFirst} from './findings';
import {Keeping} from './keeping.svelte';
import {LongWork} from './long_work';
import type {Busy, DisplayMeshes, FileFacts, Given, PlacedItem, Problem, Reading, Timing, Work} from './on_the_page';
import {ObjectsOnScreen} from './objects_on_screen.svelte';
import {Opening} from './opening';
import {Options} from './options.svelte';
import {Placements} from './placements.svelte';
import {Readings} from './readings';
import {Rest} from './rest.svelte';
import type {Works} from './works.svelte';
import {ZonesOnScreen} from './zones_on_screen.svelte';

/** Refusals that no later change of a control answers: they stay until they are read. */
const LASTING: readonly string[] = ['object', 'project', 'make', 'number'];

/** The work on the page: objects, one design, and what the library makes of them. */
export class Studio {
  readonly engine: Engine;
  readonly defaults: Design;
  readonly presets: Preset[];
  readonly bricks: BrickRange;
  readonly options: Options;
  readonly samples: string[];
  readonly version: string;

  /** What the controls show, of all items. */
  moment: Moment = $state.raw(momentOf({} as Design, null));
  #selected = $state(0);
  /** Which item is selected, by its number. */
  selected = $derived(Math.max(0, Math.min(this.#selected, (this.moment.design.items?.length ?? 1) - 1)));
  readonly #shown: ObjectsOnScreen;
  readonly #onDesign: () => void;
  /** The last good one. */
  packing: Packing | null = $state.raw(null);
  /** How far the last packing shifted all items so that its space is centred, and where they lie before that. */
  centred: Triple = $state.raw([0, 0, 0]);
  #lying: readonly PackedItem[] = $state.raw([]);
  /** None while it is not known. */
  lying = $derived(this.packing && this.#lying.length === this.moment.design.items?.length ? this.#lying : []);
  /** As it is for the item that is selected. */
  design: Design = $derived(focused(this.moment, this.selected, this.lying));
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
  #history: History<Moment> = $state.raw(startHistory(momentOf({} as Design, null)));
  /** An object has no size before its unit is known, and no foams. */
  get asksForUnit(): boolean {
    return this.#shown.asksForUnit;
  }
  readonly #gestures = new Gestures();
  /** The person closed that question for now. */
  unitLater = $state(false);
  /** What the way of working adds; null while it is being looked at. */
  workshopFindings: readonly Finding[] | null = $state.raw([]);
  readonly drops: DropsOnScreen;
  readonly zones = new ZonesOnScreen(this);
  /** All that is known to say about the foams, the worst first. */
  findings = $derived.by(() => gravestFirst([...(this.gap ?? this.packing)?.findings ?? [], ...this.drops.findings, ...this.drops.fitting, ...this.zones.findings, ...(this.workshopFindings ?? [])]));
  canUndo = $derived(canUndo(this.#history));
  canRedo = $derived(canRedo(this.#history));

  /** The works of this browser; null while there are none to be had. */
  works: Works | null = $state.raw(null);
  #objects = new Map<string, StoredObject>();
  readonly #resting = new Rest();
  #arrival: Promise<boolean> = Promise.resolve(true);
  readonly #readings = new Readings(this);
  readonly #keeping = new Keeping(this, this.#objects, {
    history: () => this.#history,
    becomes: (history) => this.#becomes(history),
    checked: (design) => this.#checked(design),
  });
  readonly #opening = new Opening(this, this.#objects, {
    present: () => present(this.#history),
    switchTo: (moment, infos) => this.#switchTo(moment, infos),
    show: (moment) => this.#show(moment, ''),
    pack: (moment) => this.#pack(moment),
    backTo: (moment) => this.#backTo(moment),
    refuse: (failed) => this.#refuse('object', failed),
  });
  readonly #long = new LongWork(this, {
    changes: (design) => this.#changes({...this.moment, design}),
    show: (control) => this.#show(this.moment, control),
    pack: (design) => this.#pack({...this.moment, design}),
    refuse: (control, failed) => this.#refuse(control, failed),
    stopResting: () => this.#stopResting(),
  });
  readonly arrangements = new Arrangements(this, this.#long);

  private constructor(engine: Engine, facts: Facts, onDesign: () => void) {
    this.engine = engine;
    this.#onDesign = onDesign;
    this.#shown = new ObjectsOnScreen(engine);
    this.defaults = facts.defaults;
    this.presets = facts.presets;
    this.bricks = facts.bricks;
    this.options = new Options(facts, () => this.design);
    this.drops = new DropsOnScreen(this, facts.drops);
    this.samples = facts.samples;
    this.version = facts.version;
    this.moment = momentOf(firstDesign(facts.defaults), null);
    this.#history = startHistory(this.moment);
  }

  /** `onDesign` hears of every change of the design while it is made. */
  static async start(engine: Engine, onDesign = () => {}): Promise<Studio> {
    const studio = new Studio(engine, await factsOf(engine), onDesign);
    await studio.#checked(studio.moment.design);
    return studio;
  }

  /** Which objects are on the screen; empty where there is none. */
  get shown(): string {
    return this.#shown.ids;
  }

  get #selectedObject(): number {
    return this.moment.design.items[this.selected]?.object ?? 0;
  }

  /** The object of the item that is selected. */
  get object(): ObjectInfo | null {
    return this.#shown.at(this.#selectedObject)?.info ?? null;
  }

  get meshes(): DisplayMeshes | null {
    return this.#shown.at(this.#selectedObject)?.meshes ?? null;
  }

  /** Of each object, as the moment numbers them. */
  get objects(): readonly ObjectInfo[] {
    return this.#shown.infos;
  }

  /** The items, each where it lies in the last packing; without one the selected one, as it stands in its file. */
  get placed(): readonly PlacedItem[] {
    return this.packing ? this.#shown.placedAs(this.packing) : this.#shown.unplaced(this.#selectedObject);
  }

  /** The objects' files. */
  get files(): readonly StoredObject[] {
    return this.moment.objects.flatMap(({id}) => this.#objects.get(id) ?? []);
  }

  select(item: number): void {
    this.#selected = item;
  }

  /** The gaps of these foams will be known. */
  get gapComes(): boolean {
    return this.#resting.comes || this.busy?.work === 'gaps';
  }

  /** What the command line is to make: of a thinned object its original. */
  get commanded(): Commanded | null {
    if (this.#shown.none) return null;
    const wanted = commanded(this.moment, this.objects);
    return this.thinned ? {...wanted, files: [this.thinned.name]} : wanted;
  }

  /** A change by `control`, of the design as it is for the selected item. Refused, everything stays as it was. */
  change(edit: (design: Design) => Design, control: string): void {
    this.becomes(unfocused(this.moment, this.selected, edit(this.design), this.lying), control);
  }

  /** A change of anything, with the same objects or fewer. */
  becomes(next: Moment, control: string): void {
    if (JSON.stringify(next) === JSON.stringify(this.moment)) return;
    const haveBack = this.#shown.leave(next);
    this.#changes(next);
    void this.#show(next, control).then((failed) => {
      if (failed && idsOf(this.moment) !== this.shown) haveBack();
    });
  }

  undo = () => this.#go(-1);
  redo = () => this.#go(1);

  /** Puts a file's content on the screen. `source` may make it first; `joins`: beside what is there.
   *  Null where it worked; refused or cancelled, everything is as it was. */
  openObject = (...how: Parameters<Opening['object']>) => this.#opening.object(...how);

  /** Puts several files on the screen, in place of what is there or beside it. As openObject(). */
  openItems = (files: readonly Given[], joins: boolean) => this.#opening.items(files, joins);
  /** A project with its objects' files, one for each. As openObject(). */
  openProject = (project: Project, files: readonly Given[]) => this.#opening.project(project, files);

  /** Other objects are on the screen. `infos`: of those that were just loaded. */
  async #switchTo(moment: Moment, infos: readonly ObjectInfo[]): Promise<void> {
    this.#changes(moment);
    this.packing = null;
    this.gap = null;
    this.unitLater = false;
    await this.#shown.become(moment, infos);
  }

  /** Says from the first moment on what is read, with a way out; other long work, and the reading before, end first. */
  reading<T>(file: FileFacts, run: (reading: Reading) => Promise<T | Failure>): Promise<T | Failure> {
    this.#stopResting();
    return this.#readings.run(file, this.#long.ended, run);
  }

  /** The moment that was there before a reading which ended in nothing. */
  async #backTo(moment: Moment): Promise<void> {
    const prepared = this.#shown.none || (this.packing && this.#shown.arePreparedFor(moment));
    if (this.shown !== idsOf(moment) || !prepared) return void (await this.#arrive(moment));
    this.#changes(moment);
    await this.#shown.keep(moment);
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
    this.#changes(present(history));
    // One after the other: each may have to load its object.
    const arrival = (this.#arrival = this.#arrival.then(() => this.#arrive(present(this.#history))));
    if (!(await arrival) && this.#history === history) {
      this.#history = before;
      await this.#backTo(present(before));
    }
    this.#keeping.saveSoon();
  }

  /** Shows a moment of the history, loading objects that are not there; false where one cannot be had. */
  async #arrive(moment: Moment): Promise<boolean> {
    this.#stopResting();
    if (idsOf(moment) !== this.shown) {
      const there = (id: string) => this.objects.some((object) => object.id === id);
      const missing = moment.objects.filter(({id}) => !there(id)).map(({id}) => this.#objects.get(id));
      if (moment.objects.length === 0 || missing.includes(undefined)) {
        this.#showNothing(moment);
        if (moment.objects.length > 0) this.refuse('object', files.works.objectGone);
        return true;
      }
      const failed = await this.#opening.again(moment, missing as StoredObject[]);
      if (!failed) this.#rest();
      return !failed;
    }
    this.#changes(moment);
    await this.#pack(moment);
    this.#rest();
    return true;
  }

  #showNothing(moment: Moment) {
    this.#changes(moment);
    this.#shown.clear();
    this.packing = null;
    this.gap = null;
  }

  /** What the fields show from now on. */
  #changes(moment: Moment) {
    this.moment = moment;
    this.#onDesign();
    this.#keeping.note();
  }

  /** A refusal that the next good change answers. */
  #answered() {
    if (this.problem && !LASTING.includes(this.problem.control)) this.problem = null;
  }

  /** Makes the foams of a moment; a good one becomes a part of the history. */
  async #show(moment: Moment, control: string): Promise<Failure | null> {
    const step = this.#gestures.step(control, performance.now());
    this.#stopResting();
    const failed = await this.#pack(moment);
    // A newer change is on its way, or the person went back meanwhile.
    if (failed?.kind === 'cancelled' || this.moment !== moment) return null;
    if (failed) {
      // What is being typed stays as it is: it may be on its way to a number that can be.
      const before = present(this.#history);
      const same = idsOf(before) === this.shown;
      if (same || before.objects.length > 0) this.moment = before;
      this.#keeping.note();
      const refused = this.#refuse(control, failed);
      // Prepared for a unit that has no foams, the object would stay as large as that.
      if (same) await this.#shown.prepare(before, before);
      return refused;
    }
    this.#answered();
    this.#history = record(this.#history, moment, step);
    this.#keeping.saveSoon();
    this.#rest();
    return null;
  }

  async #pack(moment: Moment): Promise<Failure | null> {
    const input = performance.now();
    const {design, objects} = moment;
    if (this.#shown.none) return this.#checked(design);
    const failed = await this.#shown.prepare(moment, present(this.#history));
    if (failed) return failed;
    if (this.asksForUnit) {
      // The question is of the object that is selected.
      const asks = (object: number) => this.objects[object]?.sizeProblem != null;
      if (!asks(this.#selectedObject)) this.#selected = design.items.findIndex(({object}) => asks(object));
      this.packing = null;
      this.gap = null;
      return this.#checked(design);
    }
    const arePacked = this.#shown.packing();
    const packing = await this.engine.pack(design, objects);
    if (isFailure(packing)) return packing;
    arePacked();
    this.centred = centring(moment, packing.items);
    this.#lying = beforeCentring(packing.items, this.centred);
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
    this.#resting.begin(this.objects, this.measureGaps);
  }
}
