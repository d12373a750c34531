const MOST_MOMENTS = 500;
/** Changes of one control that follow each other within this time are one step back: a drag, a held key. */
const ONE_GESTURE_MS = 800;

/** Where a person has been: one line of moments, and the place in it that is shown. Plain data, so that it can be
 *  saved with the rest. */
export interface History<T> {
  readonly moments: readonly T[];
  readonly at: number;
  readonly control: string;
  readonly time: number;
}

export function startHistory<T>(first: T): History<T> {
  return {moments: [first], at: 0, control: '', time: -Infinity};
}

/** What was undone before is forgotten. `control`: what the person used; the same one soon again continues its
 *  own step. */
export function record<T>(history: History<T>, moment: T, control: string, time: number): History<T> {
  const continues = control !== '' && control === history.control && time - history.time < ONE_GESTURE_MS;
  const kept = history.moments.slice(0, continues ? history.at : history.at + 1);
  const moments = [...kept, moment].slice(-MOST_MOMENTS);
  return {moments, at: moments.length - 1, control, time};
}

export function canUndo(history: History<unknown>): boolean {
  return history.at > 0;
}

export function canRedo(history: History<unknown>): boolean {
  return history.at < history.moments.length - 1;
}

/** A step of -1 or +1; stays where there is nothing further. */
export function moved<T>(history: History<T>, by: -1 | 1): History<T> {
  const at = Math.min(Math.max(history.at + by, 0), history.moments.length - 1);
  return {...history, at, control: '', time: -Infinity};
}

export function present<T>(history: History<T>): T {
  return history.moments[history.at] as T;
}
