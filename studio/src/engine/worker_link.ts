import {expose, transfer, wrap} from 'comlink';
import {failures} from '../words/failures';
import type {Failure} from './api';
import type {EngineCore} from './core';
import {brokenModule} from './failure';

/** A core somewhere else, as a rule in a worker. */
export interface CoreHandle {
  core: Pick<EngineCore, keyof EngineCore>;
  /** Resolves when the core stopped by itself or was ended: calls that still wait get this answer. */
  stopped: Promise<Failure>;
  /** Stops it at once, whatever it is doing. */
  end(answer: Failure): void;
}

/** On the page: the core that a worker serves. */
export function coreIn(worker: Worker): CoreHandle {
  let stop: (answer: Failure) => void = () => {};
  const stopped = new Promise<Failure>((resolve) => (stop = resolve));
  worker.addEventListener('error', (event) => stop(brokenModule(event.message || failures.failures.worker[0])));
  const end = (answer: Failure) => {
    worker.terminate();
    stop(answer);
  };
  return {core: wrap(worker) as unknown as CoreHandle['core'], stopped, end};
}

/** In a worker: answers the page. Calls may arrive before the core is there, and a worker that awaits it at its top level
 *  would lose them: so what is exposed waits by itself. */
export function serve(core: Promise<EngineCore>): void {
  const service = new Proxy({} as EngineCore, {
    get: (_, name: keyof EngineCore) =>
      async (...args: unknown[]) => {
        const engine = await core;
        const answer: unknown = await (engine[name] as (...args: unknown[]) => unknown).apply(engine, args);
        return typeof answer === 'object' && answer !== null ? transfer(answer, buffersOf(answer)) : answer;
      },
  });
  expose(service);
}

/** The buffers of the typed arrays in an answer, which are all fresh copies: they move instead of being copied
 *  once more. */
function buffersOf(answer: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(answer)) return [answer.buffer as ArrayBuffer];
  return typeof answer === 'object' && answer !== null ? Object.values(answer).flatMap(buffersOf) : [];
}
