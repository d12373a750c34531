import {existsSync, readFileSync} from 'node:fs';
import {basename} from 'node:path';
import {describe, expect, test} from 'vitest';
import type {BrickOptions, Design, Triple} from '../../src/design/design';
import {withPlacement, withPreset, withWorkshop} from '../../src/design/edit';
import {bodyHeight, hasStuds, partsList, STUD_HEIGHT, withParts, type ListedPart} from '../support/ldraw_parts';
import {standingParts, type StandingPart} from '../support/ldraw_scene';
import {good, startCore} from '../support/snug';

// The LDraw file of a pack of bricks, read by three.js: the bricks that stand in its scene are the foam of depths.csv.

const SHARED = new URL('../../../../shared/models/', import.meta.url).pathname;
const STUD = 20; // LDraw units of 0.4 mm
const PLATE = 8;

/** What a pack says, and what another program sees in it. */
interface Built {
  parts: StandingPart[];
  list: ListedPart[];
  wanted: string;
  blocks: Triple;
  /** Of a block: plates along x, studs along y and z. */
  block: Triple;
  lower: number[];
  upper: number[];
}

interface Wish {
  preset?: string;
  block_mm?: Triple;
  longest_mm?: number;
  rotation_deg?: Triple;
  bricks?: Partial<BrickOptions>;
}

async function built(object: string, wish: Wish): Promise<Built> {
  const core = await startCore();
  const presets = await core.presets();
  const shared = existsSync(object);
  const file = shared ? {name: basename(object), bytes: readFileSync(object)} : good(await core.sampleFile(object));
  const defaults = await core.defaultDesign();
  const first: Design = {...defaults, object: {...defaults.object, longest_mm: wish.longest_mm ?? 110, units: 'mm'}};
  good(await core.load(file.name, new Blob([new Uint8Array(file.bytes)]), first.object));
  const foamed = withPreset(first, presets.find(({name}) => name === (wish.preset ?? 'lego-brick'))!);
  const placed = withPlacement(foamed, {rotation_deg: wish.rotation_deg ?? [15, -20, 35], offset_mm: [0, 0, 0]});
  const design = withWorkshop(
    {...placed, space: {...placed.space, wall_mm: 18, block_mm: wish.block_mm ?? placed.space.block_mm}},
    {for: 'bricks', bricks: {...placed.workshop.bricks, ...wish.bricks}},
  );
  const files = new Map(good(await core.outputFiles(design)).map(({name, bytes}) => [name, new TextDecoder().decode(bytes)]));
  const {design_space} = JSON.parse(files.get('report.json')!) as {design_space: {blocks: Triple; block_mm: Triple}};
  const columns = files.get('depths.csv')!.trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  const list = partsList(files.get('bricks/parts.csv')!);
  const colors = [...new Set(list.map(({ldraw_color}) => ldraw_color))];
  const text = withParts(files.get('bricks/foams.mpd')!, list);
  const [x, y, z] = design_space.block_mm;
  return {
    parts: await standingParts(text, colors),
    list,
    wanted: files.get('bricks/wanted.xml')!,
    blocks: design_space.blocks,
    block: [Math.round(x / 3.2), Math.round(y / 8), Math.round(z / 8)],
    lower: columns.map((column) => column[2]!),
    upper: columns.map((column) => column[3]!),
  };
}

/** A part's cells: from its model's far left corner to the right, to the viewer and up from the floor. */
interface Cells {
  part: StandingPart;
  columns: [number, number];
  rows: [number, number];
  plates: [number, number];
}

function cellsOf({parts, list}: Built, model: string): Cells[] {
  const names = new Map(list.map(({part, name}) => [part, name]));
  const half = parts.filter((part) => part.model === model);
  const far = Math.max(...half.map(({box}) => box.max.z));
  const whole = (value: number, unit: number) => {
    expect(Math.abs(value / unit - Math.round(value / unit)), `${value} of ${unit}`).toBeLessThan(1e-4);
    return Math.round(value / unit);
  };
  return half.map((part) => {
    const {min, max} = part.box;
    const name = names.get(part.part)!;
    const top = -min.y - (hasStuds(name) ? STUD_HEIGHT : 0);
    expect(top + max.y).toBeCloseTo(bodyHeight(name), 3);
    return {
      part,
      columns: [whole(min.x, STUD), whole(max.x, STUD)],
      rows: [whole(far - max.z, STUD), whole(far - min.z, STUD)],
      plates: [whole(-max.y, PLATE), whole(top, PLATE)],
    };
  });
}

const range = ([from, to]: [number, number]) => Array.from({length: to - from}, (_, i) => from + i);
const footprint = ({columns, rows}: Cells) => range(rows).flatMap((row) => range(columns).map((column) => `${row} ${column}`));

/** Plates' worth of bricks in each block: `j k level`, with the level from the half's floor. */
function blockMap(pack: Built, cells: Cells[], lid: boolean): Map<string, number> {
  const found = new Map<string, number>();
  const [plates, perRow, perColumn] = pack.block;
  const rows = pack.blocks[1] * perRow;
  const taken = new Set<string>();
  for (const each of cells)
    for (const row of range(each.rows))
      for (const column of range(each.columns))
        for (const plate of range(each.plates)) {
          const cell = `${row} ${column} ${plate}`;
          expect(taken.has(cell), `two bricks in ${cell}`).toBe(false);
          taken.add(cell);
          // BACK is at the far side of the lower half and at the near side of the lid, which was turned over.
          const j = Math.floor((lid ? rows - 1 - row : row) / perRow);
          const block = `${j} ${Math.floor(column / perColumn)} ${Math.floor(plate / plates)}`;
          found.set(block, (found.get(block) ?? 0) + 1);
        }
  return found;
}

function expectFoam(pack: Built, cells: Cells[], lid: boolean) {
  const [, ny, nz] = pack.blocks;
  const kept = lid ? pack.upper : pack.lower;
  const wanted = new Map<string, number>();
  for (let j = 0; j < ny; j++)
    for (let k = 0; k < nz; k++)
      for (let level = 0; level < kept[j * nz + k]!; level++) wanted.set(`${j} ${k} ${level}`, pack.block[0] * pack.block[1] * pack.block[2]);
  const found = blockMap(pack, cells, lid);
  expect(found.size).toBe(wanted.size);
  for (const [block, plates] of wanted) expect(found.get(block), block).toBe(plates);
}

/** Every step lays one course, and none lays a brick on nothing. */
function expectCarried(cells: Cells[]) {
  const courses = new Map<number, number>();
  for (const {part, plates} of cells) {
    if (!courses.has(part.step)) courses.set(part.step, plates[0]);
    expect(plates[0], `step ${part.step}`).toBe(courses.get(part.step));
  }
  const under = new Map<string, number>();
  for (const {part, plates, ...each} of cells)
    for (const stud of footprint({part, plates, ...each})) under.set(`${stud} ${plates[1]}`, part.step);
  for (const each of cells) {
    const [bottom] = each.plates;
    if (bottom === 0) continue;
    const carriers = footprint(each).map((stud) => under.get(`${stud} ${bottom}`) ?? Infinity);
    expect(Math.min(...carriers), `${each.part.part} in step ${each.part.step} on nothing`).toBeLessThan(each.part.step);
  }
}

function expectCounts({parts, list, wanted}: Built) {
  const placed = new Map<string, number>();
  for (const {part, color} of parts) placed.set(`${part} ${color}`, (placed.get(`${part} ${color}`) ?? 0) + 1);
  expect(placed).toEqual(new Map(list.map(({part, ldraw_color, pieces}) => [`${part} ${ldraw_color}`, pieces])));
  const items = wanted.matchAll(/<ITEMID>(\w+)<\/ITEMID><COLOR>(\d+)<\/COLOR><MINQTY>(\d+)<\/MINQTY>/g);
  expect([...items].map(([, part, color, pieces]) => `${part} ${color} ${pieces}`)).toEqual(
    list.map(({part, bricklink_color, pieces}) => `${part} ${bricklink_color} ${pieces}`),
  );
  expect(wanted.startsWith('<INVENTORY>')).toBe(true);
}

function expectBuilt(pack: Built) {
  expect(pack.parts.length).toBeGreaterThan(20);
  for (const {part, mirrored, up} of pack.parts) {
    expect(mirrored, part).toBe(false);
    expect(up.y, `${part} stands on its bottom`).toBeCloseTo(-1, 6);
  }
  const [lower, lid] = ['lower.ldr', 'lid.ldr'].map((model) => cellsOf(pack, model)) as [Cells[], Cells[]];
  expectFoam(pack, lower, false);
  expectFoam(pack, lid, true);
  for (const half of [lower, lid]) expectCarried(half);
  const nearest = Math.min(...lid.map(({part}) => part.box.min.z));
  expect(nearest, 'the lid is behind the lower half').toBeGreaterThan(Math.max(...lower.map(({part}) => part.box.max.z)));
  for (const half of [lower, lid]) expect(Math.min(...half.map(({columns}) => columns[0]))).toBeCloseTo(0);
  expect(new Set(lower.map(({part}) => part.color)).size).toBe(1);
  expect(new Set(lid.map(({part}) => part.color)).size).toBe(1);
  expectCounts(pack);
}

describe('three.js builds the foams from the LDraw file', () => {
  test.each(['torus', 'vase', 'figurine', 'camera'])('of the %s', async (name) => expectBuilt(await built(name, {})));

  test.each([
    ['plates', {preset: 'lego-plate', longest_mm: 60}],
    ['plates in blocks of bricks', {bricks: {unit: 'plate' as const}, longest_mm: 60}],
    ['tiled rims', {bricks: {rim: 'tiles' as const}}],
    ['a few sizes and other colours', {bricks: {family: ['1x1', '1x2', '2x3'], lower_color: 'tan', lid_color: 'dark red'}}],
    ['larger blocks', {block_mm: [19.2, 16, 8] as Triple}],
    ['one colour for both', {bricks: {lid_color: 'blue'}, rotation_deg: [90, 0, -45] as Triple}],
  ])('of the camera, with %s', async (_, wish) => expectBuilt(await built('camera', wish)));

  test.each(['cow.obj', 'spot.obj', 'screwdriver.off'])('of %s', async (name) => {
    const path = `${SHARED}${name}`;
    if (!existsSync(path)) return;
    expectBuilt(await built(path, {longest_mm: 130}));
  });
});
