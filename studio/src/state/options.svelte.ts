import type {Design} from '../design/design';
import {bounds, comesTo, type Dependent, type OptionPath, type Schema} from '../design/options';
import {isOther, rowPath, usualValue, withUsual, type Beginning} from '../design/usual';

/** What the design's options may be, and what those come to that are left open. */
export class Options {
  readonly rows: Schema;
  /** What follows from the design's other choices. */
  #dependent: Dependent = $state.raw({});
  readonly #beginning: Beginning;
  readonly #design: () => Design;

  constructor(beginning: Beginning, design: () => Design) {
    this.rows = beginning.rows;
    this.#beginning = beginning;
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

  /** What it is where nobody chose it: a value, or what the other choices make of it; null where it is simply not there. */
  usual(path: OptionPath): unknown {
    return usualValue(this.#design(), path, this.#beginning) ?? this.#dependent[rowPath(path)]?.usual ?? null;
  }

  /** Whether something else is chosen. */
  differs(path: OptionPath): boolean {
    return isOther(this.#design(), path, this.#beginning);
  }

  /** The design with these as if nobody had chosen them. */
  withUsual(design: Design, paths: readonly OptionPath[]): Design {
    return paths.reduce((left, path) => withUsual(left, path, this.#beginning), design);
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
