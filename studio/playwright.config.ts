import {defineConfig} from '@playwright/test';

// Another one where two checkouts are tested at once.
const PORT = Number(process.env.SNUG_E2E_PORT ?? 4719);

const LAUNCH = {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: [
    '--no-sandbox',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--no-first-run',
  ],
};

// A software renderer's time goes to pictures: the page is put together without one, and the camera jumps, but for the
// tests that look at how it moves.
const FEW_PICTURES = {
  contextOptions: {reducedMotion: 'reduce' as const},
  launchOptions: {...LAUNCH, args: [...LAUNCH.args, '--disable-gpu', '--enable-unsafe-swiftshader']},
};

export default defineConfig({
  projects: [
    {name: 'tests', testDir: 'e2e', use: FEW_PICTURES},
    {name: 'everywhere', testDir: 'everywhere', timeout: 300_000, use: FEW_PICTURES},
    {name: 'bench', testDir: 'bench', testMatch: '*.bench.ts'},
    {name: 'pictures', testDir: 'pictures', testMatch: '*.pictures.ts'},
  ],
  outputDir: '../build/e2e',
  timeout: 120_000,
  expect: {timeout: 15_000},
  // The software renderer needs the cores for itself.
  workers: 1,
  // A machine that other work slows down at the wrong moment; what passes at the second time only is named as flaky.
  retries: 1,
  reporter: 'list',
  use: {
    baseURL: `http://127.0.0.1:${PORT}/`,
    viewport: {width: 1280, height: 800},
    locale: 'en-GB',
    launchOptions: LAUNCH,
  },
  webServer: {
    command: `npx vite preview --host 127.0.0.1 --port ${PORT} --strictPort`,
    url: `http://127.0.0.1:${PORT}/`,
    reuseExistingServer: false,
  },
});
