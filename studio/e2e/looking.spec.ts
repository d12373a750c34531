import type {Page} from '@playwright/test';
import {sample} from './support/command_line';
import {expect, foamsShown, gapsMeasured, open, test} from './support/studio';

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
