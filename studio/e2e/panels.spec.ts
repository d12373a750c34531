import type {Page} from '@playwright/test';
import {violations} from './support/axe';
import {sample} from './support/command_line';
import {expect, foamsShown, gapsMeasured, open, PLAIN, set, status, test} from './support/studio';
import {tabbed} from './support/tabbed';

// The panels as somebody meets them: one step at a time, a few choices each, and the rest behind More.

test.use({address: PLAIN});

const step = (page: Page, name: string) => page.getByRole('navigation', {name: 'Steps'}).getByRole('link', {name});
const more = (page: Page) => page.getByRole('button', {name: /^(More \(\d+\)|Fewer)$/});
const sections = (page: Page) => page.locator('section[id^=step-]:visible');
const find = (page: Page) => page.getByRole('combobox', {name: 'Find a field'});
/** Of the panel alone: the picture and the slices have theirs. */
const stops = async (page: Page) => {
  const names = await tabbed(page);
  return names.slice(names.indexOf('Find a field') + 1, names.findIndex((name) => name.startsWith('Next: ') || name === 'Export') + 1).length;
};

test('one step at a time: few stops of the Tab key in each, Next to the last, and a link past them', async ({studio: page}) => {
  await open(page, sample('torus'));
  await gapsMeasured(page);
  // Of 84 there were, all steps together.
  expect((await tabbed(page)).length).toBeLessThanOrEqual(50);
  for (const next of ['Foam', 'Placement', 'Check', 'Make']) {
    expect(await stops(page), next).toBeLessThanOrEqual(14);
    expect(await violations(page)).toEqual([]);
    await page.getByRole('button', {name: `Next: ${next}`}).click();
    await expect(page.getByRole('region', {name: next})).toBeFocused();
    await expect(sections(page)).toHaveCount(1);
  }
  await expect(page.getByRole('button', {name: /^Next/})).toHaveCount(0);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.getByRole('link', {name: 'Past the controls, to the picture'}).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('application')).toBeFocused();
  // A step that has something to say is marked, and read by a click on the verdict.
  await step(page, 'Foam').click();
  await set(page, 'slider', 'Wall', 10);
  await expect(step(page, 'Check')).toHaveAccessibleName(/Check.*warnings/);
  await status(page).getByRole('link').click();
  await expect(page.getByRole('region', {name: 'Check'})).toContainText('Thin below');
  // What the library says of flags is of fields here.
  await expect(page.getByRole('region', {name: 'Check'})).toContainText('“Wall” 25 would do');
  await expect(page.getByRole('region', {name: 'Check'})).not.toContainText('--');
});

test('a field behind More is found by a word, stays in view once it differs, and goes back by itself', async ({studio: page}) => {
  await open(page, sample('torus'));
  const rib = page.getByRole('spinbutton', {name: 'Least rib'});
  await step(page, 'Foam').click();
  await expect(rib).toHaveCount(0);
  await page.keyboard.press('/');
  await expect(find(page)).toBeFocused();
  await page.keyboard.type('rib');
  await expect(page.getByRole('option', {name: 'Least rib Foam', selected: true})).toBeVisible();
  await page.keyboard.press('Enter');
  await expect(rib).toBeFocused();
  await page.keyboard.type('20');
  await expect(rib).toHaveValue('20');
  const folded = await more(page).textContent();
  await more(page).click();
  await expect(page.getByRole('slider', {name: 'Clearance'})).toHaveCount(0);
  await expect(rib).toHaveValue('20');
  await expect(more(page)).not.toHaveText(folded!);
  await page.getByRole('button', {name: 'Reset Least rib to 0 mm'}).click();
  await expect(rib).toHaveCount(0);
  await page.getByRole('button', {name: 'Undo', exact: true}).click();
  await expect(rib).toHaveValue('20');

  // The angles, too, and whoever opens them finds them open again.
  await step(page, 'Placement').click();
  const angle = page.getByRole('slider', {name: 'Rotation θ'});
  await expect(angle).toHaveCount(0);
  await more(page).click();
  await expect(angle).toBeVisible();
  await page.reload();
  await foamsShown(page);
  await step(page, 'Placement').click();
  await expect(angle).toBeVisible();

  // What comes with a way of working says so, and leads there.
  await find(page).fill('切り幅');
  await page.getByRole('option', {name: /^Kerf/}).click();
  await expect(page.getByText('“Kerf” comes with “Sheets, cut and glued”')).toBeVisible();
  await page.getByRole('radio', {name: /Sheets, cut/}).check();
  await find(page).fill('kerf');
  await expect(page.getByRole('option', {name: /^Kerf/})).toBeVisible();
  expect(await violations(page)).toEqual([]);
  await find(page).press('Enter');
  await expect(page.getByRole('spinbutton', {name: 'Kerf'})).toBeFocused();
  // For those who want it so: everything, always.
  await page.getByRole('button', {name: 'All', exact: true}).click();
  await expect(sections(page)).toHaveCount(5);
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toBeVisible();
  await expect(more(page)).toHaveCount(0);
});
