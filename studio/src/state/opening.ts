import type {Design} from '../design/design';
import {forNewObject} from '../design/edit';
import {idsOf, momentOf, optionsOf, withJoined, type Moment, type ObjectUse} from '../design/moment';
import type {BesideFile, Failure, Loading, ObjectInfo, Project} from '../engine/api';
import {CANCELLED, isFailure} from '../engine/failure';
import {about} from '../words/words';
import type {StoredObject} from './autosave';
import {newId} from '../engine/new_id';
import {level} from './level';
import type {Content, FileFacts, Given, Reading} from './on_the_page';
import type {Studio} from './studio.svelte';

/** What the studio does with what was read. */
interface Parts {
  /** The last good moment. */
  present(): Moment;
  /** `infos`: of the objects that were just loaded. */
  switchTo(moment: Moment, infos: readonly ObjectInfo[]): Promise<void>;
  show(moment: Moment): Promise<Failure | null>;
  pack(moment: Moment): Promise<Failure | null>;
  backTo(moment: Moment): Promise<void>;
  refuse(failed: Failure): Failure;
}

/** Brings files' contents onto the screen. Each gives null where that worked; refused or cancelled, everything is as it
 *  was. */
export class Opening {
  readonly #studio: Studio;
  readonly #objects: Map<string, StoredObject>;
  readonly #parts: Parts;

  constructor(studio: Studio, objects: Map<string, StoredObject>, parts: Parts) {
    this.#studio = studio;
    this.#objects = objects;
    this.#parts = parts;
  }

  /** One object; `source` may make it first. `joins`: beside what is there, not in its place. */
  object(
    name: string,
    source: Blob | (() => Promise<Content | Failure>),
    options: {beside?: readonly BesideFile[]; design?: Design | undefined; joins?: boolean} = {},
  ): Promise<Failure | null> {
    const bytes = source instanceof Blob ? source.size : 0;
    return this.#whole({name, bytes}, async (reading, before) => {
      const own = {name, converted: false, beside: options.beside ?? []};
      const made = source instanceof Blob ? {...own, content: source} : await source();
      if (reading.cancelled || isFailure(made)) return isFailure(made) ? made : CANCELLED;
      if (options.joins && before.objects.length > 0) return this.#join([made], reading);
      const failed = await this.#open(made, options.design ?? this.#fresh(before), reading);
      // A design that this object cannot have is no reason to lose the object.
      const again = failed && options.design && failed.kind !== 'cancelled' && this.#studio.shown !== idsOf(before);
      return named(name, again ? await this.#open(made, this.#fresh(before), reading) : failed);
    });
  }

  /** Several, in place of what is there or beside it. */
  items(files: readonly Given[], joins: boolean): Promise<Failure | null> {
    return this.#whole(together(files), async (reading, before) => {
      const contents = files.map((file) => ({...file, converted: false}));
      if (joins && before.objects.length > 0) return this.#join(contents, reading);
      const [first, ...others] = contents;
      const failed = first ? await this.#open(first, this.#fresh(before), reading, others.length > 0) : null;
      return failed ?? this.#join(others, reading, 0);
    });
  }

  /** A project with its objects' files, one for each. */
  project({design, objects}: Project, files: readonly Given[]): Promise<Failure | null> {
    return this.#whole(together(files), async (reading) => {
      const uses: ObjectUse[] = [];
      const infos: ObjectInfo[] = [];
      for (const [i, file] of files.entries()) {
        const own = objects[i]?.own ?? null;
        const load = (how: Loading) => this.#load({...file, converted: false}, own ?? design.object, how, reading);
        let loaded = await load({joins: true});
        // The same file twice, with other choices.
        if (uses.some(({id}) => !isFailure(loaded) && id === loaded.info.id)) loaded = await load({joins: true, id: newId()});
        if (isFailure(loaded)) return loaded;
        const {info, options} = loaded;
        uses.push({id: info.id, own: options === design.object ? null : options});
        infos.push(info);
      }
      return this.#show({design, objects: uses}, infos, 0, reading);
    });
  }

  /** A moment of the history with objects that are not there any more. */
  async again(moment: Moment, missing: readonly StoredObject[]): Promise<Failure | null> {
    const show = async (cancelled: () => boolean) => {
      const infos: ObjectInfo[] = [];
      for (const {id, name, content, beside} of missing) {
        const info = await this.#studio.engine.load(name, content, optionsOf(moment, id), beside, {id, joins: true});
        if (cancelled() || isFailure(info)) return isFailure(info) ? named(name, info) : CANCELLED;
        infos.push(info);
      }
      await this.#parts.switchTo(moment, infos);
      if (!cancelled()) await this.#parts.pack(moment);
      return cancelled() ? CANCELLED : null;
    };
    if (missing.length === 0) return show(() => false);
    const failed = await this.#studio.reading(together(missing), (reading) => show(() => reading.cancelled));
    if (failed) this.#parts.refuse(failed);
    return failed;
  }

  /** A reading; where it comes to nothing, everything is as it was. */
  async #whole(
    file: FileFacts,
    run: (reading: Reading, before: Moment) => Promise<Failure | null>,
  ): Promise<Failure | null> {
    const before = this.#parts.present();
    const failed = await this.#studio.reading(file, (reading) => run(reading, before));
    if (!failed) return null;
    await this.#parts.backTo(before);
    return this.#parts.refuse(failed);
  }

  #fresh(before: Moment): Design {
    return forNewObject(before.design, this.#studio.defaults, this.#studio.presets);
  }

  /** In place of all. `more`: others join it before it is shown. */
  async #open(given: Content, design: Design, reading: Reading, more = false): Promise<Failure | null> {
    const loaded = await this.#load(given, design.object, {}, reading);
    if (isFailure(loaded)) return loaded;
    const {info, options} = loaded;
    const moment = momentOf({...design, object: options}, info.id);
    if (!more) return this.#show(moment, [info], 0, reading);
    await this.#parts.switchTo(moment, [info]);
    return null;
  }

  /** Beside those that are there. As a rule the first of them is selected. */
  async #join(
    given: readonly Content[],
    reading: Reading,
    selected = this.#studio.moment.design.items.length,
  ): Promise<Failure | null> {
    const infos: ObjectInfo[] = [];
    const own = new Map<string, Design['object']>();
    const {defaults} = this.#studio;
    for (const one of given) {
      const loaded = await this.#load(one, defaults.object, {joins: true}, reading);
      if (isFailure(loaded)) return loaded;
      infos.push(loaded.info);
      if (loaded.options !== defaults.object) own.set(loaded.info.id, loaded.options);
    }
    const {moment, lying} = this.#studio;
    const joined = withJoined(moment, infos, defaults, lying);
    const objects = joined.objects.map((use) => ({...use, own: own.get(use.id) ?? use.own}));
    return this.#show({...joined, objects}, infos, selected, reading);
  }

  /** Content for the library, and kept for later; with the options that it has in the end. */
  async #load(
    given: Content,
    options: Design['object'],
    how: Loading,
    reading: Reading,
  ): Promise<{info: ObjectInfo; options: Design['object']} | Failure> {
    const {name, content, converted} = given;
    const info = await this.#studio.engine.load(name, content, options, given.beside, how);
    if (reading.cancelled || isFailure(info)) return isFailure(info) ? named(name, info) : CANCELLED;
    const beside = given.beside?.filter((file) => info.beside.includes(file.name)) ?? [];
    this.#objects.set(info.id, {id: info.id, name, content, converted, beside});
    if (level === 'usual' || !info.sizeProblem) return {info, options};
    // Nothing is asked.
    const inMm = {...options, units: 'mm' as const};
    const prepared = await this.#studio.engine.reprepare({...this.#studio.defaults, object: inMm}, info.id);
    return isFailure(prepared) ? prepared : {info: prepared, options: inMm};
  }

  async #show(moment: Moment, infos: readonly ObjectInfo[], selected: number, reading: Reading): Promise<Failure | null> {
    await this.#parts.switchTo(moment, infos);
    this.#studio.select(selected);
    if (reading.cancelled) return CANCELLED;
    const failed = await this.#parts.show(moment);
    if (reading.cancelled) return CANCELLED;
    if (!failed) this.#studio.thinned = null;
    return failed;
  }
}

function together(files: readonly {name: string; content: Blob}[]): FileFacts {
  return {name: files.map(({name}) => name).join(', '), bytes: files.reduce((sum, {content}) => sum + content.size, 0)};
}

function named<T extends Failure | null>(name: string, failed: T): T {
  return failed && {...failed, error: about(name, failed.error)};
}
