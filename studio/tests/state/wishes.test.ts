import {beforeEach, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import {forNewObject, withKnownCase, withPreset} from '../../src/design/edit';
import {withFragility} from '../../src/design/protection';
import {planned, planWishes, USUAL_WISHES, waysFor, withLooseSurface, withMass, withSideKept} from '../../src/state/wishes';
import type {Studio} from '../../src/state/studio.svelte';
import {startStudio} from '../support/studio';

let studio: Studio;
let fresh: Design;
beforeEach(async () => {
  studio ??= await startStudio();
  fresh = forNewObject(studio.moment.design, studio.defaults, studio.presets);
});
const preset = (name: string) => studio.presets.find((one) => one.name === name)!;
const plannedOf = (design: Design, to = {}, error_mm = 0) => planned(design, {...USUAL_WISHES, ...to}, studio.defaults, studio.presets, error_mm);
const CASE = {name: '1450', inside_mm: [155, 260, 372] as [number, number, number], lid_mm: null, divisor: null, rotation_deg: [0, 90, 0] as [number, number, number]};

test('what was answered of the object stays in the design that is planned from', () => {
  let design = withMass(fresh, 0, 1.2);
  design = withFragility(design, 'museum');
  design = withLooseSurface(design, true, studio.defaults);
  design = withSideKept(design, '-z');
  const {workshop, protection, cut, search, placement} = plannedOf(design);
  expect([workshop.mass_kg, protection.fragility, cut.liner_mm, search.upright]).toEqual([1.2, 'museum', 0.5, 'z']);
  expect(placement.rotation_deg).toEqual(design.placement.rotation_deg);
  expect(placement.rotation_deg).not.toEqual([0, 0, 0]);
  expect(plannedOf(withSideKept(design, null)).placement.rotation_deg).toEqual([0, 0, 0]);
});

test('what an earlier proposal chose is open again, what is there is not', () => {
  const taken: Design = {
    ...withKnownCase(withPreset(fresh, preset('sheet-10')), CASE),
    protection: {...fresh.protection, rule: 'ista-2a'},
    workshop: {...fresh.workshop, for: 'sheets'},
  };
  const again = plannedOf(taken);
  expect([again.space.blocks, again.space.wall_mm, again.case.inside_mm, again.protection.rule, again.workshop.for]).toEqual(['auto', null, null, null, null]);
  expect(again.cut.clearance_mm).toBe(studio.defaults.cut.clearance_mm);
  expect(plannedOf(taken, {cases: 'named'}).case.name).toBe('1450');
  const own = plannedOf(taken, {foam: 'blocks'});
  expect([own.space.preset, own.space.block_mm, own.cut.clearance_mm]).toEqual(['sheet-10', [10, 2.5, 2.5], 1]);
});

test('an error of measuring is added to what the foams need anyway, once', () => {
  const measured = {...fresh, cut: {...fresh.cut, clearance_mm: preset(fresh.space.preset).clearance_mm + 1}};
  expect(plannedOf(measured, {ways: ['sponge']}, 1).cut.clearance_mm).toBe(1);
  expect(plannedOf(measured, {ways: ['sponge', 'sheets']}, 1).cut.clearance_mm).toBe(2);
  const byHand = {...fresh, cut: {...fresh.cut, clearance_mm: 4}};
  expect(plannedOf(byHand, {}, 1).cut.clearance_mm).toBe(4);
});

test('the wishes are those of the library', () => {
  expect(planWishes(USUAL_WISHES)).toEqual({carrier: 'parcel', ways: ['sponge', 'sheets'], cases: 'cartons', own_blocks: false});
  expect(planWishes({...USUAL_WISHES, foam: 'blocks', cases: 'named'})).toMatchObject({cases: 'none', own_blocks: true});
});

test.each([['slit-10', 'sponge'], ['paper', 'sponge'], ['sheet-5', 'sheets'], ['lego-plate', 'bricks'], ['print', 'print'], ['mill', 'mill'], ['cast', 'mould']])(
  'blocks of %s are for %s',
  (name, way) => expect(waysFor(preset(name), studio.presets)).toEqual([way]),
);
