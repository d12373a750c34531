import {beforeAll, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import {firstDesign, withClearance, withFit, withPreset, withPresetOfWay, withTray, withWalls, withWorkshop} from '../../src/design/edit';
import {usualGroup, withValue} from '../../src/design/options';
import {withFoamData} from '../../src/design/protection';
import {isOther, usualValue, withUsual, type Beginning} from '../../src/design/usual';
import {startCore} from '../support/snug';

let beginning: Beginning;
let first: Design;
let foam: NonNullable<Design['protection']['foam']>;
beforeAll(async () => {
  const core = await startCore();
  const [rows, defaults, presets] = await Promise.all([core.options(), core.defaultDesign(), core.presets()]);
  beginning = {rows, defaults, presets};
  foam = (await core.dropChoices()).foams[0]!.design;
  first = firstDesign(defaults);
});

const presetOf = (name: string) => beginning.presets.find((preset) => preset.name === name)!;

test('nothing is other than usual at the beginning', () => {
  for (const path of Object.keys(beginning.rows) as (keyof typeof beginning.rows)[])
    if (path !== 'items') expect(isOther(first, path, beginning), path).toBe(false);
});

test('a number that was chosen is other, and goes back by itself', () => {
  const chosen = withValue(withValue(first, 'cut.liner_mm', 2), 'fit.least_rib_mm', 25);
  expect(isOther(chosen, 'cut.liner_mm', beginning)).toBe(true);
  const back = withUsual(chosen, 'cut.liner_mm', beginning);
  expect(back).toEqual(withValue(first, 'fit.least_rib_mm', 25));
});

test('what a foam brings is usual with it, and a way of working makes its foam usual', () => {
  const slit = withPreset(first, presetOf('slit-10'));
  expect(isOther(slit, 'space.preset', beginning)).toBe(true);
  expect(isOther(slit, 'space.block_mm', beginning)).toBe(false);
  expect(isOther(slit, 'cut.clearance_mm', beginning)).toBe(false);
  const finer = withValue(slit, 'space.block_mm', [5, 5, 5]);
  expect(withUsual(finer, 'space.block_mm', beginning).space.block_mm).toEqual(presetOf('slit-10').block_mm);
  expect(withUsual(slit, 'space.preset', beginning)).toEqual(withPreset(first, presetOf('paper')));
  const sheets = withWorkshop(slit, {for: 'sheets'});
  expect(presetOf(String(usualValue(sheets, 'space.preset', beginning))).usual_for).toContain('sheets');
});

test('what is rigid brings its walls, which go with it; others stay', () => {
  const print = withPreset(withWalls(first, 50), presetOf('print'), presetOf('paper'));
  expect(print.space.wall_mm).toBe(presetOf('print').wall_mm);
  expect(isOther(print, 'space.wall_mm', beginning)).toBe(false);
  expect(isOther(withWalls(print, 30), 'space.wall_mm', beginning)).toBe(true);
  expect(withUsual(withWalls(print, 30), 'space.wall_mm', beginning)).toEqual(print);
  const bricks = withPreset(print, presetOf('lego-brick'), presetOf('print'));
  expect(bricks.space.wall_mm).toBe(presetOf('lego-brick').wall_mm);
  expect(withPreset(bricks, presetOf('slit-10'), presetOf('lego-brick')).space.wall_mm).toBe(null);
  expect(withPreset(withWalls(print, 30), presetOf('slit-10'), presetOf('print')).space.wall_mm).toBe(30);
  expect(withPreset(withWalls(first, 30), presetOf('slit-10'), presetOf('paper')).space.wall_mm).toBe(30);
});

test('another foam has none of what is known of the last; the same in other blocks has all of it', () => {
  const known = {...foam, name: 'ethafoam-200lc', density_kg_m3: 35, creep_kpa: 7};
  const inBlocks = (from: string) => withFoamData(withPreset(first, presetOf(from)), known, presetOf(from));
  const next = (from: string, to: string) => withPreset(inBlocks(from), presetOf(to), presetOf(from));
  for (const [from, to] of [['slit-10', 'slit-15'], ['sheet-10', 'mill']] as const)
    expect(next(from, to)).toMatchObject({protection: {foam: known}, fit: {creep_kpa: 7}, workshop: {density_kg_m3: 35}});
  for (const [from, to] of [['sheet-10', 'slit-15'], ['paper', 'slit-15'], ['paper', 'print']] as const) {
    const other = next(from, to);
    expect([other.protection.foam, other.fit.creep_kpa, other.workshop.density_kg_m3], to).toEqual([null, presetOf(to).creep_kpa, presetOf(to).density_kg_m3]);
  }
  expect(withPreset(inBlocks('paper'), presetOf('slit-15')).protection.foam).toEqual(known);
  // A way of working brings its blocks, of whatever foam it is; what is printed is none.
  expect(withPresetOfWay(inBlocks('paper'), presetOf('sheet-10'), presetOf('paper')).protection.foam).toEqual(known);
  expect(withPresetOfWay(inBlocks('paper'), presetOf('print'), presetOf('paper')).protection.foam).toBe(null);
});

test('what was added to the clearance stays added, there and back', () => {
  for (const mm of [0, 0.3, 1.7, [0, 0.1, 0.2, 1, -0.4, 2]]) {
    const slit = withPreset(withClearance(first, mm), presetOf('slit-10'), presetOf('paper'));
    const print = withPreset(slit, presetOf('print'), presetOf('slit-10'));
    const more = presetOf('print').clearance_mm - presetOf('paper').clearance_mm;
    [print.cut.clearance_mm].flat().forEach((now, i) => expect(now).toBeCloseTo([mm].flat()[i]! + more));
    expect(withPreset(print, presetOf('paper'), presetOf('print')).cut.clearance_mm).toEqual(mm);
  }
  expect(withPreset(withClearance(first, 3), presetOf('print')).cut.clearance_mm).toBe(presetOf('print').clearance_mm);
});

test('a squeeze that the next blocks cannot have is as much as they can', () => {
  const squeezed = withClearance(withPreset(first, presetOf('slit-15')), -4);
  const print = withPreset(squeezed, presetOf('print'), presetOf('slit-15'));
  expect(print.cut.clearance_mm).toBe(presetOf('print').least_clearance_mm);
});

test('a group that is there is other; within it, what was changed', () => {
  const notches = usualGroup(beginning.rows, 'fit.notches') as unknown as Design['fit']['notches'];
  const held = withFit(first, {notches});
  expect(isOther(first, 'fit.notches.width_mm', beginning)).toBe(false);
  expect(isOther(held, 'fit.notches', beginning)).toBe(true);
  expect(isOther(held, 'fit.notches.width_mm', beginning)).toBe(false);
  expect(isOther(withValue(held, 'fit.notches.width_mm', 50), 'fit.notches.width_mm', beginning)).toBe(true);
  expect(withUsual(held, 'fit.notches', beginning)).toEqual(first);
});

test('a case and a tray go with what came with them', () => {
  const inCase = {...first, case: {...first.case, name: 'Box', inside_mm: [200, 300, 400] as [number, number, number], lid_mm: 40}};
  expect(withUsual(inCase, 'case.inside_mm', beginning)).toEqual(first);
  expect(withUsual(withTray(first, 0.6), 'space.open', beginning)).toEqual(first);
});

test('of an item, too', () => {
  const second = {...first, items: [first.items[0]!, {...first.items[0]!, layer: 3}]};
  expect(isOther(second, 'items.0.layer', beginning)).toBe(false);
  expect(isOther(second, 'items.1.layer' as 'items.0.layer', beginning)).toBe(true);
  expect(withUsual(second, 'items.1.layer' as 'items.0.layer', beginning).items[1]!.layer).toBe(1);
});
