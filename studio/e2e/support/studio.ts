import {readFileSync} from 'node:fs';
import {expect, test as base, type Page} from '@playwright/test';
import {unzipSync} from 'fflate';

/** Every field is open and nothing is asked. */
export const EVERYTHING = './?level=all';
/** As somebody sees it who opens it for the first time. */
export const PLAIN = './';

/** As a double click opens it, and as somebody sees it for the first time. */
export const ONE_FILE = new URL('../../../build/one-file/snug-studio.html', import.meta.url).href;

/** A page whose console stays silent: any error on it fails the test. */
export const test = base.extend<{address: string; studio: Page}>({
  address: [EVERYTHING, {option: true}],
  studio: async ({page, address}, use) => {
    const errors: string[] = [];
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('request', (request) => {
      const asked = new URL(request.url());
      const own = asked.href === address || /^(data|blob):$/.test(asked.protocol);
      // A page on a disk may not ask for anything; another one asks the server that it came from.
      if (!own && (address.startsWith('file:') || asked.hostname !== '127.0.0.1')) errors.push(`a request for ${asked.href}`);
    });
    await page.goto(address);
    await expect(page.getByRole('heading', {name: 'What are you packing?'})).toBeVisible();
    await use(page);
    expect(errors).toEqual([]);
  },
});

export {expect};

export const status = (page: Page) => page.locator('footer .verdict');

/** Waits until there are foams. */
export async function foamsShown(page: Page, options?: {timeout: number}) {
  await expect(status(page)).toHaveAttribute('data-fill', /^\d/, options);
}

/** Past the questions that are asked where something new is open; another one may lie above them. */
export async function skipQuestions(page: Page) {
  await page.getByRole('button', {name: 'Skip, I know what I want'}).press('Enter');
}

/** Opens a file, asked nothing, and waits for its foams. */
export async function open(page: Page, file: string | {name: string; buffer: Buffer}) {
  const input = page.getByLabel('Open object', {exact: true});
  await input.setInputFiles(typeof file === 'string' ? file : {...file, mimeType: 'application/octet-stream'});
  if (!page.url().includes('level=all')) await skipQuestions(page);
  const name = typeof file === 'string' ? (file.split('/').at(-1) ?? file) : file.name;
  await expect(page.getByTitle(name)).toBeVisible();
  await foamsShown(page);
}

/** Waits for the gaps, which are measured by themselves once nobody has changed anything for a while. */
export async function gapsMeasured(page: Page) {
  await expect(status(page)).toHaveAttribute('data-gap', /^\d/, {timeout: 60_000});
}

/** A range or number field's value, as a person's hand would set it. */
export async function set(page: Page, role: 'slider' | 'spinbutton', name: string, value: number) {
  await page.getByRole(role, {name, exact: true}).fill(String(value));
}

/** The files of the zip that Export saves. */
export async function exported(page: Page): Promise<Record<string, Uint8Array>> {
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', {name: 'Export', exact: true}).click(),
  ]);
  return unzipSync(readFileSync(await file.path()));
}

/** Waits until the command line on the page has all of these. */
export async function commandSays(page: Page, ...options: string[]) {
  for (const option of options) await expect(page.locator('code')).toContainText(option);
}
