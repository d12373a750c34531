import {vi} from 'vitest';
import {createEngine} from '../../src/engine/engine';
import type {Studio} from '../../src/state/studio.svelte';
import {Cores} from './cores';

/** A browser's storage without a browser. */
export function memory(map = new Map<string, string>()): Storage {
  return {
    getItem: (key: string) => map.get(key) ?? null,
    setItem: (key: string, value: string) => void map.set(key, value),
    removeItem: (key: string) => void map.delete(key),
  } as unknown as Storage;
}

/** The page's work without the page: its library runs in this thread. */
export async function startStudio(): Promise<Studio> {
  vi.stubGlobal('localStorage', memory());
  vi.stubGlobal('navigator', {language: 'en'});
  const {Studio} = await import('../../src/state/studio.svelte');
  return Studio.start(await createEngine({startCore: new Cores().start}));
}
