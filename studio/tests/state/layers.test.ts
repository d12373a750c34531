import {beforeEach, expect, test, vi} from 'vitest';
import {withOffset, withParting, withTray} from '../../src/design/edit';
import {withLayersStacked} from '../../src/design/layers';
import {withoutItem} from '../../src/design/moment';
import {withValue, type OptionPath} from '../../src/design/options';
import type {Studio} from '../../src/state/studio.svelte';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

// Items are put into layers, and trays made, as the panels do it.

let studio: Studio;

beforeEach(async () => {
  studio = await startStudio();
  const {openFiles} = await import('../../src/import/open_files');
  await openFiles(studio, [new File([box([120, 80, 60])], 'body.stl'), new File([box([50, 40, 60])], 'lens.stl')]);
});

const packed = async (change: () => void) => {
  const before = studio.packing;
  change();
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
};
const putInto = (item: number, layer: number) =>
  packed(() => studio.change((design) => withLayersStacked(withValue(design, `items.${item}.layer` as OptionPath, layer), item, studio.lying), `items.${item}.layer`));
const layers = () => studio.packing?.items.map(({layer}) => layer);

test('an item that is put into another layer is back in its own after undo', async () => {
  const {pieces} = studio.packing!;
  await putInto(1, 2);
  expect([layers(), studio.packing?.pieces.length]).toEqual([[1, 2], 3]);
  expect(studio.problem).toBeNull();
  await studio.undo();
  expect(layers()).toEqual([1, 1]);
  expect(studio.packing?.pieces).toEqual(pieces);
  await studio.redo();
  expect(layers()).toEqual([1, 2]);
});

test('a parting level that was chosen for one layer is not held against two', async () => {
  await packed(() => studio.change((design) => withParting(design, 6), 'parting'));
  await putInto(1, 2);
  expect([studio.problem, studio.design.parting.level, studio.packing?.partingLevels.length]).toEqual([null, 'auto', 2]);
  await packed(() => studio.change((design) => withParting(design, [3, 9]), 'parting'));
  expect(studio.packing?.partingLevels).toEqual([3, 9]);
  // Where the lowest layer is taken out, the other one is the lowest.
  await packed(() => studio.becomes(withoutItem(studio.moment, 0), ''));
  expect([layers(), studio.design.parting.level]).toEqual([[1], 'auto']);
});

test('items that a hand has placed are stacked, too, and stay where they are in the plan', async () => {
  studio.select(1);
  const [, y, z] = studio.design.placement.offset_mm;
  await packed(() => studio.change((design) => withOffset(design, [7, y + 3, z - 40]), 'handles'));
  const plan = () => studio.packing!.items[1]!.offset_mm.slice(1).map((mm, i) => mm - studio.packing!.items[0]!.offset_mm[i + 1]!);
  const before = plan();
  await putInto(1, 2);
  const [body, lens] = studio.packing!.items;
  // A block more than the least foam between them, and with the lens below it is the same.
  expect(lens!.bounds.min[0] - body!.bounds.max[0]).toBeCloseTo(45, 0);
  expect(plan()).toEqual(before);
  expect(studio.findings.filter(({severity}) => severity === 'danger')).toEqual([]);
  await putInto(1, 1);
  const level = ({bounds: {min, max}}: {bounds: {min: number[]; max: number[]}}) => (min[0]! + max[0]!) / 2;
  expect(level(studio.packing!.items[1]!)).toBeCloseTo(level(studio.packing!.items[0]!), 0);
});

test('a layer below which nothing lies is refused with a sentence, and nothing changes', async () => {
  studio.change((design) => withValue(design, 'items.1.layer' as OptionPath, 3), 'items.1.layer');
  await vi.waitFor(() => expect(studio.problem?.text[0]).toContain('layer 2'));
  expect([layers(), studio.moment.design.items.map(({layer}) => layer)]).toEqual([[1, 1], [1, 1]]);
});

test('a tray is switched on and off, and its surface follows how deep things are sunk', async () => {
  await packed(() => studio.change((design) => withParting(design, 6), 'parting'));
  await packed(() => studio.change((design) => withTray(design, 0.5), 'tray'));
  expect([studio.packing?.open, studio.packing?.pieces.length, studio.design.parting.level]).toEqual([true, 1, 'auto']);
  const [half] = studio.packing!.partingLevels;
  await packed(() => studio.change((design) => withTray(design, 0.9), 'tray'));
  expect(studio.packing!.partingLevels[0]).toBeGreaterThan(half!);
  expect(studio.findings.map(({code}) => code)).not.toContain('no_upper');
  await packed(() => studio.change((design) => withTray(design, null), 'tray'));
  expect([studio.packing?.open, studio.packing?.pieces.length]).toEqual([false, 2]);
});
