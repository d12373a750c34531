import {readFileSync} from 'node:fs';
import {made, sample} from './support/command_line';
import {expect, foamsShown, open, set, status, test} from './support/studio';

const file = (name: string, content: string | Buffer) => ({name, mimeType: '', buffer: Buffer.from(content)});

test('broken files get a sentence, and the last good object stays', async ({studio: page}) => {
  const vase = sample('vase');
  await open(page, vase);
  const before = (await status(page).getAttribute('data-fill')) ?? '';
  const input = page.getByLabel('Open object', {exact: true});
  const whole = readFileSync(vase);
  const newer = JSON.stringify({...JSON.parse(made(vase).get('project.snug.json')?.toString() ?? ''), snug: 99});
  const broken = [
    [file('cut.stl', whole.subarray(0, whole.length - 700)), /cut\.stl: /],
    [file('noise.ply', Buffer.from(Array.from({length: 999}, (_, i) => (i * 7919) % 251))), /noise\.ply: /],
    [file('empty.obj', ''), /empty\.obj: /],
    [file('picture.png', 'PNG'), /picture\.png: /],
    [file('scene.glb', 'glTF, they said'), /scene\.glb: /],
    [file('box.3mf', 'PK, perhaps'), /box\.3mf: /],
    [file('project.snug.json', '{"snug": 1, '), /project\.snug\.json: /],
    [file('project.snug.json', newer), /newer/],
  ] as const;
  for (const [content, sentence] of broken) {
    await input.setInputFiles(content);
    await expect(page.getByRole('alert').filter({hasText: sentence})).toBeVisible();
    await expect(page.getByTitle('vase.stl')).toBeVisible();
  }
  await set(page, 'slider', 'Rotation ψ', 0);
  await expect(status(page)).toHaveAttribute('data-fill', before);
});

test('a number outside its range gets the library’s sentence beside it, and nothing changes', async ({studio: page}) => {
  await open(page, sample('torus'));
  const blocks = page.getByRole('spinbutton', {name: 'Blocks x', exact: true});
  const before = await blocks.inputValue();
  await blocks.fill('5000');
  await expect(page.getByRole('alert')).toContainText('a count of blocks is 5000, but must be from 1 to 4096');
  await blocks.blur();
  await expect(blocks).toHaveValue(before);
  await set(page, 'spinbutton', 'Block size y', 0);
  await expect(page.getByRole('alert')).toContainText('but must be from 0.1 to 10000 mm');
  await set(page, 'spinbutton', 'Clearance mm', -50);
  await expect(page.getByRole('alert')).toContainText('the clearance must be');
  await set(page, 'slider', 'Wall', 60);
  await expect(page.getByRole('alert')).toBeHidden();
});

test('a space that is too small draws the object and says what would do', async ({studio: page}) => {
  await open(page, sample('vase'));
  await set(page, 'spinbutton', 'Blocks x', 3);
  await expect(status(page)).toContainText('It does not fit');
  await expect(page.getByText('Danger: Does not fit')).toBeVisible();
  await expect(page.getByRole('button', {name: 'Export', exact: true})).toBeDisabled();
  await page.getByRole('button', {name: 'Fit the space'}).click();
  await foamsShown(page);
});

test('a project without its object asks for it, and is used for no other', async ({studio: page}) => {
  const vase = sample('vase');
  const project = made(vase, '--rotate', '0,45,0').get('project.snug.json') ?? Buffer.alloc(0);
  const input = page.getByLabel('Open object', {exact: true});
  await input.setInputFiles(file('work.snug.json', project));
  await expect(page.getByRole('alert')).toContainText('Now open its object: vase.stl');
  await input.setInputFiles(sample('torus'));
  await expect(page.getByRole('alert')).toContainText('The project was for vase.stl and is not used');
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toHaveValue('0');
  await input.setInputFiles(vase);
  await expect(page.getByTitle('vase.stl')).toBeVisible();
  await expect(page.getByRole('slider', {name: 'Rotation θ'})).toHaveValue('0');
});
