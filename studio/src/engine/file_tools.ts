import type {Failure} from './api';
import {isFailure} from './failure';
import type {SceneTools} from './module';

/** The tools for one file: what the library asks for in the middle of reading it. */
export interface FileTools {
  readonly tools: SceneTools;
  /** Names of the files beside it that were asked for and are there. */
  readonly used: string[];
  /** Fetches what was asked for and not at hand, after which another try may go better; false where that was nothing. */
  fetchMissing(): Promise<boolean>;
}

/** What a reader makes of a file once all that it asks for is at hand. */
export async function readWith<Read>(box: FileTools, read: () => Read | Failure): Promise<Read | Failure> {
  let answer = read();
  while (isFailure(answer) && answer.kind === 'input' && (await box.fetchMissing())) answer = read();
  return answer;
}
