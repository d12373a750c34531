import type {Page} from '@playwright/test';
import {expect} from './studio';

/** Waits until the browser's memory has the text: an object's name, or a part of a design as JSON has it. */
export async function kept(page: Page, text: string) {
  const memory = () =>
    page.evaluate(async () => {
      const opening = indexedDB.open('snug');
      await new Promise((resolve, reject) => ((opening.onsuccess = resolve), (opening.onerror = reject)));
      const db = opening.result;
      const stores = [...db.objectStoreNames].map(
        (name) =>
          new Promise((resolve) => {
            const reading = db.transaction(name).objectStore(name).getAll();
            reading.onsuccess = () => resolve(reading.result.map((value: object) => ({...value, picture: null})));
          }),
      );
      const all = await Promise.all(stores);
      db.close();
      return JSON.stringify(all);
    });
  await expect.poll(memory).toContain(text);
}
