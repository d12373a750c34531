import {proxy} from 'comlink';
import type {Design} from '../design/design';
import {firstDesign} from '../design/edit';
import {failures} from '../words/failures';
import type {
  BesideFile,
  CaseRanking,
  DirectionMap,
  DisplayMesh,
  Engine,
  Failure,
  Gap,
  ObjectInfo,
  OnProgress,
  OutputFile,
  Packing,
  SearchResult,
  SearchStep,
  WorkshopFigures,
} from './api';
import {brokenModule, CANCELLED, failure, isFailure} from './failure';
import {latest} from './latest';
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

interface Kept {
  name: string;
  content: Blob;
  options: Design['object'];
  beside: readonly BesideFile[];
}

/** Two cores: one answers while sliders move; the other, started when it is first needed, does what takes long,
 *  so that the first stays free and the second can be ended in the middle. */
class PageEngine implements Engine {
  readonly #options: EngineOptions;
  #quick: CoreHandle;
  /** Settles when #quick has its object back after a restart. */
  #restored: Promise<void> = Promise.resolve();
  /** `ready`: it has its object, and hears a cancel() that comes after what it was asked. */
  #slow: {handle: CoreHandle; loaded: Promise<ObjectInfo | Failure | null>; ready: boolean} | null = null;
  #slowWork = {gaps: 0, searches: 0, outputs: 0};
  /** How often a reading was stopped. */
  #stops = 0;
  /** What a new core needs. A Blob lies outside the page's memory. */
  #object: Kept | null = null;
  #packed: Design | null = null;
  #displayMeshes = new Map<number, Promise<DisplayMesh>>();
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
  options = () => this.#quickly((core) => core.options()).then(orThrow);
  samples = () => this.#quickly((core) => core.samples()).then(orThrow);
  sampleFile = (name: string) => this.#quickly((core) => core.sampleFile(name));
  parseProject = (text: string) => this.#quickly((core) => core.parseProject(text));
  projectText = (design: Design) => {
    const plain = copied(design);
    return this.#quickly((core) => core.projectText(plain)).then((answer) => orThrow(answer).text);
  };

  commandLine = async (file: string, design: Design, language?: string): Promise<string | Failure> => {
    const plain = copied(design);
    const answer = await this.#quickly((core) => core.commandLine(file, plain, language));
    return isFailure(answer) ? answer : answer.text;
  };

  async load(
    name: string,
    bytes: ArrayBuffer | Blob,
    object: Design['object'],
    beside: readonly BesideFile[] = [],
  ): Promise<ObjectInfo | Failure> {
    const options = copied(object);
    const content = bytes instanceof Blob ? bytes : new Blob([bytes]);
    const stops = this.#stops;
    await this.#restored;
    // Stopped while it waited for its turn.
    if (stops !== this.#stops) return CANCELLED;
    const answer = await this.#quickly((core) => core.load(name, content, options, beside)).catch((reason: unknown) =>
      failure('input', failures.failures.unreadable(name, reason instanceof Error ? reason.message : String(reason))),
    );
    if (isFailure(answer)) return answer.kind === 'memory' ? this.#tooLarge(name, options) : answer;
    this.#endSlow();
    this.#object = {name, content, options, beside};
    this.#packed = null;
    this.#displayMeshes.clear();
    return answer;
  }

  async reprepare(design: Design): Promise<ObjectInfo | Failure> {
    const plain = copied(design);
    const answer = await this.#quickly((core) => core.reprepare(plain));
    if (!isFailure(answer)) this.#usesOptions(plain.object);
    return answer;
  }

  displayMesh(mostTriangles: number): Promise<DisplayMesh> {
    const cached = this.#displayMeshes.get(mostTriangles);
    if (cached) return cached;
    const made = this.#quickly((core) => core.displayMesh(mostTriangles)).then(orThrow);
    this.#displayMeshes.set(mostTriangles, made);
    made.catch(() => this.#displayMeshes.delete(mostTriangles));
    return made;
  }

  pack = (design: Design) => this.#packLatest(copied(design));

  #packLatest = latest(
    async (design: Design): Promise<Packing | Failure> => {
      const answer = await this.#quickly((core) => core.pack(design));
      if (isFailure(answer)) return answer;
      this.#packed = design;
      this.#usesOptions(design.object);
      return answer;
    },
    (): Packing | Failure => SUPERSEDED,
  );

  async gaps(onProgress?: OnProgress): Promise<Gap | Failure> {
    if (this.#slowWork.gaps > 0) this.#endSlow(SUPERSEDED);
    const design = this.#packed;
    if (!design) return this.#quickly((core) => core.gaps());
    return this.#slowly('gaps', async (core) => {
      const packing = await core.pack(design);
      if (isFailure(packing)) return packing;
      return core.gaps(onProgress && proxy(onProgress));
    });
  }

  async distances(points: Float32Array<ArrayBuffer>): Promise<Float32Array<ArrayBuffer> | Failure> {
    const design = this.#packed;
    if (!design) return this.#quickly((core) => core.distances(points));
    return this.#slowly('gaps', async (core) => {
      const packing = await core.pack(design);
      return isFailure(packing) ? packing : core.distances(points);
    });
  }

  async search(design: Design, onStep: (step: SearchStep) => void): Promise<SearchResult | Failure> {
    let last: SearchStep | null = null;
    const listen = (step: SearchStep) => {
      last = step;
      onStep(step);
    };
    const plain = copied(design);
    const answer = await this.#slowly('searches', (core) => core.search(plain, proxy(listen)));
    const best = last as SearchStep | null;
    return isFailure(answer) && answer.kind === 'cancelled' && best ? {...best, distinct: []} : answer;
  }

  directions(design: Design, onStep: (map: DirectionMap) => void): Promise<DirectionMap | Failure> {
    const plain = copied(design);
    return this.#slowly('searches', (core) => core.directions(plain, proxy(onStep)));
  }

  fitCase(design: Design, onProgress?: OnProgress): Promise<{design: Design} | Failure> {
    const plain = copied(design);
    return this.#slowly('outputs', (core) => core.fitCase(plain, onProgress && proxy(onProgress)));
  }

  rankCases(design: Design): Promise<CaseRanking | Failure> {
    const plain = copied(design);
    return this.#quickly((core) => core.rankCases(plain));
  }

  workshopFigures(design: Design): Promise<WorkshopFigures | Failure> {
    const plain = copied(design);
    return this.#slowly('outputs', (core) => core.workshopFigures(plain));
  }

  outputFiles(design: Design, language?: string, onProgress?: OnProgress): Promise<OutputFile[] | Failure> {
    const plain = copied(design);
    return this.#slowly('outputs', (core) => core.outputFiles(plain, language, onProgress && proxy(onProgress)));
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

  #usesOptions(options: Design['object']) {
    if (!this.#object || JSON.stringify(this.#object.options) === JSON.stringify(options)) return;
    this.#object = {...this.#object, options};
    this.#displayMeshes.clear();
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
    const object = this.#object;
    const handle = this.#quick;
    const {core, stopped} = handle;
    const reload = object ? loadAgain(core, object) : core.version();
    this.#restored = Promise.race([reload, stopped])
      .catch(brokenModule)
      .then((answer) => {
        if (handle !== this.#quick) return; // ended in its turn: the next one tells
        // The object alone is too much now; it stays with the page, which may save it.
        if (isFailure(answer)) this.#object = null;
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
    const object = this.#object;
    const loaded = object ? loadAgain(handle.core, object) : Promise.resolve(null);
    this.#slowWork = {gaps: 0, searches: 0, outputs: 0};
    return {handle, loaded, ready: false};
  }

  #endSlow(answer: Failure = CANCELLED) {
    this.#slow?.handle.end(answer);
    this.#slow = null;
    this.#slowWork = {gaps: 0, searches: 0, outputs: 0};
  }
}

function loadAgain(core: CoreHandle['core'], {name, content, options, beside}: Kept) {
  return core.load(name, content, options, beside);
}

/** As it is now, and as a plain value: a page's reactive state cannot be sent to a worker. */
function copied<T>(value: T): T {
  return JSON.parse(JSON.stringify(value)) as T;
}

function orThrow<T>(answer: T | Failure): T {
  if (isFailure(answer)) throw new Error(answer.error[0]);
  return answer;
}
