import type {Pair} from '../words/words';
import type {Studio} from './studio.svelte';

/** A field takes a number by itself, or says why not. */
export function refuseNumber(studio: Studio, why: Pair | null): void {
  if (why) studio.refuse('number', why);
  else if (studio.problem?.control === 'number') studio.problem = null;
}
