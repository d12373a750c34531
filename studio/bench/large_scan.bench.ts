import {execFileSync} from 'node:child_process';
import {readdirSync, readFileSync, rmSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {folder, made, snug} from '../e2e/support/command_line';
import {expect, open, set, status, test} from '../e2e/support/studio';

// A scan of 150 MB in the page: opened, turned and exported, and what that takes. A scan of more than the page takes:
// the sentence, and the command line in it.

const LARGE_SCAN = fileURLToPath(new URL('../../build/bench/snug_large_scan', import.meta.url));
const EXPORTED_WITHIN_MS = 240_000;

function scan(name: string, triangles: number): string {
  const path = join(folder(), name);
  execFileSync(LARGE_SCAN, [path, String(triangles)]);
  return path;
}

/** The resident memory of all that this process started (pages shared by several are counted once), in MB. */
function memoryOfBrowser(): number {
  const parents = new Map<number, number>();
  for (const entry of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      const fields = readFileSync(`/proc/${entry}/stat`, 'utf8').split(') ').at(-1)?.split(' ') ?? [];
      parents.set(Number(entry), Number(fields[1]));
    } catch {
      // It has ended since.
    }
  }
  const mine = (id: number): boolean => id > 1 && (parents.get(id) === process.pid || mine(parents.get(id) ?? 0));
  let kilobytes = 0;
  for (const id of [...parents.keys()].filter(mine)) {
    try {
      kilobytes += Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${id}/smaps_rollup`, 'utf8'))?.[1] ?? 0);
    } catch {
      // It has ended since.
    }
  }
  return kilobytes / 1000;
}

const line = (text: string, milliseconds?: number) => {
  const took = milliseconds === undefined ? ' '.repeat(10) : `${milliseconds.toFixed(0).padStart(7)} ms`;
  console.log(`${text.padEnd(46)}${took} ${memoryOfBrowser().toFixed(0).padStart(6)} MB of memory`);
};

test('a scan of 150 MB', async ({studio: page}) => {
  test.setTimeout(600_000);
  const path = scan('scan.stl', 3_000_000);
  line('a page without an object');

  let start = performance.now();
  await open(page, path);
  line(`opened: ${Math.round(statSync(path).size / 1e6)} MB`, performance.now() - start);

  start = performance.now();
  const before = (await status(page).getAttribute('data-ms')) ?? '';
  await set(page, 'slider', 'Rotation θ', 30);
  await expect(status(page)).not.toHaveAttribute('data-ms', before, {timeout: 60_000});
  await expect(status(page)).toContainText('F ');
  line('turned by a slider', performance.now() - start);

  start = performance.now();
  await page.getByRole('radio', {name: /foams as STL/}).check();
  const foams = new Map<string, Buffer>();
  const all = new Promise<void>((resolve) => {
    page.on('download', async (download) => {
      foams.set(download.suggestedFilename(), readFileSync(await download.path()));
      if (foams.size === 2) resolve();
    });
  });
  await page.getByRole('button', {name: 'Export', exact: true}).click();
  await Promise.race([all, page.waitForTimeout(EXPORTED_WITHIN_MS)]);
  line('exported as two STL files', performance.now() - start);

  const expected = made(path, '--rotate', '0,30,0', '--blocks', 'auto');
  for (const [name, content] of foams) expect(content.equals(expected.get(name) ?? Buffer.alloc(0)), name).toBe(true);
  expect(foams.size).toBe(2);
  rmSync(path);
});

test('a scan that is too big for a page', async ({studio: page}) => {
  test.setTimeout(600_000);
  const path = scan('survey.stl', 20_100_000);
  await page.getByLabel('Open object', {exact: true}).setInputFiles(path);
  const sentence = page.getByText(/too big for the browser/).first();
  await expect(sentence).toBeVisible();
  const commandLine = /(snug make .*)$/.exec((await sentence.textContent()) ?? '')?.[1];
  expect(commandLine).toBeDefined();
  console.log(`${Math.round(statSync(path).size / 1e6)} MB: ${await sentence.textContent()}`);
  const options = (commandLine ?? '').split(' ').slice(1).map((option) => (option === 'survey.stl' ? path : option));
  const start = performance.now();
  snug(...options.map((option) => (option === 'survey-foam' ? join(folder(), 'foam') : option)));
  console.log(`${'its command line'.padEnd(46)}${(performance.now() - start).toFixed(0).padStart(7)} ms`);
  rmSync(path);
});
