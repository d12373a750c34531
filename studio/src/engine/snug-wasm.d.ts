// What wasm/ builds.

declare module 'snug-wasm/snug.mjs' {
  import type {SnugModule} from './module';

  export default function createSnug(options: {
    wasmBinary?: Uint8Array;
    locateFile?: (path: string) => string;
  }): Promise<SnugModule>;
}
