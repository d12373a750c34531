import {present, type History} from '../design/history';
import {withStorage} from '../words/remembered';
import {asMoment, type StoredMoment} from './autosave';

// The browser's database takes its time, and a page that goes away has none. So the last change of a work is noted at
// once, in few bytes, until the database has it.

/** What was on the screen, and which moment of the history that was. */
export interface LastChange {
  at: number;
  moment: StoredMoment;
}

const PREFIX = 'snug-last-';

export function noteChange(work: string, change: LastChange): void {
  withStorage((storage) => storage.setItem(PREFIX + work, JSON.stringify(change)));
}

export function notedChange(work: string): LastChange | null {
  // It may be what nobody can read; then only the database keeps the work.
  return withStorage((storage) => JSON.parse(storage.getItem(PREFIX + work) ?? 'null') as LastChange | null) ?? null;
}

export function forgetChange(work: string): void {
  withStorage((storage) => storage.removeItem(PREFIX + work));
}

/** The history has it, as what is on the screen. */
export function isKept(change: LastChange, history: History<StoredMoment>): boolean {
  return change.at === history.at && same(change.moment, present(history));
}

/** A step back or forth that was noted is made again; any other change is none of the history's moments. */
export function stepped<T extends StoredMoment>(history: History<T>, noted: LastChange | null): History<T> {
  const moment = noted && history.moments[noted.at];
  return moment && same(moment, noted.moment) ? {...history, at: noted.at} : history;
}

function same(a: StoredMoment, b: StoredMoment): boolean {
  return JSON.stringify(asMoment(a)) === JSON.stringify(asMoment(b));
}
