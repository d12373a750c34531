import {fileURLToPath} from 'node:url';
import {svelte} from '@sveltejs/vite-plugin-svelte';
import {defineConfig} from 'vitest/config';
import {indexWords} from './index_words.ts';
import {licenseFile, licenses} from './licenses.ts';
import {oneFile} from './one_file.ts';
import {serviceWorker} from './service_worker.ts';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** For a static host. */
const FOLDER = {
  plugins: [
    indexWords(true),
    serviceWorker(here('./src/service_worker.js'), ['icon.svg', 'manifest.webmanifest']),
    licenseFile(licenses(here('.'))),
  ],
  alias: [],
  build: {outDir: 'dist'},
};
/** For a disk: `vite build --mode one-file`. */
const ONE_FILE = {
  plugins: [indexWords(false), oneFile({name: 'snug-studio.html', icon: here('./public/icon.svg'), licenses: licenses(here('.'))})],
  alias: [{find: './start_worker', replacement: here('./src/start_worker_inside.ts')}],
  build: {
    outDir: '../build/one-file',
    // Nothing stays beside it.
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    copyPublicDir: false,
    cssCodeSplit: false,
    modulePreload: false as const,
    rolldownOptions: {output: {codeSplitting: false}},
  },
};

export default defineConfig(({mode}) => {
  const {plugins, alias, build} = mode === 'one-file' ? ONE_FILE : FOLDER;
  return {
    // Relative addresses: the studio works from any folder of any static host.
    base: './',
    plugins: [svelte(), ...plugins],
    resolve: {
      // The library as WebAssembly, where `cmake --build --preset wasm` leaves it.
      alias: [{find: 'snug-wasm', replacement: here('../build/wasm')}, ...alias],
      // Component tests want Svelte's browser build.
      ...(process.env.VITEST ? {conditions: ['browser']} : {}),
    },
    // In the one file the worker is a text, whose parts cannot lie beside it.
    worker: mode === 'one-file' ? {format: 'iife', rolldownOptions: {output: {codeSplitting: false}}} : {format: 'es'},
    build: {target: 'es2022', emptyOutDir: true, chunkSizeWarningLimit: 1500, ...build},
    server: {fs: {allow: [here('.'), here('../build/wasm')]}},
    test: {include: ['tests/**/*.test.ts'], environment: 'node', testTimeout: 60_000},
  };
});
