import type {Preset} from '../design/design';
import {withFit} from '../design/edit';
import type {Moment} from '../design/moment';
import {lackingForDrops, type Lacking} from '../design/protection';
import type {Engine, Failure, Finding, Packing} from '../engine/api';
import type {DropChoices, Drops, KnownFoam} from '../engine/drops';
import {isFailure} from '../engine/failure';
import type {ReliefOffer} from '../engine/fit';
import type {Gap} from '../engine/gap';
import {ContactsOnScreen} from './contacts.svelte';
import type {Work} from './on_the_page';
import {OwnFoams} from './own_foams.svelte';

/** What is dropped. */
interface Pack {
  readonly engine: Engine;
  readonly moment: Moment;
  readonly presets: readonly Preset[];
  readonly packing: Packing | null;
  readonly gap: Gap | null;
  becomes(next: Moment, control: string): void;
  refuse(control: string, text: Failure['error']): void;
  long<T>(work: Work, run: (onProgress: (fraction: number) => void) => Promise<T>): Promise<T>;
}

/** So long nothing may have changed: a slider that moves needs the library for itself. */
const STILL_MS = 150;

/** Of any side a shock is told, or that there is none to be told. */
export function hasFigures({items}: Drops): boolean {
  return items.some(({faces}) => faces.some(({verdict}) => verdict !== 'unknown'));
}

/** What the pack on the screen meets in a drop, and the walls that are chosen for it. */
export class DropsOnScreen {
  readonly choices: DropChoices;
  readonly #pack: Pack;
  readonly ownFoams: OwnFoams;
  /** What squeezes what, where that is to be seen. */
  readonly contacts: ContactsOnScreen;
  #found = $state.raw<{of: Packing; drops: Drops} | null>(null);
  /** They are of the foams on the screen. */
  current = $derived.by(() => this.#found !== null && this.#found.of === this.#pack.packing);

  constructor(pack: Pack, choices: DropChoices) {
    this.#pack = pack;
    this.contacts = new ContactsOnScreen(pack);
    this.choices = choices;
    this.ownFoams = new OwnFoams(pack.engine);
  }

  /** The library's and behind them this person's own, which count where names are the same. */
  get foams(): readonly KnownFoam[] {
    const own = this.ownFoams.all;
    const others = this.choices.foams.filter(({design}) => own.every((one) => one.design.name !== design.name));
    return [...others, ...own];
  }

  /** Anything was asked that drops, or a rest, could answer. */
  get wanted(): boolean {
    const {foam, height_mm, rule} = this.#pack.moment.design.protection ?? {};
    return foam != null || height_mm != null || rule != null;
  }

  /** The last that were estimated, of what was there just before where they are not `current`. */
  get last(): Drops | null {
    return this.wanted && this.#pack.packing?.fit ? (this.#found?.drops ?? null) : null;
  }

  /** Of the foams on the screen. */
  get #told(): Drops | null {
    return this.current ? this.last : null;
  }

  /** Less foam that would do more, as it is found where nobody changes anything. */
  get relief(): ReliefOffer | null {
    return this.#told && (this.#pack.gap?.relief ?? null);
  }

  /** What drops cannot be estimated without; none of it where the library says why they are not. null: they are told, or
   *  nobody would ask: a tray is not dropped, and what is rigid does not cushion. */
  get untold(): readonly Lacking[] | null {
    const {moment: {design}, presets} = this.#pack;
    if (design.space.open !== null || presets.find(({name}) => name === design.space.preset)?.rigid) return null;
    const lacking = lackingForDrops(design);
    if (lacking.length > 0) return lacking;
    return this.#told && !hasFigures(this.#told) ? [] : null;
  }

  /** What is missing is said where it is entered. */
  get findings(): readonly Finding[] {
    const own = (this.#told?.findings ?? []).filter(({code}) => code !== 'no_shock' && !code.startsWith('zone_')); // zones tell of themselves
    return this.relief ? [...own, this.relief.finding] : own;
  }

  /** Of pads and reliefs; where no drops are looked at, they are the packing's. */
  get fitting(): readonly Finding[] {
    return this.#told?.fitting ?? [];
  }

  /** Looks a little after a change; the function that it gives stops that. */
  lookSoon(): () => void {
    if (!this.wanted || !this.#pack.packing?.fit) return () => {};
    const timer = setTimeout(() => void this.look(), STILL_MS);
    return () => clearTimeout(timer);
  }

  async look(): Promise<void> {
    const {packing, engine} = this.#pack;
    if (!packing?.fit || !this.wanted) return;
    const drops = await engine.drops();
    if (!isFailure(drops) && packing === this.#pack.packing) this.#found = {of: packing, drops};
  }

  takeRelief = (): void => {
    if (!this.relief) return;
    const {height_mm, island_mm} = this.relief;
    const {moment} = this.#pack;
    this.#pack.becomes({...moment, design: withFit(moment.design, {relief: {height_mm, island_mm}})}, '');
  };

  /** The walls that what lies in the case needs. */
  chooseWalls = async (): Promise<void> => {
    const {moment, engine} = this.#pack;
    const found = await this.#pack.long('walls', (onProgress) => engine.protectingWalls(moment.design, onProgress, moment.objects));
    if (!isFailure(found)) this.#pack.becomes({...moment, design: found.design}, '');
    else if (found.kind !== 'cancelled') this.#pack.refuse('walls', found.error);
  };
}
