import {expose, transfer} from 'comlink';
import createSnug from 'snug-wasm/snug.mjs';
import wasmUrl from 'snug-wasm/snug.wasm?url';
import {EngineCore} from './core';

// Calls may arrive before the module is there, and a worker that awaits at its top level would lose them: so
// what is exposed waits by itself.
const core = createSnug({locateFile: () => wasmUrl}).then((snug) => new EngineCore(snug));

/** The buffers of the typed arrays in an answer, which are all fresh copies: they move instead of being copied
 *  once more. */
function buffersOf(answer: unknown): ArrayBuffer[] {
  if (typeof answer !== 'object' || answer === null) return [];
  return Object.values(answer).flatMap((value: unknown) => {
    if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
    return Array.isArray(answer) ? buffersOf(value) : [];
  });
}

const service = new Proxy({} as EngineCore, {
  get: (_, name: keyof EngineCore) =>
    async (...args: unknown[]) => {
      const engine = await core;
      const answer: unknown = await (engine[name] as (...args: unknown[]) => unknown).apply(engine, args);
      return typeof answer === 'object' && answer !== null ? transfer(answer, buffersOf(answer)) : answer;
    },
});

expose(service);
