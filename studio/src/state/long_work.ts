import type {Design} from '../design/design';
import {withPlacement, withSpace} from '../design/edit';
import type {Arrangement, ArrangeStep, DirectionMap, Failure} from '../engine/api';
import {isFailure} from '../engine/failure';
import type {Work} from './on_the_page';
import type {Studio} from './studio.svelte';

/** What the studio does with what was found. */
interface Parts {
  changes(design: Design): void;
  /** What it changed to last. */
  show(control: string): Promise<Failure | null>;
  pack(design: Design): Promise<Failure | null>;
  refuse(control: string, failed: Failure): Failure;
  stopResting(): void;
}

/** Searches, maps, gaps and files: what takes its time, with progress and cancel. */
export class LongWork {
  readonly #studio: Studio;
  readonly #parts: Parts;
  #ended: Promise<void> = Promise.resolve();

  constructor(studio: Studio, parts: Parts) {
    this.#studio = studio;
    this.#parts = parts;
  }

  /** Settles when the last long work has ended. */
  get ended(): Promise<void> {
    return this.#ended;
  }

  /** Looks for the placement that cuts the least foam away, and shows the best so far on the way. */
  optimize(): Promise<void> {
    this.#ended = this.#search();
    return this.#ended;
  }

  /** The fewest blocks that hold the object and its walls, and the placement for them. */
  fitCase(): Promise<void> {
    this.#ended = this.#fitCase();
    return this.#ended;
  }

  async #fitCase(): Promise<void> {
    const {design: start, objects} = this.#studio.moment;
    const fitted = await this.#long('search', (onProgress) => this.#studio.engine.fitCase(start, onProgress, objects));
    if (isFailure(fitted)) {
      this.#parts.refuse('optimize', fitted);
      return;
    }
    this.#parts.changes(fitted.design);
    await this.#parts.show('optimize');
  }

  /** Colours all directions by what they cut, better and better. */
  map(): Promise<void> {
    this.#ended = this.#map();
    return this.#ended;
  }

  async #map(): Promise<void> {
    const {design, objects} = this.#studio.moment;
    this.#parts.stopResting();
    let running = true;
    let stop = () => {};
    const cancelled = new Promise<null>((resolve) => (stop = () => resolve(null)));
    const cancel = () => {
      void this.#studio.engine.cancel();
      stop();
    };
    this.#studio.busy = {work: 'map', fraction: 0, cancel};
    const grown = (map: DirectionMap) => {
      if (!running) return;
      if (this.#studio.busy?.work === 'map') this.#studio.busy = {...this.#studio.busy, fraction: map.fraction};
      this.#studio.placements.foundMap(design, map);
    };
    // What was found so far is on the page: nobody waits for the step that is under way.
    const map = await Promise.race([this.#studio.engine.directions(design, grown, objects), cancelled]);
    this.#studio.busy = null;
    if (isFailure(map)) this.#parts.refuse('optimize', map);
    else if (map) grown(map);
    running = false;
  }

  async #search(): Promise<void> {
    const {design: start, objects} = this.#studio.moment;
    this.#parts.stopResting();
    this.#studio.busy = {work: 'search', fraction: 0, cancel: () => void this.#studio.engine.cancel()};
    const blocks = this.#studio.packing?.blocks ?? start.space.blocks;
    let shown = '';
    const best = await this.#studio.engine.search(start, (step) => {
      if (this.#studio.busy?.work !== 'search') return;
      this.#studio.busy = {...this.#studio.busy, fraction: step.fraction};
      const next = withSpace(withPlacement(start, step), blocks);
      if (JSON.stringify(next.placement) === shown) return;
      shown = JSON.stringify(next.placement);
      this.#parts.changes(next);
      void this.#parts.pack(next);
    }, objects);
    this.#studio.busy = null;
    if (isFailure(best)) {
      this.#parts.changes(start);
      this.#parts.refuse('optimize', best);
    } else {
      this.#parts.changes(await this.#studio.placements.asFound(withPlacement(start, best), best.cut_blocks, blocks));
      this.#studio.placements.foundDistinct(start, blocks, best.distinct);
    }
    await this.#parts.show('optimize');
  }

  /** Arranges what lies in the case, with the best so far on the screen. `settle`: what becomes of what was found. */
  arrange(
    run: (onStep: (step: ArrangeStep) => void) => Promise<Arrangement | Failure>,
    settle: (found: Arrangement) => Design,
  ): Promise<void> {
    this.#ended = this.#arrange(run, settle);
    return this.#ended;
  }

  async #arrange(...[run, settle]: Parameters<LongWork['arrange']>): Promise<void> {
    const {design: start} = this.#studio.moment;
    const found = await this.#long('arrange', (onProgress) =>
      run(({fraction, better}) => {
        if (this.#studio.busy?.work !== 'arrange') return;
        onProgress(fraction);
        if (!better) return;
        this.#parts.changes(better);
        void this.#parts.pack(better);
      }),
    );
    this.#parts.changes(isFailure(found) ? start : settle(found));
    const failed = await this.#parts.show('arrange');
    if (isFailure(found) && !failed) this.#parts.refuse('arrange', found);
  }

  async measureGaps(): Promise<void> {
    if (!this.#studio.packing?.fit || this.#studio.busy) return;
    const packing = this.#studio.packing;
    this.#studio.busy = {work: 'gaps', fraction: 0, cancel: () => void this.#studio.engine.cancel()};
    const gap = await this.#studio.engine.gaps((fraction) => {
      if (this.#studio.busy?.work === 'gaps') this.#studio.busy = {...this.#studio.busy, fraction};
    });
    if (this.#studio.busy?.work === 'gaps') this.#studio.busy = null;
    if (!isFailure(gap) && packing === this.#studio.packing) this.#studio.gap = gap;
    else if (isFailure(gap) && gap.kind !== 'cancelled') this.#parts.refuse('check', gap);
  }

  /** Runs other long work with the page's progress and cancel. */
  run<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T> {
    const answer = this.#long(work, run);
    this.#ended = answer.then(() => {});
    return answer;
  }

  async #long<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T> {
    this.#parts.stopResting();
    this.#studio.busy = {work, fraction: 0, cancel: () => void this.#studio.engine.cancel()};
    const answer = await run((fraction) => {
      if (this.#studio.busy?.work === work) this.#studio.busy = {...this.#studio.busy, fraction};
    });
    this.#studio.busy = null;
    return answer;
  }
}
