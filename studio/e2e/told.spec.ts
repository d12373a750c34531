import {sample} from './support/command_line';
import {hold, holdReads, letGo} from './support/hold_reads';
import {inTheMoment} from './support/in_the_moment';
import {kept} from './support/kept';
import {EVERYTHING, expect, foamsShown, gapsMeasured, open, PLAIN, set, skipQuestions, status, test} from './support/studio';
import {torusStl} from './support/torus';
import {WEDGE_IN_METRES} from './support/wedge';

const PHONE = {width: 390, height: 800};
const file = (name: string, content: string) => ({name, mimeType: '', buffer: Buffer.from(content)});

for (const viewport of [PHONE, {width: 1280, height: 800}])
  test(`a refusal is in view ${viewport.width} px wide, and stays until it is read`, async ({studio: page}) => {
    await page.setViewportSize(viewport);
    await open(page, sample('torus'));
    // As far from the sentence's old place as one can be.
    await page.getByRole('button', {name: 'Export', exact: true}).scrollIntoViewIfNeeded();
    await page.getByLabel('Open object', {exact: true}).setInputFiles(file('broken.stl', 'nothing'));
    const alert = page.getByRole('alert').filter({hasText: 'broken.stl: '});
    await expect(alert).toBeInViewport({ratio: 1});
    await set(page, 'slider', 'Wall', 60);
    await expect(page.getByRole('spinbutton', {name: 'Wall mm'})).toHaveValue('60');
    await expect(alert).toBeInViewport();
    await alert.getByRole('button', {name: 'Close'}).click();
    await expect(alert).toBeHidden();
  });

test('what is read is named from the first moment, and Cancel leaves the work before', async ({page}) => {
  await holdReads(page);
  await page.goto(EVERYTHING);
  await open(page, sample('torus'));
  await set(page, 'slider', 'Rotation ψ', 20);
  await hold(page);
  await page.getByLabel('Open object', {exact: true}).setInputFiles(sample('vase'));
  await expect(page.getByText('Reading vase.stl')).toBeInViewport();
  await expect(page.getByRole('progressbar', {name: 'Reading the object'})).toBeVisible();
  await page.evaluate(() => {
    window.holdReads = false;
    window.heldReads = []; // it would never have ended
  });
  await page.getByRole('button', {name: 'Cancel'}).click();
  await expect(page.getByText('Reading vase.stl')).toBeHidden();
  await expect(page.getByTitle('torus.stl')).toBeVisible();
  await expect(page.getByRole('slider', {name: 'Rotation ψ'})).toHaveValue('20');
  // The library has the object again, too.
  await set(page, 'slider', 'Wall', 80);
  await expect(page.getByText('No foam')).toBeHidden();
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('80');
  await expect(page.getByRole('button', {name: 'Export', exact: true})).toBeEnabled();
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('slider', {name: 'Wall'})).toHaveValue('50');
});

test('another file ends the reading of the one before', async ({page}) => {
  await holdReads(page, true);
  await page.goto(EVERYTHING);
  await page.getByLabel('Open object', {exact: true}).setInputFiles(sample('vase'));
  await expect(page.getByText('Reading vase.stl')).toBeVisible();
  await page.evaluate(() => {
    window.holdReads = false;
    window.heldReads = [];
  });
  await page.getByLabel('Open object', {exact: true}).setInputFiles(sample('torus'));
  await expect(page.getByTitle('torus.stl')).toBeVisible();
  await foamsShown(page);
  await expect(page.getByText('Reading')).toBeHidden();
});

test('the page is there before the object that comes back, which can be left for later', async ({page}) => {
  await page.goto(EVERYTHING);
  await open(page, sample('torus'));
  await set(page, 'slider', 'Rotation ψ', 20);
  await kept(page, '"rotation_deg":[20,0,0]');
  await holdReads(page, true);
  await page.reload();
  await expect(page.getByText('Reading torus.stl')).toBeVisible();
  await expect(page.getByRole('navigation', {name: 'Steps'})).toBeVisible();
  await page.getByRole('button', {name: 'Cancel'}).click();
  await expect(page.getByRole('heading', {name: 'What are you packing?'})).toBeVisible();
  await letGo(page);
  await page.getByRole('button', {name: /^Continue torus.stl/}).click();
  await expect(page.getByTitle('torus.stl')).toBeVisible();
  await expect(page.getByRole('slider', {name: 'Rotation ψ'})).toHaveValue('20');
});

test.describe('where something is asked', () => {
  test.use({address: PLAIN});

  test('the question for the unit can be left, found again, moved, and answered by a length', async ({studio: page}) => {
    await page.getByLabel('Open object', {exact: true}).setInputFiles(file('wedge.off', WEDGE_IN_METRES));
    await skipQuestions(page);
    const question = page.getByRole('dialog', {name: 'Which unit does this file use?'});
    await expect(question).toBeVisible();
    const before = await question.boundingBox();
    await page.getByRole('heading', {name: 'Which unit does this file use?'}).hover();
    await page.mouse.down();
    await page.mouse.move(300, 400, {steps: 3});
    await page.mouse.up();
    expect((await question.boundingBox())?.y).not.toBe(before?.y);
    await page.keyboard.press('Escape');
    await expect(question).toBeHidden();
    // In the step Check it is said as well.
    await expect(page.locator('span', {hasText: 'There are no foams yet'})).toBeInViewport();
    await page.getByRole('button', {name: 'Choose the unit'}).first().click();
    await question.getByRole('spinbutton', {name: 'Or: its longest side is'}).fill('300');
    await question.getByRole('button', {name: 'Set', exact: true}).click();
    await expect(question).toBeHidden();
    await expect(page.getByText('There are no foams yet')).toHaveCount(0);
    await expect(page.getByText('300 × 225 × 150 mm')).toBeVisible();
    await expect(page.getByLabel('Unit of the file').locator('option:checked')).toHaveText('by a known length');
    // The length is of this object alone.
    await page.getByLabel('Open object', {exact: true}).setInputFiles(file('other.off', WEDGE_IN_METRES.replace('0.15', '0.16')));
    await skipQuestions(page);
    await expect(page.getByTitle('other.off')).toBeVisible();
    await expect(question.getByRole('spinbutton', {name: 'Or: its longest side is'})).toHaveValue('0');
    await question.getByRole('button', {name: /^Metres/}).click();
    await foamsShown(page);
  });
});

test('a part that must stay keeps its tick', async ({studio: page}) => {
  const corners = (at: number) => `0 0 ${at}\n60 0 ${at}\n0 50 ${at}\n0 0 ${at + 40}\n`;
  const faces = (i: number) => [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map((face) => `3 ${face.map((corner) => corner + i).join(' ')}\n`).join('');
  await open(page, {name: 'two.off', buffer: Buffer.from(`OFF\n8 8 0\n${corners(0)}${corners(80)}${faces(0)}${faces(4)}`)});
  const part = (number: number) => page.getByRole('checkbox', {name: `Part ${number}:`});
  await part(1).click();
  await expect(page.locator('#step-object dl')).toContainText('60 × 50 × 40 mm');
  await part(2).click();
  await expect(page.getByRole('alert')).toBeVisible();
  await expect(part(2)).toBeChecked();
  await expect(part(1)).not.toBeChecked();
  await part(1).click();
  await expect(part(1)).toBeChecked();
  await expect(page.locator('#step-object dl')).toContainText('60 × 50 × 120 mm');
});

test('gaps whose measuring is cancelled are said to be not measured', async ({studio: page}) => {
  await inTheMoment(page, 'progress[aria-label^="Measuring the gaps"]', 'Escape');
  await open(page, {name: 'ring.stl', buffer: torusStl(300, 150)});
  await expect(page.locator('body')).toHaveAttribute('data-gap', 'comes');
  await expect(status(page)).toHaveAttribute('data-gap', 'none');
  await page.getByRole('button', {name: 'Figures'}).click();
  await expect(page.locator('footer')).toContainText('not measured');
  await page.getByRole('button', {name: 'Measure the gaps'}).click();
  await gapsMeasured(page);
});

test('nothing makes a narrow page scroll sideways', async ({studio: page}) => {
  await page.setViewportSize(PHONE);
  await open(page, sample('torus'));
  for (const work of ['Toy bricks', 'Mill', 'The foams’ own files']) {
    await page.getByRole('radio', {name: new RegExp(work)}).check();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(PHONE.width);
  }
});
