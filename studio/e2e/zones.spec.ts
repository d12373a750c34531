import {readFileSync} from 'node:fs';
import type {Page} from '@playwright/test';
import {violations} from './support/axe';
import {commandSays, expect, foamsShown, test} from './support/studio';
import {torusStl} from './support/torus';

// Places on an item that foam keeps away from, painted by hand.

const RING = {name: 'ring.stl', mimeType: 'application/octet-stream', buffer: torusStl(24, 12, 60, 20)};
const line = (page: Page) => page.locator('code');
const places = (page: Page) => page.getByRole('list', {name: 'Places to keep off, one by one'}).getByRole('listitem');
const cut = async (page: Page) => Number(/([\d,]+) blocks? cut for it/.exec(await places(page).first().innerText())?.[1]?.replace(',', '') ?? -1);
const shot = (page: Page, name: string) => page.screenshot({path: test.info().outputPath(`${name}.png`)});

async function vase(page: Page) {
  await page.getByRole('button', {name: /Vase/}).click();
  await foamsShown(page);
}

/** Drags over the view, by shares of it. */
async function drag(page: Page, from: [number, number], to: [number, number], button: 'left' | 'right' = 'left') {
  const {x, y, width, height} = (await page.getByRole('application').boundingBox())!;
  const at = ([across, down]: [number, number]) => [x + width * across, y + height * down] as const;
  await page.mouse.move(...at(from));
  await page.mouse.down({button});
  await page.mouse.move(...at(to), {steps: 8});
  await page.mouse.up({button});
}

async function begin(page: Page) {
  await page.getByRole('button', {name: 'Add a place'}).click();
  await expect(page.getByRole('group', {name: 'Paint on the object'})).toBeVisible();
}

test('a stroke cuts foam, is undone, erased, saved and opened again', async ({studio: page}) => {
  await vase(page);
  await begin(page);
  await shot(page, 'empty');
  await drag(page, [0.48, 0.47], [0.52, 0.52]);
  await commandSays(page, '--keep-off=', ':15');
  await expect(places(page)).toHaveCount(1);
  await expect.poll(() => cut(page)).toBeGreaterThan(0);
  await shot(page, 'painted');
  expect(await violations(page)).toEqual([]);
  // Beside the object the view turns, with the right button over it, too.
  const painted = await line(page).textContent();
  await drag(page, [0.06, 0.75], [0.12, 0.75]);
  await drag(page, [0.5, 0.5], [0.6, 0.5], 'right');
  await expect(line(page)).toHaveText(painted!);
  // Another stroke in the same place, one step.
  await drag(page, [0.45, 0.55], [0.5, 0.58]);
  await expect(line(page)).not.toHaveText(painted!);
  await expect(places(page)).toHaveCount(1);
  await page.getByRole('button', {name: 'Undo'}).click();
  await expect(line(page)).toHaveText(painted!);
  await page.getByRole('button', {name: 'Redo'}).click();
  await expect(line(page)).not.toHaveText(painted!);

  await page.getByRole('spinbutton', {name: 'Distance', exact: true}).fill('22');
  await commandSays(page, ':22');
  await page.getByRole('checkbox', {name: 'May be pressed with at most'}).check();
  await commandSays(page, ':22:press=2kPa');
  await page.getByRole('checkbox', {name: /^Loose surface/}).check();
  await commandSays(page, ':22:loose');
  await expect(line(page)).not.toContainText('press=');

  await page.keyboard.press('Escape');
  await expect(page.getByRole('group', {name: 'Paint on the object'})).toHaveCount(0);
  await expect(places(page).first()).toContainText('nothing may touch it');
  await shot(page, 'done');
  await page.getByLabel('Colours').selectOption('dark');
  await shot(page, 'dark');
  await page.getByLabel('Colours').selectOption('light');
  const kept = await line(page).textContent();
  await page.reload();
  await expect(line(page)).toHaveText(kept!);
  const download = page.waitForEvent('download');
  await page.getByRole('button', {name: 'Save project'}).click();
  const project = {name: 'vase.snug.json', mimeType: 'application/json', buffer: readFileSync((await (await download).path())!)};
  expect(project.buffer.toString()).toContain('"keep_off_mm": 22');

  await page.getByRole('button', {name: 'Paint on the object'}).click();
  await page.getByRole('button', {name: 'Eraser'}).click();
  await page.getByRole('spinbutton', {name: 'Radius of the brush in mm'}).fill('60');
  await drag(page, [0.3, 0.3], [0.7, 0.75]);
  for (let i = 0; i < 6; i++) await drag(page, [0.34, 0.25 + i * 0.1], [0.66, 0.25 + i * 0.1]);
  await expect(line(page)).not.toContainText('--keep-off');
  await expect(places(page).first()).toContainText('paint it on the object');
  await page.getByRole('button', {name: 'Done'}).first().click();
  await page.getByLabel('Open object', {exact: true}).setInputFiles(project);
  await expect(line(page)).toHaveText(kept!);
});

test('all between two heights is painted, and removed', async ({studio: page}) => {
  await vase(page);
  await begin(page);
  await page.getByRole('button', {name: 'By height'}).click();
  await shot(page, 'band');
  await page.getByRole('button', {name: 'Paint between'}).click();
  await commandSays(page, '--keep-off=');
  await expect.poll(() => cut(page)).toBeGreaterThan(0);
  await shot(page, 'by_height');
  await page.getByRole('button', {name: 'Remove place 1'}).click();
  await expect(line(page)).not.toContainText('--keep-off');
});

test('of two items each has its own, in Japanese, and on a small screen', async ({studio: page}) => {
  await vase(page);
  await begin(page);
  await drag(page, [0.48, 0.47], [0.5, 0.5]);
  await commandSays(page, '--keep-off=');
  await page.getByRole('button', {name: 'Done'}).first().click();
  await page.getByLabel('Add objects').setInputFiles(RING);
  await expect(page.getByRole('list', {name: 'In the case'}).getByRole('listitem')).toHaveCount(2);
  await commandSays(page, ':keep-off=');
  await expect(page.getByText('Of ring.stl').last()).toBeVisible();
  await page.getByRole('button', {name: 'Add a place'}).click();
  await shot(page, 'two_painting');
  await page.getByRole('button', {name: 'By height'}).click();
  await page.getByRole('button', {name: 'Paint between'}).click();
  await commandSays(page, 'ring.stl:keep-off=');
  await page.getByRole('button', {name: 'Done'}).first().click();
  await shot(page, 'two');
  await page.getByRole('button', {name: 'Take ring.stl out'}).click();
  await commandSays(page, '--keep-off=');
  await expect(line(page)).not.toContainText('ring.stl');

  await page.getByLabel('Language').selectOption('ja');
  await page.getByRole('button', {name: '対象物に塗る'}).click();
  await expect(page.getByText('対象物の上をドラッグして塗ります。')).toBeVisible();
  await expect(page.getByText(/個のブロック|ブロック/).filter({visible: true}).first()).toBeVisible();
  await shot(page, 'japanese');
  await page.setViewportSize({width: 380, height: 760});
  await shot(page, 'small');
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(380);
  await page.locator('details', {hasText: '触れない場所'}).first().scrollIntoViewIfNeeded();
  await shot(page, 'small_list');
  expect(await violations(page)).toEqual([]);
});

/** Two binary STLs as one, the second so much further along x. */
function beside(one: Buffer, other: Buffer, by: number): Buffer {
  const both = Buffer.concat([one, other.subarray(84)]);
  both.writeUInt32LE((one.length + other.length - 168) / 50, 80);
  for (let at = one.length; at < both.length; at += 50)
    for (let corner = 1; corner <= 3; corner++) both.writeFloatLE(both.readFloatLE(at + 12 * corner) + by, at + 12 * corner);
  return both;
}

test('a separate part is taken by a click', async ({studio: page}) => {
  const two = {...RING, name: 'two.stl', buffer: beside(torusStl(24, 12, 40, 22), torusStl(24, 12, 30, 20), 150)};
  await page.getByLabel('Open object', {exact: true}).setInputFiles(two);
  await foamsShown(page);
  await begin(page);
  await page.getByRole('button', {name: 'Whole part'}).click();
  await page.getByRole('button', {name: 'Top', exact: true}).click();
  await page.waitForTimeout(500);
  await shot(page, 'parts');
  const {x, y, width, height} = (await page.getByRole('application').boundingBox())!;
  for (let i = 1; i < 20 && !(await line(page).textContent())!.includes('part='); i++) {
    await page.mouse.click(x + (width * i) / 20, y + height * 0.5);
    await page.waitForTimeout(400);
  }
  await commandSays(page, '--keep-off=part=');
  await expect.poll(() => cut(page)).toBeGreaterThan(0);
  await shot(page, 'part');
});

test.describe('with fingers', () => {
  test.use({hasTouch: true});
  test('one paints, two turn', async ({studio: page}) => {
    await vase(page);
    await begin(page);
    const {x, y, width, height} = (await page.getByRole('application').boundingBox())!;
    const client = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...fingers: [number, number][]) =>
      client.send('Input.dispatchTouchEvent', {type, touchPoints: fingers.map(([across, down], id) => ({x: x + width * across, y: y + height * down, id}))});
    await touch('touchStart', [0.5, 0.5]);
    await touch('touchStart', [0.5, 0.5], [0.3, 0.6]);
    await touch('touchMove', [0.55, 0.5], [0.35, 0.6]);
    await touch('touchEnd');
    await page.waitForTimeout(400);
    await expect(line(page)).not.toContainText('--keep-off');
    await touch('touchStart', [0.5, 0.45]);
    await touch('touchMove', [0.52, 0.47]);
    await touch('touchMove', [0.53, 0.5]);
    await touch('touchEnd');
    await commandSays(page, '--keep-off=');
  });
});
