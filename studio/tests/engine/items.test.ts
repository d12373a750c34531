import {beforeAll, expect, test} from 'vitest';
import type {EngineCore} from '../../src/engine/core';
import {good, refused, startCore} from '../support/snug';

// Projects with items, as the command line writes them.

let core: EngineCore;
beforeAll(async () => void (core = await startCore()));

const project = (objects: object[], items: object[]) => JSON.stringify({snug: 2, objects, design: {items}});
const lens = {name: 'lens.stl', bytes: 7, sha256: ''};

test('what one item and its object chose for themselves is in the fields of the page', async () => {
  const own = {rotation_deg: [0, 90, 0], offset_mm: [1, 2, 3], clearance_mm: 2, mass_kg: 0.6, name: 'wide'};
  const {object, design} = good(await core.parseProject(project([{...lens, options: {units: 'cm', longest_mm: 80}}], [own])));
  expect(object.name).toBe('lens.stl');
  expect(design.object).toMatchObject({units: 'cm', longest_mm: 80});
  expect(design.placement).toEqual({rotation_deg: [0, 90, 0], offset_mm: [1, 2, 3]});
  expect(design.cut.clearance_mm).toBe(2);
  expect(design.workshop.mass_kg).toBe(0.6);
  expect(design.items).toHaveLength(1);
  expect(design.items[0]).toMatchObject({name: 'wide', rotation_deg: null, offset_mm: null, clearance_mm: null, mass_kg: null});
});

test('several items are refused with a sentence that says who makes them', async () => {
  const {error} = refused(await core.parseProject(project([lens], [{}, {offset_mm: [0, 0, 90]}])));
  expect(error).toMatch(/2 items.*snug make/);
});

test('a project of the page is of version 2, with its one item', async () => {
  const {text} = good(await core.projectText(await core.defaultDesign()));
  expect(JSON.parse(text)).toMatchObject({snug: 2, design: {items: [{object: 0}]}});
});
