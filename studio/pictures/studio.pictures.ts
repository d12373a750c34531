import {fileURLToPath} from 'node:url';
import type {Page} from '@playwright/test';
import {sample} from '../e2e/support/command_line';
import {expect, gapsMeasured, PLAIN, set, skipQuestions, status, test} from '../e2e/support/studio';

// Every step in both colours, in Japanese and on a tablet, into build/pictures; the two of the README into docs/.

const to = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
test.use({address: PLAIN});

const STEPS = ['Object', 'Foam', 'Placement', 'Check', 'Make'];

/** Every field of every step. */
const showAll = (page: Page) => page.getByRole('button', {name: 'All', exact: true}).click();

async function shoot(page: Page, name: string) {
  await page.mouse.move(2, 2);
  await page.waitForTimeout(1500);
  await page.screenshot({path: to(`${name}.png`)});
}

async function withSample(page: Page, name: string) {
  await page.getByRole('button', {name}).click();
  await skipQuestions(page);
  await gapsMeasured(page);
}

test('each step, light and dark', async ({studio: page}) => {
  await shoot(page, 'build/pictures/empty');
  await withSample(page, 'Camera');
  for (const theme of ['light', 'dark']) {
    await page.getByLabel('Colours').selectOption(theme);
    for (const step of STEPS) {
      await page.getByRole('navigation').getByText(step).click();
      await shoot(page, `build/pictures/${step.toLowerCase()}-${theme}`);
    }
  }
});

test('the ways of working with tools of their own', async ({studio: page}) => {
  await withSample(page, 'Ring');
  await showAll(page);
  await page.setViewportSize({width: 1280, height: 1350});
  for (const work of ['bricks', 'mill', 'mould']) {
    await page.locator(`input[type=radio][value=${work}]`).check();
    await expect(page.getByTestId('figures')).toBeVisible({timeout: 60_000});
    for (const [language, theme] of [['en', 'light'], ['en', 'dark'], ['ja', 'light']] as const) {
      await page.locator('header select').first().selectOption(theme);
      await page.locator('header select').last().selectOption(language);
      await page.locator('nav a[href="#step-make"]').click();
      await shoot(page, `build/pictures/make-${work}-${theme}-${language}`);
    }
    await page.locator('header select').last().selectOption('en');
  }
});

test('three layers, and a tray', async ({studio: page}) => {
  const samples = ['camera', 'torus', 'vase'].map((name) => sample(name));
  await page.getByLabel('Open object', {exact: true}).setInputFiles(samples);
  await skipQuestions(page);
  await showAll(page);
  for (const [i, name] of ['torus', 'vase'].entries()) {
    await page.getByRole('button', {name: `${i + 2}. ${name}.stl`, exact: true}).click();
    await set(page, 'spinbutton', 'Layer', i + 2);
  }
  await gapsMeasured(page);
  await page.getByRole('button', {name: 'Show all'}).click();
  for (const theme of ['light', 'dark']) {
    await page.getByLabel('Colours').selectOption(theme);
    await shoot(page, `build/pictures/layers-${theme}`);
  }
  await page.getByRole('tab', {name: 'Middle 1, above'}).click();
  await page.locator('nav a[href="#step-check"]').click();
  await shoot(page, 'build/pictures/layers-map');
  await page.getByRole('checkbox', {name: 'Tray without a lid'}).check();
  // A layer is never left empty between others.
  for (const name of ['vase', 'torus']) {
    await page.getByRole('button', {name: new RegExp(`^\\d\\. ${name}`)}).click();
    await set(page, 'spinbutton', 'Layer', 1);
  }
  await gapsMeasured(page);
  await page.getByRole('button', {name: 'Show all'}).click();
  await shoot(page, 'build/pictures/tray');
});

test('Japanese, a tablet and a telephone', async ({studio: page}) => {
  await withSample(page, 'Figurine');
  for (const [name, width, height] of [['tablet', 1024, 768], ['upright', 820, 1180], ['telephone', 390, 844]] as const) {
    await page.setViewportSize({width, height});
    await shoot(page, `build/pictures/${name}`);
  }
  await page.setViewportSize({width: 1280, height: 800});
  await page.getByLabel('Language').selectOption('ja');
  await shoot(page, 'build/pictures/japanese');
});

test('the README’s two', async ({studio: page}) => {
  await withSample(page, 'Camera');
  await page.getByRole('navigation').getByText('Placement').click();
  await page.getByRole('button', {name: 'This side down: -y'}).click();
  await page.getByRole('tab', {name: 'Lower'}).click();
  await expect(status(page)).not.toHaveAttribute('data-gap', 'comes', {timeout: 30_000});
  await shoot(page, 'docs/studio-light');
  await page.getByLabel('Colours').selectOption('dark');
  await page.getByRole('navigation').getByText('Check').click();
  await page.locator('#step-check .more').last().click();
  await page.getByLabel('Colour the foam').check();
  await page.getByRole('button', {name: 'Lid: shown'}).click();
  await page.getByRole('tab', {name: 'Section'}).click();
  await shoot(page, 'docs/studio-dark');
});
