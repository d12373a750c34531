import type {Design} from '../design/design';
import {walls} from '../design/edit';
import type {Moment} from '../design/moment';
import type {Arranged, Engine} from '../engine/api';
import type {LongWork} from './long_work';
import type {Options} from './options.svelte';

/** What is arranged. */
export interface Kit {
  readonly engine: Engine;
  readonly moment: Moment;
  readonly options: Options;
  readonly selected: number;
  becomes(next: Moment, control: string): void;
}

interface Found {
  /** Inputs that it is of, and the design that it began with. */
  of: string;
  start: Design;
  /** All that were found. */
  designs: Design[];
  choices: Arranged[];
}

/** Puts several things where they take the least room, and keeps what there was to choose from as long as it is true of
 *  what is on the screen. */
export class Arrangements {
  readonly #kit: Kit;
  readonly #long: LongWork;
  #found = $state.raw<Found | null>(null);

  constructor(kit: Kit, long: LongWork) {
    this.#kit = kit;
    this.#long = long;
  }

  /** The best first. */
  get choices(): Arranged[] {
    const {design} = this.#kit.moment;
    if (!this.#found || this.#found.of !== this.#inputs(design)) return [];
    const {designs, choices} = this.#found;
    return designs.some(({space}) => String(space.blocks) === String(design.space.blocks)) ? choices : [];
  }

  /** Which of them is on the screen; -1: none. */
  get chosen(): number {
    const now = JSON.stringify(this.#kit.moment.design.items);
    return this.choices.findIndex(({design}) => JSON.stringify(design.items) === now);
  }

  /** All that is not locked. */
  arrange = () => this.#run(this.#reopened(), ({engine, moment}, design, onStep) => engine.arrange(design, onStep, moment.objects));

  /** As many of the selected one as fit. */
  fill = () =>
    this.#run(this.#kit.moment.design, ({engine, moment, selected}, design, onStep) =>
      engine.fill(design, selected, onStep, moment.objects),
    );

  take(choice: Arranged): void {
    this.#kit.becomes({...this.#kit.moment, design: choice.design}, '');
  }

  async #run(
    start: Design,
    run: (kit: Kit, start: Design, onStep: Parameters<Engine['arrange']>[1]) => ReturnType<Engine['arrange']>,
  ): Promise<void> {
    await this.#long.arrange(
      (onStep) => run(this.#kit, start, onStep),
      ({design, choices}) => {
        this.#found = {of: this.#inputs(design), start, designs: [design, ...choices.map((choice) => choice.design)], choices};
        return design;
      },
    );
  }

  /** A space that an arrangement chose by itself is nobody's wish when the next one begins. */
  #reopened(): Design {
    const {design} = this.#kit.moment;
    const start = this.#found?.start.space;
    const own = this.#found?.designs.some(({space}) => String(space.blocks) === String(design.space.blocks));
    if (start?.blocks !== 'auto' || !own) return design;
    return {...design, space: {...design.space, blocks: 'auto', wall_mm: start.wall_mm}};
  }

  /** All that arrangements depend on, but for where the items lie. */
  #inputs(design: Design): string {
    const items = design.items.map(({rotation_deg: _, offset_mm: __, layer: ___, ...rest}) => rest);
    const space = {...design.space, blocks: null, wall_mm: walls(design, this.#kit.options.fittedWall)};
    return JSON.stringify([this.#kit.moment.objects, {...design, items, space}]);
  }
}
