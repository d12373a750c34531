import type {Design} from '../design/design';
import {bounds, comesTo, type Dependent, type OptionPath, type Schema} from '../design/options';

/** What the design's options may be, and what those come to that are left open. */
export class Options {
  readonly rows: Schema;
  /** What follows from the design's other choices. */
  #dependent: Dependent = $state.raw({});
  readonly #design: () => Design;

  constructor(rows: Schema, design: () => Design) {
    this.rows = rows;
    this.#design = design;
  }

  /** As the library found it when it looked at a design. */
  depend(dependent: Dependent): void {
    this.#dependent = dependent;
  }

  /** What an option comes to in the design, chosen or not; null where it is simply not there. */
  comesTo(path: OptionPath): unknown {
    return comesTo(this.#design(), path, this.#dependent);
  }

  /** Least and most of a number in the design. */
  bounds(path: OptionPath): {min?: number; max?: number} {
    return bounds(this.rows[path], this.#dependent[path]);
  }

  /** Of a side where none is chosen and the space is fitted to the object. */
  get fittedWall(): number {
    const {fitted = 0, tray = 0} = this.rows['space.wall_mm'];
    return this.#design().space.open === null ? fitted : tray;
  }
}
