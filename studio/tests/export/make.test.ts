import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, relative} from 'node:path';
import {unzipSync} from 'fflate';
import {afterAll, beforeAll, describe, expect, test} from 'vitest';
import type {Design, Triple, Work} from '../../src/design/design';
import {usualPreset} from '../../src/design/edit';
import type {OutputFile} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {placeless} from '../support/report';
import {good, refused, startCore} from '../support/snug';
import {WORKS} from '../support/works';

// What a maker gets from the page, beside what the command line writes for the same project. PDF comes from two
// libraries, so its pages are compared as pictures that a third program draws.

const SNUG = new URL('../../../build/snug', import.meta.url).pathname;
let core: EngineCore;
let folder: string;
let file: OutputFile;

beforeAll(async () => {
  core = await startCore();
  folder = mkdtempSync(join(tmpdir(), 'snug-make-'));
  file = good(await core.sampleFile('camera'));
  writeFileSync(join(folder, file.name), file.bytes);
  const design = await core.defaultDesign();
  good(await core.load(file.name, new Blob([file.bytes]), design.object));
});
afterAll(() => rmSync(folder, {recursive: true, force: true}));

async function designFor(work: Work | null): Promise<Design> {
  const design = await core.defaultDesign();
  const preset = usualPreset(await core.presets(), work) ?? (await core.presets())[0]!;
  return {
    ...design,
    space: {...design.space, preset: preset.name, block_mm: preset.block_mm, blocks: 'auto'},
    workshop: {...design.workshop, for: work, price_per_litre: 0.8, currency: 'EUR', mass_kg: 1.2},
  };
}

/** Without the hidden list of what was made, which a zip needs not. */
function filesIn(path: string): Map<string, Buffer> {
  const names = readdirSync(path, {recursive: true, withFileTypes: true});
  const paths = names.filter((name) => name.isFile() && !name.name.startsWith('.')).map((name) => join(name.parentPath, name.name));
  return new Map(paths.map((name) => [relative(path, name), readFileSync(name)]));
}

/** Grey values of each page, 36 dots an inch. */
function pages(pdf: Uint8Array, name: string): Buffer[] {
  const path = join(folder, `${name}.pdf`);
  writeFileSync(path, pdf);
  execFileSync('pdftoppm', ['-r', '36', '-gray', path, join(folder, name)]);
  const pictures = readdirSync(folder).filter((picture) => picture.startsWith(`${name}-`) && picture.endsWith('.pgm'));
  return pictures.sort().map((picture) => readFileSync(join(folder, picture)));
}

/** But for PDF, which comes from two libraries. */
function expectTheSame(made: ReadonlyMap<string, Uint8Array>, written: ReadonlyMap<string, Buffer>) {
  expect([...made.keys()].sort()).toEqual([...written.keys()].sort());
  for (const [name, bytes] of made) {
    const other = written.get(name)!;
    if (name === 'report.json') {
      expect(placeless(new TextDecoder().decode(bytes))).toBe(placeless(other.toString()));
    } else if (name.endsWith('.3mf')) {
      expect(Object.keys(unzipSync(bytes))).toEqual(Object.keys(unzipSync(other)));
      expect(unzipSync(bytes)).toEqual(unzipSync(new Uint8Array(other)));
    } else if (!name.endsWith('.pdf')) {
      expect(Buffer.compare(Buffer.from(bytes), other), name).toBe(0);
    }
  }
}

describe.skipIf(!existsSync(SNUG))('a pack from the page', () => {
  test.each(WORKS)('for %s is the command line’s', async (work) => {
    const design = await designFor(work);
    const made = new Map(good(await core.outputFiles(design)).map(({name, bytes}) => [name, bytes]));
    const project = join(folder, `${work}.snug.json`);
    writeFileSync(project, good(await core.projectText(design)).text);
    const out = join(folder, work);
    execFileSync(SNUG, ['make', project, '--object', join(folder, file.name), '-o', out, '--quiet']);
    const written = filesIn(out);
    expectTheSame(made, written);
  });

  test('of several items is the command line’s, and so is the line that makes it', async () => {
    const ring = good(await core.sampleFile('torus'));
    writeFileSync(join(folder, ring.name), ring.bytes);
    const load = async ({name, bytes}: OutputFile, joins: boolean) =>
      good(await core.load(name, new Blob([bytes]), (await core.defaultDesign()).object, [], {joins}));
    const ids = [await load(file, false), await load(ring, true)].map(({id}) => id);
    const defaults = await designFor('sheets');
    const own = {...defaults.object, scale: 0.5};
    const objects = [{id: ids[0]!, own: null}, {id: ids[1]!, own}];
    const [item] = defaults.items;
    const design = {
      ...defaults,
      items: [
        {...item!, rotation_deg: [0, 30, 0] as Triple, mass_kg: 0.7},
        {...item!, object: 1, offset_mm: [0, 10, 200] as Triple, clearance_mm: 2},
        {...item!, object: 1, offset_mm: [0, 0, -220.5] as Triple, name: 'spare'},
      ],
    };
    const made = new Map(good(await core.outputFiles(design, 'en', undefined, objects)).map(({name, bytes}) => [name, bytes]));
    writeFileSync(join(folder, 'kit.snug.json'), good(await core.projectText(design, objects)).text);
    execFileSync(SNUG, ['make', 'kit.snug.json', '-o', 'kit', '--quiet'], {cwd: folder});
    expectTheSame(made, filesIn(join(folder, 'kit')));
    const {text} = good(await core.commandLine([file.name, ring.name], design, 'en', objects));
    expect(text).toContain('torus.ply:name=spare,move=0x0x-220.5,scale=0.5');
    execFileSync('sh', ['-c', text.replace(/^snug/, `'${SNUG}'`)], {cwd: folder});
    expect(readFileSync(join(folder, 'camera-foam', 'depths.csv'))).toEqual(Buffer.from(made.get('depths.csv')!));
    await load(file, false);
  });

  test('draws the same pages as the command line', async () => {
    const made = good(await core.outputFiles(await designFor('sponge'))).filter(({name}) => name.endsWith('.pdf'));
    expect(made.length).toBeGreaterThan(1);
    for (const {name, bytes} of made) {
      const ours = pages(bytes, 'ours');
      const theirs = pages(readFileSync(join(folder, 'sponge', name)), 'theirs');
      expect(ours.length, name).toBe(theirs.length);
      ours.forEach((page, i) => {
        expect(page.length, `${name}, page ${i + 1}: the same size of paper`).toBe(theirs[i]!.length);
        const off = page.reduce((sum, grey, at) => sum + Math.abs(grey - theirs[i]![at]!), 0) / page.length;
        const ink = page.reduce((sum, grey) => sum + 255 - grey, 0) / page.length;
        expect(ink, `${name}, page ${i + 1} is not blank`).toBeGreaterThan(0.2);
        expect(off, `${name}, page ${i + 1}`).toBeLessThan(0.12 * ink + 0.4);
      });
      for (const left of readdirSync(folder)) if (left.endsWith('.pgm')) rmSync(join(folder, left));
    }
    const info = execFileSync('pdfinfo', [join(folder, 'ours.pdf')]).toString();
    expect(info).toContain('Snug');
  });
});

test('what it takes is known before anything is made, and a wrong wish is a sentence', async () => {
  const design = await designFor('sheets');
  const {figures} = good(await core.workshopFigures(design));
  expect(figures.length).toBeGreaterThan(3);
  expect(figures.some(({value}) => value[0].includes('EUR'))).toBe(true);
  design.workshop.sheets.thickness_mm = 7;
  expect(refused(await core.workshopFigures(design)).error).toContain('mm');
});

test('the cases that are known are ranked, and one that is chosen is filled', async () => {
  const design = await designFor(null);
  design.space.wall_mm = 20;
  const {fitting, leastInside} = good(await core.rankCases(design));
  expect(fitting.length).toBeGreaterThan(0);
  fitting.reduce((before, next) => (expect(next.fill).toBeLessThanOrEqual(before.fill), next));
  expect(leastInside.every((mm) => mm > 40)).toBe(true);
  const [best] = fitting;
  const cased: Design = {
    ...design,
    case: {...design.case, name: best!.name, inside_mm: best!.inside_mm, lid_mm: best!.lid_mm, divisor: best!.divisor},
    placement: {rotation_deg: best!.rotation_deg, offset_mm: [0, 0, 0]},
  };
  expect(good(await core.pack(cased)).fit).not.toBeNull();
});

test('each figure has its name in every language', async () => {
  for (const work of WORKS) {
    const design = await designFor(work);
    design.workshop.print.bed_mm = [120, 120, 120];
    const {figures} = good(await core.workshopFigures(design));
    for (const {label} of figures) expect(label[1]).toMatch(/[\u3040-\u30ff\u4e00-\u9fff]/);
  }
});
