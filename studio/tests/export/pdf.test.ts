import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {afterAll, beforeAll, describe, expect, test} from 'vitest';
import {writePdf, type Page} from '../../src/export/pdf';
import {good, startCore} from '../support/snug';

// Pages are read back by Poppler: drawn at ten dots a mm, or as words with their places.

/** One dot. */
const BLACK_PNG = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNgYGAAAAAEAAH2FzhVAAAAAElFTkSuQmCC';
const DOTS = 10;
const POINTS = 72 / 25.4;
let folder: string;
beforeAll(() => void (folder = mkdtempSync(join(tmpdir(), 'snug-pdf-'))));
afterAll(() => rmSync(folder, {recursive: true, force: true}));

function poppler(): boolean {
  try {
    execFileSync('pdftoppm', ['-v'], {stdio: 'ignore'});
    return true;
  } catch {
    return false;
  }
}

type Item = Page['items'][number];
const page = (...items: Item[]): Page => ({title: 'page', size: [60, 40], items});
const black = (width: number, dashes: number[] = []) => ({color: '#000000', width, dashes});
const square = (from: number, to: number) => [from, from, to, from, to, to, from, to];
const text = (words: string, more: object = {}): Item => ({
  text: words, at: [30, 20], height: 5, anchor: 'start', turn: 0, bold: false, color: '#000000', ...more,
});

async function saved(...pages: Page[]): Promise<string> {
  const path = join(folder, 'pages.pdf');
  writeFileSync(path, await writePdf('title', true, pages));
  return path;
}

/** How dark the first page is at (x, y) in mm, 0 to 255. */
function darkness(path: string): (x: number, y: number) => number {
  execFileSync('pdftoppm', ['-r', String(25.4 * DOTS), '-gray', '-singlefile', path, join(folder, 'picture')]);
  const picture = readFileSync(join(folder, 'picture.pgm'));
  const [, width, height] = /^P5\s+(\d+)\s+(\d+)\s+255\s/.exec(picture.toString('latin1', 0, 40))!.map(Number);
  const pixels = picture.subarray(picture.length - width! * height!);
  return (x, y) => 255 - pixels[Math.floor(y * DOTS) * width! + Math.floor(x * DOTS)]!;
}

async function drawn(...items: Item[]): Promise<(x: number, y: number) => number> {
  return darkness(await saved(page(...items)));
}

interface Word {
  text: string;
  /** mm from the upper left corner */
  left: number;
  top: number;
  right: number;
  bottom: number;
}
async function words(...pages: Page[]): Promise<Word[]> {
  const read = execFileSync('pdftotext', ['-bbox', await saved(...pages), '-']).toString();
  const found = read.matchAll(/<word xMin="(.+?)" yMin="(.+?)" xMax="(.+?)" yMax="(.+?)">(.*?)<\/word>/g);
  return Array.from(found, ([, left, top, right, bottom, word]) => ({
    text: word!,
    left: Number(left) / POINTS,
    top: Number(top) / POINTS,
    right: Number(right) / POINTS,
    bottom: Number(bottom) / POINTS,
  }));
}

describe.skipIf(!poppler())('a PDF', () => {
  test('has pages of the size that was said, asks for 100 % and is the same every time', async () => {
    const sizes: [number, number][] = [[210, 297], [215.9, 279.4], [420, 297]];
    const pages = sizes.map((size) => ({title: '', size, items: [text('one')]}));
    const read = execFileSync('pdftotext', ['-bbox', await saved(...pages), '-']).toString();
    const found = Array.from(read.matchAll(/<page width="(.+?)" height="(.+?)">/g), ([, ...size]) =>
      size.map((points) => Math.round((Number(points) / POINTS) * 100) / 100),
    );
    expect(found).toEqual(sizes);
    const bytes = await writePdf('Vase', true, pages);
    const unscaled = (pdf: Uint8Array) => /\/PrintScaling\s*\/None/.test(Buffer.from(pdf).toString('latin1'));
    expect([unscaled(bytes), unscaled(await writePdf('Vase', false, pages))]).toEqual([true, false]);
    expect(Buffer.compare(Buffer.from(bytes), Buffer.from(await writePdf('Vase', true, pages)))).toBe(0);
    expect(execFileSync('pdfinfo', [await saved(...pages)]).toString()).toMatch(/Title:\s+title/);
  });

  test('has lines where they are, as thick as they are, and y points down', async () => {
    const dark = await drawn({path: [square(5, 25)], closed: true, fill: null, pen: black(1)});
    for (const at of [4.6, 5.4]) expect(dark(at, 15), `left side at ${at}`).toBe(255);
    for (const at of [4.3, 5.7, 15]) expect(dark(at, 15), `beside it at ${at}`).toBe(0);
    expect(dark(15, 5)).toBe(255);
    expect(dark(15, 25)).toBe(255);
    expect(dark(15, 35)).toBe(0);
  });

  test('fills loops by the even-odd rule, and open lines not at all', async () => {
    const dark = await drawn(
      {path: [square(2, 30), square(10, 20)], closed: true, fill: '#000000', pen: null},
      {path: [square(35, 39)], closed: false, fill: '#000000', pen: black(0.4)},
    );
    expect([dark(5, 5), dark(15, 15), dark(28, 28)]).toEqual([255, 0, 255]);
    expect(dark(37, 37)).toBe(0);
    expect([dark(37, 35), dark(35, 37)]).toEqual([255, 0]); // open: the left side is not there
  });

  test('leaves out and draws as the dashes say', async () => {
    const dark = await drawn({path: [[5, 20, 55, 20]], closed: false, fill: null, pen: black(1, [4, 1])});
    for (let dash = 0; dash < 10; dash++) {
      expect(dark(5 + 5 * dash + 2, 20), `dash ${dash}`).toBe(255);
      expect(dark(5 + 5 * dash + 4.5, 20), `gap ${dash}`).toBe(0);
    }
  });

  test('has round circles', async () => {
    const dark = await drawn({circle: [30, 20, 10], fill: '#000000', pen: null});
    for (let degrees = 0; degrees < 360; degrees += 15) {
      const [x, y] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      expect(dark(30 + 9.8 * x, 20 + 9.8 * y), `inside at ${degrees}`).toBe(255);
      expect(dark(30 + 10.2 * x, 20 + 10.2 * y), `outside at ${degrees}`).toBe(0);
    }
  });

  test('has texts at their anchors, turned clockwise', async () => {
    const size = (word: Word) => [word.right - word.left, word.bottom - word.top];
    const [start] = await words(page(text('anchor')));
    const [middle] = await words(page(text('anchor', {anchor: 'middle'})));
    const [end] = await words(page(text('anchor', {anchor: 'end'})));
    expect(start!.left).toBeCloseTo(30, 1);
    expect((middle!.left + middle!.right) / 2).toBeCloseTo(30, 1);
    expect(end!.right).toBeCloseTo(30, 1);
    const [down] = await words(page(text('anchor', {turn: 90})));
    const [back] = await words(page(text('anchor', {turn: 180})));
    const [up] = await words(page(text('anchor', {turn: 270})));
    expect(down!.top).toBeCloseTo(20, 1);
    expect(back!.right).toBeCloseTo(30, 1);
    expect(up!.bottom).toBeCloseTo(20, 1);
    expect(size(down!)[1]).toBeCloseTo(size(start!)[0]!, 1);
    const [bold] = await words(page(text('anchor', {bold: true})));
    expect(size(bold!)[0]).toBeGreaterThan(size(start!)[0]!);
  });

  test('of maps begins with a square whose sides are 100 mm', async () => {
    const core = await startCore();
    const design = await core.defaultDesign();
    const {name, bytes} = good(await core.sampleFile('vase'));
    good(await core.load(name, new Blob([bytes]), design.object));
    const files = good(await core.outputFiles({...design, workshop: {...design.workshop, for: 'sponge'}}));
    const path = join(folder, 'maps.pdf');
    writeFileSync(path, files.find((file) => file.name === 'sponge-maps.pdf')!.bytes);
    const dark = darkness(path);
    const range = (length: number) => Array.from({length: length * DOTS}, (_, i) => (i + 0.5) / DOTS);
    const inked = (at: number[], along: number[], is: (a: number, b: number) => number) =>
      at.filter((a) => along.filter((b) => is(a, b) > 95).length > 97 * DOTS);
    const rows = inked(range(297), range(210), (y, x) => dark(x, y));
    const columns = inked(range(210), range(297), (x, y) => dark(x, y));
    expect(rows.at(-1)! - rows[0]!).toBeCloseTo(100, 0);
    expect(columns.at(-1)! - columns[0]!).toBeCloseTo(100, 0);
  }, 60_000);

  test('has a picture of what its fonts lack where the words would be, turned with them', async () => {
    // A black box of 12 x 6 mm: the words begin 1 mm from its left and stand 2 mm above its lower edge.
    const png = new Uint8Array(Buffer.from(BLACK_PNG, 'base64'));
    const draw = async () => ({png, width: 12, height: 6, left: 1, below: 2, advance: 10});
    const darkWith = async (more: object) => {
      const path = join(folder, 'picture.pdf');
      writeFileSync(path, await writePdf('title', true, [page(text('下', more), text('plain', {at: [2, 38]}))], draw));
      return darkness(path);
    };
    const start = await darkWith({});
    expect([start(29.2, 20), start(40.8, 16.2), start(40.8, 21.8)]).toEqual([255, 255, 255]);
    expect([start(28.8, 20), start(41.2, 20), start(35, 15.8), start(35, 22.2)]).toEqual([0, 0, 0, 0]);
    const end = await darkWith({anchor: 'end'});
    expect([end(19.2, 20), end(30.8, 20), end(31.2, 20)]).toEqual([255, 255, 0]);
    const down = await darkWith({turn: 90});
    expect([down(30, 29.2 - 10 + 0.2), down(28.2, 30), down(33.8, 30), down(34.2, 30)]).toEqual([255, 255, 255, 0]);
  });

  test('says every Western letter, and a question mark for what its fonts lack', async () => {
    const latin = Array.from({length: 0x5f}, (_, i) => String.fromCharCode(0xa1 + i)).filter((c) => c !== '\u00ad').join('');
    const windows = '€‚ƒ„…†‡ˆ‰Š‹ŒŽ‘’“”•–—˜™š›œžŸ';
    const read = async (words_: string) => (await words({...page(), size: [900, 40], items: [text(words_)]})).map((word) => word.text).join(' ');
    const plain = (await read(latin)).replaceAll('&amp;', '&');
    expect(plain).toBe(latin);
    expect(await read(windows)).toBe(windows);
    expect(await read('下 Ω 🧽 vase\u00a0A\u00adB\tC\nD')).toMatch(/^\? \? \?? ?\?? ?vase.A.*B\?C\?D$/u);
    expect(await read('Cafe\u0301')).toBe('Café');
  });
});
