import {readFileSync} from 'node:fs';
import type {Download, Locator, Page} from '@playwright/test';
import {unzipSync} from 'fflate';

/** A way through the page, with what it takes of whoever goes it. */
export class Walk {
  readonly #page: Page;
  clicks = 0;
  decisions = 0;

  constructor(page: Page) {
    this.#page = page;
  }

  async click(place: Locator): Promise<void> {
    this.clicks++;
    await place.click();
  }

  /** One of a list that unfolds. */
  async choose(list: Locator, option: string): Promise<void> {
    this.clicks += 2;
    this.decisions++;
    await list.selectOption(option);
  }

  async type(field: Locator, value: string): Promise<void> {
    this.clicks++;
    this.decisions++;
    await field.fill(value);
  }

  async decide(place: Locator): Promise<void> {
    this.decisions++;
    await this.click(place);
  }

  /** The zip that a click, or a key, makes the page hand over; what it warns of is read and agreed to. */
  async pack(begin: () => Promise<void>, anyway: string): Promise<Record<string, Uint8Array>> {
    const download = this.#page.waitForEvent('download', {timeout: 60_000});
    await begin();
    const warned = this.#page.getByRole('dialog').getByRole('button', {name: anyway});
    const first = await Promise.race([download, warned.waitFor().then(() => null, () => null)]);
    if (!first) await this.click(warned);
    return filesOf(await download);
  }
}

async function filesOf(file: Download): Promise<Record<string, Uint8Array>> {
  return unzipSync(readFileSync(await file.path()));
}

/** Presses Tab until what has the focus is called so. */
export async function tabTo(page: Page, name: RegExp): Promise<void> {
  for (let i = 0; i < 80; i++) {
    await page.keyboard.press('Tab');
    const here = await page.evaluate(() => {
      const element = document.activeElement as HTMLInputElement | null;
      return (element?.getAttribute('aria-label') ?? element?.labels?.[0]?.textContent ?? element?.textContent ?? '').trim();
    });
    if (name.test(here)) return;
  }
  throw new Error(`Tab does not reach ${name}`);
}
