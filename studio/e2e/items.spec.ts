import {readFileSync} from 'node:fs';
import type {Page} from '@playwright/test';
import {violations} from './support/axe';
import {commandSays, expect, foamsShown, open, set, status, test} from './support/studio';
import {torusStl} from './support/torus';

// Several things in one case.

const RING = {name: 'ring.stl', buffer: torusStl(24, 12, 60, 20)};
const SMALL = {name: 'small.stl', buffer: torusStl(24, 12, 40, 15)};

/** As from the desktop. */
async function drop(page: Page, ...files: {name: string; buffer: Buffer}[]) {
  const given = files.map(({name, buffer}) => ({name, base64: buffer.toString('base64')}));
  await page.evaluate((all) => {
    const data = new DataTransfer();
    for (const {name, base64} of all)
      data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    window.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}));
  }, given);
}

const list = (page: Page) => page.getByRole('list', {name: 'In the case'}).getByRole('listitem');
const item = (page: Page, name: string) => page.getByRole('button', {name, exact: true});
const plan = (page: Page) => page.getByRole('img', {name: /^Section through layer/});
const foams = (page: Page) => status(page).getAttribute('data-fill');

/** Drags in the plan, by shares of its width and pixels from its middle. */
async function dragInPlan(page: Page, from: number, by: number) {
  const {x, y, width, height} = (await plan(page).boundingBox())!;
  const [startX, startY] = [x + width * from, y + height / 2];
  await page.mouse.move(startX, startY);
  await page.mouse.down();
  for (let i = 1; i <= 6; i++) await page.mouse.move(startX + (by * i) / 6, startY, {steps: 2});
  await page.mouse.up();
}

test('two files are dropped, one is moved by hand, doubled, taken back, saved and opened again', async ({studio: page}) => {
  await drop(page, RING, SMALL);
  await expect(list(page)).toHaveCount(2);
  await foamsShown(page);
  await commandSays(page, 'snug make ring.stl small.stl --blocks=auto');

  const before = await foams(page);
  await dragInPlan(page, 0.67, 40);
  await expect(item(page, '2. small.stl')).toHaveAttribute('aria-pressed', 'true');
  await commandSays(page, 'small.stl:move=0x0x');
  await expect.poll(() => foams(page)).not.toBe(before);
  // What is selected in the plan is what the placement speaks of.
  await expect(page.getByText('Turns and shifts small.stl.')).toBeVisible();

  await page.getByRole('button', {name: 'Duplicate small.stl'}).click();
  await expect(list(page)).toHaveCount(3);
  await expect(item(page, '3. small.stl (3)')).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('spinbutton', {name: 'Mass'}).fill('1.5');
  await commandSays(page, 'mass=1.5');
  await page.getByRole('button', {name: 'Undo'}).click();
  await page.getByRole('button', {name: 'Undo'}).click();
  await expect(list(page)).toHaveCount(2);
  await expect(item(page, '2. small.stl')).toBeVisible();

  const line = await page.locator('code').textContent();
  const made = await foams(page);
  const download = page.waitForEvent('download');
  await page.getByRole('button', {name: 'Save project'}).click();
  const project = {name: 'kit.snug.json', buffer: readFileSync((await (await download).path())!)};
  await page.getByRole('button', {name: 'Start over'}).click();
  await Promise.all([page.waitForEvent('load'), page.getByRole('button', {name: 'Forget everything'}).click()]);
  await expect(page.getByRole('heading', {name: 'What are you packing?'})).toBeVisible();
  await drop(page, project);
  await expect(page.getByText('Now open its object: ring.stl, small.stl')).toBeVisible();
  await drop(page, SMALL, RING);
  await expect(list(page)).toHaveCount(2);
  await expect.poll(() => foams(page)).toBe(made);
  await expect(page.locator('code')).toHaveText(line!);
});

test('a file that is dropped joins what is there, one that is opened takes its place', async ({studio: page}) => {
  await open(page, RING);
  await expect(list(page)).toHaveCount(0);
  await drop(page, SMALL);
  await expect(list(page)).toHaveCount(2);
  await expect(page.getByTitle('small.stl').first()).toBeVisible();
  await page.getByRole('button', {name: 'Take ring.stl out'}).click();
  await expect(list(page)).toHaveCount(0);
  await expect(page.getByTitle('small.stl')).toBeVisible();
  await page.getByLabel('Add objects').setInputFiles({...RING, mimeType: 'application/octet-stream'});
  await expect(list(page)).toHaveCount(2);
  await open(page, {...SMALL, name: 'alone.stl'});
  await expect(list(page)).toHaveCount(0);
});

test('items that come too near each other are named, and a locked one stays where it is', async ({studio: page}) => {
  await drop(page, RING, SMALL);
  await foamsShown(page);
  await page.getByRole('button', {name: 'Lock ring.stl: no hand moves it'}).click();
  await commandSays(page, 'ring.stl:lock');
  const before = await page.locator('code').textContent();
  await dragInPlan(page, 0.35, 40);
  await expect(item(page, '1. ring.stl')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('code')).toHaveText(before!);
  await dragInPlan(page, 0.67, -60);
  await expect(page.getByText('Danger: Items too near each other').first()).toBeVisible();
  await expect(item(page, '2. small.stl')).toHaveAttribute('title', 'too near another item');
  expect(await violations(page)).toEqual([]);
  await page.reload();
  await expect(list(page)).toHaveCount(2);
  await expect(page.getByText('Danger: Items too near each other').first()).toBeVisible();
  await expect(page.getByRole('button', {name: 'Unlock ring.stl'})).toBeVisible();
});

test('things are arranged, another arrangement is taken, and a case filled with as many as fit', async ({studio: page}) => {
  const CAP = {name: 'cap.stl', buffer: torusStl(24, 12, 30, 12)};
  await drop(page, RING, SMALL, CAP);
  await expect(list(page)).toHaveCount(3);
  await foamsShown(page);
  const litres = async () => Number(await status(page).getAttribute('data-litres'));
  const row = await litres();
  const fill = page.getByRole('button', {name: /^As many of/});
  await expect(fill).toBeDisabled();
  await page.getByRole('button', {name: 'Arrange', exact: true}).click();
  const choices = page.getByRole('list', {name: 'Arrangements to choose from'}).getByRole('button');
  await expect(choices.first()).toHaveAttribute('aria-pressed', 'true', {timeout: 20_000});
  await expect.poll(litres).toBeLessThan(row);
  await commandSays(page, 'cap.stl:');
  await expect(page.getByText(/[0-9] dangers?/)).toHaveCount(0);
  await page.screenshot({path: test.info().outputPath('arranged.png')});
  await choices.nth(1).click();
  await expect(choices.nth(1)).toHaveAttribute('aria-pressed', 'true');
  expect(await violations(page)).toEqual([]);

  await set(page, 'spinbutton', 'Blocks z', 40);
  await item(page, '3. cap.stl').click();
  await fill.click();
  await expect.poll(() => list(page).count(), {timeout: 30_000}).toBeGreaterThan(6);
  await expect(fill).toBeEnabled({timeout: 30_000});
  await expect(page.getByText(/[0-9] dangers?/)).toHaveCount(0);
  await page.screenshot({path: test.info().outputPath('filled.png')});
});
