import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {unzipSync} from 'fflate';
import type {Download, Page} from '@playwright/test';
import {folder, made, sample, untimed} from './support/command_line';
import {expect, foamsShown, open, set, test} from './support/studio';

async function bytes(download: Download): Promise<Buffer> {
  return readFileSync(await download.path());
}

async function exported(page: Page, kind: RegExp): Promise<Map<string, Buffer>> {
  await page.getByRole('radio', {name: kind}).check();
  const files = new Map<string, Buffer>();
  const wanted = kind.source.includes('zip') ? 1 : 2;
  const all = new Promise<void>((resolve) => {
    page.on('download', async (download) => {
      files.set(download.suggestedFilename(), await bytes(download));
      if (files.size === wanted) resolve();
    });
  });
  await page.getByRole('button', {name: 'Export', exact: true}).click();
  await all;
  page.removeAllListeners('download');
  return files;
}

const ROTATION = {ψ: 12, θ: -30, φ: 77};

test('an exported foam is the command line’s, byte for byte', async ({studio: page}) => {
  const vase = sample('vase');
  await open(page, vase);
  for (const [angle, degrees] of Object.entries(ROTATION)) await set(page, 'slider', `Rotation ${angle}`, degrees);
  for (const [axis, count] of Object.entries({x: 24, y: 26, z: 20})) await set(page, 'spinbutton', `Blocks ${axis}`, count);
  for (const [axis, mm] of Object.entries({x: 14, y: 13.5, z: 20})) await set(page, 'spinbutton', `Block size ${axis}`, mm);
  await set(page, 'slider', 'Clearance', 1.5);
  await expect(page.getByText('336 × 351 × 400 mm')).toBeVisible();

  const options = ['--rotate', '12,-30,77', '--blocks', '24x26x20', '--block-size', '14x13.5x20', '--clearance', '1.5'];
  const expected = made(vase, ...options);
  const foams = await exported(page, /foams as STL/);
  expect([...foams.keys()].sort()).toEqual(['lower.stl', 'upper.stl']);
  for (const [name, content] of foams) expect(content.equals(expected.get(name) ?? Buffer.alloc(0)), name).toBe(true);

  const saved = page.getByRole('status').filter({hasText: 'saved'});
  await expect(saved).toHaveText('lower.stl, upper.stl were saved');
  const zip = unzipSync([...(await exported(page, /in one zip/)).values()][0] ?? Buffer.alloc(0));
  expect(Object.keys(zip).sort()).toEqual([...expected.keys()].sort());
  for (const [name, content] of expected) {
    const mine = Buffer.from(zip[name] ?? []);
    if (name === 'report.json') expect(untimed(mine)).toEqual(untimed(content));
    else expect(mine.equals(content), name).toBe(true);
  }
  await expect(saved).toHaveText('vase-foam.zip was saved');
  await expect(page.locator('#step-make')).toContainText('vase-foam.zip was saved');
  await set(page, 'slider', 'Clearance', 2);
  await expect(page.getByText('was saved')).toHaveCount(0);
});

test('a fitted space exports what --blocks auto makes', async ({studio: page}) => {
  const camera = sample('camera', 'ply');
  await open(page, camera);
  const foams = await exported(page, /foams as PLY/);
  const expected = made(camera, '--blocks', 'auto');
  for (const [name, content] of foams) expect(content.equals(expected.get(name) ?? Buffer.alloc(0)), name).toBe(true);
  expect(foams.size).toBe(2);
});

test('a saved project makes the same foams on the command line, and comes back', async ({studio: page}) => {
  const path = sample('figurine');
  await open(page, path);
  await set(page, 'slider', 'Rotation θ', 35);
  await foamsShown(page);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', {name: 'Save project'}).click(),
  ]);
  expect(download.suggestedFilename()).toBe('figurine.snug.json');
  const project = join(folder(), 'figurine.snug.json');
  await download.saveAs(project);
  const foams = await exported(page, /foams as STL/);
  const expected = made(project, '--object', path);
  expect(foams.get('lower.stl')?.equals(expected.get('lower.stl') ?? Buffer.alloc(0))).toBe(true);

  // A project that the command line wrote, with its object, into a page that has forgotten it.
  const other = join(folder(), 'other.snug.json');
  const written = made(path, '--rotate', '0,90,0', '--blocks', '22x30x20').get('project.snug.json');
  (await import('node:fs')).writeFileSync(other, written ?? '');
  await page.getByLabel('Open object', {exact: true}).setInputFiles([other, path]);
  await expect(page.getByRole('spinbutton', {name: 'Blocks y', exact: true})).toHaveValue('30');
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toHaveValue('90');
});

test('while a danger stands, Export names it and asks', async ({studio: page}) => {
  await open(page, {name: 'cup.off', buffer: openBox()});
  await page.getByRole('button', {name: 'Export', exact: true}).click();
  const dialog = page.getByRole('dialog', {name: 'This foam is not safe yet'});
  await expect(dialog).toContainText('foam would grow inside');
  await dialog.getByRole('button', {name: 'Go back'}).click();
  await expect(dialog).toBeHidden();
  await page.getByRole('button', {name: 'Export', exact: true}).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    dialog.getByRole('button', {name: 'Make the files anyway'}).click(),
  ]);
  expect(download.suggestedFilename()).toBe('cup-foam.zip');

  // What the finding offers mends it.
  await page.getByRole('button', {name: 'Close the holes'}).click();
  await expect(page.getByText('Danger: Foam would grow inside')).toHaveCount(0);
  const [safe] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', {name: 'Export', exact: true}).click(),
  ]);
  expect(safe.suggestedFilename()).toBe('cup-foam.zip');
});

/** A box of 100 mm without its lowest side (-x). */
function openBox(): Buffer {
  const corners = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => `${x * 100} ${y * 100} ${z * 100}`)));
  const sides = ['4 5 7 6', '0 4 6 2', '1 3 7 5', '0 1 5 4', '2 6 7 3'].map((side) => `4 ${side}`);
  return Buffer.from(['OFF', `8 ${sides.length} 0`, ...corners, ...sides, ''].join('\n'));
}
