import {beforeAll, expect, test} from 'vitest';
import type {Design, Triple} from '../../src/design/design';
import type {Packing} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {box} from '../support/shapes';
import {good, refused, startCore} from '../support/snug';

// Items in layers that stand on each other, and trays: what the page is handed beside what the files say.

let core: EngineCore;
beforeAll(async () => void (core = await startCore()));

const SIZES: Record<string, Triple> = {'body.stl': [120, 80, 60], 'lens.stl': [50, 40, 60], 'cap.stl': [40, 40, 10]};

/** Boxes, each in its layer, and a design that they lie in. */
async function boxes(...layers: [name: string, layer: number, offset_mm?: Triple][]) {
  const defaults = await core.defaultDesign();
  const names = [...new Set(layers.map(([name]) => name))];
  const infos = [];
  for (const [i, name] of names.entries()) infos.push(good(await core.load(name, box(SIZES[name]!), defaults.object, [], {joins: i > 0})));
  const items = layers.map(([name, layer, offset_mm = null]) => ({...defaults.items[0]!, object: names.indexOf(name), layer, offset_mm}));
  const design: Design = {...defaults, items, space: {...defaults.space, blocks: 'auto'}};
  return {design, objects: infos.map(({id}) => ({id, own: null}))};
}

/** The columns of depths.csv by their names. */
async function depths(design: Design, objects: {id: string; own: null}[]): Promise<Map<string, number[]>> {
  const files = good(await core.outputFiles(design, 'en', undefined, objects));
  const text = new TextDecoder().decode(files.find(({name}) => name === 'depths.csv')!.bytes);
  const [heading, ...rows] = text.trim().split('\n').map((row) => row.split(','));
  return new Map(heading!.map((name, at) => [name, rows.map((row) => Number(row[at]))]));
}

const sum = (numbers: Iterable<number>) => [...numbers].reduce((a, b) => a + b, 0);
const blocksOf = ({pieces}: Packing, piece: number) => Array.from(pieces[piece]!.end, (end, i) => end - pieces[piece]!.first[i]!);

test('three layers lie between four pieces, which are those of the files', async () => {
  const {design, objects} = await boxes(['body.stl', 1], ['lens.stl', 2], ['lens.stl', 2], ['cap.stl', 3]);
  const packing = good(await core.pack(design, objects));
  expect([packing.pieces.length, packing.open, packing.items.map(({layer}) => layer)]).toEqual([4, false, [1, 2, 2, 3]]);
  expect(packing.partingLevels).toHaveLength(3);
  expect(packing.partingLevels).toEqual([...packing.partingLevels].sort((a, b) => a - b));
  const columns = await depths(design, objects);
  expect(blocksOf(packing, 0)).toEqual(columns.get('lower_blocks'));
  expect(blocksOf(packing, 3)).toEqual(columns.get('upper_blocks'));
  for (const middle of [1, 2]) {
    expect(blocksOf(packing, middle)).toEqual(columns.get(`middle_${middle}_blocks`));
    expect([...packing.pieces[middle]!.first]).toEqual(columns.get(`middle_${middle}_first`));
  }
  expect(packing.fit!.pieces.map(({blocks}) => blocks)).toEqual([0, 1, 2, 3].map((piece) => sum(blocksOf(packing, piece))));
  expect(packing.fit!.pieces.map(({parts}) => parts)).toEqual([1, 1, 1, 1]);
});

test('gaps are told of each layer, and the widest of all', async () => {
  const {design, objects} = await boxes(['body.stl', 1], ['lens.stl', 2]);
  good(await core.pack(design, objects));
  const gap = good(await core.gaps());
  expect(gap.layers).toHaveLength(2);
  expect(gap.widest_mm).toBe(Math.max(...gap.layers.map(({widest_mm}) => widest_mm)));
  expect(gap.step_mm3).toBeCloseTo(sum(gap.layers.map(({step_mm3}) => step_mm3)), 2);
});

test('a tray has no lid: its foam ends at the uppermost level', async () => {
  const {design, objects} = await boxes(['body.stl', 1], ['lens.stl', 1]);
  const tray: Design = {...design, space: {...design.space, open: 0.5}};
  const packing = good(await core.pack(tray, objects));
  expect([packing.pieces.length, packing.open, packing.fit!.pieces.length]).toEqual([1, true, 1]);
  expect(Math.max(...packing.pieces[0]!.end)).toBe(packing.partingLevels[0]);
  expect(packing.partingLevels[0]).toBeLessThan(packing.blocks[0]);
  const columns = await depths(tray, objects);
  expect(blocksOf(packing, 0)).toEqual(columns.get('lower_blocks'));
  expect(sum(columns.get('upper_blocks')!)).toBe(0);
  const [layer] = good(await core.gaps()).layers;
  expect(layer!.upper.step_mm3).toBe(0);
  // The uppermost layer alone stands open.
  const two = {...tray, items: tray.items.map((item, i) => ({...item, layer: i + 1}))};
  expect(good(await core.pack(two, objects)).pieces).toHaveLength(2);
});

test('what is found of items in layers names those, and no others', async () => {
  const near = await boxes(['body.stl', 1, [-70, 0, 0]], ['lens.stl', 2, [65, 0, 0]], ['lens.stl', 2, [65, 0, 65]]);
  const found = good(await core.pack(near.design, near.objects)).findings;
  expect(found.filter(({code}) => code === 'items_near').map(({items}) => items)).toEqual([[1, 2]]);
  const masses = [0.2, 3, 0.1];
  const heavy = {...near.design, items: near.design.items.map((item, i) => ({...item, mass_kg: masses[i]!}))};
  const above = good(await core.pack(heavy, near.objects)).findings.filter(({code}) => code === 'heavy_above');
  expect(above.map(({items}) => items)).toEqual([[0, 1]]);
  // More room for the fingers than these blocks have: each item lacks its own.
  const notches = {width_mm: 20, depth_mm: 15, room_mm: 900, axis: null, first_mm: null, second_mm: null};
  const space = {...near.design.space, blocks: [40, 30, 30] as [number, number, number]};
  const small = good(await core.pack({...near.design, space, fit: {...near.design.fit, notches}}, near.objects));
  const none = small.findings.filter(({code}) => code === 'no_notches');
  expect(none.map(({items}) => items)).toEqual([[0], [1], [2]]);
});

test('a layer in which nothing lies is refused, and so are levels of another number of layers', async () => {
  const {design, objects} = await boxes(['body.stl', 1], ['lens.stl', 3]);
  expect(refused(await core.pack(design, objects)).error).toContain('layer 2');
  const two = {...design, items: design.items.map((item, i) => ({...item, layer: i + 1}))};
  expect(refused(await core.pack({...two, parting: {level: 7}}, objects)).error).toContain('2');
  const {partingLevels} = good(await core.pack(two, objects));
  const chosen = good(await core.pack({...two, parting: {level: partingLevels}}, objects));
  expect(chosen.partingLevels).toEqual(partingLevels);
});

test('searches are for foams that close', async () => {
  const {design, objects} = await boxes(['lens.stl', 1]);
  const tray = {...design, space: {...design.space, open: 0.5}};
  expect(refused(await core.search(tray, () => {}, objects)).error).toContain('tray');
  expect(refused(await core.fitCase(tray, undefined, objects)).error).toContain('tray');
});
