import type {Design} from '../design/design';
import {walls, withPlacement, withSpace, withWalls} from '../design/edit';
import type {Moment} from '../design/moment';
import type {DirectionMap, Engine, FoundPlacement} from '../engine/api';
import {isFailure} from '../engine/failure';
import type {Options} from './options.svelte';

type Blocks = Design['space']['blocks'];

/** What a search or a map found, and the space that it was found in. */
interface Found<T> {
  of: string;
  blocks: Blocks;
  what: T;
}

/** What placements are looked for in. */
export interface Place {
  readonly engine: Engine;
  readonly design: Design;
  readonly moment: Moment;
  readonly options: Options;
  /** Which object is on the screen. */
  readonly shown: string | null;
  change(edit: (design: Design) => Design, control: string): void;
}

/** What the last search and the last map found, as long as it is true of what is on the screen. */
export class Placements {
  readonly #place: Place;
  #distinct = $state.raw<Found<FoundPlacement[]> | null>(null);
  #map = $state.raw<Found<DirectionMap> | null>(null);

  constructor(place: Place) {
    this.#place = place;
  }

  get distinct(): FoundPlacement[] {
    const now = this.#place.design.space.blocks;
    const found = this.#current(this.#distinct, true);
    return found && (now === 'auto' || String(now) === String(found.blocks)) ? found.what : [];
  }

  get map(): DirectionMap | null {
    const found = this.#current(this.#map, false);
    return found && String(this.#place.design.space.blocks) === String(found.blocks) ? found.what : null;
  }

  /** `blocks`: the counts that the search kept to. */
  foundDistinct(start: Design, blocks: Blocks, what: FoundPlacement[]) {
    this.#distinct = {of: this.#inputs(start, true), blocks, what};
  }

  /** `start`: the design that the map was made for. */
  foundMap(start: Design, what: DirectionMap) {
    this.#map = {of: this.#inputs(start, false), blocks: start.space.blocks, what};
  }

  /** Puts the object where a search found it, or a map. The cut is what was promised, and the walls are those that
   *  were asked for: in a space that follows the object they are fitted anew; where that would cut otherwise, the
   *  space of the search stays, with its walls. */
  async take(placement: FoundPlacement, control: string): Promise<void> {
    const {design} = this.#place;
    const blocks = this.#distinct?.what.includes(placement) ? this.#distinct.blocks : design.space.blocks;
    const taken = await this.asFound(withPlacement(design, placement), placement.cut_blocks, blocks, true);
    this.#place.change((now) => ({...withPlacement(now, placement), space: taken.space}), control);
  }

  /** A space that is fitted anew may begin half a block elsewhere and cut otherwise: then the search's own stays, and
   *  the walls are asked for by their numbers, as a space of chosen blocks wants none by itself. */
  async asFound(design: Design, cut_blocks: number, blocks: Blocks, exactly = false): Promise<Design> {
    if (design.space.blocks !== 'auto' || blocks === 'auto') return design;
    const packing = await this.#place.engine.pack(design, this.#place.moment.objects);
    const cut = isFailure(packing) ? null : (packing.fit?.cut_blocks ?? null);
    const asGood = cut !== null && (exactly ? cut === cut_blocks : cut <= cut_blocks);
    const wanted = walls(design, this.#place.options.fittedWall);
    return asGood ? design : withWalls(withSpace(design, blocks), wanted.every((mm) => mm === wanted[0]) ? wanted[0]! : wanted);
  }

  /** True still, if nothing changed but the placement and what taking one changes. */
  #current<T>(found: Found<T> | null, withWishes: boolean): Found<T> | null {
    return found?.of === this.#inputs(this.#place.design, withWishes) ? found : null;
  }

  /** All that placements depend on, but for the number of blocks where the space follows the object. */
  #inputs(design: Design, withWishes: boolean): string {
    const {object, space, cut, fit, search} = design;
    const wishes = withWishes ? [search.weights, search.upright] : [];
    return JSON.stringify([this.#place.shown, object, space.block_mm, walls(design, this.#place.options.fittedWall), cut, design.case, fit.notches, wishes]);
  }
}

