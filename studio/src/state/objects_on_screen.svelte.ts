import {idsOf, optionsOf, type Moment} from '../design/moment';
import type {Engine, Failure, ObjectInfo, Packing} from '../engine/api';
import type {PlacedItem} from './on_the_page';
import {ShownObject} from './shown_object.svelte';

/** As it stands in its file. */
const UNPLACED = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The objects on the screen, as a moment numbers them. */
export class ObjectsOnScreen {
  #all: readonly ShownObject[] = $state.raw([]);
  /** Those of the last packing. */
  #packed: readonly ShownObject[] = [];
  readonly #engine: Engine;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  get none(): boolean {
    return this.#all.length === 0;
  }

  /** As idsOf(). */
  get ids(): string {
    return this.#all.map(({id}) => id).join(' ');
  }

  get infos(): readonly ObjectInfo[] {
    return this.#all.flatMap(({info}) => info ?? []);
  }

  get asksForUnit(): boolean {
    return this.#all.some(({info}) => info?.sizeProblem != null);
  }

  /** None where there is nothing. */
  at(number: number): ShownObject | null {
    return this.#all[number] ?? null;
  }

  arePreparedFor(moment: Moment): boolean {
    return this.#all.every((shown) => shown.isPreparedFor(optionsOf(moment, shown.id)));
  }

  /** The items of a packing, each where it lies; none before their copies are there. */
  placedAs(packing: Packing): readonly PlacedItem[] {
    const placed = packing.items.flatMap(({object, placement}) => {
      const meshes = this.#packed[object]?.meshes;
      return meshes ? [{meshes, placement}] : [];
    });
    return placed.length === packing.items.length ? placed : [];
  }

  unplaced(number: number): readonly PlacedItem[] {
    const meshes = this.at(number)?.meshes;
    return meshes ? [{meshes, placement: UNPLACED}] : [];
  }

  /** Those of a moment. `infos`: of those that were just loaded; the others are there already. Nothing else is kept. */
  async become(moment: Moment, infos: readonly ObjectInfo[]): Promise<void> {
    const fresh = new Map(infos.map((info) => [info.id, info]));
    const known = new Map(this.#all.map((shown) => [shown.id, shown]));
    for (const shown of this.#all)
      if (fresh.has(shown.id) || !moment.objects.some(({id}) => id === shown.id)) shown.leave();
    this.#all = moment.objects.map(({id}) => (fresh.has(id) ? new ShownObject(this.#engine, id) : known.get(id)!));
    // All are known before the first of their copies is.
    const loaded = this.#all.map((shown) => {
      const info = fresh.get(shown.id);
      return info && shown.loaded(info, optionsOf(moment, shown.id));
    });
    await Promise.all(loaded);
    await this.keep(moment);
  }

  keep({objects}: Moment): Promise<void> {
    return this.#engine.keep(objects.map(({id}) => id));
  }

  /** Without those that a moment has no more. Returns how to have them back. */
  leave(moment: Moment): () => void {
    const before = this.#all;
    if (idsOf(moment) !== this.ids) this.#all = moment.objects.map(({id}) => before.find((shown) => shown.id === id)!);
    return () => (this.#all = before);
  }

  clear(): void {
    for (const shown of this.#all) shown.leave();
    this.#all = [];
  }

  /** With the moment's units and parts. `before`: the last good one. */
  async prepare(moment: Moment, before: Moment): Promise<Failure | null> {
    for (const shown of this.#all) {
      const failed = await shown.prepare(moment.design, optionsOf(moment, shown.id), optionsOf(before, shown.id));
      if (failed) return failed;
    }
    return null;
  }

  /** A packing of those that are there now; what it returns is called when its foams are. */
  packing(): () => void {
    const now = this.#all;
    return () => (this.#packed = now);
  }
}
