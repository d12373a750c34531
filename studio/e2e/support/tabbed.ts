import type {Page} from '@playwright/test';

/** What Tab reaches from the top of the page, by role and name, until it starts again. */
export async function tabbed(page: Page): Promise<string[]> {
  const names: string[] = [];
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (let i = 0; i < 200; i++) {
    await page.keyboard.press('Tab');
    const name = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return null;
      const text = element.getAttribute('aria-label') ?? (element as HTMLInputElement).labels?.[0]?.textContent ?? element.textContent;
      const visible = getComputedStyle(element).outlineStyle !== 'none' || element.closest('.number') !== null;
      return `${(text ?? '').trim()}${visible ? '' : ' (focus not visible)'}`;
    });
    if (name === null) break;
    names.push(name);
  }
  return names;
}
