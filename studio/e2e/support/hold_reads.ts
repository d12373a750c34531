import type {Page} from '@playwright/test';

declare global {
  interface Window {
    holdReads?: boolean;
    heldReads: (() => void)[];
  }
}

/** From the next load of the page on, what is asked to be read is not read before letGo(): a file as large as it
 *  likes. `from_start`: the first object, too. */
export async function holdReads(page: Page, from_start = false) {
  await page.addInitScript((hold) => {
    window.holdReads = hold;
    window.heldReads = [];
    const post = Worker.prototype.postMessage as (this: Worker, ...args: unknown[]) => void;
    Worker.prototype.postMessage = function (this: Worker, ...args: unknown[]) {
      const {path} = args[0] as {path?: string[]};
      if (window.holdReads && path?.[0] === 'load') window.heldReads.push(() => post.apply(this, args));
      else post.apply(this, args);
    } as typeof Worker.prototype.postMessage;
  }, from_start);
}

export const hold = (page: Page) => page.evaluate(() => void (window.holdReads = true));

export const letGo = (page: Page) =>
  page.evaluate(() => {
    window.holdReads = false;
    for (const read of window.heldReads.splice(0)) read();
  });
