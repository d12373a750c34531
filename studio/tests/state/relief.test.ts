import {beforeEach, expect, test, vi} from 'vitest';
import type {Design} from '../../src/design/design';
import {withFit, withPreset, withWalls, withWorkshop} from '../../src/design/edit';
import {withDrop, withFoamData, withFragility} from '../../src/design/protection';
import type {Studio} from '../../src/state/studio.svelte';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

// Less foam where less would do more: offered once nobody changes anything, taken and taken back.

let studio: Studio;

beforeEach(async () => {
  studio = await startStudio();
  const {openFiles} = await import('../../src/import/open_files');
  await openFiles(studio, [new File([box([60, 200, 240])], 'plate.stl')]);
  const foam = studio.drops.choices.foams.find(({design}) => design.name === 'ld33')!.design;
  const preset = studio.presets.find(({name}) => name === 'sheet-10')!;
  await change((design) =>
    withWorkshop(withFragility(withDrop(withFoamData(withWalls(withPreset(design, preset), 50), foam, preset), 500), 60), {mass_kg: 3}),
  );
});

async function change(edit: (design: Design) => Design) {
  const before = studio.packing;
  studio.change(edit, '');
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
  await studio.drops.look();
}

const floor = () => studio.drops.last!.items[0]!.faces[0]!;
const codes = () => studio.findings.map(({code}) => code);

test('a relief is offered with what it does, taken as one change, and taken back', async () => {
  expect(floor().verdict).toBe('over');
  expect(studio.drops.relief).toBeNull();
  await studio.measureGaps();
  const offer = studio.drops.relief!;
  expect(offer.finding.message[0]).toContain(`--relief ${offer.height_mm}x${offer.island_mm}`);
  expect(codes()).toContain('relief_offer');
  const [before, high] = [studio.moment.design, floor().high_g!];

  const packing = studio.packing;
  studio.drops.takeRelief();
  await vi.waitFor(() => expect(studio.packing).not.toBe(packing));
  await studio.drops.look();
  expect(studio.design.fit.relief).toEqual({height_mm: offer.height_mm, island_mm: offer.island_mm});
  expect(floor().high_g!).toBeLessThan(high);
  expect(offer.finding.message[0]).toContain(`${Math.round(floor().low_g!)} to ${Math.round(floor().high_g!)} G`);
  expect(codes()).toContain('relief');
  await studio.measureGaps();
  expect(studio.drops.relief).toBeNull();
  expect(codes()).not.toContain('relief_offer');
  await studio.undo();
  expect(studio.moment.design).toEqual(before);
});

test('none is offered where the drop is borne, and none where none is looked at', async () => {
  await change((design) => withFragility(design, 150));
  await studio.measureGaps();
  expect(studio.gap!.relief).toBeNull();
  await change((design) => withFoamData(withDrop(withFragility(design, 60), null), null, undefined));
  await studio.measureGaps();
  expect(studio.gap!.relief).toBeNull();
});

test('what follows from drops for pads and reliefs is told beside them, else with the foams', async () => {
  const asked = studio.design;
  await change((design) => withFit(design, {pads: {sheet_mm: 2, squeeze_mm: 1}, relief: {height_mm: 40, island_mm: 60}}));
  expect(studio.drops.fitting.map(({code}) => code)).toContain('relief');
  expect(codes().filter((code) => code === 'relief')).toHaveLength(1);
  await change((design) => withFoamData(withDrop(design, null), null, undefined));
  expect(asked.protection.foam).not.toBeNull();
  expect(studio.drops.fitting).toEqual([]);
  expect(studio.packing!.findings.map(({code}) => code)).toContain('relief');
  expect(codes().filter((code) => code === 'relief')).toHaveLength(1);
});
