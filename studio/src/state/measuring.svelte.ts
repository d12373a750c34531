import type {Design} from '../design/design';
import {forNewObject, withMoreClearance, withRotation} from '../design/edit';
import {sideDown} from '../design/rotation';
import {errorIn, FIRST_SHAPE, isShape, shapeText, type Shape} from '../design/shape';
import {isFailure} from '../engine/failure';
import type {Studio} from './studio.svelte';

const NAME = 'measured.shape';
/** So long nothing may have changed. */
const STILL_MS = 300;

/** An object that is put together from measurements, and opened like any other at every change. */
export class Measuring {
  readonly #studio: Studio;
  shape: Shape = $state.raw(FIRST_SHAPE);
  #timer: ReturnType<typeof setTimeout> | undefined;
  #opening: Promise<unknown> = Promise.resolve();
  /** What the clearance on the page has for an error of measuring. */
  #added = 0;
  #name = NAME;
  /** It is made just now, and nothing was asked of it yet. */
  anew = false;

  constructor(studio: Studio) {
    this.#studio = studio;
  }

  /** One object, which was made so. */
  get canEdit(): boolean {
    const {objects} = this.#studio;
    return objects.length === 1 && isShape(objects[0]!.file.name);
  }

  start(): Promise<unknown> {
    this.anew = true;
    this.#added = 0;
    this.#name = NAME;
    this.shape = FIRST_SHAPE;
    const {moment, defaults, presets} = this.#studio;
    // What is typed as its height stands upright.
    const standing = sideDown(defaults.placement.rotation_deg, '-z');
    return this.#open(withRotation(forNewObject(moment.design, defaults, presets), standing));
  }

  /** False where the file has what cannot be edited here. `anew`: as start() began it. */
  async edit(anew = false): Promise<boolean> {
    const [file] = this.#studio.files;
    if (!file) return false;
    const text = await file.content.text();
    const read = await this.#studio.engine.parseShape(text);
    if (isFailure(read)) return false;
    this.anew = anew;
    this.shape = {solids: read.solids, error_mm: errorIn(text)};
    this.#added = this.shape.error_mm;
    this.#name = file.name;
    return true;
  }

  change(to: Partial<Shape>): void {
    this.shape = {...this.shape, ...to};
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#open(this.#studio.moment.design), STILL_MS);
  }

  /** Nothing is opened any more. */
  leave(): void {
    clearTimeout(this.#timer);
  }

  /** What was changed last is open then. */
  async done(): Promise<void> {
    this.leave();
    await this.#opening;
    const [file] = this.#studio.files;
    const text = shapeText(this.shape);
    if (file && (await file.content.text()) !== text) await this.#open(this.#studio.moment.design);
  }

  #open(design: Design): Promise<unknown> {
    const {error_mm} = this.shape;
    const more = error_mm - this.#added;
    const cleared = more === 0 ? design : withMoreClearance(design, more, 0);
    const file = new Blob([shapeText(this.shape)], {type: 'text/plain'});
    this.#opening = this.#studio.openObject(this.#name, file, {design: cleared}).then((failed) => {
      if (!failed) this.#added = error_mm;
    });
    return this.#opening;
  }
}
