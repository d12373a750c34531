const MOST_MOMENTS = 500;
const ONE_GESTURE_MS = 800;

/** Where a person has been: one line of moments, and the place in it that is shown. Plain data, so that it can be
 *  saved with the rest. */
export interface History<T> {
  readonly moments: readonly T[];
  readonly at: number;
  /** That the last moment belongs to; a change of the same step takes its place. */
  readonly step: string;
}

/** Names the step back that a change belongs to: changes of one control that follow each other soon are one, a drag or a
 *  held key, however long their foams take. */
export class Gestures {
  #control = '';
  #heard = -Infinity;
  #count = 0;

  /** `control`: what the person used, none if empty; `time` in ms. */
  step(control: string, time: number): string {
    if (control !== this.#control || time - this.#heard >= ONE_GESTURE_MS) this.#count++;
    [this.#control, this.#heard] = [control, time];
    return control && `${control} ${this.#count}`;
  }
}

export function startHistory<T>(first: T): History<T> {
  return {moments: [first], at: 0, step: ''};
}

/** What was undone before is forgotten. `step`: of Gestures; none if empty. */
export function record<T>(history: History<T>, moment: T, step: string): History<T> {
  const continues = step !== '' && step === history.step;
  const kept = history.moments.slice(0, continues ? history.at : history.at + 1);
  const moments = [...kept, moment].slice(-MOST_MOMENTS);
  return {moments, at: moments.length - 1, step};
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
  return {...history, at, step: ''};
}

export function present<T>(history: History<T>): T {
  return history.moments[history.at] as T;
}
