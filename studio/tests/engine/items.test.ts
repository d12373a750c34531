import {beforeAll, expect, test} from 'vitest';
import type {Triple} from '../../src/design/design';
import type {EngineCore} from '../../src/engine/core';
import {box} from '../support/shapes';
import {good, refused, startCore} from '../support/snug';

interface Report {
  items: {file: string; mass_kg: number}[];
}

// Projects with items, as the command line writes them.

let core: EngineCore;
beforeAll(async () => void (core = await startCore()));

const project = (objects: object[], items: object[]) => JSON.stringify({snug: 2, objects, design: {items}});
const lens = {name: 'lens.stl', bytes: 7, sha256: ''};

test('what one item and its object chose for themselves is in the fields of the page', async () => {
  const own = {rotation_deg: [0, 90, 0], offset_mm: [1, 2, 3], clearance_mm: 2, mass_kg: 0.6, name: 'wide'};
  const {objects, design} = good(await core.parseProject(project([{...lens, options: {units: 'cm', longest_mm: 80}}], [own])));
  expect(objects).toEqual([{...lens, own: null}]);
  expect(design.object).toMatchObject({units: 'cm', longest_mm: 80});
  expect(design.placement).toEqual({rotation_deg: [0, 90, 0], offset_mm: [1, 2, 3]});
  expect(design.cut.clearance_mm).toBe(2);
  expect(design.workshop.mass_kg).toBe(0.6);
  expect(design.items).toHaveLength(1);
  expect(design.items[0]).toMatchObject({name: 'wide', rotation_deg: null, offset_mm: null, clearance_mm: null, mass_kg: null});
});

test('several items keep what they chose for themselves', async () => {
  const read = good(await core.parseProject(project([lens, {...lens, name: 'body.stl', options: {units: 'cm'}}], [{}, {object: 1, mass_kg: 2}])));
  expect(read.objects).toMatchObject([{name: 'lens.stl', own: null}, {name: 'body.stl', own: {units: 'cm', scale: 1}}]);
  expect(read.design.items).toMatchObject([{object: 0, offset_mm: null}, {object: 1, mass_kg: 2}]);
  expect(read.design.object.units).toBeNull();
});

/** Two boxes, and a design that they lie in. */
async function two() {
  const defaults = await core.defaultDesign();
  const load = async (name: string, size: [number, number, number], joins: boolean) =>
    good(await core.load(name, box(size), defaults.object, [], {joins}));
  const infos = [await load('body.stl', [120, 80, 60], false), await load('lens.stl', [50, 40, 60], true)];
  const objects = infos.map(({id}) => ({id, own: null}));
  const item = (object: number, offset_mm: Triple | null = null) => ({...defaults.items[0]!, object, offset_mm});
  const design = {...defaults, items: [item(0), item(1)]};
  return {defaults, infos, objects, item, design};
}

test('several items lie in one foam, each where it is', async () => {
  const {objects, item, design} = await two();
  const packing = good(await core.pack(design, objects));
  expect(packing.items.map(({name, object}) => [name, object])).toEqual([['body.stl', 0], ['lens.stl', 1]]);
  const [body, lens] = packing.items;
  expect(lens!.bounds.min[2] - body!.bounds.max[2]).toBeGreaterThan(12.7);
  expect(packing.fit).not.toBeNull();
  // One of them twice, and the other the last.
  const items = [item(1, [0, 0, -160]), item(1, [0, 0, 160]), item(0, [0, 0, 0])];
  const three = good(await core.pack({...design, items}, objects));
  expect(three.items.map(({name}) => name)).toEqual(['lens.stl (1)', 'lens.stl (2)', 'body.stl']);
  expect(three.items[1]!.bounds).toEqual({min: [-25, -20, 130], max: [25, 20, 190]});
});

test('what is found names its items by their numbers', async () => {
  const {objects, item, design} = await two();
  const near = good(await core.pack({...design, items: [item(0), item(1, [0, 0, 30]), item(1, [0, 0, -150])]}, objects));
  const dangers = near.findings.filter(({code}) => code === 'items_near');
  expect(dangers.map(({items}) => items)).toEqual([[0, 1]]);
  const outside = good(await core.pack({...design, items: [item(0), item(1, [0, 0, 900])]}, objects));
  expect(outside.findings.map(({code, items}) => [code, items])).toEqual([['outside', [1]]]);
  expect(outside.fit).toBeNull();
});

test('an object may have a unit of its own, and what is said of it says so', async () => {
  const {defaults, infos, objects, design} = await two();
  const own = {...defaults.object, units: 'in'} as const;
  const [body, lens] = objects;
  const packing = good(await core.pack(design, [{...body!, own: {...own, scale: 0.1}}, lens!]));
  expect(packing.items[0]!.bounds.max[0]).toBeCloseTo(60 * 2.54, 4);
  expect(good(await core.reprepare({...design, object: own}, infos[1]!.id)).size_mm![0]).toBeCloseTo(50 * 25.4, 3);
  const line = good(await core.commandLine(['body.stl', 'my lens.stl'], design, 'en', [{...body!, own}, lens!]));
  expect(line.text).toBe("snug make body.stl:units=in 'my lens.stl' --no-arrange -o body-foam");
  const {text} = good(await core.projectText(design, [{...body!, own}, lens!]));
  const read = good(await core.parseProject(text));
  expect(read.objects).toMatchObject([{name: 'body.stl', own}, {name: 'lens.stl', own: null}]);
  expect(read.design).toEqual(design);
});

test('objects that are kept no more are gone, and the others are as they were', async () => {
  const {objects, item, design} = await two();
  const lens = [objects[1]!];
  const alone = {...design, items: [item(0)]};
  const before = good(await core.pack(alone, lens));
  await core.keep([lens[0]!.id]);
  expect(good(await core.pack(alone, lens)).pieces).toEqual(before.pieces);
  expect(refused(await core.pack(design, objects)).error).toContain('no object');
});

test('an item of an object that there is not is refused, also after good packings', async () => {
  const {objects, item, design} = await two();
  good(await core.pack(design, objects));
  expect(refused(await core.pack({...design, items: [item(0), item(7)]}, objects)).error).toContain('7');
  good(await core.pack(design, objects));
});

test('everything that is made for several tells of all, and a search of none', async () => {
  const {objects, design} = await two();
  const items = design.items.map((item, i) => ({...item, mass_kg: i + 1}));
  const files = good(await core.outputFiles({...design, items}, 'en', undefined, objects));
  const report = JSON.parse(new TextDecoder().decode(files.find(({name}) => name === 'report.json')!.bytes)) as Report;
  expect(report.items.map(({file, mass_kg}) => [file, mass_kg])).toEqual([['body.stl', 1], ['lens.stl', 2]]);
  good(await core.pack({...design, items}, objects));
  expect(good(await core.gaps()).bearing.static_kpa[0]).toBeGreaterThan(0);
  const far = good(await core.distances(new Float32Array([0, 0, 500])));
  expect(far[0]).toBeLessThan(500);
  expect(refused(await core.search(design, () => {}, objects)).error).toMatch(/one item, and 2/);
  expect(good(await core.rankCases(design, objects)).leastInside[2]).toBeGreaterThan(120);
});

test('a project of the page is of version 2, with its one item', async () => {
  const {text} = good(await core.projectText(await core.defaultDesign()));
  expect(JSON.parse(text)).toMatchObject({snug: 2, design: {items: [{object: 0}]}});
});
