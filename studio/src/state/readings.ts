import type {Engine, Failure} from '../engine/api';
import {CANCELLED} from '../engine/failure';
import type {Busy, FileFacts, Problem, Reading} from './on_the_page';

/** Where a reading is shown. */
interface Page {
  readonly engine: Pick<Engine, 'cancel' | 'stopReading'>;
  busy: Busy | null;
  problem: Problem | null;
}

/** Readings of files, one after the other. */
export class Readings {
  readonly #page: Page;
  #now: Reading | null = null;

  constructor(page: Page) {
    this.#page = page;
  }

  get underWay(): boolean {
    return this.#now !== null;
  }

  /** Says from the first moment on what is read, with a way out that ends it at once. The reading before, and `work`,
   *  end first. */
  async run<T>(file: FileFacts, work: Promise<void>, run: (reading: Reading) => Promise<T | Failure>): Promise<T | Failure> {
    const page = this.#page;
    this.#now?.cancel();
    // A search or an export of the last object ends, too, and leaves the design alone.
    if (page.busy) void page.engine.cancel();
    const before = [this.#now?.ended, work];
    let stop: (answer: Failure) => void = () => {};
    let end = () => {};
    const cancelled = new Promise<Failure>((resolve) => (stop = resolve));
    const cancel = () => {
      if (reading.cancelled) return;
      reading.cancelled = true;
      void page.engine.stopReading();
      stop(CANCELLED);
    };
    const reading: Reading = {cancelled: false, cancel, ended: new Promise((resolve) => (end = resolve))};
    this.#now = reading;
    const busy = {work: 'read', file, fraction: null, cancel} as const;
    page.busy = busy;
    page.problem = null;
    await Promise.all(before);
    page.busy = busy;
    const answer = reading.cancelled ? CANCELLED : await Promise.race([run(reading), cancelled]);
    end();
    if (this.#now === reading) {
      this.#now = null;
      page.busy = null;
    }
    return answer;
  }
}
