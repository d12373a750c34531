import type {Moment} from '../design/moment';
import type {Engine, Finding, Packing} from '../engine/api';
import {isFailure} from '../engine/failure';
import type {ZoneResult, ZoneResults} from '../engine/zones';

/** What is packed. */
interface Pack {
  readonly engine: Engine;
  readonly moment: Moment;
  readonly packing: Packing | null;
}

/** So long nothing may have changed: a slider that moves needs the library for itself. */
const STILL_MS = 200;

/** What becomes of the places that foam keeps away from, in the pack on the screen. */
export class ZonesOnScreen {
  readonly #pack: Pack;
  #found = $state.raw<{of: Packing; results: ZoneResults} | null>(null);

  constructor(pack: Pack) {
    this.#pack = pack;
  }

  get #wanted(): boolean {
    const {protection, items} = this.#pack.moment.design;
    return (protection?.zones.length ?? 0) > 0 || (items?.some(({zones}) => zones.length > 0) ?? false);
  }

  /** Of the foams on the screen; null while that is not known. */
  get #current(): ZoneResults | null {
    return this.#wanted && this.#found?.of === this.#pack.packing ? (this.#found?.results ?? null) : null;
  }

  get findings(): readonly Finding[] {
    return this.#current?.findings ?? [];
  }

  of(item: number, zone: number): ZoneResult | null {
    return this.#current?.zones.find((one) => one.item === item && one.number === zone + 1) ?? null;
  }

  /** Looks a little after a change; the function that it gives stops that. */
  lookSoon(): () => void {
    if (!this.#wanted || !this.#pack.packing?.fit) return () => {};
    const timer = setTimeout(() => void this.look(), STILL_MS);
    return () => clearTimeout(timer);
  }

  async look(): Promise<void> {
    const {packing, engine} = this.#pack;
    if (!packing?.fit || !this.#wanted) return;
    const results = await engine.zones();
    if (!isFailure(results) && packing === this.#pack.packing) this.#found = {of: packing, results};
  }
}
