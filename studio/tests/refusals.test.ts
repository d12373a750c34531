import {beforeEach, expect, test, vi} from 'vitest';
import {withUnits, withWall} from '../src/state/edit';
import type {Studio} from '../src/state/studio.svelte';
import {box} from './support/shapes';
import {startStudio} from './support/studio';

let studio: Studio;

beforeEach(async () => {
  studio = await startStudio();
  await studio.openObject('box.stl', box([120, 80, 60]));
});

const refusal = () => vi.waitFor(() => expect(studio.problem).not.toBeNull());

test('a unit that makes too many blocks leaves the object as large as it was', async () => {
  const before = {size: studio.object?.size_mm, volume: studio.object?.volume_mm3, packing: studio.packing};
  studio.change((design) => withUnits(design, 'm'), 'units');
  await refusal();
  expect(studio.problem?.text).toContain('more than');
  expect(studio.design.object.units).toBeNull();
  await vi.waitFor(() => expect(studio.object?.size_mm).toEqual(before.size));
  expect(studio.object?.volume_mm3).toBe(before.volume);
  expect(studio.packing).toBe(before.packing);
  await vi.waitFor(() => expect(Math.max(...(studio.meshes?.still.positions ?? []))).toBe(120));
  // What follows is of the object as it is said to be.
  studio.change((design) => withWall(design, 30), 'wall');
  await vi.waitFor(() => expect(studio.packing).not.toBe(before.packing));
  expect(studio.object?.size_mm).toEqual(before.size);
  expect(studio.problem).toBeNull();
});

test('a change that overtakes a refused unit is of the old unit', async () => {
  studio.change((design) => withUnits(design, 'm'), 'units');
  studio.change((design) => withUnits(design, 'mm'), 'units');
  await vi.waitFor(() => expect(studio.canUndo && studio.design.object.units).toBe('mm'));
  await vi.waitFor(() => expect(studio.object?.size_mm).toEqual([120, 80, 60]));
});
