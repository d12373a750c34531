import type {Page} from '@playwright/test';

/**
 * Watches for the first moment in which the selector matches, which a quick machine may be past before a test that looks
 * now and then has seen it: the status line's text of that moment stands at the body as `data-moment` from then on, what
 * it said of the gaps as `data-gap`, and a key is pressed in it, if one is given.
 */
export async function inTheMoment(page: Page, selector: string, key?: string): Promise<void> {
  await page.evaluate(
    ([selector, key]) => {
      delete document.body.dataset.moment;
      delete document.body.dataset.gap;
      new MutationObserver((_, observer) => {
        if (!document.querySelector(selector)) return;
        observer.disconnect();
        const {gap} = document.querySelector<HTMLElement>('[role=status]')?.dataset ?? {};
        if (gap) document.body.dataset.gap = gap;
        document.body.dataset.moment = document.querySelector('footer')?.textContent ?? '';
        if (key) window.dispatchEvent(new KeyboardEvent('keydown', {key}));
      }).observe(document.body, {subtree: true, childList: true, attributes: true});
    },
    [selector, key] as const,
  );
}
