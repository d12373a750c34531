import type {Design} from '../design/design';
import type {Engine, Failure, ObjectInfo} from '../engine/api';
import {failure, isFailure} from '../engine/failure';
import type {DisplayMeshes} from './on_the_page';

/** Drawn while something moves, and when it stands still. */
const MOVING_TRIANGLES = 10_000;
const STILL_TRIANGLES = 100_000;

/** The object on the screen as a design has it, and the copies of it that the views draw. */
export class ShownObject {
  info: ObjectInfo | null = $state.raw(null);
  meshes: DisplayMeshes | null = $state.raw(null);
  readonly #engine: Engine;
  #preparedFor = '';
  #turn = 0;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  isPreparedFor(design: Design): boolean {
    return JSON.stringify(design.object) === this.#preparedFor;
  }

  /** Just loaded for this design. */
  async loaded(info: ObjectInfo, design: Design): Promise<void> {
    this.#preparedFor = JSON.stringify(design.object);
    await this.#becomes(info);
  }

  /** With the design's unit and parts. `before`: the last good design. */
  async prepare(design: Design, before: Design): Promise<Failure | null> {
    if (!this.info || this.isPreparedFor(design)) return null;
    const wanted = JSON.stringify(design.object);
    // From now on: who asks meanwhile asks after this.
    this.#preparedFor = wanted;
    const hadSize = this.info.size_mm !== null && sameScale(design, before);
    const info = await this.#engine.reprepare(design);
    // No unit is missing that was not missing before: the library says what is.
    const failed = isFailure(info) ? info : hadSize && info.sizeProblem ? failure('input', info.sizeProblem) : null;
    if (failed && this.#preparedFor === wanted) this.#preparedFor = '';
    if (!failed) await this.#becomes(info as ObjectInfo);
    return failed;
  }

  clear(): void {
    this.#turn++;
    this.info = null;
    this.meshes = null;
  }

  /** The finer copy comes later. */
  async #becomes(info: ObjectInfo): Promise<void> {
    this.info = info;
    const turn = ++this.#turn;
    const moving = await this.#engine.displayMesh(MOVING_TRIANGLES);
    if (turn !== this.#turn) return;
    this.meshes = {moving, still: moving};
    void this.#engine.displayMesh(STILL_TRIANGLES).then((still) => {
      if (turn === this.#turn) this.meshes = {moving, still};
    });
  }
}

function sameScale({object: a}: Design, {object: b}: Design): boolean {
  return a.units === b.units && a.scale === b.scale && a.longest_mm === b.longest_mm;
}
