import {readFileSync} from 'node:fs';
import type {Browser, Page} from '@playwright/test';
import {expect, gapsMeasured, open, test} from '../e2e/support/studio';
import {torusStl} from '../e2e/support/torus';

// What was open leaves nothing behind.

const OBJECTS = 30;
const MORE = 1.2;
const STILL = 1.05;

/** MB that the page's process has for itself, and of them of scripts' heap, once what nobody needs is gone. */
async function memory(browser: Browser, page: Page): Promise<{process: number; heap: number}> {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  await session.send('Performance.enable');
  const {metrics} = await session.send('Performance.getMetrics');
  await session.detach();
  const whole = await browser.newBrowserCDPSession();
  const {processInfo} = await whole.send('SystemInfo.getProcessInfo');
  await whole.detach();
  const ofPages = processInfo.filter(({type}) => type === 'renderer').map(({id}) => {
    const text = readFileSync(`/proc/${id}/smaps_rollup`, 'utf8');
    return Number(/^Private_Dirty: +(\d+)/m.exec(text)?.[1] ?? 0) / 1024;
  });
  const heap = metrics.find(({name}) => name === 'JSHeapUsedSize')?.value ?? 0;
  return {process: Math.max(...ofPages), heap: heap / 2 ** 20};
}

test('30 objects, one after the other, leave no more memory taken than the first', async ({browser, studio: page}) => {
  const all: {process: number; heap: number}[] = [];
  for (let i = 0; i < OBJECTS; i++) {
    await open(page, {name: `ring-${i}.stl`, buffer: torusStl(160, 160, 80 + i)});
    await gapsMeasured(page);
    all.push(await memory(browser, page));
  }
  console.log(all.map(({process, heap}) => `${process.toFixed(0)}/${heap.toFixed(1)}`).join(' '), 'MB');
  expect(all.at(-1)!.process).toBeLessThan(MORE * all[0]!.process);
  // Code that is compiled on the way is no leak: it comes to an end.
  expect(all.at(-1)!.heap).toBeLessThan(STILL * all[OBJECTS / 2]!.heap);
});
