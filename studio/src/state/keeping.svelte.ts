import type {Design, Triple} from '../design/design';
import {completed} from '../design/edit';
import {present, type History} from '../design/history';
import type {Moment} from '../design/moment';
import type {DisplayMesh, Failure} from '../engine/api';
import {thumbnail, together, type Picture} from '../picture/thumbnail';
import {files} from '../words/files';
import {asMoment, type StoredMoment, type StoredObject} from './autosave';
import {stepped} from './last_change';
import {forgetStage} from './last_stage';
import type {Studio} from './studio.svelte';
import type {Works} from './works.svelte';

const SAVE_MS = 250;
/** In pixels, and the colour of the object in it. */
const PICTURE_SIZE = 96;
const PICTURE_COLOR = [214, 200, 170];

/** What the studio gives, and does with what comes back. */
interface Parts {
  history(): History<Moment>;
  /** False, and everything as it was, where its present cannot be shown. */
  becomes(history: History<Moment>): Promise<boolean>;
  checked(design: Design): Promise<Failure | null>;
}

/** Keeps the work of a tab in the browser, and brings it back. */
export class Keeping {
  readonly #studio: Studio;
  readonly #objects: Map<string, StoredObject>;
  readonly #parts: Parts;
  /** Nothing is saved while what was saved is not back yet, or shall be forgotten. */
  #on = true;
  #saving: ReturnType<typeof setTimeout> | undefined;
  #picture: {meshes: DisplayMesh[]; of: string; picture: Picture} | null = null;

  constructor(studio: Studio, objects: Map<string, StoredObject>, parts: Parts) {
    this.#studio = studio;
    this.#objects = objects;
    this.#parts = parts;
  }

  /** Keeps what is on the page from now on; what was there before waits. */
  async in(works: Works): Promise<void> {
    this.#studio.works = works;
    await works.begin();
    await works.renew();
    await works.look();
    await this.saveNow();
  }

  /** Brings back what this tab had before it was loaded anew; where a person opened something else meanwhile, that stays and the
   *  other waits. */
  async restore(works: Works): Promise<void> {
    this.#on = false;
    this.#studio.works = works;
    const id = await works.begin();
    if (id && (this.#opened || !(await this.#resume(id, () => this.#opened)))) await works.renew();
    await works.look();
    this.#on = true;
    if (this.#opened) this.saveSoon();
  }

  get #opened(): boolean {
    return this.#studio.object !== null || this.#studio.busy?.work === 'read';
  }

  /** Goes on with a work that no tab has open; this tab's own stays as it was saved. */
  async resume(id: string): Promise<void> {
    const works = this.#studio.works;
    if (!works) return;
    await this.saveNow();
    this.#on = false;
    if (!(await works.take(id))) this.#studio.notice = files.works.elsewhere;
    else if (!(await this.#resume(id))) await works.renew();
    await works.look();
    this.#on = true;
  }

  /** False where nothing came back; then what was saved stays as it is. */
  async #resume(id: string, tooLate = () => false): Promise<boolean> {
    const saved = await this.#studio.works?.load(id);
    if (!saved) return true;
    for (const object of saved.objects) this.#objects.set(object.id, object);
    // Designs of another version may say less, or other things, than this one's.
    const whole = (at: StoredMoment): Moment => {
      const moment = asMoment(at);
      return {...moment, design: completed(moment.design, this.#studio.defaults)};
    };
    const last = saved.last && {...saved.last, moment: whole(saved.last.moment)};
    const moments = saved.work.history.moments.map(whole);
    const history = stepped({moments, at: saved.work.history.at, step: ''}, last);
    const checked = await this.#parts.checked(present(history).design);
    if (checked) {
      this.#studio.refuse('object', files.works.broken(checked.error));
      return false;
    }
    if (tooLate() || !(await this.#parts.becomes(history))) return false;
    // Made again like any change, which may be refused.
    if (last && sameObjects(last.moment, present(history))) this.#studio.becomes(last.moment, '');
    return true;
  }

  /** What is on the page, saved or not; of a search, what it began with. */
  note(): void {
    if (!this.#on || this.#studio.busy?.work === 'search') return;
    const {moment, works} = this.#studio;
    works?.note({at: this.#parts.history().at, moment});
  }

  /** Forgets everything of this tab, on the screen and in the browser. */
  async clear(): Promise<void> {
    this.#on = false;
    document.body.inert = true; // what came in now would be lost with the page
    forgetStage();
    await this.#studio.works?.discardOwn();
    location.reload();
  }

  async saveNow(): Promise<void> {
    clearTimeout(this.#saving);
    // A page on which nothing happened is no work.
    if (!this.#on || !this.#studio.works || this.#parts.history().moments.length < 2) return;
    const work = {history: $state.snapshot(this.#parts.history())};
    const saved = this.#studio.works.save(work, [...this.#objects.values()], this.#drawn());
    await saved.catch((reason: unknown) => this.#refuse(reason));
  }

  /** The objects as they lie, small. */
  #drawn(): Picture | null {
    const {placed, design} = this.#studio;
    const [first] = placed;
    if (!first) return null;
    // One by itself also where there is no room for it.
    const turn: Triple = placed.length === 1 ? design.placement.rotation_deg : [0, 0, 0];
    const of = JSON.stringify([turn, placed.length === 1 || placed.map(({placement}) => placement)]);
    const meshes = placed.map(({meshes: {moving}}) => moving);
    const {meshes: last = [], of: lastOf = ''} = this.#picture ?? {};
    if (of !== lastOf || meshes.length !== last.length || meshes.some((mesh, i) => mesh !== last[i])) {
      const mesh = placed.length === 1 ? meshes[0]! : together(placed.map(({placement}, i) => ({mesh: meshes[i]!, placement})));
      this.#picture = {meshes, of, picture: thumbnail(mesh, turn, PICTURE_SIZE, PICTURE_COLOR)};
    }
    return this.#picture?.picture ?? null;
  }

  saveSoon() {
    this.note();
    clearTimeout(this.#saving);
    this.#saving = setTimeout(() => void this.saveNow(), SAVE_MS);
  }

  #refuse(reason: unknown) {
    this.#studio.notice = files.works.cannotKeep(reason instanceof Error ? reason.message : String(reason));
  }
}

function sameObjects(a: Moment, b: Moment): boolean {
  return String(a.objects.map(({id}) => id)) === String(b.objects.map(({id}) => id));
}
