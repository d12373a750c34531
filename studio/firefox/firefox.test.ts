import {mkdtempSync, readdirSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import puppeteer, {type Browser, type Page} from 'puppeteer-core';
import {preview, type PreviewServer} from 'vite';
import {afterAll, beforeAll, expect, test} from 'vitest';
import {made, sample} from '../e2e/support/command_line';

// Firefox, with and without the 3D view, from a host and from a disk: from the empty page to exported foams that are the
// command line's.

const EXECUTABLE = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
const ONE_FILE = new URL('../../build/one-file/snug-studio.html?level=all', import.meta.url).href;
const WAIT = {timeout: 60_000};

let server: PreviewServer;
beforeAll(async () => {
  server = await preview({root: fileURLToPath(new URL('..', import.meta.url)), preview: {host: '127.0.0.1', port: 4727}});
});
afterAll(() => server.close());

async function withFirefox(folder: string, webgl: boolean, run: (page: Page, browser: Browser) => Promise<void>) {
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: EXECUTABLE,
    extraPrefsFirefox: {
      'webgl.disabled': !webgl,
      'browser.download.folderList': 2,
      'browser.download.dir': folder,
      'browser.download.useDownloadDir': true,
      'browser.download.always_ask_before_handling_new_types': false,
    },
  });
  try {
    await run(await browser.newPage(), browser);
  } finally {
    await browser.close();
  }
}

async function foamsExported(address: string, webgl: boolean) {
  const vase = sample('vase');
  const expected = made(vase, '--blocks', 'auto');
  const folder = mkdtempSync(join(tmpdir(), 'snug-firefox-'));
  try {
    await withFirefox(folder, webgl, async (page) => {
      const errors: string[] = [];
      page.on('pageerror', (error) => errors.push(String(error)));
      await page.goto(address);
      const input = await page.waitForSelector('input[type=file]', WAIT);
      await input!.uploadFile(vase);
      await page.waitForSelector('[role=status][data-fill^="0."]', WAIT);
      expect(await page.$$eval('canvas', (all) => all.length)).toBeGreaterThan(0);
      await page.evaluate(() => {
        const labelled = (words: RegExp) => [...document.querySelectorAll('label')].find((label) => words.test(label.textContent ?? ''));
        labelled(/foams as STL/)?.click();
        const button = [...document.querySelectorAll('button')].find((one) => one.textContent?.trim() === 'Export');
        button?.click();
      });
      for (const name of ['lower.stl', 'upper.stl'])
        await expect
          .poll(() => (readdirSync(folder).includes(name) ? readFileSync(join(folder, name)).equals(expected.get(name)!) : null), WAIT)
          .toBe(true);
      expect(errors).toEqual([]);
    });
  } finally {
    rmSync(folder, {recursive: true});
  }
}

test.each([true, false])('from a host, with a 3D view: %s', (webgl) => foamsExported('http://127.0.0.1:4727/?level=all', webgl));
test.each([true, false])('the one file, with a 3D view: %s', (webgl) => foamsExported(ONE_FILE, webgl));
