import {readFileSync} from 'node:fs';
import {made, sample} from './support/command_line';
import {kept} from './support/kept';
import {expect, ONE_FILE, open, set, status, test} from './support/studio';

const address = (path: string) => new URL(path, import.meta.url).href;

// As a double click opens it.
test.use({address: `${ONE_FILE}?level=all`});

test('the one file, opened from a disk, makes the command line’s foams, and keeps the work', async ({studio: page}) => {
  const vase = sample('vase');
  await open(page, vase);
  await set(page, 'slider', 'Rotation θ', 35);
  await expect(status(page)).toHaveAttribute('data-fill', /^0\.\d+$/);
  await page.getByRole('radio', {name: /foams as STL/}).check();
  const foams = new Map<string, Buffer>();
  page.on('download', async (file) => foams.set(file.suggestedFilename(), readFileSync(await file.path())));
  await page.getByRole('button', {name: 'Export', exact: true}).click();
  const expected = made(vase, '--rotate', '0,35,0', '--blocks', 'auto');
  for (const name of ['lower.stl', 'upper.stl'])
    await expect.poll(() => foams.get(name)?.equals(expected.get(name)!), {message: name}).toBe(true);
  // The worker was not ended by it, and the page comes back as it was.
  expect(page.workers().length).toBeGreaterThan(0);
  await kept(page, '"rotation_deg":[0,35,0]');
  await page.reload();
  await expect(page.getByTitle('vase.stl')).toBeVisible();
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toHaveValue('35');
});

test('where the browser keeps nothing, the page says so', async ({studio: page}) => {
  await page.addInitScript(() => {
    const refuse = () => {
      throw new DOMException('denied', 'SecurityError');
    };
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB'])
      Object.defineProperty(window, name, {get: refuse});
  });
  await page.reload();
  await expect(page.getByRole('alert')).toContainText('does not keep the work');
  await page.getByRole('combobox', {name: 'Language'}).selectOption('ja');
  await expect(page.getByRole('alert')).toContainText('作業を保存しません');
  await page.getByRole('button', {name: '花瓶'}).click();
  await expect(status(page)).toHaveAttribute('data-fill', /^0\.\d+$/);
});

test('index.html of the folder, opened from a disk, says what to open instead', async ({page}) => {
  await page.goto(address('../dist/index.html'));
  await expect(page.getByText('open snug-studio.html instead')).toBeVisible();
  await expect(page.getByText('代わりに snug-studio.html を開くか')).toBeVisible();
});
