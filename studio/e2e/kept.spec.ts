import {readFileSync} from 'node:fs';
import type {BrowserContext, Page} from '@playwright/test';
import {made, sample} from './support/command_line';
import {kept} from './support/kept';
import {EVERYTHING, expect, foamsShown, open, set, test} from './support/studio';

const slider = (page: Page, name: string) => page.getByRole('slider', {name, exact: true});
const empty = (page: Page) => page.getByRole('heading', {name: 'What are you packing?'});

async function another(context: BrowserContext): Promise<Page> {
  const page = await context.newPage();
  await page.goto(EVERYTHING);
  await expect(empty(page)).toBeVisible();
  return page;
}

test('each tab keeps its own work, whatever the others do', async ({studio: first, context}) => {
  await open(first, sample('torus'));
  await set(first, 'slider', 'Rotation ψ', 20);
  await kept(first, '"rotation_deg":[20,0,0]');
  const second = await another(context);
  await open(second, sample('vase'));
  await set(second, 'slider', 'Rotation ψ', 40);
  await kept(second, '"rotation_deg":[40,0,0]');

  await first.reload();
  await expect(first.getByTitle('torus.stl')).toBeVisible();
  await expect(slider(first, 'Rotation ψ')).toHaveValue('20');
  await second.reload();
  await expect(second.getByTitle('vase.stl')).toBeVisible();
  await expect(slider(second, 'Rotation ψ')).toHaveValue('40');
});

test('a fresh tab asks which work to go on with, and offers none that another tab has open', async ({studio: first, context}) => {
  await open(first, sample('torus'));
  await set(first, 'slider', 'Rotation ψ', 20);
  await kept(first, '"rotation_deg":[20,0,0]');
  const second = await another(context);
  await open(second, sample('vase'));
  await kept(second, 'vase.stl');
  await second.close();

  const third = await another(context);
  await expect(third.getByRole('button', {name: /^Continue vase.stl/})).toBeVisible();
  await expect(third.getByRole('button', {name: /^Continue torus.stl/})).toHaveCount(0);
  await third.getByRole('button', {name: /^Continue vase.stl/}).click();
  await expect(third.getByTitle('vase.stl')).toBeVisible();
  await foamsShown(third);
  await first.close();

  const fourth = await another(context);
  await expect(fourth.getByRole('button', {name: /^Continue torus.stl/})).toBeVisible();
  await fourth.getByRole('button', {name: /^Discard torus.stl/}).click();
  await fourth.getByRole('button', {name: 'Discard it for good'}).click();
  await expect(fourth.getByText('Go on where you left off')).toBeHidden();
  // The work that is open in another tab is still there.
  await third.reload();
  await expect(third.getByTitle('vase.stl')).toBeVisible();
});

test('a duplicated tab goes on with a copy', async ({studio: first}) => {
  await open(first, sample('torus'));
  await set(first, 'slider', 'Rotation ψ', 20);
  await kept(first, '"rotation_deg":[20,0,0]');
  // A tab that is opened by another starts with what that one has in its session.
  const [second] = await Promise.all([first.waitForEvent('popup'), first.evaluate(() => void window.open(location.href))]);
  await expect(second.getByTitle('torus.stl')).toBeVisible();
  await foamsShown(second);
  await set(second, 'slider', 'Rotation ψ', 70);
  await kept(second, '"rotation_deg":[70,0,0]');
  await second.reload();
  await expect(slider(second, 'Rotation ψ')).toHaveValue('70');
  await first.reload();
  await expect(first.getByTitle('torus.stl')).toBeVisible();
  await expect(slider(first, 'Rotation ψ')).toHaveValue('20');
});

test('Start over forgets the work of its own tab alone', async ({studio: first, context}) => {
  await open(first, sample('torus'));
  await kept(first, 'torus.stl');
  const second = await another(context);
  await open(second, sample('vase'));
  await kept(second, 'vase.stl');
  await second.getByRole('button', {name: 'Start over'}).click();
  await second.getByRole('button', {name: 'Forget everything'}).click();
  await expect(empty(second)).toBeVisible();
  await second.reload();
  await expect(empty(second)).toBeVisible();
  await expect(second.getByText('Go on where you left off')).toBeHidden();
  await first.reload();
  await expect(first.getByTitle('torus.stl')).toBeVisible();
});

test('the work that an earlier version kept is offered, too', async ({page}) => {
  const torus = sample('torus');
  const {design} = JSON.parse(made(torus).get('project.snug.json')?.toString() ?? '') as {design: object};
  await page.route('**/nothing', (route) => route.fulfill({contentType: 'text/html', body: '<p>nothing</p>'}));
  await page.goto('./nothing');
  await page.evaluate(
    async ({design, base64}) => {
      const opening = indexedDB.open('snug', 1);
      opening.onupgradeneeded = () => {
        opening.result.createObjectStore('work');
        opening.result.createObjectStore('objects', {keyPath: 'id'});
      };
      await new Promise((resolve) => (opening.onsuccess = resolve));
      const change = opening.result.transaction(['work', 'objects'], 'readwrite');
      const moments = [{design, object: null}, {design, object: 'a'}];
      change.objectStore('work').put({history: {moments, at: 1, control: '', time: 0}}, 'last');
      change.objectStore('objects').put({id: 'a', name: 'ring.stl', content: new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))]), converted: false});
      await new Promise((resolve) => (change.oncomplete = resolve));
      opening.result.close();
    },
    {design, base64: readFileSync(torus, 'base64')},
  );
  await page.goto(EVERYTHING);
  await page.getByRole('button', {name: /^Continue ring.stl/}).click();
  await expect(page.getByTitle('ring.stl')).toBeVisible();
  await foamsShown(page);
});

test('a change just before the page goes is there when it comes back', async ({studio: page}) => {
  await open(page, sample('torus'));
  await set(page, 'slider', 'Rotation ψ', 20);
  await kept(page, '"rotation_deg":[20,0,0]');
  await set(page, 'slider', 'Wall', 73);
  await page.reload();
  await expect(page.getByTitle('torus.stl')).toBeVisible();
  await expect(slider(page, 'Wall')).toHaveValue('73');
  await expect(slider(page, 'Rotation ψ')).toHaveValue('20');
  await kept(page, '"wall_mm":73');
  await page.keyboard.press('Control+z');
  await page.reload();
  await expect(page.getByTitle('torus.stl')).toBeVisible();
  await expect(slider(page, 'Wall')).toHaveValue('50');
  await expect(page.getByRole('button', {name: 'Redo', exact: true})).toBeEnabled();
});
