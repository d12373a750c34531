import {readFileSync} from 'node:fs';
import {unzipSync} from 'fflate';
import {sample} from './support/command_line';
import {expect, open, set, status, test} from './support/studio';

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
  await expect(page.locator('code')).toContainText('--for=sponge --price=2EUR');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', {name: 'Export', exact: true}).click(),
  ]);
  const members = unzipSync(readFileSync(await download.path()));
  for (const name of ['lower.stl', 'depths.csv', 'report.json', 'packing-sheet.pdf'])
    expect(Object.keys(members)).toContain(name);
  const pdf = Object.keys(members).filter((name) => name.endsWith('.pdf'));
  expect(pdf.length).toBeGreaterThan(1);
  for (const name of pdf) expect(new TextDecoder().decode(members[name]!.slice(0, 5))).toBe('%PDF-');
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
  await expect(status(page)).toContainText('F ');
  await expect(page.getByText('What it lies on')).toBeVisible({timeout: 20_000});
  const command = await page.locator('code').innerText();
  for (const option of ['--case=', '--clearance=0,0,0,0,5,0', '--notches=40x40x25']) expect(command).toContain(option);
});
