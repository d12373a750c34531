import type {Page} from '@playwright/test';
import {sample} from './support/command_line';
import {expect, foamsShown, gapsMeasured, open, set, test} from './support/studio';

const scene = (page: Page) => page.getByRole('application');
const width = (page: Page) => scene(page).evaluate((canvas: HTMLCanvasElement) => canvas.width);

async function middle(page: Page) {
  const box = (await scene(page).boundingBox())!;
  return {x: box.x + box.width / 2, y: box.y + box.height / 2};
}

test('turning the view draws fewer pixels, and all of them again at rest', async ({studio: page}) => {
  await open(page, sample('torus'));
  await gapsMeasured(page);
  await page.getByLabel('Foam', {exact: true}).selectOption('print');
  await foamsShown(page);
  const {x, y} = await middle(page);
  const shown = (await scene(page).boundingBox())!.width;
  await page.mouse.move(x, y);
  await page.mouse.down();
  const widths: number[] = [];
  for (let i = 1; i <= 6; i++) {
    await page.mouse.move(x + 8 * i, y);
    widths.push(await width(page));
  }
  await page.mouse.up();
  expect(Math.min(...widths)).toBeLessThan(shown);
  await expect.poll(() => width(page)).toBeGreaterThan(shown);
});

test('F in the view, or a double click, shows all of it', async ({studio: page}) => {
  await open(page, sample('torus'));
  await gapsMeasured(page);
  const {x, y} = await middle(page);
  const seen = async () => {
    await expect.poll(() => width(page)).toBeGreaterThan(0);
    await page.waitForTimeout(600); // until it is sharp
    return (await scene(page).screenshot()).toString('base64');
  };
  await page.mouse.move(x, y);
  await scene(page).focus();
  await page.keyboard.press('f');
  await page.keyboard.press('+');
  await page.keyboard.press('f');
  const all = await seen();
  await page.keyboard.press('+');
  await page.keyboard.press('+');
  expect(await seen()).not.toBe(all);
  await page.keyboard.press('F');
  expect(await seen()).toBe(all);
  await page.keyboard.press('+');
  expect(await seen()).not.toBe(all);
  await page.mouse.dblclick(x, y);
  expect(await seen()).toBe(all);
});

test('six pictures show how the object may lie', async ({studio: page}) => {
  await open(page, sample('camera'));
  const pictures = page.getByRole('group', {name: 'This side down'}).locator('canvas');
  await expect(pictures).toHaveCount(6);
  const drawn = () => pictures.evaluateAll((all) => new Set(all.map((canvas) => (canvas as HTMLCanvasElement).toDataURL())).size);
  await expect.poll(drawn).toBe(6);
});

const entry = (page: Page, name: string) => page.getByRole('menuitem', {name}).or(page.getByRole('menuitemradio', {name})).or(page.getByRole('menuitemcheckbox', {name}));

test('one row of bars at each edge, a menu by button and keys, and foams that open as they did last time', async ({studio: page}) => {
  await open(page, sample('torus'));
  const high = (name: string) => page.locator(`.space3d > .bar.${name}`).evaluate((bar) => bar.getBoundingClientRect().height);
  for (const [width, height] of [[390, 844], [1024, 768], [1280, 800]] as const) {
    await page.setViewportSize({width, height});
    for (const bar of ['top', 'bottom']) await expect.poll(() => high(bar)).toBeLessThan(62);
  }
  const {x, y} = await middle(page);
  await page.mouse.click(x, y, {button: 'right'});
  await expect(entry(page, 'Lid above')).toHaveAttribute('aria-checked', 'true');
  await page.keyboard.press('Escape');
  await expect(page.getByRole('menu')).toHaveCount(0);
  await scene(page).focus();
  await page.keyboard.press('Shift+F10');
  await expect(page.getByRole('menuitem', {name: 'Show all'})).toBeFocused();
  for (let i = 0; i < 9; i++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  const book = page.getByRole('button', {name: 'Like a book'});
  await expect(book).toHaveAttribute('aria-pressed', 'true');
  await expect(scene(page)).toBeFocused();
  // The cube's sides by keys, also those that are turned away.
  const before = await scene(page).screenshot();
  await page.getByRole('button', {name: 'Corner', exact: true}).focus();
  for (const side of ['Front', 'Back']) {
    await page.keyboard.press('ArrowRight');
    await expect(page.getByRole('button', {name: side, exact: true})).toBeFocused();
  }
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await scene(page).screenshot()).equals(before)).toBe(false);
  await page.reload();
  await expect(book).toHaveAttribute('aria-pressed', 'true');
});

test('all is cut open by a plane, measured and kept as a picture', async ({studio: page}) => {
  await open(page, sample('torus'));
  await set(page, 'spinbutton', 'Opening in percent', 0);
  const {x, y} = await middle(page);
  await page.mouse.click(x, y, {button: 'right'});
  await entry(page, 'Cut open by a plane').click();
  const cut = page.getByRole('slider', {name: 'Cut at'});
  await expect(cut).toHaveValue('50');
  await page.getByLabel('Cut', {exact: true}).selectOption('z');
  const whole = await scene(page).screenshot();
  await set(page, 'slider', 'Cut at', 80);
  await expect.poll(async () => (await scene(page).screenshot()).equals(whole)).toBe(false);

  await page.getByRole('button', {name: 'What the view can do'}).click();
  await entry(page, 'Measure').click();
  await page.mouse.click(x, y);
  await page.mouse.move(x + 30, y + 40);
  await page.mouse.click(x + 30, y + 40);
  await expect(page.getByTestId('measured')).toHaveText(/^\d+(\.\d)? mm$/);
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('measured')).toHaveCount(0);

  await page.getByRole('button', {name: 'What the view can do'}).click();
  const [picture] = await Promise.all([page.waitForEvent('download'), entry(page, 'Save as a picture').click()]);
  expect(picture.suggestedFilename()).toBe('torus.png');
  await page.getByRole('button', {name: 'End the cut'}).click();
  await expect(cut).toHaveCount(0);
});
