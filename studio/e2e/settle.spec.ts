import type {Page} from '@playwright/test';
import {violations} from './support/axe';
import {commandSays, expect, foamsShown, gapsMeasured, open, set, test} from './support/studio';

// Lying on foam, pads in what block steps leave, and islands below.

/** A flat box of 60 x 200 x 240 mm (OFF). */
const PLATE = {
  name: 'plate.off',
  buffer: Buffer.from(
    'OFF\n8 12 0\n0 0 0\n60 0 0\n0 200 0\n60 200 0\n0 0 240\n60 0 240\n0 200 240\n60 200 240\n' +
      '3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n',
  ),
};

const check = (page: Page) => page.locator('#step-check');
const pads = (page: Page) => page.getByRole('list', {name: 'Pads'}).getByRole('listitem');
const turn = (page: Page, name: string) => page.getByLabel(name, {exact: true});
const choose = (page: Page, name: string, value: string) => page.getByLabel(name, {exact: true}).selectOption(value);

/** The 3D view, without the tip of what was clicked last. */
async function picture(page: Page) {
  await page.mouse.move(0, 0);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  return page.locator('canvas[role=application]').screenshot();
}

test('the camera is lowered onto its foam, and its pads are listed and drawn until they are taken back', async ({studio: page}) => {
  await page.getByRole('button', {name: 'Camera'}).click();
  await foamsShown(page);
  await expect(check(page).getByRole('heading', {name: 'Lowered onto its foam'})).toHaveCount(0);
  await turn(page, 'Lower it until it lies on foam').click();
  await commandSays(page, '--settle');
  await expect(check(page)).toContainText(/Lowered onto its foam\s*camera\.ply\s*[\d.]+ mm/);

  await page.getByRole('spinbutton', {name: 'Opening in percent'}).fill('60');
  await gapsMeasured(page);
  const without = await picture(page);
  await turn(page, 'Pads in what block steps leave').click();
  await commandSays(page, '--pads=2');
  await expect(pads(page).first()).toContainText(/^LOWER.*: \d[\d.]* × [\d.]+ × [\d.]+ mm \(\d+ sheets? of 2 mm\)$/);
  await expect(pads(page).last()).toContainText(/^LID/);
  await expect(check(page)).toContainText('Note: Pads fill what steps leave');
  await expect.poll(async () => (await picture(page)).equals(without)).toBe(false);
  expect(await violations(page)).toEqual([]);

  await set(page, 'spinbutton', 'Their sheet', 3);
  await commandSays(page, '--pads=3');
  await expect(pads(page).first()).toContainText('of 3 mm)');
  await set(page, 'spinbutton', 'They press', 1);
  await commandSays(page, '--pads=3,1');
  await expect(check(page)).toContainText('Warning: How hard pads press is not known');

  for (let i = 0; i < 3; i++) await page.getByRole('button', {name: 'Undo'}).click();
  await expect(page.locator('code')).not.toContainText('--pads');
  await expect(page.getByRole('list', {name: 'Pads'})).toHaveCount(0);
  await expect.poll(async () => (await picture(page)).equals(without)).toBe(true);
  await commandSays(page, '--settle');
  await page.getByRole('button', {name: 'Undo'}).click();
  await expect(page.locator('code')).not.toContainText('--settle');
  await expect(check(page).getByRole('heading', {name: 'Lowered onto its foam'})).toHaveCount(0);
});

test('islands are refused in slit sponge, and cut in sheets', async ({studio: page}) => {
  await open(page, PLATE);
  await turn(page, 'Islands under the object').click();
  await commandSays(page, '--relief=40x60');
  await expect(check(page)).toContainText('Warning: No relief');
  await choose(page, 'Foam', 'sheet-10');
  await expect(check(page)).toContainText(/Note: Stands on islands\s*The object stands on \d islands of [\d.]+ × [\d.]+ mm that stand 40 mm free/i);
  await expect(check(page)).not.toContainText('No relief');
  await set(page, 'spinbutton', 'Island’s side', 40);
  await expect(check(page)).toContainText(/No relief: islands of 40 mm would buckle/i);
});

test('where less foam would do more on the floor that is said, done and undone', async ({studio: page}) => {
  await open(page, PLATE);
  await choose(page, 'Foam', 'sheet-10');
  await choose(page, 'Foam material', 'ld33');
  await choose(page, 'Falls from', 'mm');
  await set(page, 'spinbutton', 'Height of the drop', 500);
  await choose(page, 'How delicate', 'g');
  await set(page, 'spinbutton', 'Shock that the object bears', 60);
  await set(page, 'spinbutton', 'Object weighs', 3);
  const take = page.getByRole('button', {name: 'Cut this relief'});
  await expect(take).toBeVisible({timeout: 60_000});
  await expect(check(page)).toContainText(/Less foam under it would (do|help) on its floor.*: “[^”]+” [\d.]+ × [\d.]+ lets it stand on \d islands/i);
  await expect(check(page)).toContainText('Note: Less foam below would do more');
  expect(await violations(page)).toEqual([]);
  await take.click();
  await commandSays(page, '--relief=');
  await expect(check(page)).toContainText('Note: Stands on islands');
  await expect(take).toHaveCount(0);
  await page.getByRole('button', {name: 'Undo'}).click();
  await expect(page.locator('code')).not.toContainText('--relief');
  await expect(take).toBeVisible({timeout: 60_000});
});
