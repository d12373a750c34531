import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import createSnug from 'snug-wasm/snug.mjs';
import {CORE_PARTS} from '../../src/core_parts';
import type {Failure} from '../../src/engine/api';
import {EngineCore} from '../../src/engine/core';
import {isFailure} from '../../src/engine/failure';

const wasmBinary = readFileSync(fileURLToPath(new URL('../../../build/wasm/snug.wasm', import.meta.url)));

/** The real library, as make build leaves it. */
export async function startCore(): Promise<EngineCore> {
  return new EngineCore(await createSnug({wasmBinary}), CORE_PARTS);
}

/** The answer, which must be none of the library's refusals. */
export function good<T>(answer: T | Failure): T {
  if (isFailure(answer)) throw new Error(`${answer.kind}: ${answer.error[0]}`);
  return answer;
}

/** Why there is no answer, in English. */
export function refused(answer: unknown): {kind: Failure['kind']; error: string; japanese: string} {
  if (!isFailure(answer)) throw new Error(`no failure: ${JSON.stringify(answer).slice(0, 200)}`);
  const [error, japanese] = answer.error;
  return {kind: answer.kind, error, japanese};
}
