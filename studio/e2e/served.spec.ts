import {spawn} from 'node:child_process';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {GEOMETRY, scene, text} from '../tests/support/scenes';
import {folder, sample, SNUG} from './support/command_line';
import {expect, foamsShown, test} from './support/studio';

/** Runs `snug studio` for the time of one test; gives the address that it prints. */
async function served(options: string[], use: (address: string) => Promise<void>) {
  const server = spawn(SNUG, ['studio', '--quiet', ...options], {stdio: ['ignore', 'pipe', 'inherit']});
  try {
    const address = await new Promise<string>((resolve, reject) => {
      server.stdout.once('data', (text: Buffer) => resolve(text.toString().trim()));
      server.once('exit', () => reject(new Error('the server ended')));
    });
    await use(address);
  } finally {
    server.kill('SIGINT');
  }
}

test('snug studio OBJECT opens the object, under its own policy', async ({studio: page}) => {
  await served([sample('vase')], async (address) => {
    await page.goto(address);
    await expect(page.getByTitle('vase.stl')).toBeVisible();
    await foamsShown(page);
    await page.getByRole('link', {name: 'Make'}).click();
    await expect(page.getByRole('button', {name: 'Export', exact: true})).toBeEnabled();
  });
});

test('a thinned copy says how far it is off, and is never exported', async ({studio: page}) => {
  await served(['--most-bytes', '1000', sample('vase')], async (address) => {
    await page.goto(address);
    await expect(page.getByText('This is a thinned copy, nowhere more than')).toBeVisible();
    await foamsShown(page);
    await page.getByRole('link', {name: 'Make'}).click();
    await expect(page.getByRole('button', {name: 'Export', exact: true})).toBeDisabled();
    await expect(page.getByText('snug make vase.stl').first()).toBeVisible();
    await expect(page.getByRole('button', {name: 'Save project'})).toBeDisabled();
  });
});

test('a .gltf comes with the files that it names, from folders below it, too', async ({studio: page}) => {
  const home = folder();
  mkdirSync(join(home, 'parts'));
  writeFileSync(join(home, 'parts', 'the chair.bin'), GEOMETRY);
  writeFileSync(join(home, 'chair.gltf'), text(scene([{mesh: 0}], {uri: 'parts/the%20chair.bin'})));
  await served([join(home, 'chair.gltf')], async (address) => {
    await page.goto(address);
    await expect(page.getByTitle('chair.gltf')).toBeVisible();
    await expect(page.getByText('100 × 100 × 100 mm')).toBeVisible();
    await foamsShown(page);
  });
});
