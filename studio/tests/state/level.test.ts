import {afterEach, expect, test, vi} from 'vitest';
import {levelIn} from '../../src/state/level';
import {startStudio} from '../support/studio';

// A wedge of 0.2 x 0.15 x 0.1 of its unit, which can hardly be millimetres.
const WEDGE = 'OFF\n4 4 0\n0 0 0\n0.2 0 0\n0 0.15 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';
const wedge = (name = 'wedge.off') => new File([WEDGE.replace('OFF\n', `OFF\n# ${name}\n`)], name);

afterEach(() => {
  vi.unstubAllGlobals();
  vi.resetModules();
});

test('the address says how much is shown', () => {
  expect(levelIn('?level=all')).toBe('all');
  expect(levelIn('?object&level=all')).toBe('all');
  for (const address of ['', '?level=usual', '?level', '?all']) expect(levelIn(address)).toBe('usual');
});

test('with everything open nothing is asked: an implausible size is taken in millimetres, also of what joins', async () => {
  vi.resetModules();
  vi.stubGlobal('location', {search: '?level=all'});
  const studio = await startStudio();
  const {openFiles} = await import('../../src/import/open_files');
  await openFiles(studio, [wedge()]);
  expect(studio.asksForUnit).toBe(false);
  expect(studio.design.object.units).toBe('mm');
  expect(studio.object?.size_mm?.map((mm) => Number(mm.toFixed(3)))).toEqual([0.2, 0.15, 0.1]);
  expect(studio.packing).not.toBeNull();
  await openFiles(studio, [wedge('another.off')], {joins: true});
  expect(studio.asksForUnit).toBe(false);
  expect(studio.moment.design.items.length).toBe(2);
  await studio.undo();
  expect(studio.moment.design.items.length).toBe(1);
  expect(studio.asksForUnit).toBe(false);
});

test('otherwise the unit is asked for', async () => {
  vi.resetModules();
  const studio = await startStudio();
  const {openFiles} = await import('../../src/import/open_files');
  await openFiles(studio, [wedge()]);
  expect(studio.asksForUnit).toBe(true);
  expect(studio.design.object.units).toBeNull();
});
