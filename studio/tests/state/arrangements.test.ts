import {beforeEach, expect, test, vi} from 'vitest';
import {withSpace} from '../../src/design/edit';
import {withLock, withoutItem} from '../../src/design/moment';
import type {Studio} from '../../src/state/studio.svelte';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

let studio: Studio;
const file = (name: string, size: [number, number, number]) => new File([box(size)], name);

beforeEach(async () => {
  studio = await startStudio();
  const {openFiles} = await import('../../src/import/open_files');
  await openFiles(studio, [file('body.stl', [60, 120, 180]), file('lens.stl', [60, 100, 90]), file('cap.stl', [40, 60, 60])]);
});

const packed = async () => {
  const before = studio.packing;
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
};
const count = () => studio.packing!.blocks.reduce((a, b) => a * b);
const dangers = () => studio.findings.filter(({severity}) => severity === 'danger');

test('arranged items take less room than a row, and are arranged anew as if nobody had chosen the space', async () => {
  const row = count();
  await studio.arrangements.arrange();
  expect(studio.problem).toBeNull();
  expect(count()).toBeLessThan(row);
  expect(dangers()).toEqual([]);
  expect(studio.busy).toBeNull();
  const least = count();
  studio.becomes(withoutItem(studio.moment, 2), '');
  await packed();
  await studio.arrangements.arrange();
  expect(count()).toBeLessThan(least);
  await studio.undo();
  await studio.undo();
  await studio.undo();
  expect(count()).toBe(row);
  expect(studio.canUndo).toBe(true);
});

test('there are others to choose from, until something else changes', async () => {
  await studio.arrangements.arrange();
  const {choices} = studio.arrangements;
  expect(choices.length).toBeGreaterThan(1);
  expect(studio.arrangements.chosen).toBe(0);
  for (const [i, choice] of choices.entries()) {
    expect(choice.plan.length).toBe(3);
    studio.arrangements.take(choice);
    await vi.waitFor(() => expect(count() * studio.packing!.block_mm.reduce((a, b) => a * b)).toBeCloseTo(choice.volume_mm3, 0));
    expect(studio.arrangements.chosen).toBe(i);
    expect(studio.arrangements.choices).toBe(choices);
    expect(dangers()).toEqual([]);
  }
  studio.change((design) => ({...design, cut: {...design.cut, clearance_mm: 2}}), '');
  await packed();
  expect(studio.arrangements.choices).toEqual([]);
});

test('a locked item stays where it lies', async () => {
  studio.becomes({...studio.moment, design: withSpace(studio.moment.design, [12, 30, 30])}, '');
  await packed();
  await studio.arrangements.arrange();
  const place = studio.moment.design.items[1];
  studio.becomes(withLock(studio.moment, 1, true), '');
  await studio.arrangements.arrange();
  expect(studio.problem).toBeNull();
  expect(studio.moment.design.items[1]).toEqual({...place, lock: true});
});

test('as many of the selected one as fit', async () => {
  studio.becomes({...studio.moment, design: withSpace(studio.moment.design, [12, 30, 20])}, '');
  await packed();
  studio.select(2);
  await studio.arrangements.fill();
  expect(studio.problem).toBeNull();
  const caps = studio.packing!.items.filter(({object}) => object === 2);
  expect(caps.length).toBeGreaterThan(2);
  expect(studio.packing!.items.length).toBe(caps.length + 2);
  expect(dangers()).toEqual([]);
  await studio.undo();
  expect(studio.moment.design.items.length).toBe(3);
});

test('what does not go in is said, and everything stays as it was', async () => {
  const design = withSpace(studio.moment.design, [8, 10, 10]);
  studio.becomes({...studio.moment, design}, '');
  await packed();
  await studio.arrangements.arrange();
  expect(studio.problem?.text[0]).toMatch(/the 3 items do not go into/);
  expect(studio.moment.design).toEqual(design);
});

test('cancelled, the best so far stays', async () => {
  const row = count();
  const arranging = studio.arrangements.arrange();
  await vi.waitFor(() => expect(studio.busy?.work).toBe('arrange'));
  studio.busy!.cancel!();
  await arranging;
  expect(studio.busy).toBeNull();
  expect(studio.problem).toBeNull();
  expect(count()).toBeLessThanOrEqual(row);
});
