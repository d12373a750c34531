import type {Locator, Page} from '@playwright/test';
import {sample} from './support/command_line';
import {expect, open, test} from './support/studio';

const PHONE = {width: 390, height: 844};
/** A page of 1280 x 800 px at 200 %. */
const ZOOMED = {width: 640, height: 400};
const WORKS = ['none', 'sponge', 'sheets', 'print', 'bricks', 'mill', 'mould'];

const tip = (page: Page) => page.locator('[role=tooltip]:popover-open');

async function pointAt(page: Page, control: Locator) {
  await page.mouse.move(0, 0);
  await control.scrollIntoViewIfNeeded();
  await control.hover();
  await expect(tip(page)).toBeVisible();
}

/** Controls under what is explained of another, by their names. */
const covered = (page: Page) =>
  page.evaluate(() => {
    const tip = document.querySelector('[role=tooltip]:popover-open')!.getBoundingClientRect();
    return [...document.querySelectorAll('.panel :is(input, select, button), .drawings :is(input, button)')]
      .filter((control) => {
        const {left, right, top, bottom} = control.getBoundingClientRect();
        return left < tip.right && right > tip.left && top < tip.bottom && bottom > tip.top;
      })
      .map((control) => control.getAttribute('aria-label') ?? control.textContent);
  });

test('a tip covers no field and leaves with Escape', async ({studio: page}) => {
  await open(page, sample('torus'));
  for (const name of ['Blocks x', 'Block size y', 'Wall mm', 'Layer from below']) {
    await pointAt(page, page.getByRole('spinbutton', {name, exact: true}));
    expect(await covered(page), name).toEqual([]);
  }
  await page.keyboard.press('Escape');
  await expect(tip(page)).toHaveCount(0);
});

test('on a phone a tip covers neither its control nor what is filled next', async ({studio: page}) => {
  await page.setViewportSize(PHONE);
  await open(page, sample('torus'));
  await pointAt(page, page.getByRole('spinbutton', {name: 'Blocks y', exact: true}));
  const names = await covered(page);
  for (const name of ['Blocks x', 'Blocks y', 'Blocks z', 'Block size x', 'Block size y']) expect(names).not.toContain(name);
});

for (const [name, size] of Object.entries({'on a phone': PHONE, 'at 200 %': ZOOMED}))
  test(`nothing is wider than the page ${name}`, async ({studio: page}) => {
    test.slow();
    await page.setViewportSize(size);
    const width = () => page.evaluate(() => document.documentElement.scrollWidth);
    expect(await width()).toBe(size.width);
    await open(page, sample('camera'));
    await page.locator('details').evaluateAll((all) => all.forEach((each) => ((each as HTMLDetailsElement).open = true)));
    for (const language of ['en', 'ja']) {
      await page.locator('header select').last().selectOption(language);
      for (const work of WORKS) {
        await page.locator(`input[type=radio][value=${work}]`).check();
        expect(await width(), `${language} ${work}`).toBe(size.width);
      }
    }
  });

/** Selects whose room is less than what is chosen in them, as "name: words". */
const cutSelects = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('select')].flatMap((select) => {
      const [style, pen] = [getComputedStyle(select), document.createElement('canvas').getContext('2d')!];
      pen.font = `${style.fontSize} ${style.fontFamily}`;
      const arrow = 18;
      const room = select.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - arrow;
      const cut = [...select.options].filter((option) => pen.measureText(option.label).width > room);
      return cut.map((option) => `${select.getAttribute('aria-label')}: ${option.label}`);
    }),
  );

test('selects are as wide as their words', async ({studio: page}) => {
  await open(page, sample('camera'));
  for (const language of ['en', 'ja']) {
    await page.locator('header select').last().selectOption(language);
    for (const work of WORKS) {
      await page.locator(`input[type=radio][value=${work}]`).check();
      expect(await cutSelects(page)).toEqual([]);
    }
  }
});

/** Fields for numbers that show hardly a digit, with how wide they are, px. */
const narrowFields = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll<HTMLInputElement>('input[type=number]')]
      .map((field) => ({name: field.getAttribute('aria-label'), px: field.getBoundingClientRect().width}))
      .filter(({px}) => px > 0 && px < 48)
      .map(({name, px}) => `${name}: ${Math.round(px)}`),
  );

for (const [name, size] of Object.entries({'1280 px wide': {width: 1280, height: 800}, 'on a phone': PHONE}))
  test(`every number can be read ${name}`, async ({studio: page}) => {
    await page.setViewportSize(size);
    await open(page, sample('camera'));
    await page.getByRole('checkbox', {name: 'Fill a case'}).check();
    await page.locator('details').evaluateAll((all) => all.forEach((each) => ((each as HTMLDetailsElement).open = true)));
    for (const language of ['en', 'ja']) {
      await page.locator('header select').last().selectOption(language);
      for (const work of WORKS) {
        await page.locator(`input[type=radio][value=${work}]`).check();
        expect(await narrowFields(page), `${language} ${work}`).toEqual([]);
      }
    }
  });

test('where colours are forced, what is chosen is seen', async ({studio: page}) => {
  await page.emulateMedia({forcedColors: 'active'});
  await open(page, sample('torus'));
  const ground = (element: Locator) => element.evaluate((each) => getComputedStyle(each).backgroundColor);
  const pairs = [
    [page.getByRole('button', {name: 'Look', exact: true}), page.getByRole('button', {name: 'Turn', exact: true})],
    [page.getByRole('tab', {name: 'Upright'}), page.getByRole('tab', {name: 'Lower'})],
    [page.getByRole('button', {name: 'This side down: -x'}), page.getByRole('button', {name: 'This side down: +x'})],
    [page.getByRole('link', {name: 'Object'}), page.getByRole('link', {name: 'Make'})],
  ] as const;
  for (const [chosen, other] of pairs) expect(await ground(chosen)).not.toBe(await ground(other));
});
