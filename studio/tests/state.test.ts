import {Quaternion, Vector3} from 'three';
import {describe, expect, it} from 'vitest';
import type {Design, Triple} from '../src/engine/api';
import {
  completed,
  forNewObject,
  mmPerFileUnit,
  walls,
  withBlocks,
  withCase,
  withClearanceOf,
  withLength,
  withLongest,
  withNotches,
  withPreset,
  withSpace,
  withUpright,
  withWalls,
  withWorkshop,
  USUAL_NOTCHES,
} from '../src/state/edit';
import {canRedo, canUndo, moved, present, record, startHistory} from '../src/state/history';
import {angles, quarterTurned, quaternion, sideDown, SIDES, sideThatIsDown} from '../src/state/rotation';
import {numbers} from './support/packing';
import {good, startCore} from './support/snug';

const TURNS: Triple[] = Array.from({length: 50}, (_, seed) => {
  const number = numbers(seed + 1);
  return [number(360) - 180, number(360) - 180, number(360) - 180];
});

describe('rotations', () => {
  it('are the library’s', async () => {
    const core = await startCore();
    const sample = good(await core.sampleFile('torus'));
    const design = await core.defaultDesign();
    await core.load(sample.name, new Blob([sample.bytes]), design.object);
    for (const rotation_deg of TURNS.slice(0, 12)) {
      const packing = good(await core.pack({...design, placement: {...design.placement, rotation_deg}}));
      const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
      axes.forEach((axis, column) => {
        const turned = axis.applyQuaternion(quaternion(rotation_deg)).toArray();
        turned.forEach((value, row) => expect(packing.placement[column * 4 + row]).toBeCloseTo(value, 9));
      });
    }
  });

  it('come back from their angles', () => {
    for (const turn of TURNS) {
      const again = quaternion(angles(quaternion(turn)));
      expect(again.angleTo(quaternion(turn))).toBeLessThan(1e-4);
    }
  });

  it('four quarter turns are none, and there is one for each axis', () => {
    for (const turn of TURNS)
      for (const axis of [0, 1, 2] as const) {
        const once = quaternion(quarterTurned(turn, axis, 1));
        expect(once.angleTo(quaternion(turn))).toBeCloseTo(Math.PI / 2, 4);
        let four = turn;
        for (let i = 0; i < 4; i++) four = quarterTurned(four, axis, 1);
        expect(quaternion(four).angleTo(quaternion(turn))).toBeLessThan(1e-3);
        expect(quaternion(quarterTurned(quarterTurned(turn, axis, 1), axis, -1)).angleTo(quaternion(turn))).toBeLessThan(1e-3);
      }
  });

  it('put the named side down, and say which one is', () => {
    for (const turn of TURNS)
      for (const side of SIDES) {
        const down = sideDown(turn, side);
        expect(sideThatIsDown(down)).toBe(side);
        expect(down.every((degrees) => degrees % 90 === 0)).toBe(true);
        expect(sideDown(down, side)).toEqual(down);
        expect(quaternion(down)).toBeInstanceOf(Quaternion);
      }
  });
});

describe('the history', () => {
  it('goes back and forth, and forgets what was undone before a change', () => {
    let history = startHistory(0);
    for (const moment of [1, 2, 3]) history = record(history, moment, '', 0);
    history = moved(moved(history, -1), -1);
    expect(present(history)).toBe(1);
    expect(canRedo(history)).toBe(true);
    history = record(history, 9, 'x', 0);
    expect(history.moments).toEqual([0, 1, 9]);
    expect(canRedo(history)).toBe(false);
    for (let i = 0; i < 9; i++) history = moved(history, -1);
    expect(present(history)).toBe(0);
    expect(canUndo(history)).toBe(false);
  });

  it('takes a drag as one step, and two drags as two', () => {
    let history = startHistory(0);
    for (let i = 1; i <= 10; i++) history = record(history, i, 'slider', i * 16);
    history = record(history, 20, 'slider', 5000);
    history = record(history, 21, 'other', 5010);
    expect(history.moments).toEqual([0, 10, 20, 21]);
  });

  it('never loses where it started from while one control moves', () => {
    let history = record(startHistory('start'), 'a', 'slider', 0);
    history = record(history, 'b', 'slider', 1);
    expect(history.moments).toEqual(['start', 'b']);
  });
});

describe('edits', async () => {
  const design = await (await startCore()).defaultDesign();

  it('a design of another version is completed, and what it says stays', () => {
    const {fit: _, ...old} = {...design, cut: {clearance_mm: 3}};
    const now = completed(old as unknown as Design, design);
    expect(now.cut).toEqual({...design.cut, clearance_mm: 3});
    expect(now.fit).toEqual(design.fit);
    expect(completed(now, design)).toEqual(now);
  });

  it('a clearance and a wall may differ from side to side', () => {
    const loose = withClearanceOf({...design, cut: {...design.cut, clearance_mm: 1}}, 4, 3);
    expect(loose.cut.clearance_mm).toEqual([1, 1, 1, 1, 3, 1]);
    expect(walls(withWalls(design, 20))).toEqual([20, 20, 20, 20, 20, 20]);
    expect(walls(withWalls(design, [1, 2, 3, 4, 5, 6]))).toEqual([1, 2, 3, 4, 5, 6]);
  });

  it('a known length scales the object to it, whatever its unit was', () => {
    for (const units of ['mm', 'cm', 'm', 'in'] as const)
      for (const longest_mm of [null, 77]) {
        const before = {...design, object: {...design.object, units, scale: 3, longest_mm}};
        const after = withLength(before, 0.4, 250);
        expect(mmPerFileUnit(after, [1, 2, 3]) * 0.4).toBeCloseTo(250);
      }
  });

  it('the next object begins without what was chosen to hold the last one, and with what belongs to the person', async () => {
    const presets = await (await startCore()).presets();
    const preset = presets.find(({name}) => name === 'slit-10')!;
    let used = withWorkshop(withPreset(design, preset), {for: 'sponge', mass_kg: 3, price_per_litre: 4, currency: 'EUR'});
    used = withUpright(withNotches(withWalls(withClearanceOf(used, 0, -2), 5), USUAL_NOTCHES), 'z');
    used = withCase(used, {name: 'box', inside_mm: [100, 200, 300], lid_mm: 20, play_mm: 5});
    const next = forNewObject(used, design, presets);
    expect(walls(next)).toEqual([50, 50, 50, 50, 50, 50]);
    expect(next.cut.clearance_mm).toBe(preset.clearance_mm);
    expect(next.fit.notches).toBeNull();
    expect(next.case.inside_mm).toBeNull();
    expect(next.case.name).toBe('');
    expect(next.search.upright).toBeNull();
    expect(next.workshop.mass_kg).toBeNull();
    expect(next.space.preset).toBe('slit-10');
    expect(next.case.play_mm).toBe(5);
    expect(next.workshop).toMatchObject({for: 'sponge', price_per_litre: 4, currency: 'EUR'});
  });

  it('a known longest side is the size, whatever the unit of the file', () => {
    const sized = withLongest({...design, object: {...design.object, units: 'in', scale: 7}}, 300);
    expect(mmPerFileUnit(sized, [1, 2, 3]) * 3).toBeCloseTo(300);
  });

  it('a file that states its unit is in mm, whatever the design says, and a length scales it alone', () => {
    const before = {...design, object: {...design.object, units: 'in' as const, scale: 3}};
    expect(mmPerFileUnit(before, [1, 2, 3], true)).toBe(3);
    const after = withLength(before, 40, 100, true);
    expect(after.object).toMatchObject({units: null, scale: 2.5});
    expect(mmPerFileUnit(after, [1, 2, 3], true) * 40).toBeCloseTo(100);
  });

  it('a typed block count takes over from the fitted ones', () => {
    expect(withBlocks(withSpace(design, 'auto'), 1, 9, [4, 5, 6]).space.blocks).toEqual([4, 9, 6]);
  });
});
