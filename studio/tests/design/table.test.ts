import {readFileSync, writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {beforeAll, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import {firstDesign} from '../../src/design/edit';
import {bounds, comesTo, fieldName, pathsBelow, usualGroup, valueAt, withValue, type OptionPath, type Schema} from '../../src/design/options';
import type {EngineCore} from '../../src/engine/core';
import {en} from '../../src/words/texts';
import {good, startCore} from '../support/snug';
import {tableFile} from '../support/table';

const TABLE = fileURLToPath(new URL('../../src/design/table.ts', import.meta.url));
let core: EngineCore;
let schema: Schema;
let defaults: Design;

beforeAll(async () => {
  core = await startCore();
  schema = await core.options();
  defaults = await core.defaultDesign();
});

test('the types of a design are those of the library’s table', () => {
  const written = tableFile(schema);
  if (process.env.SNUG_WRITE) writeFileSync(TABLE, written);
  expect(readFileSync(TABLE, 'utf8')).toBe(written);
});

test('every option is found in a design with its default', () => {
  const inGroup = (path: string) =>
    Object.entries(schema).some(([group, {kind}]) => kind === 'group' && path.startsWith(`${group}.`));
  for (const [path, row] of Object.entries(schema) as [OptionPath, Schema[OptionPath]][]) {
    if (row.kind === 'list') expect(valueAt(defaults, path), path).toHaveLength(1);
    else if (row.kind === 'group') expect(valueAt(defaults, path), path).toBeNull();
    else if (!inGroup(path)) expect(valueAt(defaults, path), path).toEqual(row.default);
  }
});

test('an option is changed alone, and the library takes what the bounds take', async () => {
  const changed = withValue(defaults, 'workshop.mill.feed_mm_min', 800);
  expect(changed.workshop.mill.feed_mm_min).toBe(800);
  expect({...changed.workshop.mill, feed_mm_min: defaults.workshop.mill.feed_mm_min}).toEqual(defaults.workshop.mill);
  expect(changed.fit).toBe(defaults.fit);
  const {min, max} = bounds(schema['workshop.mill.feed_mm_min']);
  for (const value of [min, max]) good(await core.parseProject(JSON.stringify(withValue(changed, 'workshop.mill.feed_mm_min', value))));
});

test('what is left open comes to what the other choices make of it', async () => {
  const {dependent} = good(await core.parseProject(JSON.stringify(firstDesign(defaults))));
  expect(comesTo(defaults, 'workshop.mill.step_down_mm', dependent)).toBe(3);
  expect(comesTo(withValue(defaults, 'workshop.mill.step_down_mm', 1), 'workshop.mill.step_down_mm', dependent)).toBe(1);
  expect(comesTo(defaults, 'workshop.mass_kg', dependent)).toBeNull();
  expect(schema['space.wall_mm']).toMatchObject({fitted: 50, tray: 25.4});
  expect(bounds(schema['cut.clearance_mm'], dependent['cut.clearance_mm'])).toMatchObject({min: -6});
});

test('a field that may be empty, or 0 besides, goes down to 0', () => {
  expect(bounds(schema['workshop.mill.step_down_mm'])).toEqual({min: 0, max: 1000});
  expect(bounds(schema['workshop.mill.pin_mm'])).toEqual({min: 0, max: 50});
  expect(bounds(schema['workshop.mill.cutter_mm'])).toEqual({min: 0.5, max: 100});
  expect(bounds(schema['workshop.currency'])).toEqual({});
});

test('an option without words of the page is called by its label in either language', () => {
  expect(fieldName(schema['fit.least_rib_mm'])).toEqual(['Least rib', 'リブの最小厚さ']);
  expect(fieldName(schema['workshop.sheets.thickness_mm'])).toEqual(['Sheet\'s thickness', 'シートの厚さ']);
  for (const row of Object.values(schema)) expect(fieldName(row).every((name) => name.length > 0)).toBe(true);
});

test('the options of a way of working are found in their order, and none where it has none', () => {
  expect(pathsBelow(schema, 'workshop.mould')).toEqual(['workshop.mould.wall_mm', 'workshop.mould.rim_mm', 'workshop.mould.draft_deg']);
  expect(pathsBelow(schema, 'workshop.sponge')).toEqual(['workshop.sponge.maps']);
  expect(pathsBelow(schema, 'workshop.felt')).toEqual([]);
});

test('a group that is missing begins as the library has it', async () => {
  const fit = {...defaults.fit, notches: usualGroup(schema, 'fit.notches')};
  const {design} = good(await core.parseProject(JSON.stringify({...defaults, fit: {...fit, notches: {}}})));
  expect(design.fit.notches).toEqual(fit.notches);
});

test('the page’s words for fields are of options that there are, with every word and every number of theirs', () => {
  for (const [path, {parts, words}] of Object.entries(en.fields)) {
    const row = schema[path as OptionPath];
    expect(row, path).toBeDefined();
    expect(parts?.length, path).toBe(row.kind === 'numbers' ? row.count : undefined);
    const known = row.words && [...(row.optional ? ['none'] : []), ...row.words];
    expect(words && Object.keys(words).sort(), path).toEqual(known?.sort());
  }
});
