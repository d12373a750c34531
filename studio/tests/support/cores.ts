import type {Failure} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import type {CoreHandle} from '../../src/engine/worker_link';
import {startCore} from './snug';

/** Cores in this thread instead of workers, which notice what was started and ended. */
export class Cores {
  started: {core: EngineCore; ended: boolean}[] = [];

  start = (): CoreHandle => {
    const number = this.started.length;
    const ready = startCore().then((core) => (this.started[number]!.core = core));
    this.started.push({core: null as unknown as EngineCore, ended: false});
    let stop: (answer: Failure) => void = () => {};
    const stopped = new Promise<Failure>((resolve) => (stop = resolve));
    const core = new Proxy({} as EngineCore, {
      get: (_, name: keyof EngineCore) =>
        async (...args: unknown[]) => {
          const target = await ready;
          return (target[name] as (...args: unknown[]) => unknown).apply(target, args);
        },
    });
    const end = (answer: Failure) => {
      this.started[number]!.ended = true;
      stop(answer);
    };
    return {core, stopped, end};
  };
}
