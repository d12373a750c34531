import type {Picture} from '../picture/thumbnail';
import {openAutosave, summaryOf, type Autosave, type AutosaveNews, type StoredObject, type StoredWork, type WorkSummary} from './autosave';
import {openClaims, type Claims} from './claims';
import {newId} from '../engine/new_id';
import {forgetChange, isKept, noteChange, notedChange, type LastChange} from './last_change';

/** Works that are kept beside those that a tab has open. */
const MOST_WORKS = 10;
/** For what is left of this page where it is loaded anew. */
const RELOAD_MS = 1000;
const OWN = 'snug-work';

/** The works of this browser, and the one that belongs to this tab. */
export class Works {
  /** What no tab has open, the newest first: works that can be continued. */
  waiting: WorkSummary[] = $state.raw([]);
  readonly #autosave: Autosave;
  readonly #claims: Claims;
  #own = '';
  /** The one that the database has of this tab. */
  #saved = '';
  /** What no tab has open, with and without an object. */
  #free: WorkSummary[] = [];

  constructor(autosave: Autosave, claims: Claims) {
    this.#autosave = autosave;
    this.#claims = claims;
  }

  static async open(news: AutosaveNews): Promise<Works> {
    return new Works(await openAutosave(news), openClaims());
  }

  /** Finds this tab's work. Returns the id of what it continues: its own from before a reload, or, in the duplicate of
   *  another tab, a copy of what that one had saved; null in a fresh tab. */
  async begin(): Promise<string | null> {
    const before = sessionStorage.getItem(OWN);
    if (before && (await this.#claims.take(before, RELOAD_MS))) this.#own = before;
    else await this.renew();
    await this.look();
    return before;
  }

  /** Lets go of this tab's work, which stays as it was saved, and begins another. */
  async renew(): Promise<void> {
    await this.#becomes(newId());
  }

  /** Makes a waiting work this tab's own. False where another tab has it by now. */
  async take(id: string): Promise<boolean> {
    const mine = await this.#becomes(id);
    await this.look();
    return mine;
  }

  /** `last`: the change that came too late to be saved. */
  async load(id: string): Promise<{work: StoredWork; objects: StoredObject[]; last: LastChange | null} | null> {
    const found = await this.#autosave.load(id);
    if (found) this.#saved = id;
    return found && {...found, last: notedChange(id)};
  }

  /** Notes at once what will be saved. Of a work that was never saved there is nothing to come back to. */
  note(change: LastChange): void {
    if (this.#saved === this.#own) noteChange(this.#own, change);
  }

  /** Saves this tab's work; where the browser has no room left, works that wait go first, the oldest ones. */
  async save(work: StoredWork, objects: readonly StoredObject[], picture: Picture | null): Promise<void> {
    const summary = summaryOf(this.#own, work, objects, Date.now(), picture);
    for (;;) {
      try {
        await this.#autosave.save(summary, work, objects);
        this.#isSaved(summary.id, work);
        break;
      } catch (reason) {
        const full = reason instanceof DOMException && reason.name === 'QuotaExceededError';
        if (!full || !(await this.#dropBeyond(this.#free.length - 1))) throw reason;
      }
    }
    await this.#dropBeyond(MOST_WORKS);
  }

  #isSaved(id: string, {history}: StoredWork) {
    this.#saved = id;
    // What came after it is saved next.
    const last = notedChange(id);
    if (last && isKept(last, history)) forgetChange(id);
  }

  /** Forgets a work that no tab has open; one that another tab has stays. */
  async discard(id: string): Promise<void> {
    await this.#claims.whileFree(id, () => this.#forget(id));
    await this.look();
  }

  async discardOwn(): Promise<void> {
    await this.#forget(this.#own);
  }

  async #forget(id: string): Promise<void> {
    forgetChange(id);
    await this.#autosave.remove(id);
  }

  /** Looks again at what is waiting. */
  async look(): Promise<void> {
    const all = await this.#autosave.list();
    const taken = await this.#claims.taken(all.map(({id}) => id));
    this.#free = all.filter(({id}) => id !== this.#own && !taken.has(id));
    this.waiting = this.#free.filter(({objects}) => objects.length > 0);
  }

  async #becomes(id: string): Promise<boolean> {
    if (!(await this.#claims.take(id))) return false;
    if (this.#own && this.#own !== id) this.#claims.leave(this.#own);
    this.#own = id;
    sessionStorage.setItem(OWN, id);
    return true;
  }

  /** Whether anything went. */
  async #dropBeyond(count: number): Promise<boolean> {
    await this.look();
    const before = this.#free.length;
    for (const {id} of this.#free.slice(Math.max(count, 0))) await this.discard(id);
    return this.#free.length < before;
  }
}
