import type {Design} from '../design/design';
import type {Engine, Failure, ObjectInfo} from '../engine/api';
import {failure, isFailure} from '../engine/failure';
import type {DisplayMeshes} from './on_the_page';

/** Drawn while something moves, and when it stands still. */
const MOVING_TRIANGLES = 10_000;
const STILL_TRIANGLES = 100_000;

type Options = Design['object'];

/** An object on the screen as a design has it, and the copies of it that the views draw. */
export class ShownObject {
  info: ObjectInfo | null = $state.raw(null);
  meshes: DisplayMeshes | null = $state.raw(null);
  /** What it was loaded as. */
  readonly id: string;
  readonly #engine: Engine;
  #preparedFor = '';
  #turn = 0;

  constructor(engine: Engine, id: string) {
    this.#engine = engine;
    this.id = id;
  }

  isPreparedFor(options: Options): boolean {
    return JSON.stringify(options) === this.#preparedFor;
  }

  /** Just loaded with these options. */
  async loaded(info: ObjectInfo, options: Options): Promise<void> {
    this.#preparedFor = JSON.stringify(options);
    await this.#becomes(info);
  }

  /** With these options in place of the design's own for it. `before`: those of the last good design. */
  async prepare(design: Design, options: Options, before: Options): Promise<Failure | null> {
    if (!this.info || this.isPreparedFor(options)) return null;
    const wanted = JSON.stringify(options);
    // From now on: who asks meanwhile asks after this.
    this.#preparedFor = wanted;
    const hadSize = this.info.size_mm !== null && sameScale(options, before);
    const info = await this.#engine.reprepare({...design, object: options}, this.id);
    // No unit is missing that was not missing before: the library says what is.
    const failed = isFailure(info) ? info : hadSize && info.sizeProblem ? failure('input', info.sizeProblem) : null;
    if (failed && this.#preparedFor === wanted) this.#preparedFor = '';
    if (!failed) await this.#becomes(info as ObjectInfo);
    return failed;
  }

  /** Nothing that is still on its way shows. */
  leave(): void {
    this.#turn++;
  }

  /** The finer copy comes later. */
  async #becomes(info: ObjectInfo): Promise<void> {
    this.info = info;
    const turn = ++this.#turn;
    const moving = await this.#engine.displayMesh(MOVING_TRIANGLES, this.id);
    if (turn !== this.#turn) return;
    this.meshes = {moving, still: moving};
    void this.#engine.displayMesh(STILL_TRIANGLES, this.id).then((still) => {
      if (turn === this.#turn) this.meshes = {moving, still};
    });
  }
}

function sameScale(a: Options, b: Options): boolean {
  return a.units === b.units && a.scale === b.scale && a.longest_mm === b.longest_mm;
}
