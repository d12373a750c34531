import type {SnugModule} from './types/engine/module.js';

export type * from './types/engine/api.js';
export type * from './types/engine/module.js';
export type {Design} from './types/design/design.js';

/** Starts the library. It keeps nothing beside what a `Session` holds, so one is enough for a thread. `wasmBinary`: the content
 *  of snug.wasm, where it does not lie beside the program. */
export function createSnug(wasmBinary?: Uint8Array): Promise<SnugModule>;
