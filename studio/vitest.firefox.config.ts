import {defineConfig} from 'vitest/config';

/** Firefox takes its time, one at a time: `make soak`. */
export default defineConfig({
  test: {include: ['firefox/**/*.test.ts'], environment: 'node', testTimeout: 180_000, hookTimeout: 60_000, fileParallelism: false},
});
