import {cpus} from 'node:os';
import type {Page} from '@playwright/test';
import {expect, foamsShown, gapsMeasured, open, test} from '../e2e/support/studio';
import {torusStl} from '../e2e/support/torus';

// From a slider's input to the picture of its foams, in the software renderer of a headless browser: the default
// space (30 x 18 x 18) and an object of 100,352 triangles, or one of five such items, at 1280 x 800.

interface Frame {
  /** From the input event to the answer, of which the library, and until the picture was drawn and handed over. */
  library: number;
  answer: number;
  drawn: number;
  presented: number;
}

const DRAGS = 3;
const STEPS = 60;

test('from slider to picture', async ({studio: page}) => {
  await open(page, {name: 'ring.stl', buffer: torusStl(224, 224)});
  await inDefaultSpace(page);
  await gapsMeasured(page);
  await measure(page, '100,352 triangles');
});

test('one of five that turns', async ({studio: page}) => {
  const rings = [30, 31, 32, 33, 34].map((radius, i) => ({
    name: `ring-${i + 1}.stl`,
    mimeType: 'application/octet-stream',
    buffer: torusStl(224, 224, radius, 10),
  }));
  await page.getByLabel('Open object', {exact: true}).setInputFiles(rings);
  await expect(page.getByRole('list', {name: 'In the case'}).getByRole('listitem')).toHaveCount(5, {timeout: 60_000});
  await foamsShown(page, {timeout: 60_000});
  await inDefaultSpace(page);
  await page.getByRole('button', {name: '3. ring-3.stl'}).click();
  await measure(page, 'one of five items of 100,352 triangles');
});

async function inDefaultSpace(page: Page) {
  const blocks = [30, 18, 18];
  for (const [i, axis] of ['x', 'y', 'z'].entries())
    await page.getByRole('spinbutton', {name: `Blocks ${axis}`, exact: true}).fill(String(blocks[i]));
}

async function measure(page: Page, what: string) {
  const frames: Frame[] = [];
  for (let drag = 0; drag < DRAGS; drag++) {
    frames.push(...(await page.evaluate(dragged, [drag, STEPS] as const)));
    await page.waitForTimeout(1500);
  }
  report(what, frames);
}

/** Moves the slider a step at a time, as fast as pictures come. Runs in the page. */
async function dragged([drag, steps]: readonly [number, number]): Promise<Frame[]> {
  const slider = document.querySelector<HTMLInputElement>('input[type=range][aria-label="Rotation θ"]');
  if (!slider) throw new Error('there is no slider');
  const setter = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value')?.set;
  const frames: Frame[] = [];
  for (let step = 0; step < steps; step++) {
    const frame = new Promise<{entry: PerformanceMeasure; end: number}>((resolve) => {
      const watcher = new PerformanceObserver((list) => {
        watcher.disconnect();
        const entry = list.getEntries()[0] as PerformanceMeasure;
        // The next frame's start: by then this one was handed to the compositor.
        requestAnimationFrame(() => resolve({entry, end: performance.now()}));
      });
      watcher.observe({entryTypes: ['measure']});
    });
    const input = performance.now();
    setter?.call(slider, String(drag * steps + step + 1 - 90));
    slider.dispatchEvent(new Event('input', {bubbles: true}));
    const {entry, end} = await frame;
    const {answer_ms, library_ms} = entry.detail as {answer_ms: number; library_ms: number};
    frames.push({library: library_ms, answer: answer_ms, drawn: entry.startTime + entry.duration - input, presented: end - input});
  }
  return frames;
}

function report(what: string, frames: Frame[]) {
  const share = (name: keyof Frame, part: number) => {
    const sorted = frames.map((frame) => frame[name]).sort((a, b) => a - b);
    return (sorted[Math.min(Math.floor(sorted.length * part), sorted.length - 1)] ?? 0).toFixed(1).padStart(7);
  };
  const line = (text: string, name: keyof Frame) =>
    console.log(`${text.padEnd(46)}${share(name, 0.5)} ms median ${share(name, 0.95)} ms 95th percentile`);
  console.log(`${frames.length} inputs, ${what}, 30 x 18 x 18 blocks, 1280 x 800, ${cpus().length} cores`);
  line('library', 'library');
  line('library, worker and transfer', 'answer');
  line('input to drawn picture (all of the page)', 'drawn');
  line('input to presented picture', 'presented');
}
