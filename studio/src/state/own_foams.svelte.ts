import type {Engine, Failure} from '../engine/api';
import type {KnownFoam} from '../engine/drops';
import {isFailure} from '../engine/failure';
import {drops} from '../words/drops';
import {remember, remembered} from '../words/remembered';

const KEY = 'snug-foams';

/** As a foams.json has it. */
interface Entry {
  name: string;
}

/** The foams that a person entered or opened: kept in this browser as the entries of a foams.json, and understood by the
 *  library alone. */
export class OwnFoams {
  readonly #engine: Engine;
  all: readonly KnownFoam[] = $state.raw([]);
  #entries: readonly Entry[] = [];

  constructor(engine: Engine) {
    this.#engine = engine;
    void this.#restore();
  }

  /** A foams.json with all of them. */
  get text(): string {
    return `${JSON.stringify(this.#entries, null, 2)}\n`;
  }

  /** Those of a foams.json, each in place of one of the same name. What is wrong with one refuses all. */
  async add(text: string): Promise<KnownFoam[] | Failure> {
    const read = await this.#engine.parseFoams(text);
    if (isFailure(read)) return read;
    const added = JSON.parse(text) as Entry[];
    const names = read.map(({design}) => design.name);
    return (await this.#becomes([...this.#entries.filter(({name}) => !names.includes(name)), ...added])) ?? read;
  }

  async remove(name: string): Promise<Failure | null> {
    return this.#becomes(this.#entries.filter((entry) => entry.name !== name));
  }

  async #becomes(entries: readonly Entry[]): Promise<Failure | null> {
    const text = JSON.stringify(entries);
    const read = await this.#engine.parseFoams(text);
    if (isFailure(read)) return read;
    this.#entries = entries;
    this.all = lastOfEachName(read);
    return remember(KEY, text) ? null : {error: drops.drops.own.notKept, kind: 'output'};
  }

  async #restore(): Promise<void> {
    const text = remembered(KEY);
    if (text === null) return;
    const read = await this.#engine.parseFoams(text);
    // What another version wrote stays as it is, for that one.
    if (isFailure(read)) return;
    this.#entries = JSON.parse(text) as Entry[];
    this.all = lastOfEachName(read);
  }
}

/** As the library finds a foam by its name. */
function lastOfEachName(foams: readonly KnownFoam[]): KnownFoam[] {
  return [...new Map(foams.map((foam) => [foam.design.name, foam])).values()];
}
