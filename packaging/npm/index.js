import startModule from './snug.mjs';

export const createSnug = (wasmBinary) =>
  startModule(wasmBinary ? {wasmBinary} : {locateFile: () => new URL('./snug.wasm', import.meta.url).href});
