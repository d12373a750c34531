import {beforeEach, expect, test, vi} from 'vitest';
import {withPart, withUnits, withWalls} from '../../src/design/edit';
import {worst} from '../../src/state/findings';
import type {Studio} from '../../src/state/studio.svelte';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

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
  expect(studio.problem?.text[0]).toContain('more than');
  expect(studio.design.object.units).toBeNull();
  await vi.waitFor(() => expect(studio.object?.size_mm).toEqual(before.size));
  expect(studio.object?.volume_mm3).toBe(before.volume);
  expect(studio.packing).toBe(before.packing);
  await vi.waitFor(() => expect(Math.max(...(studio.meshes?.still.positions ?? []))).toBe(120));
  // What follows is of the object as it is said to be.
  studio.change((design) => withWalls(design, 30), 'wall');
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

test('a part that is the last one stays, and no unit is asked for', async () => {
  const corners = (at: number) => `0 0 ${at}\n60 0 ${at}\n0 50 ${at}\n0 0 ${at + 40}\n`;
  const tetrahedron = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  const faces = (first: number) => tetrahedron.map((face) => `3 ${face.map((i) => i + first).join(' ')}\n`).join('');
  await studio.openObject('two.off', new Blob([`OFF\n8 8 0\n${corners(0)}${corners(80)}${faces(0)}${faces(4)}`]));
  const dropped = () => studio.object?.parts.map((part) => part.dropped);
  studio.change((design) => withPart(design, 1, false), 'object');
  await vi.waitFor(() => expect(dropped()).toEqual([true, false]));
  studio.change((design) => withPart(design, 2, false), 'object');
  await refusal();
  expect(studio.asksForUnit).toBe(false);
  expect(studio.design.object.clean.drop_parts).toEqual([1]);
  expect(dropped()).toEqual([true, false]);
  expect(studio.packing?.fit).toBeTruthy();
});

test('what a way of working warns of counts among all that is known, the gravest first', () => {
  const thin = studio.findings.length;
  const warning = {severity: 'warning', code: 'sheets-lost', message: ['', ''], where: null} as const;
  studio.workshopFindings = [warning, {...warning, severity: 'danger'}];
  expect(studio.findings.length).toBe(thin + 2);
  expect(studio.findings[0]?.severity).toBe('danger');
  expect(worst(studio.findings)).toBe('danger');
  studio.workshopFindings = null;
  expect(studio.findings.length).toBe(thin);
});
