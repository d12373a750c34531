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

test('a number that cannot be is refused by a sentence, and the one before it comes back', async ({studio: page}) => {
  const alert = page.getByRole('alert');
  const refused = async (name: string | RegExp, values: readonly string[], before: string, why: RegExp) => {
    const field = page.getByRole('spinbutton', {name}).first();
    for (const value of values) {
      await field.click({clickCount: 3});
      await page.keyboard.type(value);
      await expect(alert, `${value}`).toHaveText(why);
      await field.blur();
      await expect(field, `${value}`).toHaveValue(before);
    }
    await field.fill(before || '1');
    await expect(alert, 'answered').toHaveCount(0);
  };
  await page.getByRole('button', {name: 'I have only a ruler'}).click();
  await refused('1. Box: Length', ['20000', '-5', '0', '1e9'], '150', /Length: must be from 0.1 to 10000 mm, not/);
  await refused('1. Box: Edges rounded by', ['31', '-1'], '0', /must be from 0 to 30 mm/);
  await refused('Measured to within', ['21', '-1'], '1', /must be from 0 to 20 mm/);
  await page.getByRole('button', {name: 'Go on'}).click();
  await expect(page.getByText('150 × 100 × 60 mm')).toBeVisible();
  await refused('It weighs', ['-5', '1e9'], '', /must be from 0 to 1000000 kg/);
  await refused(/^How many/, ['0', '1e9'], '1', /must be from 1 to \d+, not/);
  await refused(/^How many/, ['2.7'], '1', /must be a whole number, not 2.7/);
  await page.getByRole('button', {name: 'Show proposals'}).click();
  const seconds = page.getByRole('spinbutton', {name: /^Seconds of work/}).first();
  await expect(seconds).toBeVisible(SLOW);
  await refused(/^Seconds of work/, ['-5', '1e9'], await seconds.inputValue(), /must be from 0 to 86400 seconds/);
});

test('a page that is loaded anew is where it was', async ({studio: page}) => {
  const questions = page.getByRole('heading', {name: 'A few questions'});
  await page.getByRole('button', {name: 'I have only a ruler'}).click();
  const length = page.getByRole('spinbutton', {name: '1. Box: Length'});
  await length.fill('140');
  await page.getByRole('spinbutton', {name: 'Measured to within'}).fill('3');
  await kept(page, '"clearance_mm":3');
  await page.reload();
  await expect(length).toHaveValue('140');
  await page.getByRole('button', {name: 'Go on'}).click();
  await expect(questions).toBeVisible();
  const foam = page.getByRole('combobox', {name: 'Foam', exact: true});
  await foam.selectOption('blocks slit-15');
  await kept(page, 'slit-15');
  await page.reload();
  await expect(foam).toHaveValue('blocks slit-15');
  await page.getByRole('button', {name: 'Show proposals'}).click();
  await expect(page.getByRole('article').first()).toBeVisible(SLOW);
  await page.reload();
  await expect(questions).toBeVisible();
  await page.getByRole('button', {name: 'Skip, I know what I want'}).click();
  await page.reload();
  await expect(page.getByRole('navigation', {name: 'Steps'})).toBeVisible();
  // Begun anew, nothing of it is left.
  await page.getByRole('button', {name: 'Ask again'}).click();
  await page.getByRole('button', {name: 'Start over'}).click();
  await page.getByRole('dialog').getByRole('button').first().click();
  await expect(page.getByRole('heading', {name: 'What are you packing?'})).toBeVisible();
});

test('without a unit, Show proposals asks for it, and what was not opened has its name told', async ({studio: page}) => {
  const file = (name: string, text: string) => ({name, mimeType: 'text/plain', buffer: Buffer.from(text)});
  const part = 'OFF\n4 4 0\n0 0 0\n0.06 0 0\n0 0.045 0\n0 0 0.03\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';
  await page.locator('#open-object').setInputFiles([file('part.off', part), file('other.off', part), file('notes.txt', 'two parts')]);
  const asked = page.getByRole('dialog', {name: 'Which unit does this file use?'});
  await expect(asked).toBeVisible();
  await expect(page.getByRole('alert')).toContainText('notes.txt');
  expect(await asked.evaluate((dialog) => dialog.querySelector('.choices')!.contains(document.activeElement))).toBe(false);
  for (let i = 0; i < 2; i++) {
    await asked.getByRole('button', {name: 'Close'}).click();
    await expect(asked).toHaveCount(0);
    await page.getByRole('button', {name: 'Show proposals'}).click({timeout: 5000});
    await expect(asked).toBeVisible();
  }
  await asked.getByRole('button', {name: 'Close'}).click();
  await page.getByRole('button', {name: 'Skip, I know what I want'}).click({timeout: 5000});
  await page.getByRole('button', {name: /^Next/}).click({timeout: 5000});
  await page.getByRole('alert').getByRole('button', {name: 'Close'}).click();
  await page.getByText('There are no foams yet').locator('..').getByRole('button').click({timeout: 5000});
  await expect(asked).toBeVisible();
});

test('Choose a file is reached and pressed by keyboard', async ({studio: page}) => {
  const chooser = page.waitForEvent('filechooser', {timeout: 20_000});
  await tabTo(page, new RegExp(`^${en.empty.choose}$`));
  await page.keyboard.press('Enter');
  await chooser;
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
