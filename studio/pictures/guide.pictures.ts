import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import type {Page} from '@playwright/test';
import {folder, sample} from '../e2e/support/command_line';
import {expect, foamsShown, gapsMeasured, PLAIN, status, test} from '../e2e/support/studio';
import {WEDGE_IN_METRES} from '../e2e/support/wedge';
import {en, ja, type Texts} from '../src/words/texts';

// The pictures of docs/guide.md and docs/guide.ja.md, each as a person comes to it who does what stands there.

test.use({address: PLAIN, viewport: {width: 1120, height: 720}, actionTimeout: 20_000});

const GUIDE = fileURLToPath(new URL('../../docs/guide', import.meta.url));
const LANGUAGES: readonly [code: 'en' | 'ja', words: Texts][] = [['en', en], ['ja', ja]];
// What fields are called that have their words from the library.
const LAYER = {en: 'Layer', ja: '段'};
const PLANNED = {timeout: 90_000};

for (const [code, t] of LANGUAGES) {
  const button = (page: Page, name: string) => page.getByRole('button', {name, exact: true});
  const card = (page: Page, name: string) => page.getByRole('radio', {name: new RegExp(`^${name}`)});

  async function begin(page: Page) {
    await page.locator('header select').last().selectOption(code);
  }

  const openFiles = (page: Page, ...files: string[]) => page.getByLabel(t.header.open, {exact: true}).setInputFiles(files);
  const skip = (page: Page) => button(page, t.first.skip).press('Enter');

  async function shoot(page: Page, name: string, clip?: {x: number; y: number; width: number; height: number}) {
    // No tip over what it is about.
    await page.mouse.move(2, 2);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.waitForTimeout(1500);
    mkdirSync(GUIDE, {recursive: true});
    await page.screenshot({path: join(GUIDE, `${name}.${code}.png`), ...(clip && {clip})});
  }

  async function plan(page: Page) {
    await button(page, t.first.show).click();
    await expect(page.getByRole('article').first()).toBeVisible(PLANNED);
    await expect(status(page)).not.toHaveAttribute('data-gap', 'comes', {timeout: 30_000});
  }

  async function take(page: Page, which = t.first.kinds.smallest) {
    await page.getByRole('article').filter({hasText: which}).getByRole('button', {name: new RegExp(`^${t.first.take}`)}).click();
    await foamsShown(page);
    await gapsMeasured(page);
  }

  test(`a bust in slit sponge, ${code}`, async ({studio: page}) => {
    await begin(page);
    await openFiles(page, sample('figurine'));
    await page.getByRole('spinbutton', {name: t.first.what.mass}).fill('2.4');
    await page.getByRole('combobox', {name: t.first.what.fragility}).selectOption('museum');
    await shoot(page, 'questions');
    await card(page, t.first.where.courier).check();
    await page.getByRole('combobox', {name: t.first.have.foam, exact: true}).selectOption('blocks slit-15');
    await card(page, t.first.have.cases.cartons).check();
    await plan(page);
    await shoot(page, 'proposals');
    await take(page);
    await button(page, t.fieldsOf.next(t.steps.make)).click();
    await expect(page.getByTestId('figures')).toBeVisible(PLANNED);
    await page.getByRole('tab', {name: t.view2d.tabs.lower, exact: true}).click();
    await shoot(page, 'make', {x: 345, y: 49, width: 775, height: 634});
  });

  test(`a camera from a ruler, ${code}`, async ({studio: page}) => {
    await begin(page);
    await button(page, t.empty.ruler).click();
    const {kinds, numbered, of, lengths, addKind, along, axes, places} = t.measure;
    const field = (n: number, kind: 'box' | 'cylinder', what: string) => page.getByRole('spinbutton', {name: of(numbered(n, kinds[kind]), what), exact: true});
    for (const [i, mm] of [143, 60, 97].entries()) await field(1, 'box', lengths.box[i]!).fill(String(mm));
    await button(page, addKind(kinds.cylinder)).click();
    await field(2, 'cylinder', lengths.cylinder[0]!).fill('70');
    await field(2, 'cylinder', lengths.cylinder[1]!).fill('80');
    await page.getByRole('combobox', {name: along, exact: true}).last().selectOption({label: axes.y});
    for (const [i, mm] of [0, 70, 0].entries()) await field(2, 'cylinder', places[i]!).fill(String(mm));
    await page.waitForTimeout(1500);
    await shoot(page, 'ruler');
  });

  test(`a part without a unit, ${code}`, async ({studio: page}) => {
    await begin(page);
    const part = join(folder(), 'part.off');
    writeFileSync(part, WEDGE_IN_METRES);
    await openFiles(page, part);
    await expect(page.getByText(t.units.heading)).toBeVisible();
    await shoot(page, 'unit');
  });

  test(`200 castings in sheets, ${code}`, async ({studio: page}) => {
    await begin(page);
    await openFiles(page, sample('torus'));
    await page.getByRole('combobox', {name: t.first.have.foam, exact: true}).selectOption('blocks sheet-10');
    await page.getByRole('spinbutton', {name: t.first.what.copies}).fill('200');
    await card(page, t.first.have.cases.none).check();
    await plan(page);
    await take(page);
    await button(page, t.fieldsOf.next(t.steps.make)).click();
    await expect(page.getByTestId('figures')).toBeVisible(PLANNED);
    await page.getByTestId('figures').scrollIntoViewIfNeeded();
    await shoot(page, 'castings');
  });

  test(`a place to keep off, ${code}`, async ({studio: page}) => {
    await begin(page);
    await openFiles(page, sample('vase'));
    await expect(page.locator('.first').getByText(/^vase.stl/)).toBeVisible();
    await page.waitForTimeout(1500);
    await page.locator('.first summary').click();
    await page.getByRole('button', {name: t.zones.add}).click();
    const {x, y, width, height} = (await page.getByRole('application').boundingBox())!;
    await page.mouse.move(x + width * 0.47, y + height * 0.45);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.53, y + height * 0.53, {steps: 12});
    await page.mouse.up();
    await page.waitForTimeout(2500);
    await shoot(page, 'keep-off');
  });

  test(`several things in layers, ${code}`, async ({studio: page}) => {
    await begin(page);
    await openFiles(page, sample('camera'), sample('torus'));
    await skip(page);
    await foamsShown(page);
    await button(page, '2. torus.stl').click();
    await page.locator('#step-object').getByRole('button', {expanded: false}).first().click();
    await page.getByRole('spinbutton', {name: LAYER[code], exact: true}).fill('2');
    await gapsMeasured(page);
    await shoot(page, 'layers', {x: 0, y: 49, width: 1120, height: 634});
  });

  test(`what it meets in a drop, ${code}`, async ({studio: page}) => {
    await begin(page);
    await openFiles(page, sample('camera'));
    await page.getByRole('spinbutton', {name: t.first.what.mass}).fill('1.2');
    await page.getByRole('combobox', {name: t.first.what.fragility}).selectOption('rugged');
    await plan(page);
    await take(page, t.first.kinds['most-margin']);
    await page.getByRole('list', {name: t.drops.sides}).evaluate((list) => list.scrollIntoView());
    await shoot(page, 'drops');
  });
}
