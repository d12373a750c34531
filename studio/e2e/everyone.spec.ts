import {violations} from './support/axe';
import {sample} from './support/command_line';
import {expect, gapsMeasured, open, test} from './support/studio';
import {tabbed} from './support/tabbed';

test('axe finds nothing, empty or full, light or dark, English or Japanese', async ({studio: page}) => {
  expect(await violations(page)).toEqual([]);
  await open(page, sample('camera'));
  await gapsMeasured(page);
  for (const theme of ['light', 'dark']) {
    await page.getByLabel('Colours').selectOption(theme);
    expect(await violations(page)).toEqual([]);
  }
  for (const work of ['Toy bricks', 'Mill', 'Moulds']) {
    await page.getByRole('radio', {name: new RegExp(`^${work}`)}).check();
    await expect(page.getByTestId('figures')).toBeVisible({timeout: 60_000});
    expect(await violations(page)).toEqual([]);
  }
  await page.getByLabel('Language').selectOption('ja');
  expect(await violations(page)).toEqual([]);
  await page.setViewportSize({width: 820, height: 1180});
  expect(await violations(page)).toEqual([]);
});

test('every control is reached and used by keyboard', async ({studio: page}) => {
  await open(page, sample('torus'));
  await gapsMeasured(page);
  const names = await tabbed(page);
  const wanted = [
    'Open object', 'Undo', 'Save project', 'Start over', 'Colours', 'Language', 'Wall', 'Blocks x', 'Blocks y', 'Blocks z',
    'Block size x', 'Block size y', 'Block size z', 'Clearance', 'Parting level', 'Rotation ψ', 'Rotation θ', 'Rotation φ',
    'Optimize', 'This side down: +x', 'Quarter turn about x, clockwise', 'Shift x', 'Show the widest gap', 'Export', 'Copy',
    'Turn', 'Object: shown', 'Open foams', 'Corner', 'Upright', 'Print', 'Depth', 'Slice',
  ];
  for (const name of wanted) expect(names, name).toContain(name);
  expect(names.filter((name) => name.endsWith('(focus not visible)'))).toEqual([]);

  const slider = page.getByRole('slider', {name: 'Rotation ψ'});
  await slider.focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
  await expect(slider).toHaveValue('5');
  await page.getByRole('slider', {name: 'Slice'}).focus();
  const layer = Number(await page.getByRole('slider', {name: 'Slice'}).inputValue());
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('slider', {name: 'Slice'})).toHaveValue(String(layer - 1));
  await page.keyboard.press('PageDown');
  await expect(page.getByRole('slider', {name: 'Slice'})).toHaveValue(String(Math.max(layer - 6, 1)));
  await page.getByRole('tab', {name: 'Section'}).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('tab', {name: 'Lower'})).toBeFocused();
  const scene = page.getByRole('application');
  await scene.focus();
  const before = await scene.screenshot();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await scene.screenshot()).equals(before)).toBe(false);
  await page.getByRole('button', {name: 'Object: shown'}).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', {name: 'Object: see-through'})).toBeFocused();
});

test('Japanese is remembered', async ({studio: page}) => {
  await page.getByLabel('Language').selectOption('ja');
  await expect(page.getByRole('heading', {name: '何を梱包しますか？'})).toBeVisible();
  await page.reload();
  await expect(page.getByRole('heading', {name: '何を梱包しますか？'})).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
});
