import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, relative} from 'node:path';
import {fileURLToPath} from 'node:url';
import {afterAll, beforeAll, describe, expect, test} from 'vitest';
import type {Design, Preset, Triple, Work} from '../../src/design/design';
import * as edit from '../../src/design/edit';
import {withValue} from '../../src/design/options';
import type {OutputFile} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {placeless} from '../support/report';
import {good, startCore} from '../support/snug';
import {WORKS} from '../support/works';

// The command that the page shows is typed into a shell, and must make what the page makes.

const SNUG = fileURLToPath(new URL('../../../build/snug', import.meta.url));
let core: EngineCore;
let defaults: Design;
let presets: Preset[];
let folder: string;
let file: OutputFile;

beforeAll(async () => {
  core = await startCore();
  defaults = await core.defaultDesign();
  presets = await core.presets();
  folder = mkdtempSync(join(tmpdir(), 'snug-line-'));
  file = good(await core.sampleFile('camera'));
  writeFileSync(join(folder, file.name), file.bytes);
  good(await core.load(file.name, new Blob([file.bytes]), defaults.object));
});
afterAll(() => rmSync(folder, {recursive: true, force: true}));

/** Without the hidden list of what was made, which a zip needs not. */
function filesIn(path: string): Map<string, Buffer> {
  const entries = readdirSync(path, {recursive: true, withFileTypes: true}).filter((entry) => entry.isFile() && !entry.name.startsWith('.'));
  const paths = entries.map((entry) => join(entry.parentPath, entry.name));
  return new Map(paths.map((name) => [relative(path, name), readFileSync(name)]));
}

/** What a person could tell apart: not how long it took, nor how a project says the same. */
function comparable(name: string, bytes: Uint8Array): string | null {
  if (/\.(pdf|3mf)$|^project/.test(name)) return null;
  const text = Buffer.from(bytes).toString('latin1');
  return name === 'report.json' ? placeless(text) : text;
}

const preset = (name: string) => presets.find((each) => each.name === name)!;
const fitted = (design: Design): Design => ({...design, space: {...design.space, blocks: 'auto'}});
const working = (work: Work) => (design: Design) =>
  edit.withWorkshop(edit.withPreset(design, edit.usualPreset(presets, work)!), {for: work});
const cased = (design: Design) => edit.withCase(design, {inside_mm: [260, 320, 420] as Triple, lid_mm: 60, play_mm: 2}, defaults.case);

const small = (design: Design) =>
  edit.withWorkshop(design, {print: {...design.workshop.print, bed_mm: [180, 180, 180], dowel_diameter_mm: 8}});

/** Numbers that differ from every default. */
const MILL = {
  cutter_mm: 8,
  flute_mm: 120,
  step_down_mm: 2.5,
  stepover: 0.35,
  feed_mm_min: 1250.5,
  plunge_mm_min: 300,
  spindle_rpm: 12_000,
  safe_mm: 7.5,
  pin_mm: 0,
  origin: 'centre',
} as const;
const NOTCHES = {width_mm: 80, depth_mm: 40, room_mm: 25, axis: null, first_mm: null, second_mm: null};
const BRICKS = {
  unit: 'plate',
  family: ['1x1', '1x2', '2x4'],
  lower_color: 'light bluish gray',
  lid_color: 'dark red',
  stock: {'2x4': 50, '1x2': 400},
  rim: 'tiles',
  capacity_n: 0.55,
} as const;

const CHANGES: [string, (design: Design) => Design][] = [
  ['nothing', (design) => design],
  ['a fitted space', fitted],
  ['another foam', (design) => edit.withPreset(design, preset('slit-12.7'))],
  ['walls of their own', (design) => edit.withWalls(fitted(design), [60, 30, 20, 25, 40, 45])],
  ['a turn and a shift', (design) => edit.withOffset(edit.withRotation(design, [-12.5, 30, 90]), [-3, 0, 4.25])],
  ['a clearance for each half', (design) => edit.withClearanceOf(withValue(design, 'cut.liner_mm', 0.5), 3, 2.5)],
  ['notches', (design) => edit.withFit(fitted(design), {notches: {...NOTCHES, axis: 'z', first_mm: -5, second_mm: 5}})],
  ['settled onto the foam', (design) => edit.withFit(fitted(design), {settle: true})],
  ['pads that press', (design) => edit.withFit(fitted(design), {settle: true, pads: {sheet_mm: 1.5, squeeze_mm: 0.5}})],
  ['a relief', (design) => edit.withFit(fitted(edit.withPreset(design, preset('sheet-10'))), {relief: {height_mm: 37.5, island_mm: 55}})],
  ['a case', cased],
  ['a case around a fitted space', (design) => cased(fitted(design))],
  ['a case whose foam is cut to size', (design) => cased(edit.withPreset(design, preset('sheet-10')))],
  ['sponge', working('sponge')],
  ['sponge of the paper’s blocks', (design) => edit.withWorkshop(fitted(design), {for: 'sponge', paper: 'letter'})],
  ['sponge, priced and weighed', (design) => edit.withWorkshop(working('sponge')(design), {price_per_litre: 0.85, currency: 'EUR', mass_kg: 1.25})],
  ['sheets', working('sheets')],
  [
    'sheets of half a block without dowels',
    (design) => {
      const sheets = {...design.workshop.sheets, thickness_mm: 5, stock_mm: [800, 500] as [number, number], kerf_mm: 0.2, dowels: 0};
      return edit.withWorkshop(working('sheets')(design), {sheets});
    },
  ],
  ['a price in a currency that a shell would take for more', (design) => edit.withWorkshop(working('sponge')(design), {price_per_litre: 1, currency: "a'$(b) &"})],
  ['notches without places, printed on a small bed', (design) => edit.withFit(small(working('print')(design)), {notches: NOTCHES})],
  ['bricks', working('bricks')],
  ['bricks of one colour', (design) => edit.withWorkshop(working('bricks')(design), {bricks: {...design.workshop.bricks, lower_color: 'orange'}})],
  [
    'plates of few sizes from a stock, tiled, in other colours',
    (design) => edit.withWorkshop(working('bricks')(design), {bricks: {...BRICKS, family: [...BRICKS.family]}}),
  ],
  ['a mill', working('mill')],
  ['a mill with everything chosen', (design) => edit.withWorkshop(working('mill')(design), {mill: MILL})],
  ['a mould', working('mould')],
  [
    'a mould with everything chosen, on a small bed',
    (design) => edit.withWorkshop(small(working('mould')(design)), {mould: {wall_mm: 4, rim_mm: 7.5, draft_deg: 3}}),
  ],
  [
    'a mould in one piece without dowels',
    (design) => edit.withWorkshop(working('mould')(design), {print: {...design.workshop.print, bed_mm: [600, 600, 400], dowels: false}}),
  ],
  ['edits by hand, also of columns that are not there', (design) => ({...fitted(design), edits: [{piece: 'lower', j: 1, k: 2, blocks: 2}, {piece: 'upper', j: 6, k: 9, blocks: -1}, {piece: 'lower', j: 99, k: 0, blocks: 1}]})],
  ['a mass alone', (design) => edit.withWorkshop(design, {mass_kg: 2})],
];

/** What the command line says about a way of working, beside what all have. */
function toolsOf({workshop}: Design): (Work & keyof Design['workshop'])[] {
  const names = [workshop.for, workshop.for === 'mould' ? 'print' : null] as const;
  return names.filter((name): name is Work & keyof Design['workshop'] => name !== null && name in workshop);
}

describe.skipIf(!existsSync(SNUG))('the command that is shown makes what the page makes', () => {
  test.each(CHANGES)('%s', async (_, change) => same(change(defaults)));

  test('a known case', async () => {
    const design = edit.withWalls(fitted(defaults), 20);
    const {fitting} = good(await core.rankCases(design));
    await same(edit.withKnownCase(design, fitting[0]!));
    const last = edit.withKnownCase(design, fitting.at(-1)!);
    await same(edit.withCase(last, {play_mm: 5}, defaults.case));
    await same(edit.withCase(last, {lid_mm: 40}, defaults.case));
    expect(edit.withCase(last, {inside_mm: [300, 400, 500]}, defaults.case).case).toEqual({...defaults.case, inside_mm: [300, 400, 500], lid_mm: last.case.lid_mm});
  });

  test.each(WORKS)('the usual foam for %s is the same', (work) => {
    const out = join(folder, work);
    execFileSync(SNUG, ['make', join(folder, file.name), '--for', work, '-o', out, '--quiet']);
    const project = JSON.parse(readFileSync(join(out, 'project.snug.json'), 'utf8')) as {design: Design};
    expect(edit.usualPreset(presets, work)?.name).toBe(project.design.space.preset);
    const {space, ...others} = working(work)(defaults);
    // What is rigid brings its walls on the page; the command's stay.
    expect({...others, space: {...space, wall_mm: null}}).toEqual(project.design);
  });

  async function same(design: Design) {
    const mine = good(await core.outputFiles(design));
    const line = good(await core.commandLine(file.name, design)).text;
    execFileSync('sh', ['-c', `${line} --quiet`], {cwd: folder, env: {...process.env, PATH: `${dirname(SNUG)}:${process.env.PATH}`}});
    const out = join(folder, 'camera-foam');
    const theirs = filesIn(out);
    rmSync(out, {recursive: true});
    const {workshop} = (JSON.parse(theirs.get('project.snug.json')!.toString()) as {design: Design}).design;
    for (const tools of toolsOf(design)) expect(workshop[tools], line).toEqual(design.workshop[tools]);
    expect([...theirs.keys()].sort()).toEqual(mine.map(({name}) => name).sort());
    for (const {name, bytes} of mine)
      expect(comparable(name, bytes) === comparable(name, theirs.get(name)!), `${name} of ${line}`).toBe(true);
  }
});
