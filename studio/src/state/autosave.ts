import {openDB} from 'idb';
import type {Design} from '../engine/api';
import type {History} from './history';

// The browser's own database: the work of this browser, and of nobody else.

/** An object by the name of its content. */
export interface StoredObject {
  id: string;
  name: string;
  content: Blob;
  /** It came from another format and has no file of this name on the person's disk. */
  converted: boolean;
}

/** What is on the screen: a design, and the object in it (by id), if there is one. */
export interface Moment {
  design: Design;
  object: string | null;
}

export interface StoredWork {
  history: History<Moment>;
}

export interface Autosave {
  load(): Promise<{work: StoredWork; objects: StoredObject[]} | null>;
  /** Whole or not at all. Objects that no moment names are dropped. */
  save(work: StoredWork, objects: Iterable<StoredObject>): Promise<void>;
  clear(): Promise<void>;
}

const WORK = 'work';
const OBJECTS = 'objects';
const KEY = 'last';

export async function openAutosave(name = 'snug'): Promise<Autosave> {
  const db = await openDB(name, 1, {
    upgrade(fresh) {
      fresh.createObjectStore(WORK);
      fresh.createObjectStore(OBJECTS, {keyPath: 'id'});
    },
  });
  return {
    async load() {
      const work = (await db.get(WORK, KEY)) as StoredWork | undefined;
      if (!work) return null;
      return {work, objects: (await db.getAll(OBJECTS)) as StoredObject[]};
    },
    async save(work, objects) {
      const used = new Set(work.history.moments.map(({object}) => object));
      const change = db.transaction([WORK, OBJECTS], 'readwrite');
      const known = new Set(await change.objectStore(OBJECTS).getAllKeys());
      for (const object of objects)
        if (used.has(object.id) && !known.has(object.id)) void change.objectStore(OBJECTS).put(object);
      for (const id of known) if (!used.has(id as string)) void change.objectStore(OBJECTS).delete(id);
      void change.objectStore(WORK).put(work, KEY);
      await change.done;
    },
    async clear() {
      const change = db.transaction([WORK, OBJECTS], 'readwrite');
      void change.objectStore(WORK).clear();
      void change.objectStore(OBJECTS).clear();
      await change.done;
    },
  };
}
