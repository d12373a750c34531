import {fileURLToPath} from 'node:url';
import {svelte} from '@sveltejs/vite-plugin-svelte';
import {defineConfig} from 'vitest/config';
import {indexWords} from './index_words.ts';
import {serviceWorker} from './service_worker.ts';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  // Relative addresses: the studio works from any folder of any static host.
  base: './',
  plugins: [svelte(), indexWords(), serviceWorker(here('./src/service_worker.js'), ['icon.svg', 'manifest.webmanifest'])],
  resolve: {
    // The library as WebAssembly, where `cmake --build --preset wasm` leaves it.
    alias: {'snug-wasm': here('../build/wasm')},
    // Component tests want Svelte's browser build.
    ...(process.env.VITEST ? {conditions: ['browser']} : {}),
  },
  worker: {format: 'es'},
  build: {target: 'es2022', outDir: 'dist', emptyOutDir: true, chunkSizeWarningLimit: 1500},
  server: {fs: {allow: [here('.'), here('../build/wasm')]}},
  test: {include: ['tests/**/*.test.ts'], environment: 'node', testTimeout: 60_000},
});
