import {readFileSync} from 'node:fs';
import type {Page} from '@playwright/test';
import {made, sample} from './support/command_line';
import {atRest} from './support/at_rest';
import {inTheMoment} from './support/in_the_moment';
import {kept} from './support/kept';
import {EVERYTHING, expect, foamsShown, gapsMeasured, open, PLAIN, set, skipQuestions, status, test} from './support/studio';
import {torusStl} from './support/torus';
import {WEDGE_IN_METRES} from './support/wedge';

async function projectText(page: Page): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', {name: 'Save project'}).click(),
  ]);
  return readFileSync(await download.path(), 'utf8');
}

async function fRatio(page: Page): Promise<number> {
  return Number(await status(page).getAttribute('data-fill'));
}

test('undo goes back to the empty start, and redo to the end', async ({studio: page}) => {
  await open(page, sample('torus'));
  await set(page, 'slider', 'Rotation ψ', 20);
  await page.getByRole('button', {name: 'This side down: +z'}).click();
  await set(page, 'spinbutton', 'Blocks x', 17);
  await page.getByLabel('Foam', {exact: true}).selectOption('slit-10');
  await page.getByRole('button', {name: 'Quarter turn about y, clockwise'}).click();
  await set(page, 'spinbutton', 'Shift x', 5);
  await expect(page.getByRole('spinbutton', {name: 'Shift x'})).toHaveValue('5');
  const last = await projectText(page);

  const undo = page.getByRole('button', {name: 'Undo', exact: true});
  const redo = page.getByRole('button', {name: 'Redo', exact: true});
  let steps = 0;
  for (; await undo.isEnabled(); steps++) await undo.click();
  expect(steps).toBe(7);
  await expect(page.getByRole('heading', {name: 'What are you packing?'})).toBeVisible();
  for (let i = 0; i < steps; i++) await redo.click();
  await expect(redo).toBeDisabled();
  await foamsShown(page);
  expect(await projectText(page)).toBe(last);
});

test('a reload brings everything back', async ({studio: page}) => {
  await open(page, sample('vase', 'ply'));
  await set(page, 'slider', 'Rotation φ', 45);
  await set(page, 'slider', 'Wall', 70);
  await expect(page.getByRole('button', {name: 'Undo', exact: true})).toBeEnabled();
  const before = await projectText(page);
  await kept(page, '"wall_mm":70');
  await page.reload();
  await foamsShown(page);
  await expect(page.getByTitle('vase.ply')).toBeVisible();
  await expect(page.getByRole('slider', {name: 'Rotation φ'})).toHaveValue('45');
  expect(await projectText(page)).toBe(before);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('50');
});

test('a project is pasted like a file that is dropped', async ({studio: page}) => {
  const torus = sample('torus');
  await open(page, torus);
  const project = made(torus, '--rotate', '0,40,0', '--blocks', 'auto').get('project.snug.json')!.toString();
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData('text/plain', text);
    document.body.dispatchEvent(new ClipboardEvent('paste', {clipboardData: data, bubbles: true, cancelable: true}));
  }, project);
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toHaveValue('40');
});

test('without a network it opens and works', async ({studio: page, context}) => {
  await page.evaluate(async () => {
    const {active} = await navigator.serviceWorker.ready;
    while (active?.state !== 'activated') await new Promise((resolve) => setTimeout(resolve, 50));
  });
  await context.setOffline(true);
  await page.reload();
  await page.getByRole('button', {name: 'Camera'}).click();
  await foamsShown(page);
  await expect(status(page)).toHaveAttribute('data-ms', /^\d/);
  await context.setOffline(false);
});

test('Optimize shows its climb, never ends below its start, and is one step back', async ({studio: page}) => {
  await open(page, sample('camera'));
  await set(page, 'slider', 'Rotation ψ', 30);
  for (const [axis, count] of Object.entries({x: 20, y: 20, z: 16})) await set(page, 'spinbutton', `Blocks ${axis}`, count);
  await kept(page, '"blocks":[20,20,16]');
  const before = await fRatio(page);
  await inTheMoment(page, 'footer .busy button');
  await page.getByRole('button', {name: 'Optimize', exact: true}).click();
  await expect(page.locator('body')).toHaveAttribute('data-moment', /Cancel/);
  await expect(page.getByRole('button', {name: 'Optimize', exact: true})).toBeEnabled({timeout: 60_000});
  expect(await fRatio(page)).toBeGreaterThan(before);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('slider', {name: 'Rotation ψ'})).toHaveValue('30');
  await expect.poll(() => fRatio(page)).toBe(before);
});

test('a cancelled Optimize keeps the best so far', async ({studio: page}) => {
  await open(page, {name: 'ring.stl', buffer: torusStl(224, 224)});
  await set(page, 'slider', 'Rotation θ', 33);
  // A climb may end before a slow hand has found the button.
  await page.evaluate(async () => {
    const button = (name: string) =>
      [...document.querySelectorAll('button')].find((element) => element.textContent?.trim() === name);
    button('Optimize')?.click();
    while (!button('Cancel')) await new Promise(requestAnimationFrame);
    button('Cancel')?.click();
  });
  await expect(page.getByRole('button', {name: 'Optimize', exact: true})).toBeEnabled();
  await foamsShown(page);
});

test('another object opened meanwhile ends an Optimize, and starts anew', async ({studio: page}) => {
  await open(page, sample('figurine'));
  await set(page, 'slider', 'Rotation θ', 33);
  await page.getByRole('button', {name: 'Optimize', exact: true}).click();
  await open(page, sample('torus'));
  // Long enough for any step of the search that would still be on its way.
  await gapsMeasured(page);
  for (const angle of ['ψ', 'θ', 'φ'])
    await expect(page.getByRole('slider', {name: `Rotation ${angle}`})).toHaveValue('0');
  await expect(page.getByRole('button', {name: 'Optimize', exact: true})).toBeEnabled();
});

test.describe('where something is asked', () => {
  test.use({address: PLAIN});

  test('a file in metres asks for its unit', async ({studio: page}) => {
    await page.getByLabel('Open object', {exact: true}).setInputFiles({name: 'wedge.off', mimeType: '', buffer: Buffer.from(WEDGE_IN_METRES)});
    await skipQuestions(page);
    const dialog = page.getByRole('dialog', {name: 'Which unit does this file use?'});
    await dialog.getByRole('button', {name: /^Metres/}).click();
    await expect(dialog).toBeHidden();
    await expect(page.getByText('200 × 150 × 100 mm')).toBeVisible();
    await foamsShown(page);

    // And a length that is known scales it.
    await page.getByText('Set a length').click();
    await page.getByRole('spinbutton', {name: 'This length is'}).fill('300');
    await page.getByRole('button', {name: 'Set', exact: true}).click();
    await expect(page.getByText('300 × 225 × 150 mm')).toBeVisible();

    // Where everything is open nothing is asked.
    await page.goto(EVERYTHING);
    await page.getByLabel('Open object', {exact: true}).setInputFiles({name: 'unasked.off', mimeType: '', buffer: Buffer.from(`${WEDGE_IN_METRES}\n`)});
    await expect(page.getByTitle('unasked.off')).toBeVisible();
    await foamsShown(page);
    await expect(page.getByLabel('Unit of the file')).toHaveValue('mm');
    await expect(page.getByRole('dialog')).toHaveCount(0);
  });
});

test('a lost graphics context says so and comes back', async ({studio: page}) => {
  await open(page, sample('torus'));
  const scene = page.getByRole('application');
  const context = await scene.evaluateHandle((canvas: HTMLCanvasElement) => canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context'));
  await context.evaluate((extension) => extension?.loseContext());
  await expect(page.getByText('The graphics of this browser stopped')).toBeVisible();
  await context.evaluate((extension) => extension?.restoreContext());
  await expect(page.getByText('The graphics of this browser stopped')).toBeHidden();
  await set(page, 'slider', 'Rotation ψ', 10);
  await foamsShown(page);
});

test.describe('with a camera that moves', () => {
  test.use({contextOptions: {reducedMotion: 'no-preference'}});

  test('pointing at a column shows it in both windows', async ({studio: page}) => {
    await open(page, sample('torus'));
    await page.getByRole('tab', {name: 'Lower'}).click();
    const map = page.getByRole('img', {name: 'Map of the lower foam'});
    const box = await map.boundingBox();
    if (!box) throw new Error('there is no map');
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await expect(page.getByText(/^Row \d+, column \d+: remove \d+ below/)).toBeVisible();
    await page.getByRole('button', {name: 'View from: Top'}).or(page.getByRole('button', {name: 'Top'})).click();
    await atRest(page);
    const scene = await page.getByRole('application').boundingBox();
    if (!scene) throw new Error('there is no scene');
    await page.mouse.move(scene.x + scene.width / 2, scene.y + scene.height / 2);
    await expect(page.getByText(/^Row \d+, column \d+: remove/)).toBeVisible();
  });
});

test('both maps go to the printer', async ({studio: page}) => {
  await open(page, sample('torus'));
  await page.evaluate(() => (window.print = () => document.body.setAttribute('data-printed', 'yes')));
  await page.getByRole('button', {name: 'Print'}).click();
  await expect(page.locator('body[data-printed=yes]')).toBeAttached();
  await expect(page.locator('#print img')).toHaveCount(2);
});

test('a hand on the rings turns the object, as one step', async ({studio: page}) => {
  await open(page, sample('camera'));
  await page.getByRole('button', {name: 'Turn', exact: true}).click();
  await atRest(page);
  const scene = await page.getByRole('application').boundingBox();
  if (!scene) throw new Error('there is no scene');
  const rotation = () => Promise.all(['ψ', 'θ', 'φ'].map((angle) => page.getByRole('spinbutton', {name: `${angle} in degrees`}).inputValue()));
  const before = await rotation();
  const middle = {x: scene.x + scene.width / 2, y: scene.y + scene.height / 2};
  await page.mouse.move(middle.x + 8, middle.y - 22);
  await page.mouse.down();
  for (let i = 1; i <= 12; i++) await page.mouse.move(middle.x + 8 + 5 * i, middle.y - 22 - 3 * i);
  await page.mouse.up();
  await expect.poll(rotation).not.toEqual(before);
  await kept(page, `"rotation_deg":[${(await rotation()).join()}]`);
  await page.keyboard.press('Control+z');
  await expect.poll(rotation).toEqual(before);
});
