import {proxy} from 'comlink';
import type {Design} from '../design/design';
import {firstDesign} from '../design/edit';
import {failures} from '../words/failures';
import type {
  Arrangement,
  ArrangeStep,
  BesideFile,
  CaseRanking,
  DirectionMap,
  DisplayMesh,
  Engine,
  Failure,
  Loading,
  ObjectInfo,
  OnProgress,
  OutputFile,
  Packing,
  SearchResult,
  SearchStep,
  WorkshopFigures,
} from './api';
import type {ContactMap, Drops, Pressing} from './drops';
import {brokenModule, CANCELLED, failure, isFailure} from './failure';
import type {Gap} from './gap';
import {latest} from './latest';
import type {PlanWishes, Proposal} from './plan';
import {copied, loadAgain, sent, type Kept, type Objects} from './sent';
import type {CoreHandle} from './worker_link';

export interface EngineOptions {
  /** Hears that the library had to be started anew, and why; the object is loaded again by then. */
  onRestart?: (reason: Failure) => void;
  /** Called again whenever a core has ended. */
  startCore: () => CoreHandle;
}

/** Rejects where the browser cannot run the library at all. */
export async function createEngine(options: EngineOptions): Promise<Engine> {
  const engine = new PageEngine(options);
  await engine.start();
  return engine;
}

const SUPERSEDED = failure('cancelled', failures.failures.superseded);

/** Two cores: one answers while sliders move; the other, started when it is first needed, does what takes long,
 *  so that the first stays free and the second can be ended in the middle. */
class PageEngine implements Engine {
  readonly #options: EngineOptions;
  #quick: CoreHandle;
  /** Settles when #quick has its objects back after a restart. */
  #restored: Promise<void> = Promise.resolve();
  /** `ready`: it has its objects, and hears a cancel() that comes after what it was asked. */
  #slow: {handle: CoreHandle; loaded: Promise<unknown>; ready: boolean} | null = null;
  #slowWork = {gaps: 0, searches: 0, outputs: 0};
  /** How often a reading was stopped. */
  #stops = 0;
  /** As they were loaded, one after the other. */
  #kept: readonly Kept[] = [];
  #packed: {design: Design; objects: Objects} | null = null;
  /** By object, then by their most triangles. */
  #displayMeshes = new Map<string, Map<number, Promise<DisplayMesh>>>();
  #defaults: Design | null = null;

  constructor(options: EngineOptions) {
    this.#options = options;
    this.#quick = this.#options.startCore();
  }

  async start(): Promise<void> {
    this.#defaults = await this.defaultDesign();
  }

  version = () => this.#quickly((core) => core.version()).then(orThrow);
  defaultDesign = () => this.#quickly((core) => core.defaultDesign()).then(orThrow);
  presets = () => this.#quickly((core) => core.presets()).then(orThrow);
  bricks = () => this.#quickly((core) => core.bricks()).then(orThrow);
  dropChoices = () => this.#quickly((core) => core.dropChoices()).then(orThrow);
  parseFoams = (text: string) => this.#quickly((core) => core.parseFoams(text));
  parseShape = (text: string) => this.#quickly((core) => core.parseShape(text));
  options = () => this.#quickly((core) => core.options()).then(orThrow);
  samples = () => this.#quickly((core) => core.samples()).then(orThrow);
  sampleFile = (name: string) => this.#quickly((core) => core.sampleFile(name));
  parseProject = (text: string) => this.#quickly((core) => core.parseProject(text));
  packedProject = (zip: Blob) => this.#quickly((core) => core.packedProject(zip));
  projectText = (design: Design, objects?: Objects) => {
    const [plain, uses] = sent(design, objects);
    return this.#quickly((core) => core.projectText(plain, uses)).then((answer) => orThrow(answer).text);
  };

  commandLine = async (
    file: string | readonly string[],
    design: Design,
    language?: string,
    objects?: Objects,
  ): Promise<string | Failure> => {
    const [plain, uses] = sent(design, objects);
    const files = [file].flat();
    const answer = await this.#quickly((core) => core.commandLine(files, plain, language, uses));
    return isFailure(answer) ? answer : answer.text;
  };

  async load(
    name: string,
    bytes: ArrayBuffer | Blob,
    object: Design['object'],
    beside: readonly BesideFile[] = [],
    how: Loading = {},
  ): Promise<ObjectInfo | Failure> {
    const options = copied(object);
    const content = bytes instanceof Blob ? bytes : new Blob([bytes]);
    const stops = this.#stops;
    await this.#restored;
    // Stopped while it waited for its turn.
    if (stops !== this.#stops) return CANCELLED;
    const answer = await this.#quickly((core) => core.load(name, content, options, beside, how)).catch((reason: unknown) =>
      failure('input', failures.failures.unreadable(name, reason instanceof Error ? reason.message : String(reason))),
    );
    if (isFailure(answer)) return answer.kind === 'memory' ? this.#tooLarge(name, options) : answer;
    this.#endSlow();
    const {id} = answer;
    const others = how.joins ? this.#kept.filter((one) => one.id !== id) : [];
    this.#holds([...others, {id, name, content, options, beside}]);
    this.#displayMeshes.delete(id);
    return answer;
  }

  async keep(ids: readonly string[]): Promise<void> {
    const kept = this.#kept.filter(({id}) => ids.includes(id));
    if (kept.length === this.#kept.length) return;
    const plain = [...ids];
    await this.#quickly((core) => core.keep(plain));
    this.#endSlow();
    this.#holds(kept);
  }

  #holds(kept: readonly Kept[]) {
    this.#kept = kept;
    this.#packed = null;
    for (const id of [...this.#displayMeshes.keys()])
      if (!kept.some((one) => one.id === id)) this.#displayMeshes.delete(id);
  }

  async reprepare(design: Design, id?: string): Promise<ObjectInfo | Failure> {
    const plain = copied(design);
    const answer = await this.#quickly((core) => core.reprepare(plain, id));
    if (!isFailure(answer)) this.#usesOptions(answer.id, plain.object);
    return answer;
  }

  displayMesh(mostTriangles: number, id = this.#kept.at(-1)?.id ?? ''): Promise<DisplayMesh> {
    const copies = this.#displayMeshes.get(id) ?? new Map<number, Promise<DisplayMesh>>();
    this.#displayMeshes.set(id, copies);
    const cached = copies.get(mostTriangles);
    if (cached) return cached;
    const made = this.#quickly((core) => core.displayMesh(mostTriangles, id)).then(orThrow);
    copies.set(mostTriangles, made);
    made.catch(() => copies.delete(mostTriangles));
    return made;
  }

  pack = (design: Design, objects?: Objects) => this.#packLatest(...sent(design, objects));

  #packLatest = latest(
    async (design: Design, objects: Objects): Promise<Packing | Failure> => {
      const answer = await this.#quickly((core) => core.pack(design, objects));
      if (isFailure(answer)) return answer;
      this.#packed = {design, objects};
      const last = this.#kept.at(-1);
      for (const {id, own} of objects ?? (last ? [{id: last.id, own: null}] : []))
        this.#usesOptions(id, own ?? design.object);
      return answer;
    },
    (): Packing | Failure => SUPERSEDED,
  );

  async gaps(onProgress?: OnProgress): Promise<Gap | Failure> {
    if (this.#slowWork.gaps > 0) this.#endSlow(SUPERSEDED);
    const packed = this.#packed;
    if (!packed) return this.#quickly((core) => core.gaps());
    return this.#slowly('gaps', async (core) => {
      const packing = await core.pack(packed.design, packed.objects);
      if (isFailure(packing)) return packing;
      return core.gaps(onProgress && proxy(onProgress));
    });
  }

  zones = () => this.#quickly((core) => core.zones());

  async distances(points: Float32Array<ArrayBuffer>): Promise<Float32Array<ArrayBuffer> | Failure> {
    const packed = this.#packed;
    if (!packed) return this.#quickly((core) => core.distances(points));
    return this.#slowly('gaps', async (core) => {
      const packing = await core.pack(packed.design, packed.objects);
      return isFailure(packing) ? packing : core.distances(points);
    });
  }

  async search(
    design: Design,
    onStep: (step: SearchStep) => void,
    objects?: Objects,
  ): Promise<SearchResult | Failure> {
    let last: SearchStep | null = null;
    const listen = (step: SearchStep) => {
      last = step;
      onStep(step);
    };
    const [plain, uses] = sent(design, objects);
    const answer = await this.#slowly('searches', (core) => core.search(plain, proxy(listen), uses));
    const best = last as SearchStep | null;
    return isFailure(answer) && answer.kind === 'cancelled' && best ? {...best, distinct: []} : answer;
  }

  arrange(design: Design, onStep: (step: ArrangeStep) => void, objects?: Objects): Promise<Arrangement | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#arranging(onStep, (core, listen) => core.arrange(plain, listen, uses));
  }

  fill(
    design: Design,
    item: number,
    onStep: (step: ArrangeStep) => void,
    objects?: Objects,
  ): Promise<Arrangement | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#arranging(onStep, (core, listen) => core.fill(plain, item, listen, uses));
  }

  /** Cancelled, the last better design is what it comes to. */
  async #arranging(
    onStep: (step: ArrangeStep) => void,
    run: (core: CoreHandle['core'], listen: (step: ArrangeStep) => void) => Promise<Arrangement | Failure>,
  ): Promise<Arrangement | Failure> {
    let last: Design | null = null;
    const listen = (step: ArrangeStep) => {
      last = step.better ?? last;
      onStep(step);
    };
    const answer = await this.#slowly('outputs', (core) => run(core, proxy(listen)));
    const best = last as Design | null;
    if (!isFailure(answer) || answer.kind !== 'cancelled' || !best) return answer;
    return {design: best, choices: []};
  }

  directions(
    design: Design,
    onStep: (map: DirectionMap) => void,
    objects?: Objects,
  ): Promise<DirectionMap | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#slowly('searches', (core) => core.directions(plain, proxy(onStep), uses));
  }

  fitCase(design: Design, onProgress?: OnProgress, objects?: Objects): Promise<{design: Design} | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#slowly('outputs', (core) => core.fitCase(plain, onProgress && proxy(onProgress), uses));
  }

  drops = (): Promise<Drops | Failure> => this.#quickly((core) => core.drops());
  contacts = latest(
    (pressing: Pressing): Promise<ContactMap | Failure> => this.#quickly((core) => core.contacts(pressing)),
    (): ContactMap | Failure => SUPERSEDED,
  );

  protectingWalls(design: Design, onProgress?: OnProgress, objects?: Objects): Promise<{design: Design} | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#slowly('outputs', (core) => core.protectingWalls(plain, onProgress && proxy(onProgress), uses));
  }

  plan(
    design: Design,
    wishes: PlanWishes,
    language: string,
    onProgress?: OnProgress,
    objects?: Objects,
  ): Promise<Proposal[] | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#slowly('outputs', (core) => core.plan(plain, wishes, language, onProgress && proxy(onProgress), uses));
  }

  rankCases(design: Design, objects?: Objects): Promise<CaseRanking | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#quickly((core) => core.rankCases(plain, uses));
  }

  workshopFigures(design: Design, objects?: Objects): Promise<WorkshopFigures | Failure> {
    const [plain, uses] = sent(design, objects);
    return this.#slowly('outputs', (core) => core.workshopFigures(plain, uses));
  }

  outputFiles(
    design: Design,
    language?: string,
    onProgress?: OnProgress,
    objects?: Objects,
  ): Promise<OutputFile[] | Failure> {
    const [plain, uses] = sent(design, objects);
    const told = onProgress && proxy(onProgress);
    return this.#slowly('outputs', (core) => core.outputFiles(plain, language, told, uses));
  }

  async cancel(): Promise<void> {
    const {gaps, searches, outputs} = this.#slowWork;
    // A search listens between its steps, once it has begun; the others have no ear until they are done.
    if (gaps + outputs > 0 || (searches > 0 && !this.#slow?.ready)) this.#endSlow();
    else if (searches > 0) await this.#slow?.handle.core.cancel();
  }

  async stopReading(): Promise<void> {
    this.#stops++;
    this.#restart(CANCELLED);
    await this.#restored;
  }

  async #tooLarge(name: string, object: Design['object']): Promise<Failure> {
    const line = this.#defaults && (await this.commandLine(name, firstDesign(this.#defaults, object)));
    return failure('memory', failures.failures.tooLarge(name, line === null || isFailure(line) ? 'snug make' : line));
  }

  #usesOptions(id: string, options: Design['object']) {
    const before = this.#kept.find((one) => one.id === id);
    if (!before || JSON.stringify(before.options) === JSON.stringify(options)) return;
    this.#kept = this.#kept.map((one) => (one === before ? {...one, options} : one));
    this.#displayMeshes.delete(id);
  }

  async #quickly<T>(ask: (core: CoreHandle['core']) => Promise<T | Failure>): Promise<T | Failure> {
    await this.#restored;
    const handle = this.#quick;
    const answer = await Promise.race([ask(handle.core), handle.stopped]);
    if (isFailure(answer) && answer.kind === 'memory') {
      if (handle === this.#quick) this.#restart(answer);
      await this.#restored;
    }
    // What it answered with its last breath belongs to a core that is gone.
    return handle === this.#quick ? answer : handle.stopped;
  }

  #restart(reason: Failure) {
    this.#quick.end(reason);
    this.#endSlow(reason);
    this.#quick = this.#options.startCore();
    const kept = this.#kept;
    const handle = this.#quick;
    const {core, stopped} = handle;
    const reload = kept.length > 0 ? loadAgain(core, kept) : core.version();
    this.#restored = Promise.race([reload, stopped])
      .catch(brokenModule)
      .then((answer) => {
        if (handle !== this.#quick) return; // ended in its turn: the next one tells
        // The objects alone are too much now; they stay with the page, which may save them.
        if (isFailure(answer)) this.#kept = [];
        if (isFailure(answer)) this.#options.onRestart?.(answer);
        else if (reason.kind !== 'cancelled') this.#options.onRestart?.(reason);
      });
  }

  async #slowly<T>(
    kind: 'gaps' | 'searches' | 'outputs',
    ask: (core: CoreHandle['core']) => Promise<T | Failure>,
  ): Promise<T | Failure> {
    const slow = (this.#slow ??= this.#startSlow());
    const {handle, loaded} = slow;
    this.#slowWork[kind]++;
    const work = loaded.then((answer) => {
      slow.ready = true;
      return isFailure(answer) ? answer : ask(handle.core);
    });
    const answer = await Promise.race([work, handle.stopped]);
    if (handle !== this.#slow?.handle) return answer;
    this.#slowWork[kind]--;
    if (isFailure(answer) && answer.kind === 'memory') this.#endSlow(answer);
    return answer;
  }

  #startSlow() {
    const handle = this.#options.startCore();
    const loaded = loadAgain(handle.core, this.#kept);
    this.#slowWork = {gaps: 0, searches: 0, outputs: 0};
    return {handle, loaded, ready: false};
  }

  #endSlow(answer: Failure = CANCELLED) {
    this.#slow?.handle.end(answer);
    this.#slow = null;
    this.#slowWork = {gaps: 0, searches: 0, outputs: 0};
  }
}

function orThrow<T>(answer: T | Failure): T {
  if (isFailure(answer)) throw new Error(answer.error[0]);
  return answer;
}
