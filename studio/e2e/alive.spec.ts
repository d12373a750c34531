import {sample} from './support/command_line';
import {expect, open, set, test} from './support/studio';

test('the page stays alive while it looks in every direction, and Cancel answers at once', async ({studio: page}) => {
  await open(page, sample('figurine'));
  // So that it takes its time.
  for (const axis of ['x', 'y', 'z']) await set(page, 'spinbutton', `Block size ${axis}`, 5);
  const progress = page.getByRole('progressbar', {name: 'Looking in every direction'});
  await page.getByRole('button', {name: 'Map of directions'}).click();
  await expect(page.getByText('Dark cuts the least.')).toBeVisible();
  const longest = await page.evaluate(async () => {
    let longest = 0;
    const watch = new PerformanceObserver((list) => {
      for (const {duration} of list.getEntries()) longest = Math.max(longest, duration);
    });
    watch.observe({entryTypes: ['longtask']});
    await new Promise((resolve) => setTimeout(resolve, 1500));
    watch.disconnect();
    return longest;
  });
  // Some 40 ms on cores of its own.
  expect(longest).toBeLessThan(300);
  await expect(progress).toBeVisible();
  const answered = await page.evaluate(async () => {
    const began = performance.now();
    const cancel = [...document.querySelectorAll('footer button')].find((button) => button.textContent === 'Cancel');
    (cancel as HTMLElement).click();
    while (document.querySelector('footer progress')) await new Promise((resolve) => setTimeout(resolve));
    return performance.now() - began;
  });
  expect(answered).toBeLessThan(500);
  // What was found so far stays.
  await expect(page.getByText('Dark cuts the least.')).toBeVisible();
});
