// What the browser remembers of a person's choices. Storage may be forbidden, or full: then it remembers nothing, and all else
// works.

export function remembered(key: string): string | null {
  return withStorage((storage) => storage.getItem(key)) ?? null;
}

/** False where it cannot. */
export function remember(key: string, value: string): boolean {
  return withStorage((storage) => {
    storage.setItem(key, value);
    return true;
  }) ?? false;
}

export function withStorage<T>(use: (storage: Storage) => T): T | undefined {
  try {
    return use(localStorage);
  } catch {
    return undefined;
  }
}
