import AxeBuilder from '@axe-core/playwright';
import type {Page} from '@playwright/test';

/** What axe finds on the page. */
export async function violations(page: Page): Promise<string[]> {
  // Without the page of its own that only frames of other sites need.
  const {violations: found} = await new AxeBuilder({page}).setLegacyMode().analyze();
  return found.flatMap(({id, nodes}) => nodes.map(({html}) => `${id}: ${html.slice(0, 140)}`));
}
