import type {Engine, Packing} from '../engine/api';
import {contactsOf, type ContactMap, type Pressing} from '../engine/drops';
import {isFailure} from '../engine/failure';

/** What is packed. */
interface Pack {
  readonly engine: Engine;
  readonly packing: Packing | null;
}

/** What the colours end at. */
export interface MostPressed {
  kpa: number;
  strain: number;
}

/** So long nothing may have changed: a slider that moves needs the library for itself. */
const STILL_MS = 150;

/** Pressure on the items and strain of the foam as the 3D view is to show them, in the pack on the screen. */
export class ContactsOnScreen {
  readonly #pack: Pack;
  /** None: they are not to be seen. */
  chosen: Pressing | null = $state(null);
  #found = $state.raw<{of: Packing; pressing: Pressing; map: ContactMap} | null>(null);
  /** Of the foams on the screen; null while that is not known. */
  current: ContactMap | null = $derived.by(() => {
    const found = this.#found;
    return found && found.of === this.#pack.packing && found.pressing === this.chosen ? found.map : null;
  });
  most: MostPressed = $derived(mostOf(this.current));

  constructor(pack: Pack) {
    this.#pack = pack;
  }

  choose(pressing: Pressing | null) {
    this.chosen = pressing;
  }

  /** Looks a little after a change of the pack, and at once after another choice; the function that it gives stops that. */
  lookSoon(): () => void {
    if (this.chosen === null || !this.#pack.packing?.fit || this.current) return () => {};
    const timer = setTimeout(() => void this.look(), this.#found?.of === this.#pack.packing ? 0 : STILL_MS);
    return () => clearTimeout(timer);
  }

  async look(): Promise<void> {
    const {chosen} = this;
    const {packing, engine} = this.#pack;
    if (!packing?.fit || chosen === null) return;
    const map = await engine.contacts(chosen);
    if (!isFailure(map) && packing === this.#pack.packing) this.#found = {of: packing, pressing: chosen, map};
  }
}

function mostOf(map: ContactMap | null): MostPressed {
  let [kpa, strain] = [0, 0];
  for (const contact of map?.items.flatMap(contactsOf) ?? []) {
    kpa = Math.max(kpa, contact.kpa);
    strain = Math.max(strain, contact.strain);
  }
  return {kpa, strain};
}
