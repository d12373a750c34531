import {openDB, type IDBPTransaction} from 'idb';
import type {Design} from '../design/design';
import {present, type History} from '../design/history';
import {momentOf, type Moment} from '../design/moment';
import type {BesideFile} from '../engine/api';
import type {Picture} from '../picture/thumbnail';

// The browser's own database: the works of this browser, and of nobody else. Each tab of the page has a work of
// its own; objects are shared by all that name them.

/** An object by the name of its content. */
export interface StoredObject {
  id: string;
  name: string;
  content: Blob;
  /** Snug made it: there is no file of this name on the person's disk. */
  converted: boolean;
  /** Files that it is read with, such as a .gltf's .bin; none in what earlier versions saved. */
  beside?: readonly BesideFile[];
}

/** What earlier versions saved: a design, and the one object in it (by id), if there is one. */
export interface EarlierMoment {
  design: Design;
  object: string | null;
}

export type StoredMoment = Moment | EarlierMoment;

export function asMoment(stored: StoredMoment): Moment {
  return 'object' in stored ? momentOf(stored.design, stored.object) : stored;
}

export interface StoredWork {
  history: History<StoredMoment>;
}

/** What a person chooses a work by. */
export interface WorkSummary {
  id: string;
  /** Of the objects' files; empty while there is none. */
  name: string;
  /** Of all of them; 0 while there is none. */
  bytes: number;
  /** When it was saved last, ms since 1970; 0: not known. */
  saved: number;
  picture: Picture | null;
  /** Ids of the objects in all its moments. */
  objects: string[];
}

export interface Autosave {
  /** The newest first. */
  list(): Promise<WorkSummary[]>;
  load(id: string): Promise<{work: StoredWork; objects: StoredObject[]} | null>;
  /** Whole or not at all. `objects` may be more than the work names. */
  save(summary: WorkSummary, work: StoredWork, objects: Iterable<StoredObject>): Promise<void>;
  /** Forgets a work, and the objects that no other one names. */
  remove(id: string): Promise<void>;
}

const WORKS = 'works';
const SUMMARIES = 'summaries';
const OBJECTS = 'objects';
/** Of version 1: one work for the whole browser, by one key. */
const WORK_1 = 'work';
const KEY_1 = 'last';

export interface AutosaveNews {
  /** A tab with the page of an earlier version keeps the database from being opened until it is closed. */
  onBlocked?: () => void;
}

export async function openAutosave({onBlocked}: AutosaveNews = {}, name = 'snug'): Promise<Autosave> {
  const db = await openDB(name, 2, {
    async upgrade(fresh, from, _, change) {
      fresh.createObjectStore(WORKS);
      fresh.createObjectStore(SUMMARIES, {keyPath: 'id'});
      if (from === 0) fresh.createObjectStore(OBJECTS, {keyPath: 'id'});
      if (from !== 1) return;
      const work = (await change.objectStore(WORK_1).get(KEY_1)) as StoredWork | undefined;
      const objects = (await change.objectStore(OBJECTS).getAll()) as StoredObject[];
      if (work) {
        void change.objectStore(WORKS).put(work, KEY_1);
        void change.objectStore(SUMMARIES).put(summaryOf(KEY_1, work, objects, 0, null));
      }
      fresh.deleteObjectStore(WORK_1);
    },
    blocked: () => onBlocked?.(),
    // A page of a later version shall not wait for this tab.
    blocking: () => db.close(),
  });
  return {
    async list() {
      const all = (await db.getAll(SUMMARIES)) as WorkSummary[];
      return all.sort((a, b) => b.saved - a.saved || (a.id < b.id ? -1 : 1));
    },
    async load(id) {
      const work = (await db.get(WORKS, id)) as StoredWork | undefined;
      const summary = (await db.get(SUMMARIES, id)) as WorkSummary | undefined;
      if (!work || !summary) return null;
      const objects = await Promise.all(summary.objects.map((object) => db.get(OBJECTS, object)));
      return {work, objects: objects.filter((object) => object !== undefined) as StoredObject[]};
    },
    async save(summary, work, objects) {
      const change = db.transaction([WORKS, SUMMARIES, OBJECTS], 'readwrite');
      const known = new Set(await change.objectStore(OBJECTS).getAllKeys());
      for (const object of objects)
        if (summary.objects.includes(object.id) && !known.has(object.id)) void change.objectStore(OBJECTS).put(object);
      void change.objectStore(WORKS).put(work, summary.id);
      void change.objectStore(SUMMARIES).put(summary);
      await dropUnnamed(change);
      await change.done;
    },
    async remove(id) {
      const change = db.transaction([WORKS, SUMMARIES, OBJECTS], 'readwrite');
      void change.objectStore(WORKS).delete(id);
      void change.objectStore(SUMMARIES).delete(id);
      await dropUnnamed(change);
      await change.done;
    },
  };
}

export function summaryOf(
  id: string,
  {history}: StoredWork,
  objects: Iterable<StoredObject>,
  saved: number,
  picture: Picture | null,
): WorkSummary {
  const known = new Map([...objects].map((object) => [object.id, object]));
  const idsOf = (moment: StoredMoment) => asMoment(moment).objects.map(({id: used}) => used);
  // Undone to before it was opened, a work still has its objects.
  const named = [present(history), ...[...history.moments].reverse()].map(idsOf).find((ids) => ids.length > 0) ?? [];
  const there = named.flatMap((used) => known.get(used) ?? []);
  const all = new Set(history.moments.flatMap(idsOf));
  return {
    id,
    name: there.map(({name}) => name).join(', '),
    bytes: there.reduce((sum, {content}) => sum + content.size, 0),
    saved,
    picture,
    objects: [...all],
  };
}

type Change = IDBPTransaction<unknown, string[], 'readwrite'>;

async function dropUnnamed(change: Change): Promise<void> {
  const summaries = (await change.objectStore(SUMMARIES).getAll()) as WorkSummary[];
  const named = new Set(summaries.flatMap(({objects}) => objects));
  for (const id of await change.objectStore(OBJECTS).getAllKeys())
    if (!named.has(id as string)) void change.objectStore(OBJECTS).delete(id as string);
}
