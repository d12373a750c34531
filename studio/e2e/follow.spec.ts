import type {Page} from '@playwright/test';
import {sample} from './support/command_line';
import {expect, open, set, status, test} from './support/studio';

const field = (page: Page, name: string) => page.getByRole('spinbutton', {name, exact: true});

test('fields show the design once it is changed by anything but typing', async ({studio: page}) => {
  await open(page, sample('torus'));
  const wall = field(page, 'Wall mm');
  await wall.fill('92');
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('92');
  await wall.blur();
  await wall.fill('33');
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('33');
  await expect(page.getByRole('button', {name: 'Undo', exact: true})).toBeEnabled();
  await wall.press('Control+z');
  const shown = await page.getByRole('slider', {name: 'Wall'}).inputValue();
  expect(shown).not.toBe('33');
  await expect(wall).toHaveValue(shown);
  // What is refused stays while it is typed: it may be on its way to a number that can be.
  const size = field(page, 'Block size y');
  const before = await size.inputValue();
  await size.fill('0');
  await expect(page.getByRole('alert')).toContainText('but must be from 0.1 to 10000 mm');
  await expect(size).toHaveValue('0');
  await size.blur();
  await expect(size).toHaveValue(before);
});

test('the next object has none of the walls and clearances of the last', async ({studio: page}) => {
  await open(page, sample('torus'));
  await set(page, 'slider', 'Wall', 5);
  await set(page, 'slider', 'Clearance', 3);
  await expect(page.getByText('Danger').or(page.getByText('Warning')).first()).toBeVisible();
  await open(page, sample('vase'));
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('50');
  await expect(page.getByRole('slider', {name: 'Clearance', exact: true})).toHaveValue('0');
});

test('the list of cases follows the wall and the object', async ({studio: page}) => {
  await open(page, sample('torus'));
  await page.getByRole('button', {name: 'Which cases hold it?'}).click();
  const list = page.locator('#step-foam ul');
  await expect(list.getByRole('button').first()).toBeVisible();
  const before = await list.innerText();
  await set(page, 'slider', 'Wall', 120);
  await expect(list).toHaveAttribute('aria-busy', 'false');
  await expect.poll(() => list.innerText()).not.toBe(before);
  const thick = await list.innerText();
  await open(page, sample('vase'));
  await expect.poll(() => list.innerText()).not.toBe(thick);
});

test('a slice keeps its height when its blocks become others', async ({studio: page}) => {
  await open(page, sample('vase'));
  const at = async () => Number(/at (-?\d+) mm/.exec(await page.getByText('seen from above, at').innerText())?.[1]);
  const slice = page.getByRole('slider', {name: 'Slice'});
  await slice.fill('5');
  const height = await at();
  const layers = await slice.getAttribute('max');
  await set(page, 'spinbutton', 'Block size x', 5);
  await expect(slice).not.toHaveAttribute('max', layers ?? '');
  expect(Math.abs((await at()) - height)).toBeLessThanOrEqual(3);
  await expect(slice).not.toHaveValue('5');
});

test('what is wrong is marked on its step, in the status line, and named at Export', async ({studio: page}) => {
  await open(page, sample('torus'));
  const mark = page.getByRole('navigation', {name: 'Steps'}).getByRole('link', {name: /Check/});
  await set(page, 'slider', 'Wall', 10);
  await expect(mark).toHaveAccessibleName(/Check.*warnings/);
  await expect(status(page)).toContainText(/\d+ warnings/);
  const named = page.locator('#step-make').getByText('Know before you make it');
  await expect(named).toBeVisible();
  await expect(page.locator('#step-make')).toContainText('Warning: Thin below');
  await set(page, 'slider', 'Wall', 0);
  await expect(mark).toHaveAccessibleName(/danger/);
  await expect(status(page)).toContainText(/danger/);
  await set(page, 'slider', 'Wall', 60);
  await expect(mark).toHaveAccessibleName(/Check$/);
  await expect(named).toBeHidden();
});

test('a place taken from the map cuts what the map says, with the walls that were asked for', async ({studio: page}) => {
  test.slow(); // Exact cuts of every direction, beside a software renderer.
  await open(page, sample('figurine'));
  await set(page, 'slider', 'Wall', 50);
  await set(page, 'slider', 'Rotation θ', 25);
  await page.getByRole('button', {name: 'Map of directions'}).click();
  // The whole map, however fast the machine: a button to end it early may be gone before it is pressed.
  const progress = page.getByRole('progressbar', {name: 'Looking in every direction'});
  await expect(progress).toBeVisible();
  await expect(progress).toBeHidden({timeout: 240_000});
  const map = page.getByRole('button', {name: /^Map of directions: arrow keys/});
  const foam = () => status(page).getAttribute('data-ms');
  for (const [right, down] of [[0.5, 0.5], [0.3, 0.4], [0.62, 0.75]] as const) {
    const box = (await map.boundingBox()) ?? {width: 0, height: 0};
    const before = await foam();
    await map.click({position: {x: right * box.width, y: down * box.height}});
    const promised = await page.getByText(/^Cuts [\d.]+ L$/).innerText();
    await expect.poll(foam).not.toBe(before);
    const litres = Number(/Cuts ([\d.]+)/.exec(promised)?.[1]);
    await expect.poll(async () => Math.abs((await cutLitres(page)) - litres)).toBeLessThan(0.006);
    const walls = await page.locator('#step-check .walls dd').allInnerTexts();
    for (const wall of walls) expect(parseFloat(wall)).toBeGreaterThanOrEqual(50);
    await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('50');
  }
});

/** Of the whole space, what is in neither half. */
async function cutLitres(page: Page): Promise<number> {
  const count = async (axis: string) => Number(await field(page, `Blocks ${axis}`).inputValue());
  const size = async (axis: string) => Number(await field(page, `Block size ${axis}`).inputValue());
  const [x, y, z] = ['x', 'y', 'z'] as const;
  const block = (await size(x)) * (await size(y)) * (await size(z));
  const texts = await page.locator('#step-make dl.facts dd').allInnerTexts();
  const kept = texts.slice(0, 2).map((text) => Number(text.replace(/ blocks.*/, '').replaceAll(/\D/g, '')));
  const all = (await count(x)) * (await count(y)) * (await count(z));
  return ((all - kept.reduce((a, b) => a + b, 0)) * block) / 1e6;
}
