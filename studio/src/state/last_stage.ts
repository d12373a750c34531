import type {Stage} from './first_level.svelte';
import {USUAL_WISHES, type Wishes} from './wishes';

// Where a tab stands on the first level, for when its page is loaded anew. The storage of a tab may be forbidden: then it
// stands where its work is.

export interface LastStage {
  stage: Stage | null;
  wishes: Wishes;
}

const KEY = 'snug-stage';

export function noteStage(last: LastStage): void {
  withTab((storage) => storage.setItem(KEY, JSON.stringify(last)));
}

export function notedStage(): LastStage | null {
  const noted = withTab((storage) => JSON.parse(storage.getItem(KEY) ?? 'null') as LastStage | null);
  return noted ? {...noted, wishes: {...USUAL_WISHES, ...noted.wishes}} : null;
}

export function forgetStage(): void {
  withTab((storage) => storage.removeItem(KEY));
}

function withTab<T>(use: (storage: Storage) => T): T | null {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}
