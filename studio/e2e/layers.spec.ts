import type {Page} from '@playwright/test';
import {violations} from './support/axe';
import {made, sample, untimed} from './support/command_line';
import {commandSays, expect, exported, foamsShown, gapsMeasured, set, test} from './support/studio';

// Things in layers that stand on each other, and trays.

const look = (page: Page, part: string) => page.getByRole('button', {name: `${part}: shown`});

/** The first two samples in one case, the second of them selected. */
async function openTwo(page: Page): Promise<[string, string]> {
  const files: [string, string] = [sample('camera'), sample('torus')];
  await page.getByLabel('Open object', {exact: true}).setInputFiles(files);
  await page.getByRole('button', {name: '2. torus.stl', exact: true}).click();
  await foamsShown(page);
  return files;
}

async function expectAsCommanded(page: Page, ...options: string[]) {
  const [mine, expected] = [await exported(page), made(...options)];
  expect(Object.keys(mine).sort()).toEqual([...expected.keys()].sort());
  for (const [name, content] of expected) {
    const own = Buffer.from(mine[name] ?? []);
    if (name === 'report.json') expect(untimed(own)).toEqual(untimed(content));
    else expect(own.equals(content), name).toBe(true);
  }
}

test('a thing is put into a second layer, and the foam between shows everywhere', async ({studio: page}) => {
  const [camera, torus] = await openTwo(page);
  await expect(look(page, 'Middle foam')).toHaveCount(0);
  await set(page, 'spinbutton', 'Layer', 2);
  await commandSays(page, 'torus.stl:layer=2');
  await expect(look(page, 'Middle foam')).toBeVisible();
  await expect(page.locator('#step-make')).toContainText('Middle foam 1');
  for (const layer of [1, 2]) await expect(page.getByRole('slider', {name: `Parting, layer ${layer}`})).toBeVisible();
  for (const side of ['above', 'below']) {
    await page.getByRole('tab', {name: `Middle 1, ${side}`}).click();
    await expect(page.getByRole('img', {name: `Map of middle foam 1 from ${side}`})).toBeVisible();
  }
  await page.evaluate(() => (window.print = () => document.body.setAttribute('data-printed', 'yes')));
  await page.getByRole('button', {name: 'Print'}).click();
  await expect(page.locator('body[data-printed=yes]')).toBeAttached();
  await expect(page.locator('#print img')).toHaveCount(4);
  await gapsMeasured(page);
  await expect(page.locator('#step-check thead').first()).toContainText(/Layer 2\s*Middle foam 1\s*Lid/);
  expect(await violations(page)).toEqual([]);
  await expectAsCommanded(page, camera, `${torus}:layer=2`, '--blocks', 'auto', '--no-arrange');

  await page.getByRole('button', {name: 'Undo', exact: true}).click();
  await expect(look(page, 'Middle foam')).toHaveCount(0);
  await expect(page.getByRole('tab', {name: 'Section'})).toHaveAttribute('aria-selected', 'true');
  await expect(page.getByRole('spinbutton', {name: 'Layer', exact: true})).toHaveValue('1');
});

test('a tray has no lid, and sinks its things as deep as they must be', async ({studio: page}) => {
  const [camera, torus] = await openTwo(page);
  await set(page, 'spinbutton', 'Layer', 2);
  await page.getByRole('checkbox', {name: 'Tray without a lid'}).check();
  await commandSays(page, 'torus.stl:layer=2', '--open=0.6');
  await expect(look(page, 'Lid')).toHaveCount(0);
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('25');
  await expect(page.getByRole('tab', {name: 'Lid'})).toHaveCount(0);
  await expect(look(page, 'Middle foam')).toBeVisible();
  await set(page, 'spinbutton', 'Sunk by', 30);
  await commandSays(page, '--open=30');
  await gapsMeasured(page);
  await expect(page.locator('#step-check thead').first()).not.toContainText('Lid');
  expect(await violations(page)).toEqual([]);
  await expectAsCommanded(page, camera, `${torus}:layer=2`, '--blocks', 'auto', '--open', '30', '--no-arrange');
  await page.getByRole('checkbox', {name: 'Tray without a lid'}).uncheck();
  await expect(look(page, 'Lid')).toBeVisible();
});
