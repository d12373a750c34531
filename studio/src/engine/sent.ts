import type {Design} from '../design/design';
import type {ObjectUse} from '../design/moment';
import type {BesideFile, Failure, ObjectInfo} from './api';
import {isFailure} from './failure';
import type {CoreHandle} from './worker_link';

// What goes to a core in its worker.

export type Objects = readonly ObjectUse[] | undefined;

/** What a new core needs of an object. A Blob lies outside the page's memory. */
export interface Kept {
  id: string;
  name: string;
  content: Blob;
  options: Design['object'];
  beside: readonly BesideFile[];
}

/** What came of the last one; of the first that failed. */
export async function loadAgain(core: CoreHandle['core'], kept: readonly Kept[]): Promise<ObjectInfo | Failure | null> {
  let answer: ObjectInfo | Failure | null = null;
  for (const {id, name, content, options, beside} of kept) {
    answer = await core.load(name, content, options, beside, {id, joins: true});
    if (isFailure(answer)) break;
  }
  return answer;
}

/** As it is now, and as a plain value: a page's reactive state cannot be sent to a worker. */
export function copied<T>(value: T): T {
  return JSON.parse(JSON.stringify(value)) as T;
}

export function sent(design: Design, objects: Objects): [Design, Objects] {
  return [copied(design), objects && copied(objects)];
}
