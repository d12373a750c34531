import {readFile} from 'node:fs/promises';
import startModule from './snug.mjs';

// Node's fetch() reads no files.
export const createSnug = async (wasmBinary) =>
  startModule({wasmBinary: wasmBinary ?? (await readFile(new URL('./snug.wasm', import.meta.url)))});
