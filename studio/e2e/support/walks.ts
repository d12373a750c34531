import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import type {Page} from '@playwright/test';
import {en, ja, type Texts} from '../../src/words/texts';
import {folder, sample, snug} from './command_line';
import {expect} from './studio';
import type {Walk} from './walk';

// From the opened page to the downloaded pack, as somebody goes who has only the task, in either language.

export const MOST_CLICKS = 12;
export const MOST_DECISIONS = 5;
/** Proposals of several things in several foams, beside whatever else the machine does. */
export const SLOW = {timeout: 150_000};

export interface Way {
  page: Page;
  t: Texts;
  walk: Walk;
  /** At everything new that stands there. */
  look: () => Promise<void>;
}
type Files = Record<string, Uint8Array>;

export async function speak(page: Page, code: 'en' | 'ja'): Promise<Texts> {
  await page.getByLabel('Language').selectOption(code);
  return code === 'ja' ? ja : en;
}

async function openFiles({page, walk, look}: Way, ...files: string[]) {
  await look();
  // A button opens the browser's own window, where they are chosen.
  walk.clicks++;
  await page.locator('#open-object').setInputFiles(files);
}

const beginsWith = (text: string) => new RegExp(`^${text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')}`);

const chooseFoam = ({page, t, walk}: Way, value: string) =>
  walk.choose(page.getByRole('combobox', {name: t.first.have.foam, exact: true}), value);

export async function show({page, t, walk, look}: Way) {
  await look();
  await walk.click(page.getByRole('button', {name: t.first.show, exact: true}));
  await expect(page.getByRole('article').first()).toBeVisible(SLOW);
  await look();
}

/** The first proposal, or another, as far as its files. */
export async function take({page, t, walk}: Way, proposal = page.getByRole('article').first()): Promise<Files> {
  await walk.decide(proposal.getByRole('button', {name: beginsWith(t.first.take)}));
  await expect(page.getByRole('region', {name: t.steps.check, exact: true})).toBeFocused();
  await walk.click(page.getByRole('button', {name: t.fieldsOf.next(t.steps.make), exact: true}));
  await expect(page.getByTestId('figures')).toBeVisible(SLOW);
  return walk.pack(() => walk.click(page.getByRole('button', {name: t.make.export, exact: true})), t.make.anyway);
}

async function bust(way: Way): Promise<Files> {
  await openFiles(way, sample('figurine'));
  await chooseFoam(way, 'blocks slit-15');
  await show(way);
  return take(way);
}

async function camera(way: Way): Promise<Files> {
  const {page, t, walk} = way;
  const lens = (name: string, shape: string) => {
    const path = join(folder(), name);
    snug('shape', shape, '-o', path);
    return path;
  };
  await openFiles(way, sample('camera'), lens('wide.stl', 'cylinder 63x60'), lens('tele.stl', 'cylinder 70x95'));
  for (const [name, kg] of [['camera.stl', '1.2'], ['wide.stl', '0.4'], ['tele.stl', '0.7']] as const)
    await walk.type(page.getByRole('spinbutton', {name: t.first.what.massOf(name), exact: true}), kg);
  await walk.decide(page.getByRole('radio', {name: beginsWith(t.first.have.cases['hard-cases'])}));
  await show(way);
  return take(way);
}

const PART_IN_METRES = 'OFF\n4 4 0\n0 0 0\n0.06 0 0\n0 0.045 0\n0 0 0.03\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';

async function holder(way: Way): Promise<Files> {
  const {page, t, walk} = way;
  const part = join(folder(), 'part.off');
  writeFileSync(part, PART_IN_METRES);
  await openFiles(way, part);
  await walk.click(page.getByRole('button', {name: t.units.reopen, exact: true}));
  await walk.decide(page.getByRole('dialog').getByRole('button', {name: beginsWith(t.units.names.m)}));
  await chooseFoam(way, 'blocks print');
  await show(way);
  return take(way);
}

export async function castings(way: Way): Promise<Files> {
  const {page, t, walk, look} = way;
  const {of, numbered, kinds, lengths, addKind, done} = t.measure;
  const field = (n: number, kind: 'box' | 'cylinder', what: string) => page.getByRole('spinbutton', {name: of(numbered(n, kinds[kind]), what), exact: true});
  await look();
  await walk.click(page.getByRole('button', {name: t.empty.ruler, exact: true}));
  for (const [i, mm] of ['60', '40', '20'].entries()) await field(1, 'box', lengths.box[i]!).fill(mm);
  await walk.click(page.getByRole('button', {name: addKind(kinds.cylinder), exact: true}));
  await expect(field(2, 'cylinder', lengths.cylinder[0]!)).toBeFocused();
  await page.keyboard.type('25');
  await look();
  await walk.click(page.getByRole('button', {name: done, exact: true}));
  await expect(page.getByText('measured.shape · 60 × 40 × 50 mm')).toBeVisible();
  await chooseFoam(way, 'blocks sheet-10');
  await walk.type(page.getByRole('spinbutton', {name: t.first.what.copies, exact: true}), '200');
  await show(way);
  return take(way);
}

export const WALKS = {
  'a bust in slit sponge and a carton': bust,
  'a camera with two lenses in a hard case': camera,
  'a printed holder for a part without a unit': holder,
  '200 castings, of which there is only a ruler, in sheets': castings,
};
