import {newId} from '../engine/new_id';

// Which works are open in which tab of this browser. A tab that is closed, or crashes, lets go by itself.

export interface Claims {
  /** Makes this tab the one that has the work open. False where another has it, and still has it after `wait_ms`:
   *  a page that is being loaded anew may meet what is left of itself. */
  take(id: string, wait_ms?: number): Promise<boolean>;
  leave(id: string): void;
  /** Runs while no tab has the work open, and none can open it; false where one has. */
  whileFree(id: string, run: () => Promise<void>): Promise<boolean>;
  /** Those of the works that some tab has open. */
  taken(ids: readonly string[]): Promise<Set<string>>;
}

const PREFIX = 'snug-work-';

export function openClaims(): Claims {
  const locks = navigator.locks as LockManager | undefined;
  return locks ? lockClaims(locks) : beatClaims(localStorage);
}

export function lockClaims(locks: LockManager): Claims {
  const held = new Map<string, () => void>();
  return {
    take(id, wait_ms = 0) {
      if (held.has(id)) return Promise.resolve(true);
      return new Promise((resolve) => {
        const options = wait_ms > 0 ? {signal: AbortSignal.timeout(wait_ms)} : {ifAvailable: true};
        const hold = (lock: Lock | null) => {
          resolve(lock !== null);
          return lock ? new Promise<void>((leave) => held.set(id, leave)) : undefined;
        };
        locks.request(PREFIX + id, options, hold).catch(() => resolve(false));
      });
    },
    leave(id) {
      held.get(id)?.();
      held.delete(id);
    },
    whileFree(id, run) {
      return locks.request(PREFIX + id, {ifAvailable: true}, async (lock) => {
        if (lock) await run();
        return lock !== null;
      });
    },
    async taken(ids) {
      const names = new Set((await locks.query()).held?.map(({name}) => name));
      return new Set(ids.filter((id) => names.has(PREFIX + id)));
    },
  };
}

const BEAT_MS = 5_000;
/** Browsers let the timers of hidden tabs run once a minute. */
const ALIVE_MS = 150_000;
const LOOK_AGAIN_MS = 50;

/** Where there are no locks, as on pages that are not served securely: every tab says again and again that it lives. */
export function beatClaims(storage: Storage, now = () => Date.now()): Claims {
  const tab = newId();
  const beats = new Map<string, ReturnType<typeof setInterval>>();
  const beat = (id: string) => storage.setItem(PREFIX + id, JSON.stringify([tab, now()]));
  const ofAnother = (id: string): boolean => {
    const [owner, at] = JSON.parse(storage.getItem(PREFIX + id) ?? '["", 0]') as [string, number];
    return owner !== '' && owner !== tab && now() - at < ALIVE_MS;
  };
  const claims: Claims = {
    async take(id, wait_ms = 0) {
      for (let waited = 0; ofAnother(id); waited += LOOK_AGAIN_MS) {
        if (waited >= wait_ms) return false;
        await new Promise((resolve) => setTimeout(resolve, LOOK_AGAIN_MS));
      }
      beat(id);
      clearInterval(beats.get(id));
      beats.set(id, setInterval(() => beat(id), BEAT_MS));
      return true;
    },
    leave(id) {
      if (!beats.has(id)) return;
      clearInterval(beats.get(id));
      beats.delete(id);
      storage.removeItem(PREFIX + id);
    },
    async whileFree(id, run) {
      if (beats.has(id) || !(await claims.take(id))) return false;
      await run();
      claims.leave(id);
      return true;
    },
    taken: (ids) => Promise.resolve(new Set(ids.filter((id) => beats.has(id) || ofAnother(id)))),
  };
  globalThis.addEventListener?.('pagehide', () => [...beats.keys()].forEach(claims.leave));
  return claims;
}
