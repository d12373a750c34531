import {beforeEach, describe, expect, test, vi} from 'vitest';
import {startHistory} from '../../src/design/history';
import type {Autosave, StoredWork, WorkSummary} from '../../src/state/autosave';
import {beatClaims, type Claims} from '../../src/state/claims';
import {stepped} from '../../src/state/last_change';
import {Works} from '../../src/state/works.svelte';

/** The database and the storage of one browser, and a tab of it at a time. */
class Browser {
  works = new Map<string, {summary: WorkSummary; work: StoredWork}>();
  stored = new Map<string, string>();
  session = new Map<string, string>();
  now = 1000;
  /** Works that there is room for. */
  room = Infinity;

  storage = (map: Map<string, string>) =>
    ({
      getItem: (key: string) => map.get(key) ?? null,
      setItem: (key: string, value: string) => map.set(key, value),
      removeItem: (key: string) => map.delete(key),
    }) as unknown as Storage;

  autosave: Autosave = {
    list: async () => [...this.works.values()].map(({summary}) => summary).sort((a, b) => b.saved - a.saved),
    load: async (id) => (this.works.has(id) ? {work: this.works.get(id)!.work, objects: []} : null),
    save: async (summary, work) => {
      if (!this.works.has(summary.id) && this.works.size >= this.room) throw new DOMException('full', 'QuotaExceededError');
      this.works.set(summary.id, {summary, work});
    },
    remove: async (id) => void this.works.delete(id),
  };

  claims = (): Claims => beatClaims(this.storage(this.stored), () => this.now);

  /** A fresh tab with something in it. */
  async tab(): Promise<{works: Works; id: string}> {
    this.session.clear();
    const works = new Works(this.autosave, this.claims());
    await works.begin();
    await this.save(works);
    return {works, id: this.session.get('snug-work')!};
  }

  async save(works: Works) {
    vi.setSystemTime(++this.now);
    await works.save({history: startHistory({design: {} as never, object: 'a'})}, [], null);
  }
}

let browser: Browser;

beforeEach(() => {
  vi.useFakeTimers();
  browser = new Browser();
  vi.stubGlobal('sessionStorage', browser.storage(browser.session));
  vi.stubGlobal('localStorage', browser.storage(browser.stored));
  return () => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  };
});

/** A tab that is gone, without a word. */
const crash = (id: string) => browser.stored.delete(`snug-work-${id}`);

describe('the works of a browser', () => {
  test('are kept up to ten that nobody has open; the oldest go, and never one that is open', async () => {
    const open = await browser.tab();
    for (let i = 0; i < 14; i++) crash((await browser.tab()).id);
    const last = await browser.tab();
    expect(last.works.waiting.length).toBe(10);
    expect(browser.works.has(open.id)).toBe(true);
    expect(browser.works.size).toBe(12);
    const oldest = Math.min(...last.works.waiting.map(({saved}) => saved));
    expect(last.works.waiting.filter(({saved}) => saved >= oldest).length).toBe(10);
  });

  test('make room for a new one where the browser has none, the oldest that waits first', async () => {
    const open = await browser.tab();
    const first = await browser.tab();
    const second = await browser.tab();
    crash(first.id);
    crash(second.id);
    browser.room = 3;
    const last = await browser.tab();
    expect([...browser.works.keys()].sort()).toEqual([open.id, second.id, last.id].sort());
    browser.room = 2;
    crash(last.id);
    await expect(browser.tab()).resolves.toBeTruthy();
    expect(browser.works.has(open.id)).toBe(true);
  });

  test('where only open works are left to go, the saving fails and they stay', async () => {
    const open = await browser.tab();
    browser.room = 1;
    await expect(browser.tab()).rejects.toThrow('full');
    expect([...browser.works.keys()]).toEqual([open.id]);
  });

  test('that another tab has open can neither be taken nor discarded', async () => {
    const open = await browser.tab();
    const other = await browser.tab();
    expect(await other.works.take(open.id)).toBe(false);
    await other.works.discard(open.id);
    expect(browser.works.has(open.id)).toBe(true);
    crash(open.id);
    expect(await other.works.take(open.id)).toBe(true);
    expect(browser.session.get('snug-work')).toBe(open.id);
    await other.works.look();
    expect(other.works.waiting.map(({id}) => id)).toEqual([other.id]);
  });

  test('come back to their own tab, and to a duplicate of it as a copy', async () => {
    const {id} = await browser.tab();
    const duplicate = new Works(browser.autosave, browser.claims());
    const begun = duplicate.begin();
    await vi.advanceTimersByTimeAsync(5000);
    expect(await begun).toBe(id);
    expect(browser.session.get('snug-work')).not.toBe(id);
    crash(browser.session.get('snug-work')!);
    crash(id);
    browser.session.set('snug-work', id);
    const reloaded = new Works(browser.autosave, browser.claims());
    expect(await reloaded.begin()).toBe(id);
    expect(browser.session.get('snug-work')).toBe(id);
  });
});

describe('the last change', () => {
  const design = (wall_mm: number) => ({space: {wall_mm}}) as never;
  const moments = [50, 60, 70].map((wall) => ({design: design(wall), object: 'a'}));
  const history = (at: number) => ({...startHistory(moments[0]!), moments, at});
  const save = (works: Works, at: number) => works.save({history: history(at)}, [], null);

  test('is noted before it is saved, and forgotten when it is', async () => {
    const {works, id} = await browser.tab();
    works.note({at: 2, moment: moments[2]!});
    await save(works, 1);
    expect((await works.load(id))?.last).toEqual({at: 2, moment: moments[2]});
    await save(works, 2);
    expect((await works.load(id))?.last).toBeNull();
  });

  test('of a work that was never saved is not noted, and goes with its work', async () => {
    const {works, id} = await browser.tab();
    await works.renew();
    works.note({at: 2, moment: moments[2]!});
    expect([...browser.stored.keys()].filter((key) => key.startsWith('snug-last-'))).toEqual([]);
    await works.take(id);
    await works.load(id);
    works.note({at: 2, moment: moments[2]!});
    await works.discardOwn();
    expect([...browser.stored.keys()].filter((key) => key.startsWith('snug-last-'))).toEqual([]);
  });

  test('is a step in the history where it has it', () => {
    expect(stepped(history(2), {at: 1, moment: moments[1]!}).at).toBe(1);
    expect(stepped(history(2), {at: 1, moment: {design: design(99), object: 'a'}}).at).toBe(2);
    expect(stepped(history(2), {at: 1, moment: {...moments[1]!, object: 'b'}}).at).toBe(2);
    expect(stepped(history(2), {at: 7, moment: moments[1]!}).at).toBe(2);
    expect(stepped(history(2), null).at).toBe(2);
  });
});

describe('claims without locks', () => {
  test('last as long as the tab says that it lives, and end with it', async () => {
    const [a, b] = [browser.claims(), browser.claims()];
    expect(await a.take('w')).toBe(true);
    expect(await b.take('w')).toBe(false);
    expect(await b.taken(['w', 'v'])).toEqual(new Set(['w']));
    expect(await b.whileFree('w', async () => {})).toBe(false);
    a.leave('w');
    expect(await b.whileFree('w', async () => {})).toBe(true);
    expect(await b.take('w')).toBe(true);
    browser.now += 200_000; // not heard of for long
    expect(await a.take('w')).toBe(true);
  });
});
