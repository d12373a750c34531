import {en} from '../src/words/texts';
import {violations} from './support/axe';
import {kept} from './support/kept';
import {expect, ONE_FILE, PLAIN, test} from './support/studio';
import {tabTo, Walk} from './support/walk';
import {castings, MOST_CLICKS, MOST_DECISIONS, SLOW, speak, WALKS} from './support/walks';

// From the opened page to the downloaded pack, as somebody goes who has only the task.

test.use({address: PLAIN});

const text = (bytes: Uint8Array | undefined) => new TextDecoder().decode(bytes);

test('a camera in a hard case', async ({studio: page}) => {
  const walk = new Walk(page);
  // Nothing technical before something is open.
  await expect(page.getByRole('spinbutton')).toHaveCount(0);
  await expect(page.getByRole('navigation', {name: 'Steps'})).toHaveCount(0);
  expect(await violations(page)).toEqual([]);
  await walk.click(page.getByRole('button', {name: 'Camera'}));
  await walk.type(page.getByRole('spinbutton', {name: 'It weighs'}), '1.2');
  await walk.choose(page.getByRole('combobox', {name: 'How fragile'}), 'rugged');
  await walk.decide(page.getByRole('radio', {name: /^Hard cases/}));
  expect(await violations(page)).toEqual([]);
  await walk.click(page.getByRole('button', {name: 'Show proposals'}));
  const proposals = page.getByRole('article');
  await expect(proposals.first()).toBeVisible(SLOW);
  expect(await violations(page)).toEqual([]);
  const margin = page.getByRole('article', {name: /Most margin/});
  await expect(margin).toContainText('hard case ·');
  await expect(page.getByRole('heading', {name: /Cheapest to send/})).toBeVisible();
  await expect(margin).toContainText(/(Meets at most|Does not meet it: up to) \d+ G/);
  // Hours are counts times seconds, of which somebody may know better.
  await margin.getByRole('spinbutton').fill('3600');
  await expect(margin).toContainText(/about \d+ h/);
  await walk.decide(margin.getByRole('button', {name: /^Take this/}));
  await expect(page.getByRole('region', {name: 'Check'})).toBeFocused();
  await walk.click(page.getByRole('button', {name: 'Next: Make'}));
  const files = await walk.pack(() => walk.click(page.getByRole('button', {name: 'Export', exact: true})), 'Make the files anyway');
  const {design} = JSON.parse(text(files['project.snug.json'])) as {design: {case: {name: string}; workshop: {for: string; mass_kg: number}}};
  expect(design.case.name).not.toBe('');
  expect([design.workshop.for, design.workshop.mass_kg]).toEqual(['sheets', 1.2]);
  expect(walk.clicks).toBeLessThanOrEqual(MOST_CLICKS);
  expect(walk.decisions).toBeLessThanOrEqual(MOST_DECISIONS);
  // One step back is before the proposal, and the questions are there again.
  await page.getByRole('button', {name: 'Undo', exact: true}).click();
  await page.getByRole('button', {name: 'Ask again'}).click();
  await expect(page.getByRole('spinbutton', {name: 'It weighs'})).toHaveValue('1.2');
  await expect(page.getByRole('radio', {name: /^Hard cases/})).toBeChecked();
});

test.describe('on a phone, from a disk', () => {
  test.use({address: ONE_FILE, viewport: {width: 390, height: 844}, hasTouch: true});

  test('a printed holder for a part without a unit', async ({studio: page}) => {
    const walk = new Walk(page);
    const t = await speak(page, 'ja');
    const files = await WALKS['a printed holder for a part without a unit']({page, t, walk, look: async () => expect(await violations(page)).toEqual([])});
    const {design} = JSON.parse(text(files['project.snug.json'])) as {design: {object: {units: string}; workshop: {for: string}}};
    expect([design.object.units, design.workshop.for]).toEqual(['m', 'print']);
    expect(walk.clicks).toBeLessThanOrEqual(MOST_CLICKS);
    expect(walk.decisions).toBeLessThanOrEqual(MOST_DECISIONS);
  });
});

test('a bust in slit sponge, by keyboard alone and in Japanese', async ({studio: page}) => {
  await page.getByLabel('Language').selectOption('ja');
  const walk = new Walk(page);
  await tabTo(page, /^人形$/);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('heading', {name: 'いくつかの質問'})).toBeFocused();
  await tabTo(page, /^緩衝材$/);
  const foam = page.getByRole('combobox', {name: '緩衝材', exact: true});
  for (let i = 0; i < 20 && (await foam.inputValue()) !== 'blocks slit-15'; i++) await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('checkbox', {name: 'カッターとシート'})).not.toBeChecked();
  await tabTo(page, /^案を見る$/);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('article').first()).toBeVisible(SLOW);
  await expect(page.getByRole('article').first()).toContainText('スリットスポンジ 15 mm');
  // Drawings and warnings are made in one language.
  const again = page.getByRole('button', {name: /日本語で作り直す|in English/});
  await expect(again).toHaveCount(0);
  await page.locator('header select').last().selectOption('en');
  await expect(again).toBeVisible();
  await page.locator('header select').last().selectOption('ja');
  await page.getByRole('heading', {name: '案', exact: true}).focus();
  await tabTo(page, /^この案にする/);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', {name: '確認'})).toBeFocused();
  await tabTo(page, /^次へ：製作/);
  await page.keyboard.press('Enter');
  const files = await walk.pack(async () => {
    await tabTo(page, /^書き出す$/);
    await page.keyboard.press('Enter');
  }, 'それでも作る');
  expect(text(files['preview.svg'])).toMatch(/[ぁ-ん]/);
  expect(Object.keys(files).some((name) => name.endsWith('.pdf'))).toBe(true);
});

test('200 castings, of which there is only a ruler, in sheets', async ({studio: page}) => {
  const walk = new Walk(page);
  const files = await castings({page, t: en, walk, look: async () => expect(await violations(page)).toEqual([])});
  const {design} = JSON.parse(text(files['project.snug.json'])) as {design: {cut: {clearance_mm: number}; workshop: {sheets: {copies: number}}}};
  // Of sheets 1 mm, and 1 mm of measuring.
  expect([design.workshop.sheets.copies, design.cut.clearance_mm]).toEqual([200, 2]);
  expect(walk.clicks).toBeLessThanOrEqual(MOST_CLICKS);
  expect(walk.decisions).toBeLessThanOrEqual(MOST_DECISIONS);
  // Its measurements are kept, and changed again.
  await kept(page, '"copies":200');
  await page.reload();
  await page.getByRole('button', {name: 'Change the measurements'}).click();
  await page.getByRole('button', {name: 'Remove 2. Cylinder'}).click();
  await page.getByRole('button', {name: 'Go on'}).click();
  await expect(page.getByText('60 × 40 × 20 mm')).toBeVisible();
});
