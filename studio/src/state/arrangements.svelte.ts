import type {Design} from '../design/design';
import {walls, withSpace} from '../design/edit';
import type {Moment} from '../design/moment';
import type {Arranged, Engine} from '../engine/api';
import {isFailure} from '../engine/failure';
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

/** Puts several things where they take the least room, and keeps what there was to choose from as long as it is true of
 *  what is on the screen. */
export class Arrangements {
  readonly #kit: Kit;
  readonly #long: LongWork;
  #found = $state.raw<{of: string; start: Design; choices: Arranged[]} | null>(null);

  constructor(kit: Kit, long: LongWork) {
    this.#kit = kit;
    this.#long = long;
  }

  /** The best first. */
  get choices(): Arranged[] {
    const {design} = this.#kit.moment;
    if (!this.#found || this.#found.of !== this.#inputs(design)) return [];
    const {start, choices} = this.#found;
    const spaces = [start, ...(start.space.blocks === 'auto' ? choices.map((choice) => choice.design) : [])];
    return spaces.some(({space}) => String(space.blocks) === String(design.space.blocks)) ? choices : [];
  }

  /** Which of them is on the screen; -1: none. */
  get chosen(): number {
    const now = JSON.stringify(this.#kit.moment.design.items);
    return this.choices.findIndex(({design}) => JSON.stringify(design.items) === now);
  }

  /** All that is not locked. */
  arrange = () =>
    this.#run(({engine, moment}, onStep) => engine.arrange(moment.design, onStep, moment.objects));

  /** As many of the selected one as fit. */
  fill = () =>
    this.#run(({engine, moment, selected}, onStep) => engine.fill(moment.design, selected, onStep, moment.objects));

  async take(choice: Arranged): Promise<void> {
    const {moment} = this.#kit;
    const design = await this.#asOpen(this.#found?.start ?? moment.design, choice.design);
    if (this.#kit.moment === moment) this.#kit.becomes({...moment, design}, '');
  }

  async #run(run: (kit: Kit, onStep: Parameters<Engine['arrange']>[1]) => ReturnType<Engine['arrange']>): Promise<void> {
    const start = this.#kit.moment.design;
    await this.#long.arrange(
      (onStep) => run(this.#kit, onStep),
      async ({design, choices}) => {
        if (choices.length > 0) this.#found = {of: this.#inputs(choices[0]!.design), start, choices};
        return this.#asOpen(start, design);
      },
    );
  }

  /** A space that followed its items does so from now on, too, where it then is the same. */
  async #asOpen(start: Design, arranged: Design): Promise<Design> {
    if (start.space.blocks !== 'auto' || arranged.space.blocks === 'auto' || start.case.inside_mm) return arranged;
    const open = withSpace({...arranged, space: {...arranged.space, wall_mm: start.space.wall_mm}}, 'auto');
    const packing = await this.#kit.engine.pack(open, this.#kit.moment.objects);
    if (isFailure(packing) || !packing.fit) return arranged;
    return String(packing.blocks) === String(arranged.space.blocks) ? open : arranged;
  }

  /** All that arrangements depend on, but for where the items lie. */
  #inputs(design: Design): string {
    const items = design.items.map(({rotation_deg: _, offset_mm: __, layer: ___, ...rest}) => rest);
    const space = {...design.space, blocks: null, wall_mm: walls(design, this.#kit.options.fittedWall)};
    return JSON.stringify([this.#kit.moment.objects, {...design, items, space}]);
  }
}
