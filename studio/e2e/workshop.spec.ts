import type {Page} from '@playwright/test';
import {sample} from './support/command_line';
import {commandSays, expect, exported, foamsShown, open, set, test} from './support/studio';
import {torusStl} from './support/torus';

/** Whose foams are built in a moment, block by block. */
async function openSmallRing(page: Page) {
  await open(page, {name: 'ring.stl', buffer: torusStl(64, 32, 40, 15)});
  await set(page, 'slider', 'Wall', 20);
}

test('slit sponge: what it takes is shown first, then the pack comes as one zip', async ({studio: page}) => {
  await open(page, sample('camera'));
  await page.getByRole('radio', {name: /Slit sponge/}).check();
  await expect(page.getByLabel('Foam', {exact: true})).toHaveValue('slit-15');
  await set(page, 'spinbutton', 'Price a litre', 2);
  await page.getByLabel('Currency').fill('EUR');
  await page.getByLabel('Currency').press('Tab');
  const figures = page.getByTestId('figures');
  await expect(figures).toContainText('litres', {timeout: 20_000});
  await expect(figures).toContainText('at 2 EUR a litre');
  await commandSays(page, '--for=sponge', '--price=2EUR');
  const members = await exported(page);
  for (const name of ['lower.stl', 'depths.csv', 'report.json', 'packing-sheet.pdf'])
    expect(Object.keys(members)).toContain(name);
  const pdf = Object.keys(members).filter((name) => name.endsWith('.pdf'));
  expect(pdf.length).toBeGreaterThan(1);
  for (const name of pdf) expect(new TextDecoder().decode(members[name]!.slice(0, 5))).toBe('%PDF-');
});

test('toy bricks: sizes, colours and a stock are chosen, and built by', async ({studio: page}) => {
  await openSmallRing(page);
  await page.getByRole('radio', {name: /Toy bricks/}).check();
  await expect(page.getByLabel('Foam', {exact: true})).toHaveValue('lego-brick');
  await page.getByLabel('Rims meet').selectOption('tiles');
  await page.getByLabel('Lower half').selectOption('dark blue');
  for (const size of ['1x1', '1x2', '2x4']) await page.getByRole('button', {name: size, exact: true}).press('Enter');
  await expect(page.getByRole('button', {name: '2x4', exact: true, pressed: true})).toBeVisible();
  const stock = page.getByLabel('Pieces that you have');
  await stock.fill('2x4=many');
  await stock.press('Enter');
  await expect(page.getByRole('alert')).toHaveText('Write sizes and pieces: 2x4=100, 1x1=40');
  await expect(stock).toHaveValue('2x4=many');
  await stock.fill('4x2=200');
  await stock.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expect(stock).toHaveValue('2x4=200');
  const bricks = ['--brick-sizes=1x1,1x2,2x4', "--brick-colors='dark blue,orange'", '--brick-stock=2x4=200', '--brick-rim=tiles'];
  await commandSays(page, '--for=bricks', ...bricks);
  await expect(page.getByTestId('figures')).toContainText('Bricks, lid', {timeout: 30_000});
  await stock.fill('2x4=2, 1x2=3, 1x1=4');
  await stock.press('Enter');
  await expect(page.getByRole('alert').filter({hasText: 'stock'})).toBeVisible({timeout: 30_000});
  await stock.fill('');
  await stock.press('Enter');
  await expect(page.getByTestId('figures')).toContainText('Bricks, lid', {timeout: 30_000});
  expect(Object.keys(await exported(page))).toEqual(expect.arrayContaining(['bricks/foams.mpd', 'bricks/parts.csv', 'bricks/wanted.xml', 'bricks-plan.pdf']));
});

test('a mill: the cutter and how it moves are chosen, and its programs come', async ({studio: page}) => {
  await openSmallRing(page);
  await page.getByRole('radio', {name: /Mill/}).check();
  await expect(page.getByLabel('Foam', {exact: true})).toHaveValue('mill');
  await set(page, 'spinbutton', 'Cutter', 8);
  await expect(page.getByRole('spinbutton', {name: 'Step down'})).toHaveValue('4');
  await set(page, 'spinbutton', 'Step down', 2.5);
  await set(page, 'spinbutton', 'Flute', 90);
  await set(page, 'spinbutton', 'Stepover', 35);
  await page.getByLabel('X0 Y0 at').selectOption('centre');
  await commandSays(page, '--for=mill', '--cutter=8', '--flute=90', '--step-down=2.5', '--stepover=0.35', '--origin=centre');
  await set(page, 'spinbutton', 'Step down', 0);
  await page.getByRole('spinbutton', {name: 'Step down'}).blur();
  await expect(page.getByRole('spinbutton', {name: 'Step down'})).toHaveValue('4');
  await expect(page.getByTestId('figures')).toContainText('Material', {timeout: 60_000});
  const names = Object.keys(await exported(page));
  expect(names.filter((name) => name.startsWith('mill/')).length).toBeGreaterThan(1);
  await set(page, 'spinbutton', 'Flute', 5);
  await expect(page.getByRole('alert').filter({hasText: 'flute'})).toBeVisible({timeout: 60_000});
});

test('moulds: walls and the printer are chosen, and boxes to print come', async ({studio: page}) => {
  await openSmallRing(page);
  await page.getByRole('radio', {name: /Moulds/}).check();
  await expect(page.getByLabel('Foam', {exact: true})).toHaveValue('cast');
  await set(page, 'spinbutton', 'Mould wall', 4);
  await set(page, 'spinbutton', 'Draft', 3);
  await set(page, 'spinbutton', 'Bed, up', 180);
  await page.getByRole('checkbox', {name: /Dowels/}).uncheck();
  await commandSays(page, '--for=mould', '--bed=250x210x180', '--mould-wall=4', '--draft=3', 'print.dowels=false');
  await expect(page.getByTestId('figures')).toContainText('To pour, lid', {timeout: 60_000});
  expect(Object.keys(await exported(page))).toEqual(expect.arrayContaining(['mould/bed-01.3mf', 'mould/lower-01.stl', 'mould-guide.pdf']));
});

test('each way of working brings its foam, unless another was chosen', async ({studio: page}) => {
  await open(page, sample('camera'));
  const foam = page.getByLabel('Foam', {exact: true});
  await page.getByRole('radio', {name: /Slit sponge/}).check();
  await expect(foam).toHaveValue('slit-15');
  await page.getByRole('radio', {name: /3D print/}).check();
  await expect(foam).toHaveValue('print');
  await foam.selectOption('cube-25');
  await page.getByRole('radio', {name: /Slit sponge/}).check();
  await expect(foam).toHaveValue('cube-25');
  await page.getByRole('button', {name: 'Take its usual foam: Slit sponge 15 mm'}).click();
  await expect(foam).toHaveValue('slit-15');
});

test('a sheet that cannot be is refused beside its field', async ({studio: page}) => {
  await open(page, sample('camera'));
  await page.getByRole('radio', {name: /Sheets, cut/}).check();
  await set(page, 'spinbutton', 'Sheet', 7);
  await expect(page.getByRole('alert').filter({hasText: 'mm'})).toBeVisible({timeout: 20_000});
});

test('a case that is known is filled, with walls, notches and a looser lid', async ({studio: page}) => {
  await open(page, sample('camera'));
  await page.getByLabel('Foam', {exact: true}).selectOption('slit-10');
  await set(page, 'slider', 'Wall', 20);
  await page.getByRole('button', {name: 'Which cases hold it?'}).click();
  await page.getByRole('button', {name: /% filled/}).first().click();
  await expect(page.getByRole('checkbox', {name: 'Fill a case'})).toBeChecked();
  await expect(page.getByRole('spinbutton', {name: 'Blocks x'})).toBeDisabled();
  await page.getByRole('checkbox', {name: 'Lower foam and lid each'}).check();
  await set(page, 'spinbutton', 'Clearance of the lid y', 5);
  await page.getByRole('checkbox', {name: 'Finger notches'}).check();
  await set(page, 'spinbutton', 'Width', 40);
  await foamsShown(page);
  await expect(page.getByText('What it lies on')).toBeVisible({timeout: 20_000});
  await commandSays(page, '--case=', '--clearance=0,0,0,0,5,0', '--notches=40x40x25');
});

test('what a way of working finds stands in Check, too', async ({studio: page}) => {
  await openSmallRing(page);
  const check = page.locator('#step-check');
  await page.getByRole('radio', {name: /Toy bricks/}).check();
  await expect(page.getByTestId('figures')).toContainText('Bricks, lid', {timeout: 30_000});
  await expect(check).toContainText('Note: The lid stands off');
  await expect(check.getByText('Nothing to worry about.')).toHaveCount(0);
  await page.getByRole('radio', {name: /The foams’ own files/}).check();
  await expect(check).not.toContainText('The lid stands off');
});
