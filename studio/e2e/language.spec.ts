import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {unzipSync} from 'fflate';
import {folder, sample} from './support/command_line';
import {commandSays, expect, open, set, test} from './support/studio';

const JAPANESE = /[\u3040-\u30ff\u4e00-\u9fff]/;
const LATIN_SENTENCE = /[a-z]{3,} [a-z]{2,} [a-z]{2,}/;

test('what is found and refused follows the language, also what stands there already', async ({studio: page}) => {
  await open(page, sample('torus'));
  await set(page, 'slider', 'Wall', 2);
  const finding = page.locator('#step-check li').first();
  await expect(finding).toContainText(LATIN_SENTENCE);
  await page.getByLabel('Open object', {exact: true}).setInputFiles({name: 'broken.stl', mimeType: '', buffer: Buffer.from('nothing')});
  const alert = page.getByRole('alert').filter({hasText: 'broken.stl'});
  await expect(alert).toContainText(LATIN_SENTENCE);
  const english = [await finding.innerText(), await alert.innerText()];
  await page.getByLabel('Language').selectOption('ja');
  for (const place of [finding, alert]) {
    await expect(place).toContainText(JAPANESE);
    await expect(place).not.toContainText(LATIN_SENTENCE);
  }
  await page.getByLabel('言語').selectOption('en');
  expect([await finding.innerText(), await alert.innerText()]).toEqual(english);
});

test('a Japanese page makes Japanese files, with a Japanese object on every sheet', async ({studio: page}) => {
  await open(page, {name: '土器.stl', buffer: readFileSync(sample('torus'))});
  await page.getByRole('radio', {name: /Slit sponge/}).check();
  await page.getByLabel('Language').selectOption('ja');
  await expect(page.getByTestId('figures')).toContainText('抜くブロック', {timeout: 30_000});
  await commandSays(page, '--for=sponge', '--language=ja');
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', {name: '書き出す', exact: true}).click()]);
  const members = unzipSync(readFileSync(await file.path()));
  expect(new TextDecoder().decode(members['preview.svg'])).toMatch(JAPANESE);
  const sheet = Buffer.from(members['packing-sheet.pdf']!);
  // The words are pictures; what the fonts have stays text, and nothing is a question mark.
  expect(sheet.toString('latin1')).toMatch(/\/Subtype\s*\/Image/);
  const out = process.env.SNUG_PAGES ?? folder();
  mkdirSync(out, {recursive: true});
  writeFileSync(join(out, 'packing-sheet.pdf'), sheet);
  const text = execFileSync('pdftotext', [join(out, 'packing-sheet.pdf'), '-']).toString();
  expect(text).not.toContain('?');
});
