import {describe, expect, it} from 'vitest';
import type {Design} from '../../src/design/design';
import {
  completed,
  forNewObject,
  mmPerFileUnit,
  walls,
  withBlocks,
  withCase,
  withClearanceOf,
  withFit,
  withLength,
  withLongest,
  withPreset,
  withSpace,
  withUpright,
  withWalls,
  withWorkshop,
} from '../../src/design/edit';
import {startCore} from '../support/snug';

const FIT = {
  settle: true,
  pads: {sheet_mm: 2, squeeze_mm: 1},
  relief: {height_mm: 40, island_mm: 60},
  notches: {width_mm: 80, depth_mm: 40, room_mm: 25, axis: null, first_mm: null, second_mm: null},
};

describe('edits', async () => {
  const design = await (await startCore()).defaultDesign();

  it('a design of another version is completed, and what it says stays', () => {
    const {fit: _, ...old} = {...design, cut: {clearance_mm: 3}};
    const now = completed(old as unknown as Design, design);
    expect(now.cut).toEqual({...design.cut, clearance_mm: 3});
    expect(now.fit).toEqual(design.fit);
    expect(completed(now, design)).toEqual(now);
    expect(completed(design, design)).toEqual(design);
    const edits = [{piece: 'lower', j: 1, k: 2, blocks: 1}];
    expect(completed({...design, edits}, design).edits).toEqual(edits);
  });

  it('a clearance and a wall may differ from side to side', () => {
    const loose = withClearanceOf({...design, cut: {...design.cut, clearance_mm: 1}}, 4, 3);
    expect(loose.cut.clearance_mm).toEqual([1, 1, 1, 1, 3, 1]);
    expect(walls(withWalls(design, 20), 50)).toEqual([20, 20, 20, 20, 20, 20]);
    expect(walls(withWalls(design, [1, 2, 3, 4, 5, 6]), 50)).toEqual([1, 2, 3, 4, 5, 6]);
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
    used = withUpright(withFit(withWalls(withClearanceOf(used, 0, -2), 5), FIT), 'z');
    used = withCase(used, {name: 'box', inside_mm: [100, 200, 300], lid_mm: 20, play_mm: 5}, design.case);
    const next = forNewObject(used, design, presets);
    expect(walls(next, 50)).toEqual([50, 50, 50, 50, 50, 50]);
    expect(next.cut.clearance_mm).toBe(preset.clearance_mm);
    expect(next.fit).toMatchObject({settle: false, pads: null, relief: null, notches: null});
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
