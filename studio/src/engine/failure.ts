import {failures} from '../words/failures';
import type {Pair} from '../words/words';
import type {Failure} from './api';

const said = failures.failures;

export function isFailure(answer: unknown): answer is Failure {
  return typeof answer === 'object' && answer !== null && 'error' in answer && 'kind' in answer;
}

export function failure(kind: Failure['kind'], error: Pair): Failure {
  return {error, kind};
}

export const CANCELLED = failure('cancelled', said.cancelled);

/** What a stopped WebAssembly module means for the person. After either the module cannot be used again. */
export function brokenModule(reason: unknown): Failure {
  const message = reason instanceof Error ? reason.message : String(reason);
  // The module is built to abort where memory cannot grow; the browser refuses large arrays with a RangeError.
  const outOfMemory = reason instanceof RangeError || /^Aborted|memory|allocation/i.test(message);
  return failure('memory', outOfMemory ? said.noMemory : said.stopped(message));
}
