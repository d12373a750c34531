import type {Page} from '@playwright/test';

/** Waits until the page has come to rest: nothing asks for another picture any more. */
export async function atRest(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const frame = window.requestAnimationFrame;
    let asked = false;
    window.requestAnimationFrame = (draw) => {
      asked = true;
      return frame(draw);
    };
    for (let quiet = 0; quiet < 3; quiet = asked ? 0 : quiet + 1) {
      asked = false;
      await new Promise(frame);
    }
    window.requestAnimationFrame = frame;
  });
}
